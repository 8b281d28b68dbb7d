#include "shapes.h"

#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "framework/core/base/paths.h"
#include "framework/library/mesh/obj.h"

namespace relief::basis {
namespace {

constexpr double pi = glm::pi<double>();

/// Returns the place of a surface of revolution about y, at an angle from +z towards +x. `profile` is the radius and
/// the height, `slope` their derivatives along v.
Place revolved(double angle, glm::dvec2 profile, glm::dvec2 slope) {
    const glm::dvec3 out(std::sin(angle), 0, std::cos(angle)), east(std::cos(angle), 0, -std::sin(angle));
    const glm::dvec2 direction = glm::length(slope) > 0 ? glm::normalize(slope) : glm::dvec2(0, 1);
    return {
        profile.x * out + glm::dvec3(0, profile.y, 0), direction.y * out - glm::dvec3(0, direction.x, 0), {east, 1}};
}

Place on_box(glm::dvec2 uv) {
    const int face = std::min(int(uv.x * 6), 5);
    const double s = (uv.x * 6 - face) * 2 - 1, t = uv.y * 2 - 1;
    constexpr glm::dvec3 normals[] = {{0, 0, 1}, {1, 0, 0}, {0, 0, -1}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
    const glm::dvec3 normal = normals[face];
    const glm::dvec3 tangent = face < 4 ? glm::cross(glm::dvec3(0, 1, 0), normal) : glm::dvec3(1, 0, 0);
    return {box_half * (normal + s * tangent + t * glm::cross(normal, tangent)), normal, {tangent, 1}};
}

/// Returns a pseudo-random number in [-1, 1], a hash of a and b.
double dice(uint32_t a, uint32_t b) {
    uint32_t bits = a * 2654435769u ^ (b + 0x9e37u) * 2246822519u;
    bits ^= bits >> 15, bits *= 0x85ebca6bu, bits ^= bits >> 13, bits *= 0xc2b2ae35u, bits ^= bits >> 16;
    return double(bits) / 2147483648.0 - 1;
}

/// Returns the urn, read from its file. The places of its vertices are their uv.
CoarseMesh read_urn() {
    CoarseMesh result{read_obj(course_root() / "assets" / "urn.obj").mesh, {}};
    for (Vertex& vertex : result.mesh.vertices) {
        result.places.emplace_back(vertex.uv);
        const double angle = 2 * pi * double(vertex.uv.x);
        vertex.tangent = glm::vec4(std::cos(angle), 0, -std::sin(angle), 1);
    }
    return result;
}

}  // namespace

Place place_on(Shape shape, glm::dvec2 uv, double shear) {
    const double around = 2 * pi * uv.x, up = pi * (uv.y - 0.5);
    switch (shape) {
        case Shape::quad:
            return {{(uv.x - 0.5) * 2, (uv.y - 0.5) * 2, 0}, {0, 0, 1}, {glm::normalize(glm::dvec3(1, -shear, 0)), 1}};
        case Shape::box:
            return on_box(uv);
        case Shape::cylinder:
        case Shape::urn:  // has the tangents of any surface of revolution
            return revolved(around, {0.6, (uv.y - 0.5) * 1.7}, {0, 1});
        case Shape::sphere:
            return revolved(around, 0.95 * glm::dvec2(std::cos(up), std::sin(up)), {-std::sin(up), std::cos(up)});
        case Shape::mirrored: {
            Place place = place_on(Shape::sphere, uv, 0);
            if (uv.x < 0.5) place.tangent = -place.tangent;  // u grows to the left, so the frame is left-handed
            return place;
        }
        case Shape::torus:
        case Shape::own:
            break;
    }
    const double tube = 2 * pi * uv.y;
    return revolved(around, {0.72 - 0.34 * std::cos(tube), -0.34 * std::sin(tube)}, {std::sin(tube), -std::cos(tube)});
}

CoarseMesh coarse_mesh(Shape shape, int columns, int rows, double jitter, double shear) {
    if (shape == Shape::urn) return read_urn();
    CoarseMesh result;
    const int across = shape == Shape::box ? 6 * std::max(1, columns / 6) : columns;
    const int part = shape == Shape::box ? across / 6 : across;  // columns that share vertices
    const auto add = [&](int column, int row, int first) {
        glm::dvec2 place(double(column) / across, double(row) / rows);
        const bool inner = column > first && column < first + part && row > 0 && row < rows;
        // Vertices on the mirror line do not move across it.
        const bool on_mirror = shape == Shape::mirrored && 2 * column == across;
        if (inner)
            place += jitter * 0.33 / glm::dvec2(across, rows) *
                     glm::dvec2(on_mirror ? 0 : dice(uint32_t(column), uint32_t(row)),
                                dice(uint32_t(row), uint32_t(column + 977)));
        // A place on the edge of a box is clamped to this face.
        glm::dvec2 inside = place;
        if (shape == Shape::box)
            inside.x = glm::clamp(place.x, (first + 1e-9) / across, (first + part - 1e-9) / across);
        const Place point = place_on(shape, inside, shear);
        glm::dvec2 uv = place;
        if (shape == Shape::box) uv.x = place.x * 6 - double(first / part);
        if (shape == Shape::mirrored) uv.x = std::abs(2 * place.x - 1);
        if (shape == Shape::quad) uv.y += shear * place.x;
        result.mesh.vertices.push_back(
            {glm::vec3(point.position), glm::vec3(point.normal), glm::vec4(point.tangent), glm::vec2(uv)});
        result.places.push_back(inside);
    };
    for (int first = 0; first < across; first += part) {
        const uint32_t begin = uint32_t(result.mesh.vertices.size());
        for (int row = 0; row <= rows; ++row)
            for (int column = first; column <= first + part; ++column) add(column, row, first);
        for (int row = 0; row < rows; ++row)
            for (int column = 0; column < part; ++column) {
                const uint32_t a = begin + uint32_t(row * (part + 1) + column), b = a + 1, c = a + uint32_t(part) + 1,
                               d = c + 1;
                const bool other = jitter > 0 && dice(a, 31) > 0;
                for (const uint32_t i : other ? std::array{a, b, c, b, d, c} : std::array{a, b, d, a, d, c})
                    result.mesh.indices.push_back(i);
            }
    }
    return result;
}

}  // namespace relief::basis
