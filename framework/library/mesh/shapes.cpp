#include "framework/library/mesh/shapes.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace relief {
namespace {

/// A point of a patch. u and v are in [0, 1]; s and t are the same in [-1, 1], and exactly opposite at opposite points.
struct GridPlace {
    double u, v, s, t;
};

/// Below 1e18, sums and squared lengths stay finite in float, too.
double extent(float size) { return std::isfinite(size) ? std::min(std::abs(size), 1e18f) : 0; }

int count_of(int count, int min) { return std::clamp(count, min, 4096); }

/// Appends a grid of (columns + 1) x (rows + 1) vertices; `vertex` returns the surface at a point.
template <class Surface>
void add_patch(Mesh& mesh, int columns, int rows, glm::vec2 repeat, Surface vertex) {
    columns = count_of(columns, 1), rows = count_of(rows, 1);
    repeat = {extent(repeat.x), extent(repeat.y)};
    const auto first = static_cast<uint32_t>(mesh.vertices.size());
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column) {
            const GridPlace place{.u = double(column) / columns,
                                  .v = double(row) / rows,
                                  .s = double(2 * column - columns) / columns,
                                  .t = double(2 * row - rows) / rows};
            Vertex corner = vertex(place);
            corner.uv = glm::vec2(place.u, place.v) * repeat;
            mesh.vertices.push_back(corner);
        }
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const uint32_t a = first + row * (columns + 1) + column, b = a + 1, c = a + columns + 1, d = c + 1;
            mesh.indices.insert(mesh.indices.end(), {a, b, d, a, d, c});
        }
}

template <class Surface>
Mesh make_patch(int columns, int rows, glm::vec2 repeat, Surface vertex) {
    Mesh mesh;
    add_patch(mesh, columns, rows, repeat, vertex);
    return mesh;
}

constexpr CubeFace cube_faces[] = {
    {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}}, {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}},
    {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}, {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},  {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}},
};

/// Puts the last column exactly on the first one: sin(2 pi) is not 0 in floating point.
double once_around(double u) { return u < 1 ? u : 0; }

}  // namespace

Mesh make_quad(const QuadShape& shape) {
    const double width = extent(shape.width), height = extent(shape.height);
    return make_patch(shape.columns, shape.rows, shape.repeat, [&](const GridPlace& at) {
        return Vertex{.position = {(at.u - 0.5) * width, (at.v - 0.5) * height, 0},
                      .normal = {0, 0, 1},
                      .tangent = {1, 0, 0, 1},
                      .uv = {}};
    });
}

Mesh make_grid(const GridShape& shape) {
    const double width = extent(shape.width), depth = extent(shape.depth);
    return make_patch(shape.columns, shape.rows, shape.repeat, [&](const GridPlace& at) {
        return Vertex{.position = {at.s / 2 * width, 0, -at.t / 2 * depth},
                      .normal = {0, 1, 0},
                      .tangent = {1, 0, 0, 1},
                      .uv = {}};
    });
}

Mesh make_box(const BoxShape& shape) {
    const glm::dvec3 half = glm::dvec3(extent(shape.size.x), extent(shape.size.y), extent(shape.size.z)) / 2.0;
    const glm::dvec3 cells(shape.cells);
    Mesh mesh;
    for (const CubeFace& face : cube_faces) {
        const double columns = glm::dot(cells, glm::abs(face.right)), rows = glm::dot(cells, glm::abs(face.up));
        add_patch(mesh, int(columns), int(rows), shape.repeat, [&](const GridPlace& at) {
            return Vertex{.position = half * (face.normal + at.s * face.right + at.t * face.up),
                          .normal = face.normal,
                          .tangent = glm::dvec4(face.right, 1),
                          .uv = {}};
        });
    }
    return mesh;
}

Mesh make_column(const ColumnShape& shape) {
    const double bottom = extent(shape.bottom_radius), top = extent(shape.top_radius), height = extent(shape.height);
    return make_patch(count_of(shape.sides, 3), shape.rows, shape.repeat, [&](const GridPlace& at) {
        const double angle = glm::two_pi<double>() * once_around(at.u), s = std::sin(angle), c = std::cos(angle);
        const double radius = glm::mix<double>(bottom, top, at.v), taper = top - bottom;
        // dP/du points along (c, 0, -s), dP/dv along (taper s, height, taper c); the normal is their cross product.
        const glm::dvec3 across(height * s, -taper, height * c);
        const bool is_a_line = height == 0 && taper == 0;
        return Vertex{.position = {radius * s, at.v * height, radius * c},
                      .normal = is_a_line ? glm::dvec3(s, 0, c) : glm::normalize(across),
                      .tangent = {c, 0, -s, 1},
                      .uv = {}};
    });
}

Mesh make_sphere(const SphereShape& shape) {
    const double radius = extent(shape.radius);
    return make_patch(count_of(shape.sides, 3), count_of(shape.rows, 2), shape.repeat, [&](const GridPlace& at) {
        const double around = glm::two_pi<double>() * (once_around(at.u) - 0.5), up = glm::pi<double>() * (at.v - 0.5);
        const glm::dvec3 out(std::sin(around) * std::cos(up), std::sin(up), std::cos(around) * std::cos(up));
        return Vertex{
            .position = radius * out, .normal = out, .tangent = {std::cos(around), 0, -std::sin(around), 1}, .uv = {}};
    });
}

const CubeFace& cube_face(int face) { return cube_faces[face]; }

glm::dvec3 cube_sphere_direction(int index, double s, double t) {
    // tan(pi / 4) is not 1 in floating point, but the faces must meet exactly in their edges.
    const auto equal_angle = [](double x) { return std::abs(x) == 1 ? x : std::tan(glm::quarter_pi<double>() * x); };
    const CubeFace& face = cube_faces[index];
    return glm::normalize(face.normal + equal_angle(s) * face.right + equal_angle(t) * face.up);
}

Mesh make_cube_sphere(const CubeSphereShape& shape) {
    const double radius = extent(shape.radius);
    Mesh mesh;
    for (int index = 0; index < 6; ++index) {
        const CubeFace& face = cube_faces[index];
        add_patch(mesh, shape.cells, shape.cells, shape.repeat, [&](const GridPlace& at) {
            const glm::dvec3 out = cube_sphere_direction(index, at.s, at.t);
            // On the cube, the point moves along `right` with u. The part along `out` does not move it on the sphere.
            const glm::dvec3 along_u = glm::normalize(face.right - out * glm::dot(out, face.right));
            return Vertex{.position = radius * out, .normal = out, .tangent = glm::dvec4(along_u, 1), .uv = {}};
        });
    }
    return mesh;
}

Mesh make_torus(const TorusShape& shape) {
    const double ring = extent(shape.ring_radius), tube = std::min(extent(shape.tube_radius), ring);
    return make_patch(count_of(shape.sides, 3), count_of(shape.rows, 3), shape.repeat, [&](const GridPlace& at) {
        const double around = glm::two_pi<double>() * (once_around(at.u) - 0.5);
        const double up = glm::two_pi<double>() * (once_around(at.v) - 0.5);
        const glm::dvec3 out(std::sin(around) * std::cos(up), std::sin(up), std::cos(around) * std::cos(up));
        const glm::dvec3 centre(ring * std::sin(around), 0, ring * std::cos(around));
        return Vertex{.position = centre + tube * out,
                      .normal = out,
                      .tangent = {std::cos(around), 0, -std::sin(around), 1},
                      .uv = {}};
    });
}

}  // namespace relief
