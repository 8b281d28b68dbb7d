#include "skips.h"

#include <bit>

namespace relief::exact {

void Skips::make(Method method) {
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    const int64_t before = counters().texture_bytes;
    if (method == coarse) bind(3, around_);
    if (method == windows) bind(3, surface_.windows().texture);
    if (method == max_mip) bind(3, bounds_);
    if (method == cones) bind(3, cones_);
    if (method == relaxed) bind(3, relaxed_);
    costs_[size_t(method)] = {double(counters().texture_bytes - before) / (1 << 20),
                              std::chrono::duration<double, std::milli>(Clock::now() - begin).count()};
    made_[size_t(method)] = true;
}

void Skips::set(const Program& program, Method method) {
    if (!made_[size_t(method)]) make(method);
    program.set("u_highest", highest_);
    program.set("s_around", 3, around_);
    program.set("s_bounds", 3, bounds_);
    program.set("s_cones", 3, cones_);
    program.set("s_relaxed", 3, relaxed_);
    program.set("u_top_level", std::min(4, std::countr_zero(unsigned(surface_.heights().width))));
    if (method == windows) {
        const float block = float(surface_.windows().heights.block);
        surface_.set_exact_hit(program, 3);
        program.set("u_block", block);
        program.set("u_per_block", 1 / block);
    }
}

}  // namespace relief::exact
