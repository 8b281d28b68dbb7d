#include "captions.h"

#include <fmt/format.h>

#include <algorithm>

#include "surfaces.h"

namespace relief::materials {

void list_materials(Labels& labels, glm::ivec2 size, const Tile& tile, const Scene& scene, int highlight) {
    constexpr size_t most_listed = 12;
    const float left = float(tile.corner.x), width = float(tile.size.x),
                top = float(tile.size.y) + 0.03f * float(size.y),
                line = std::min(width / 17.5f, (float(size.y) - top) / (1.35f * float(most_listed + 2)));
    labels.rectangle({left, float(tile.size.y)}, {width, float(size.y - tile.size.y)}, {0.05f, 0.055f, 0.065f, 1});
    labels.text(fmt::format("{} materials, {} programs,", scene.pieces.size(), scene.programs), {left + line, top},
                line);
    labels.text(fmt::format("{} draws", scene.pieces.size()), {left + line, top + 1.25f * line}, line);
    labels.text("triangles", {left + width - line, top + 1.25f * line}, line, Align::right);
    for (size_t i = 0; i < std::min(scene.pieces.size(), most_listed); ++i) {
        const Piece& piece = scene.pieces[i];
        const float y = top + line * (2.9f + 1.3f * float(i));
        const glm::vec3 color = glm::pow(program_color(piece.program), glm::vec3(1 / 2.2f));
        labels.rectangle({left + line, y + 0.1f * line}, {0.8f * line, 0.8f * line}, glm::vec4(color, 1));
        labels.text(piece.material.name.substr(0, 12), {left + 2.4f * line, y}, line, Align::left,
                    highlight == int(i) + 1 ? glm::vec3(1, 0.85f, 0.4f) : glm::vec3(0.93f, 0.92f, 0.89f));
        labels.text(words(piece.features), {left + 8.6f * line, y}, line);
        labels.text(fmt::format("{}", piece.index_count / 3), {left + width - line, y}, line, Align::right);
    }
}

}  // namespace relief::materials
