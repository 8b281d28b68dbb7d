// Tangents of a million triangles: time by method and threads, error against dP/du.
#include <cmath>
#include <memory>
#include <random>

#include "framework/base/parallel.h"
#include "framework/measure/topics.h"
#include "framework/mesh/tangents.h"

namespace relief {
namespace {

struct Work {
    Mesh mesh;
    std::vector<glm::vec4> tangents;
};

/// A torus of places that are jittered by up to 0.3 cells, diagonals by chance, with the exact dP/du as its tangents.
Mesh jittered_torus(int columns, int rows) {
    std::mt19937 random(1);
    std::uniform_real_distribution<> off(-0.3, 0.3);
    std::vector<glm::dvec2> moved(size_t(columns) * size_t(rows));
    for (glm::dvec2& one : moved) one = {off(random) / columns, off(random) / rows};
    Mesh mesh;
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column) {
            const glm::dvec2 uv = glm::dvec2(double(column) / columns, double(row) / rows) +
                                  moved[size_t(row % rows) * size_t(columns) + size_t(column % columns)];
            const double a = 2 * M_PI * uv.x, b = 2 * M_PI * uv.y, r = 1 + 0.4 * std::cos(b);
            mesh.vertices.push_back({.position = {r * std::cos(a), r * std::sin(a), 0.4 * std::sin(b)},
                                     .normal = {std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b)},
                                     .tangent = {-std::sin(a), std::cos(a), 0, 1},
                                     .uv = uv});
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

/// On a coarse mesh, where it shows: 4096 triangles.
BenchError error_of(TangentMethod method) {
    const Mesh mesh = jittered_torus(64, 32);
    const std::vector<glm::vec4> tangents = corner_tangents(mesh, method);
    std::vector<double> errors;
    for (size_t i = 0; i < tangents.size(); ++i) {
        const glm::dvec3 measured(tangents[i]), exact(mesh.vertices[mesh.indices[i]].tangent);
        errors.push_back(glm::degrees(std::atan2(glm::length(glm::cross(measured, exact)), glm::dot(measured, exact))));
    }
    return error_figures(std::move(errors), "degree");
}

std::vector<BenchMethod> methods(const BenchSettings& settings) {
    const auto work = std::make_shared<Work>();
    work->mesh = settings.quick ? jittered_torus(250, 100) : jittered_torus(1000, 500);
    const std::pair<const char*, TangentMethod> kinds[] = {{"per-face", TangentMethod::per_face},
                                                           {"uniform", TangentMethod::uniform},
                                                           {"area", TangentMethod::area},
                                                           {"angle", TangentMethod::angle},
                                                           {"mikktspace", TangentMethod::mikktspace}};
    std::vector<BenchMethod> result;
    for (const auto& [name, kind] : kinds)
        for (unsigned threads = 1; threads <= std::min(2u, hardware_threads()); ++threads)
            result.push_back(
                {.name = name,
                 .knobs = {{"threads", std::to_string(threads)}},
                 .items = work->mesh.indices.size() / 3,
                 .item = "triangle",
                 .run = [work, threads,
                         method = kind] { corner_tangents(work->mesh, method, work->tangents, nullptr, threads); },
                 .error = error_of(kind)});
    return result;
}

}  // namespace

BenchTopic tangents_topic() {
    return {"tangents", "tangents of a million triangles; errors on a jittered torus of 4096", methods};
}

}  // namespace relief
