// A mesh with known tangents, to test methods on.
#pragma once

#include <cmath>
#include <random>

#include "framework/core/base/mesh.h"

namespace relief {

/// Returns a torus (radii 1 and 0.4) with the exact dP/du at each vertex as its tangent. Vertices are jittered in uv,
/// and diagonals are random. It has `columns` x `rows` cells; the seam's vertices are doubled.
inline Mesh jittered_torus(int columns, int rows, unsigned seed, double jitter = 0.3) {
    std::mt19937 random(seed);
    const auto off = [&] { return std::uniform_real_distribution<double>(-jitter, jitter)(random); };
    std::vector<glm::dvec2> places(size_t(columns) * size_t(rows));
    for (glm::dvec2& place : places) place = {off() / columns, off() / rows};
    Mesh mesh;
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column) {
            const glm::dvec2 moved = places[size_t(row % rows * columns + column % columns)];
            const double u = double(column) / columns + moved.x, v = double(row) / rows + moved.y;
            const double a = 2 * M_PI * u, b = 2 * M_PI * v, r = 1 + 0.4 * std::cos(b);
            mesh.vertices.push_back({.position = {r * std::cos(a), r * std::sin(a), 0.4 * std::sin(b)},
                                     .normal = {std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b)},
                                     .tangent = {-std::sin(a), std::cos(a), 0, 1},
                                     .uv = {u, v}});
        }
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const uint32_t a = uint32_t(row * (columns + 1) + column), b = a + 1, c = a + uint32_t(columns) + 1,
                           d = c + 1;
            if (random() % 2)
                mesh.indices.insert(mesh.indices.end(), {a, b, d, a, d, c});
            else
                mesh.indices.insert(mesh.indices.end(), {a, b, c, b, d, c});
        }
    return mesh;
}

}  // namespace relief
