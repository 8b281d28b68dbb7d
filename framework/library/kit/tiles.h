// A frame divided into a grid of smaller ones, to show methods side by side.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "framework/core/lab/lab.h"

namespace relief {

/// A part of a frame, in pixels from its lower left corner, as for glViewport.
struct Tile {
    glm::ivec2 corner, size;
    int foot = 0;  ///< height of the strip below the tile that has its captions; 0: they are over its picture
};

/// Returns tiles row by row from the top, each row from the left. Together they cover the frame but for its lowest
/// `below` pixels. A tile of a tiny frame may be empty.
inline std::vector<Tile> tile_grid(glm::ivec2 size, int columns, int rows, int below = 0) {
    size.y = std::max(0, size.y - below);
    std::vector<Tile> tiles;
    for (int row = rows - 1; row >= 0; --row)
        for (int column = 0; column < columns; ++column) {
            const glm::ivec2 begin(size.x * column / columns, size.y * row / rows);
            const glm::ivec2 end(size.x * (column + 1) / columns, size.y * (row + 1) / rows);
            tiles.push_back({begin + glm::ivec2(0, below), end - begin});
        }
    return tiles;
}

/// Returns `count` tiles, with the number of columns that makes them nearly square and leaves few places empty. A last
/// row with fewer tiles is in the middle. The lowest `below` pixels stay free.
inline std::vector<Tile> tiles_of(glm::ivec2 size, int count, int below = 0) {
    const int above = std::max(0, size.y - below);
    const auto rows = [&](int columns) { return (count + columns - 1) / columns; };
    const auto cost = [&](int columns) {
        const double wide = double(size.x) / columns, high = double(above) / rows(columns);
        return std::abs(std::log(wide / high)) + std::log(double(columns) * rows(columns) / count);
    };
    int columns = 1;
    for (int candidate = 2; candidate <= count; ++candidate)
        if (cost(candidate) < cost(columns)) columns = candidate;
    std::vector<Tile> tiles = tile_grid(size, columns, rows(columns), below);
    const int in_last_row = count - (rows(columns) - 1) * columns;
    tiles.resize(size_t(count));
    for (auto tile = tiles.end() - in_last_row; tile != tiles.end(); ++tile)
        tile->corner.x += size.x * (columns - in_last_row) / (2 * columns);
    return tiles;
}

/// Returns the frame of one tile: its size, and a camera with its aspect ratio. A tile that is higher than wide has the
/// horizontal field of view of a square one.
inline Frame frame_in(const Frame& frame, const Tile& tile) {
    Frame part = frame;
    part.size = tile.size;
    const double aspect = double(tile.size.x) / std::max(1, tile.size.y);
    Orbit orbit = frame.camera.orbit();
    if (aspect > 0 && aspect < 1)
        orbit.field_of_view = glm::degrees(2 * std::atan(std::tan(glm::radians(orbit.field_of_view) / 2) / aspect));
    part.camera = Camera(orbit, aspect);
    return part;
}

/// Returns a truth composed from the truths of the tiles, or nothing if one of them is missing.
inline std::optional<Image> truth_in_tiles(
    const Frame& frame, const std::vector<Tile>& tiles,
    const std::function<std::optional<Image>(const Frame&, size_t tile)>& truth) {
    Image whole(frame.size.x, frame.size.y, 4);
    std::fill(whole.values.begin(), whole.values.end(), no_surface);  // for pixels outside of all tiles
    for (size_t i = 0; i < tiles.size(); ++i) {
        const glm::ivec2 corner = tiles[i].corner, size = tiles[i].size;
        if (size.x <= 0 || size.y <= 0) continue;
        const std::optional<Image> part = truth(frame_in(frame, tiles[i]), i);
        if (!part) return {};
        for (int y = 0; y < size.y; ++y)
            std::copy_n(part->pixel(0, y), size_t(size.x) * 4,
                        whole.pixel(corner.x, frame.size.y - corner.y - size.y + y));
    }
    return whole;
}

}  // namespace relief
