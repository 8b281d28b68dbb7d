// Rays aimed at the edges of a mesh, where searches lose some.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "framework/core/base/ray.h"
#include "framework/library/mesh/shapes.h"
#include "framework/staff/measure/bench.h"

namespace relief::measure {

/// Rays from inside a sphere of radius 1 to points on its mesh's edges and vertices. Each ray hits at t = 1 unless it
/// slips through. The sphere's centre lies at (away, away, away), where its vertices are rounded to floats.
struct RaysThroughEdges {
    Mesh mesh;
    std::vector<Ray> rays;

    RaysThroughEdges(int cells, size_t count, double away = 0) : mesh(make_cube_sphere({.radius = 1, .cells = cells})) {
        for (Vertex& vertex : mesh.vertices) vertex.position = glm::vec3(glm::dvec3(vertex.position) + away);
        std::mt19937 random(7);
        std::uniform_real_distribution<> share(0, 1), inside(-0.4, 0.4);
        for (size_t i = 0; i < count; ++i) {
            const size_t triangle = random() % (mesh.indices.size() / 3) * 3, corner = random() % 3;
            const auto place = [&](size_t k) {
                return glm::dvec3(mesh.vertices[mesh.indices[triangle + k % 3]].position);
            };
            const glm::dvec3 to = glm::mix(place(corner), place(corner + 1), i % 4 ? share(random) : 0.0);
            const glm::dvec3 from(away + inside(random), away + inside(random), away + inside(random));
            rays.push_back({from, to - from});
        }
    }

    /// Returns the error in metres; the error of a lost ray (t < 0) is its length.
    BenchError error_of(const std::vector<double>& hits) const {
        std::vector<double> errors;
        double lost = 0;
        for (size_t i = 0; i < rays.size(); ++i) {
            errors.push_back(glm::length(rays[i].direction) * std::abs(hits[i] < 0 ? 1 : hits[i] - 1));
            lost += hits[i] < 0;
        }
        BenchError error = error_figures(std::move(errors), "metre");
        error.wrong = lost / double(rays.size());
        return error;
    }
};

}  // namespace relief::measure
