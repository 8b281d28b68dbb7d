#include "skips.h"

#include <bit>

namespace relief::exact {

void Skips::make(Method method) {
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    const int64_t before = counters().texture_bytes;
    int64_t bytes = 0;
    if (method == coarse) bind(3, around_);
    if (method == windows) windows_ = height_windows(heights_), bind(3, window_texture_);
    if (method == max_mip) bind(3, bounds_);
    if (method == cones) bind(3, cones_);
    if (method == cells) {
        // Whole numbers, in an array of four quadrants: no Texture of the framework is that.
        const CellMap map = cell_map(heights_);
        cells_grown_ = map.grown;
        cells_.emplace();
        glActiveTexture(GL_TEXTURE3);
        glBindTexture(GL_TEXTURE_2D_ARRAY, *cells_);
        glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA32I, map.width, map.height, 4, 0, GL_RGBA_INTEGER, GL_INT,
                     map.texels.data());
        glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
        glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        bytes = int64_t(map.texels.size() * sizeof(int32_t));
    }
    bytes += counters().texture_bytes - before;
    costs_[size_t(method)] = {double(bytes) / (1 << 20),
                              std::chrono::duration<double, std::milli>(Clock::now() - begin).count()};
    made_[size_t(method)] = true;
}

void Skips::set(const Program& program, Method method) {
    if (!made_[size_t(method)]) make(method);
    program.set("u_highest", highest_);
    // More than any ray of these labs needs above 0.2 degrees of the surface; a ray that needs more stops in the air.
    program.set("u_most_turns", 4096);
    program.set("s_around", 3, around_);
    program.set("s_windows", 3, window_texture_);
    program.set("s_bounds", 3, bounds_);
    program.set("s_cones", 3, cones_);
    program.set("s_cells", 3);
    program.set("u_top_level", std::min(4, std::countr_zero(unsigned(heights_.width))));
    if (method == cells) {
        glActiveTexture(GL_TEXTURE3);
        glBindTexture(GL_TEXTURE_2D_ARRAY, *cells_);
    }
    if (method == cells || method == windows) {
        const auto& grown = method == cells ? cells_grown_ : windows_.grown;
        program.set("u_grown", glm::vec4(grown[0], grown[1], grown[2], grown[3]));
        program.set("u_block_shift", std::countr_zero(unsigned(windows_.block)));
    }
}

}  // namespace relief::exact
