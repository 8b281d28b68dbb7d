// Meshes for testing tangents.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "framework/staff/reference/degrees.h"
#include "framework/staff/reference/jittered_torus.h"
#include "framework/staff/reference/mikktspace.h"

namespace relief {

/// Returns a vertex that faces +z.
inline Vertex flat_vertex(glm::vec2 at, glm::vec2 uv) {
    return {.position = {at, 0}, .normal = {0, 0, 1}, .tangent = {}, .uv = uv};
}

/// Returns a flat grid around x = 0 with uv mirrored there, u = |x|. With an odd number of columns, the mirror runs
/// through the middle one, whose triangles have no area in uv.
inline Mesh mirrored_grid(int columns, int rows) {
    Mesh mesh;
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column) {
            const float x = float(column) - 0.5f * float(columns);
            mesh.vertices.push_back(flat_vertex({x, row}, {std::abs(x), row}));
        }
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const uint32_t a = uint32_t(row * (columns + 1) + column), b = a + 1, c = a + uint32_t(columns) + 1,
                           d = c + 1;
            mesh.indices.insert(mesh.indices.end(), {a, b, d, a, d, c});
        }
    return mesh;
}

/// Returns a torus with uv rounded to a coarse grid and mirrored, so that many triangles have no area in uv.
inline Mesh torus_with_rounded_uv(unsigned seed) {
    Mesh mesh = jittered_torus(14, 9, seed);
    for (Vertex& vertex : mesh.vertices) {
        vertex.uv = glm::round(vertex.uv * 6.0f) / 6.0f;
        if (vertex.uv.x > 0.5f) vertex.uv.x = 1 - vertex.uv.x;
    }
    return mesh;
}

/// Returns random triangles of a few positions, normals and uv: with shared edges, mirrored neighbours, edges of three
/// triangles, two equal corners, and uv on a line.
inline Mesh random_soup(unsigned seed, int triangles) {
    std::mt19937 random(seed);
    const auto between = [&](float low, float high) {
        return std::uniform_real_distribution<float>(low, high)(random);
    };
    Mesh mesh;
    for (int i = 0; i < 14; ++i) {
        const glm::vec2 at(between(-1, 1), between(-1, 1));
        const glm::vec3 normal = glm::normalize(glm::vec3(between(-0.5f, 0.5f), between(-0.5f, 0.5f), 1));
        mesh.vertices.push_back({{at, between(-0.2f, 0.2f)}, normal, {}, {between(-1, 1), between(-1, 1)}});
    }
    mesh.vertices.push_back(mesh.vertices[0]);  // the same vertex twice
    mesh.vertices.push_back(mesh.vertices[1]);  // the same position with another uv
    mesh.vertices.back().uv.x += 0.5f;
    mesh.vertices[2].uv = mesh.vertices[3].uv = mesh.vertices[4].uv;  // triangles without area in uv
    for (int i = 0; i < 3 * triangles; ++i) mesh.indices.push_back(uint32_t(random() % mesh.vertices.size()));
    return mesh;
}

/// Expects at each corner of a mesh the tangent of MikkTSpace's published text, where it has one.
inline void expect_mikktspace(const std::vector<glm::vec4>& found, const Mesh& mesh) {
    const std::vector<glm::dvec4> wanted = mikktspace_reference(mesh);
    ASSERT_EQ(found.size(), wanted.size());
    for (size_t i = 0; i < wanted.size(); ++i) {
        if (glm::dvec3(wanted[i]) == glm::dvec3(0)) continue;
        ASSERT_LT(degrees_between(glm::dvec3(found[i]), glm::dvec3(wanted[i])), 0.01) << "corner " << i;
        ASSERT_EQ(found[i].w, wanted[i].w) << "corner " << i;
    }
}

}  // namespace relief
