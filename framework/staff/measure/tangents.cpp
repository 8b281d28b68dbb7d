// Tangents of a million triangles: time by method and threads, error against dP/du.
#include <cmath>
#include <memory>

#include "framework/base/parallel.h"
#include "framework/staff/measure/peers.h"
#include "framework/staff/measure/topics.h"
#include "framework/staff/reference/jittered_torus.h"
#include "framework/staff/reference/tangents.h"

namespace relief {

Mesh bench_torus(int columns, int rows) { return jittered_torus(columns, rows, 1, 0.24); }

namespace {

/// A coarse mesh, on which errors show: 4096 triangles.
Mesh error_mesh() { return bench_torus(64, 32); }

/// Of a tangent for each corner of error_mesh().
BenchError error_of(const std::vector<glm::vec4>& tangents) {
    const Mesh mesh = error_mesh();
    std::vector<double> errors;
    for (size_t i = 0; i < tangents.size(); ++i) {
        const glm::dvec3 measured(tangents[i]), exact(mesh.vertices[mesh.indices[i]].tangent);
        errors.push_back(glm::degrees(std::atan2(glm::length(glm::cross(measured, exact)), glm::dot(measured, exact))));
    }
    return error_figures(std::move(errors), "degree");
}

/// The code that is commonly copied (Lengyel 2001): sums at the vertices, then Gram-Schmidt.
void usual_tangents(const Mesh& mesh, std::vector<glm::vec3>& sums, std::vector<glm::vec4>& tangents) {
    const size_t count = mesh.vertices.size();
    sums.assign(2 * count, glm::vec3(0));
    tangents.resize(count);
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vertex &a = mesh.vertices[mesh.indices[i]], &b = mesh.vertices[mesh.indices[i + 1]],
                     &c = mesh.vertices[mesh.indices[i + 2]];
        const glm::vec3 edge1 = b.position - a.position, edge2 = c.position - a.position;
        const glm::vec2 uv1 = b.uv - a.uv, uv2 = c.uv - a.uv;
        const float r = 1 / (uv1.x * uv2.y - uv2.x * uv1.y);
        const glm::vec3 along_u = (edge1 * uv2.y - edge2 * uv1.y) * r, along_v = (edge2 * uv1.x - edge1 * uv2.x) * r;
        for (size_t k = 0; k < 3; ++k)
            sums[mesh.indices[i + k]] += along_u, sums[count + mesh.indices[i + k]] += along_v;
    }
    for (size_t i = 0; i < count; ++i) {
        const glm::vec3 normal = mesh.vertices[i].normal, sum = sums[i];
        tangents[i] = glm::vec4(glm::normalize(sum - normal * glm::dot(normal, sum)),
                                glm::dot(glm::cross(normal, sum), sums[count + i]) < 0 ? -1 : 1);
    }
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

std::vector<BenchScene> scenes(const BenchSettings& settings) {
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
                         .run = [=] { corner_tangents(work->mesh, method, work->tangents, nullptr, threads); }};
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

BenchTopic tangents_topic() {
    return {"tangents", "tangents of a million triangles; errors on a jittered torus of 4096", scenes};
}

}  // namespace relief
