#include "framework/mesh/shapes.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace relief {
namespace {

/// A grid of (columns + 1) x (rows + 1) vertices over (u, v) in [0, 1]²; `vertex` gives the surface at a place.
template <class Surface>
Mesh make_patch(int columns, int rows, glm::vec2 repeat, Surface vertex) {
    columns = std::max(1, columns), rows = std::max(1, rows);
    Mesh mesh;
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column) {
            const double u = double(column) / columns, v = double(row) / rows;
            Vertex corner = vertex(u, v);
            corner.uv = glm::vec2(u, v) * repeat;
            mesh.vertices.push_back(corner);
        }
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const uint32_t a = row * (columns + 1) + column, b = a + 1, c = a + columns + 1, d = c + 1;
            mesh.indices.insert(mesh.indices.end(), {a, b, d, a, d, c});
        }
    return mesh;
}

/// The last column lies on the first to the last bit: sin(2 pi) is not 0 in floating point.
double once_around(double u) { return u < 1 ? u : 0; }

}  // namespace

Mesh make_quad(const QuadShape& shape) {
    return make_patch(shape.columns, shape.rows, shape.repeat, [&](double u, double v) {
        return Vertex{.position = {(u - 0.5) * shape.width, (v - 0.5) * shape.height, 0},
                      .normal = {0, 0, 1},
                      .tangent = {1, 0, 0, 1},
                      .uv = {}};
    });
}

Mesh make_column(const ColumnShape& shape) {
    return make_patch(std::max(3, shape.sides), shape.rows, shape.repeat, [&](double u, double v) {
        const double angle = glm::two_pi<double>() * once_around(u), s = std::sin(angle), c = std::cos(angle);
        const double radius = glm::mix<double>(shape.bottom_radius, shape.top_radius, v);
        const double taper = double(shape.top_radius) - shape.bottom_radius;
        // dP/du points along (c, 0, -s), dP/dv along (taper s, height, taper c); the normal is their cross product.
        const glm::dvec3 across(shape.height * s, -taper, shape.height * c);
        const bool is_a_line = shape.height == 0 && taper == 0;
        return Vertex{.position = {radius * s, v * shape.height, radius * c},
                      .normal = is_a_line ? glm::dvec3(s, 0, c) : glm::normalize(across),
                      .tangent = {c, 0, -s, 1},
                      .uv = {}};
    });
}

Mesh make_sphere(const SphereShape& shape) {
    return make_patch(std::max(3, shape.sides), std::max(2, shape.rows), shape.repeat, [&](double u, double v) {
        const double around = glm::two_pi<double>() * (once_around(u) - 0.5), up = glm::pi<double>() * (v - 0.5);
        const glm::dvec3 out(std::sin(around) * std::cos(up), std::sin(up), std::cos(around) * std::cos(up));
        return Vertex{.position = double(shape.radius) * out,
                      .normal = out,
                      .tangent = {std::cos(around), 0, -std::sin(around), 1},
                      .uv = {}};
    });
}

}  // namespace relief
