#include "skips.h"

#include <bit>

namespace relief::exact {

void Skips::make(Method method) {
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    const int64_t before = counters().texture_bytes;
    if (method == coarse) bind(3, around_);
    if (method == windows) {
        windows_ = height_windows(heights_);
        bind(3, window_texture_);
    }
    if (method == max_mip) bind(3, bounds_);
    if (method == cones) bind(3, cones_);
    costs_[size_t(method)] = {double(counters().texture_bytes - before) / (1 << 20),
                              std::chrono::duration<double, std::milli>(Clock::now() - begin).count()};
    made_[size_t(method)] = true;
}

void Skips::set(const Program& program, Method method) {
    if (!made_[size_t(method)]) make(method);
    program.set("u_highest", highest_);
    program.set("s_around", 3, around_);
    program.set("s_windows", 3, window_texture_);
    program.set("s_bounds", 3, bounds_);
    program.set("s_cones", 3, cones_);
    program.set("u_top_level", std::min(4, std::countr_zero(unsigned(heights_.width))));
    if (method == windows) {
        const auto& extent = windows_.extent;
        program.set("u_window_extent", glm::vec4(extent[0], extent[1], extent[2], extent[3]));
        program.set("u_block", float(windows_.block));
        program.set("u_per_block", 1.0f / float(windows_.block));
    }
}

}  // namespace relief::exact
