#include "captions.h"

#include <fmt/format.h>

#include <algorithm>

#include "surfaces.h"

namespace relief::materials {

void list_materials(Labels& labels, glm::ivec2 size, const Tile& tile, const Scene& scene, int highlight) {
    constexpr size_t most_listed = 12;
    // A narrow panel has names alone: letters stay legible.
    constexpr float whole_table = 17.5f;  // width in lines
    const float left = float(tile.corner.x), width = float(tile.size.x),
                top = float(tile.size.y) + 0.03f * float(size.y),
                line =
                    std::max(Labels::letters(size).least,
                             std::min(width / whole_table, (float(size.y) - top) / (1.35f * float(most_listed + 2))));
    const bool has_columns = width >= whole_table * line, has_heading = width >= 8 * line;
    labels.rectangle({left, float(tile.size.y)}, {width, float(size.y - tile.size.y)}, {0.05f, 0.055f, 0.065f, 1});
    const auto heading = [&](int row, const std::string& text) {
        labels.text(text, {left + line, top + 1.25f * line * float(row)}, line);
    };
    if (has_columns) {
        heading(0, fmt::format("{} materials, {} programs,", scene.pieces.size(), scene.programs));
        heading(1, fmt::format("{} draws", scene.pieces.size()));
        labels.text("triangles", {left + width - line, top + 1.25f * line}, line, Align::right);
    } else if (has_heading) {
        heading(0, fmt::format("{} materials,", scene.pieces.size()));
        heading(1, fmt::format("{} programs", scene.programs));
    }
    for (size_t i = 0; i < std::min(scene.pieces.size(), most_listed); ++i) {
        const Piece& piece = scene.pieces[i];
        const float y = top + line * (2.9f + 1.3f * float(i)), edge = has_columns ? line : 0.5f * line;
        const glm::vec3 color = glm::pow(program_color(piece.program), glm::vec3(1 / 2.2f));
        labels.rectangle({left + edge, y + 0.1f * line}, {0.8f * line, 0.8f * line}, glm::vec4(color, 1));
        const auto letters = size_t(std::clamp(2 * (width / line - 2.5f), 0.0f, 12.0f));
        labels.text(piece.material.name.substr(0, letters), {left + edge + 1.4f * line, y}, line, Align::left,
                    highlight == int(i) + 1 ? glm::vec3(1, 0.85f, 0.4f) : glm::vec3(0.93f, 0.92f, 0.89f));
        if (!has_columns) continue;
        labels.text(words(piece.features), {left + 8.6f * line, y}, line);
        labels.text(fmt::format("{}", piece.index_count / 3), {left + width - line, y}, line, Align::right);
    }
}

}  // namespace relief::materials
