#include "mask_levels.h"

#include <fmt/format.h>

#include "framework/library/kit/drawn_numbers.h"
#include "obj_textures.h"
#include "truth.h"

namespace relief::materials {

void MaskLevels::draw(const Frame& frame, Labels& labels, int alpha, float threshold) {
    glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
    glViewport(0, 0, frame.size.x, frame.size.y);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const std::array names = {fmt::format("above {:.2f}", threshold), std::string("kept"), std::string("kept, smooth"),
                              std::string("alpha")};
    const int rows = frame.probe ? 1 : int(names.size());
    std::vector<Tile> tiles = tile_grid(frame.size, levels_shown, rows);
    if (!frame.probe) tiles = Labels::with_feet(frame.size, tiles, 2, 14);
    for (size_t i = 0; i < tiles.size(); ++i) {
        const Tile& tile = tiles[i];
        if (tile.size.x <= 0 || tile.size.y <= 0) continue;
        glViewport(tile.corner.x, tile.corner.y, tile.size.x, tile.size.y);
        const int row = int(i) / levels_shown, level = int(i) % levels_shown;
        draw_level(level, frame.probe ? alpha : row, threshold, frame.probe);
        if (frame.probe) continue;
        labels.caption(frame.size, tile, 0, names[size_t(row)]);
        const double share = measure(level, row, threshold);
        labels.caption(
            frame.size, tile, -1,
            fmt::format("mip {}", level) + (std::isfinite(share) ? fmt::format(": {:.1f} %", 100 * share) : ""));
    }
}

void MaskLevels::draw_level(int level, int alpha, float threshold, const Define& purpose) {
    if (!texture_) texture_.emplace(load_texture(mask, ColorSpace::linear));
    if (scales_.empty()) scales_ = mask_scales(mask);
    const Program& program = program_.with({purpose, Settings::alphas.define(alpha)});
    glUseProgram(program);
    program.set("s_mask", 0, *texture_);
    program.set("u_level", level);
    program.set("u_scale", scales_[size_t(level)]);
    program.set("u_threshold", threshold);
    program.set("u_part", 0.25f);
    window_.draw();
}

/// Returns the covered share of a level. Infinity before the task is written.
double MaskLevels::measure(int level, int alpha, float threshold) {
    return coverages_[size_t(alpha * levels_shown + level)].get({threshold, program_.renewals()}, [&] {
        return double(draw_numbers({1, 1}, [&] { draw_level(level, alpha, threshold, "MEASURE"); }).values[0]);
    });
}

std::optional<Image> MaskLevels::truth(glm::ivec2 size, const Probe& probe) {
    const auto share = true_coverage(mask);
    if (probe.name != "coverage" || !share) return {};
    return image_of_values(size, [&](int, int) { return glm::dvec4(*share, 0, 0, 0); });
}

}  // namespace relief::materials
