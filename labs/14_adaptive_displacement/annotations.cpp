#include "annotations.h"

#include <fmt/format.h>

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

void add_legend(Labels& labels, glm::ivec2 size, const Tile& tile, const std::vector<std::vector<LegendEntry>>& rows) {
    const float line = std::min(Labels::line_height(size) * 0.75f, 0.06f * float(tile.size.y)), gap = line * 0.25f;
    glm::vec2 place(0, float(size.y - tile.corner.y));
    for (const auto& row : rows) {
        place = {float(tile.corner.x) + gap * 2, place.y - line - gap};
        for (const auto& [text, color] : row) {
            labels.rectangle(place, {line, line}, glm::vec4(color, 1));
            labels.text(text, place + glm::vec2(line * 1.25f, 0), line);
            place.x += line * 1.75f + Labels::width(text, line);
        }
    }
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
