#include "line_drawing.h"

#include <algorithm>

namespace relief {

/// Returns two triangles for each line.
std::vector<LineDrawing::Corner> LineDrawing::corners_of(glm::vec2 size, const std::vector<DrawnLine>& lines) {
    glm::vec2 low(INFINITY), high(-INFINITY);
    for (const DrawnLine& line : lines)
        low = glm::min(low, glm::min(line.from, line.to)), high = glm::max(high, glm::max(line.from, line.to));
    const glm::vec2 extent = glm::max(high - low, 1e-6f);
    const float scale = 0.84f * std::min(size.x / extent.x, size.y / extent.y);
    const float line_width = std::max(1.0f, 0.003f * std::min(size.x, size.y));
    std::vector<Corner> corners;
    for (const DrawnLine& line : lines) {
        const glm::vec2 a = (line.from - (low + high) / 2.0f) * scale, b = (line.to - (low + high) / 2.0f) * scale;
        const float length = glm::length(b - a);
        if (!(length > 0)) continue;
        const glm::vec2 aside = glm::vec2(a.y - b.y, b.x - a.x) / length * (0.5f * line_width * line.width);
        for (const glm::vec2 place : {a - aside, b - aside, b + aside, a - aside, b + aside, a + aside})
            corners.push_back({place / size * 2.0f, glm::vec4(line.color, 1)});
    }
    return corners;
}

void LineDrawing::draw(const Tile& tile, const std::vector<DrawnLine>& lines) {
    const std::vector<Corner> corners = corners_of(tile.size, lines);
    if (corners.empty()) return;
    corners_.fill<Corner>(corners);
    if (!layout_) corners_.attach(layout_.emplace());
    glViewport(tile.corner.x, tile.corner.y, tile.size.x, tile.size.y);
    glUseProgram(program_.with());
    const bool tests_depth = glIsEnabled(GL_DEPTH_TEST);
    glDisable(GL_DEPTH_TEST);
    glBindVertexArray(*layout_);
    glDrawArrays(GL_TRIANGLES, 0, corners_.count());
    if (tests_depth) glEnable(GL_DEPTH_TEST);
}

}  // namespace relief
