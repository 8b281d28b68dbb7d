#include "annotations.h"

#include <fmt/format.h>

#include "framework/library/maps/visualize.h"
#include "scene.h"

namespace relief::adaptive {

std::vector<glm::ivec2> holes_in(const Image& sums, bool is_closed) {
    const auto sum = [&](int x, int y) {
        return *sums.pixel(std::clamp(x, 0, sums.width - 1), std::clamp(y, 0, sums.height - 1));
    };
    const auto covered = [&](int x, int y, int dx, int dy) {
        for (int i = 1; i <= 3; ++i)
            if (sum(x + i * dx, y + i * dy) != 0) return true;
        return false;
    };
    std::vector<glm::ivec2> holes;
    for (int y = 0; y < sums.height; ++y)
        for (int x = 0; x < sums.width; ++x) {
            const bool is_hole = is_closed ? sum(x, y) != 0
                                           : sum(x, y) == 0 && covered(x, y, -1, 0) && covered(x, y, 1, 0) &&
                                                 covered(x, y, 0, -1) && covered(x, y, 0, 1);
            if (is_hole) holes.emplace_back(x, sums.height - 1 - y);
        }
    return holes;
}

void mark(Labels& labels, glm::ivec2 size, const Tile& tile, const std::vector<glm::ivec2>& pixels) {
    const float top = float(size.y - tile.corner.y), side = std::max(3.0f, 0.009f * float(tile.size.y));
    for (const glm::ivec2 pixel : pixels)
        labels.rectangle(glm::vec2(float(tile.corner.x + pixel.x) + 0.5f, top - float(pixel.y) - 0.5f) - side / 2,
                         glm::vec2(side), {1, 0.25f, 0.1f, 0.75f});
}

void describe_patches(Labels& labels, glm::ivec2 size, const Tile& tile, const Described& of, int more) {
    const bool is_even = of.settings.spacing == 2;  // fractional-even takes level 1 for 2
    const bool is_quad = of.surface.corners() == 4;
    const int each = is_quad ? (is_even ? 8 : 2) : (is_even ? 6 : 1);
    const size_t count = of.surface.patches().patches();
    if (more >= 0 && of.settings.cull != Settings::cull_none)
        labels.caption(size, tile, 0,
                       fmt::format("{:.0f} % of {} patches culled",
                                   100.0 * more / each / double(std::max<size_t>(1, count)), count));
    const auto add = [&](const std::string& text, glm::vec3 color, int row) {
        labels.legend(size, tile, text, color, row);
    };
    for (int octave = 0; octave < level_octaves; ++octave)  // the colours of surface.frag
        add(std::to_string(1 << octave), heat_color(0.24 + 0.73 * octave / (level_octaves - 1)), 1);
    if (of.settings.cull != Settings::cull_none) add("outside", outside_color, 0);
    if (of.settings.cull == Settings::cull_all && of.surface.is_one_sided()) add("facing away", away_color, 0);
    if (of.settings.fade) add("faded", faded_color, 0);
}

void describe_limits(Labels& labels, glm::ivec2 size, const Tile& tile, const Described& of, float most_level) {
    std::string limits;
    if (most_level < DisplacedSurface::finest_level) limits = fmt::format("levels up to {:.0f}", most_level);
    const int samples = densest_samples(of.surface.patches().patches());
    if (of.settings.method == Settings::by_error && samples < densest_samples(1))
        limits += fmt::format("{}errors from {} places a side", limits.empty() ? "" : ", ", samples);
    if (!limits.empty()) labels.caption(size, tile, 1, limits);
}

void SightLines::draw(const Camera& seen_by, const Camera& eye, double reach) {
    const Program& program = program_.with();
    glUseProgram(program);
    program.set("u_clip_from_world", seen_by.clip_from_world());
    program.set("u_places[0]", eye.eye());
    for (int i = 0; i < 4; ++i)
        program.set(fmt::format("u_places[{}]", i + 1).c_str(),
                    eye.eye() + reach * eye.ray({i == 0 || i == 3 ? -1 : 1, i < 2 ? -1 : 1}).direction);
    program.set("u_color", glm::vec4(0.85f, 0.92f, 1.0f, 0.55f));
    if (!no_corners_) no_corners_.emplace();
    glBindVertexArray(*no_corners_);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDrawArrays(GL_LINES, 0, 16);
    glDisable(GL_BLEND);
}

}  // namespace relief::adaptive
