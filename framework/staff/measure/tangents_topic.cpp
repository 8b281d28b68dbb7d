// Tangents of a million triangles: time by method and threads, and the error against dP/du.
#include "framework/staff/measure/tangents_topic.h"

#include <cmath>
#include <memory>

#include "framework/core/base/parallel.h"
#include "framework/library/mesh/tangents.h"
#include "framework/staff/measure/bench.h"
#include "framework/staff/measure/peers.h"
#include "framework/staff/measure/usual.h"
#include "framework/staff/reference/degrees.h"
#include "framework/staff/reference/jittered_torus.h"

namespace relief::measure {

Mesh bench_torus(int columns, int rows) { return jittered_torus(columns, rows, 1, 0.24); }

namespace {

/// A coarse mesh of 4096 triangles, on which errors are large enough to measure.
Mesh error_mesh() { return bench_torus(64, 32); }

/// Returns the error of a tangent for each corner of error_mesh().
BenchError error_of(const std::vector<glm::vec4>& tangents) {
    const Mesh mesh = error_mesh();
    std::vector<double> errors;
    for (size_t i = 0; i < tangents.size(); ++i) {
        const glm::dvec3 measured(tangents[i]), exact(mesh.vertices[mesh.indices[i]].tangent);
        errors.push_back(degrees_between(measured, exact));
    }
    return error_figures(std::move(errors), "degree");
}

struct Work {
    bool quick;
    Mesh mesh;
    std::vector<glm::vec4> tangents;
    std::vector<glm::vec3> sums;
    void make() {
        if (mesh.vertices.empty()) mesh = quick ? bench_torus(250, 100) : bench_torus(1000, 500);
    }
    size_t triangles() const { return mesh.indices.size() / 3; }
};

std::vector<BenchScene> tangents_scenes(const BenchSettings& settings) {
    const auto work = std::make_shared<Work>();
    work->quick = settings.quick;
    const std::pair<const char*, TangentMethod> kinds[] = {{"per-face", TangentMethod::per_face},
                                                           {"uniform", TangentMethod::uniform},
                                                           {"area", TangentMethod::area},
                                                           {"angle", TangentMethod::angle},
                                                           {"mikktspace", TangentMethod::mikktspace}};
    BenchScene scene{{}, "triangle"};
    for (const auto& [name, kind] : kinds)
        for (unsigned threads = 1; threads <= std::min(2u, hardware_threads()); ++threads)
            scene.methods.push_back(
                {name, {{"threads", std::to_string(threads)}}, [work, threads, method = kind] {
                     work->make();
                     return BenchSubject{
                         .items = work->triangles(),
                         .error = error_of(corner_tangents(error_mesh(), method)),
                         .run = [=] { corner_tangents(work->mesh, method, work->tangents, nullptr, threads); },
                         .is_parallel = threads > 1};
                 }});
    const auto usual = [work] {
        work->make();
        const Mesh mesh = error_mesh();
        std::vector<glm::vec4> at_vertices, at_corners;
        usual_tangents(mesh, work->sums, at_vertices);
        for (const uint32_t index : mesh.indices) at_corners.push_back(at_vertices[index]);
        return BenchSubject{.items = work->triangles(), .error = error_of(at_corners), .run = [work] {
                                usual_tangents(work->mesh, work->sums, work->tangents);
                            }};
    };
    scene.methods.push_back({"usual", {{"threads", "1"}}, usual, true});
    if (has_peers())
        scene.methods.push_back(
            {"Assimp",
             {{"threads", "1"}},
             [work] {
                 work->make();
                 const auto peer = assimp_tangents(error_mesh());
                 peer->run();
                 const BenchError error = error_of(peer->tangents());
                 return BenchSubject{.items = work->triangles(),
                                     .error = error,
                                     .run = [timed = std::shared_ptr(assimp_tangents(work->mesh))] { timed->run(); }};
             },
             true});
    return {scene};
}

}  // namespace

const TopicRegistration tangents_topic({.name = "tangents",
                                        .help = "tangents of a million triangles; errors on a jittered torus of 4096",
                                        .question = "Which tangents are right, and how long do they take?",
                                        .scenes = tangents_scenes,
                                        .labs = {"05"}});

}  // namespace relief::measure
