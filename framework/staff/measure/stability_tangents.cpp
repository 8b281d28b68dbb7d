// Tangents under extreme scales, for slivers, for normals along the tangent, and for meshes jittered until they fold.
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>
#include <random>

#include "framework/library/mesh/tangents.h"
#include "framework/staff/measure/peers.h"
#include "framework/staff/measure/stability.h"
#include "framework/staff/measure/usual.h"
#include "framework/staff/reference/degrees.h"
#include "framework/staff/reference/jittered_torus.h"

namespace relief::measure {
namespace {

constexpr unsigned mesh_seed = 1;
using Exact = glm::vec<3, long double>;

/// Separate triangles: every method should give each triangle its own dP/du.
struct Soup {
    Mesh mesh;
    std::vector<glm::dvec3> tangents;  ///< of each corner; zero if the triangle has none
};

/// Adds the exact direction of dP/du in the tangent plane, from the mesh's floats. long double has 64 bits of mantissa,
/// enough for the area of a sliver's uv.
void add_truth(Soup& soup) {
    for (size_t i = 0; i < soup.mesh.indices.size(); i += 3) {
        const Vertex* const corner = &soup.mesh.vertices[i];
        const Exact p[3] = {corner[0].position, corner[1].position, corner[2].position};
        const glm::vec<2, long double> uv[3] = {corner[0].uv, corner[1].uv, corner[2].uv};
        const auto uv1 = uv[1] - uv[0], uv2 = uv[2] - uv[0];
        const long double area = uv1.x * uv2.y - uv1.y * uv2.x;
        Exact along = ((p[1] - p[0]) * uv2.y - (p[2] - p[0]) * uv1.y) * (area > 0 ? 1.0L : area < 0 ? -1.0L : 0.0L);
        const long double largest = std::max({std::abs(along.x), std::abs(along.y), std::abs(along.z)});
        for (int k = 0; k < 3; ++k) {
            glm::dvec3 tangent(0);
            if (largest > 0) {
                const Exact a = along / largest, n = glm::normalize(Exact(corner[k].normal));
                const Exact flat = a - n * glm::dot(n, a);
                if (glm::dot(flat, flat) > 0) tangent = glm::normalize(flat);
            }
            soup.tangents.push_back(tangent);
        }
    }
}

struct SoupShape {
    double position_scale = 1, uv_scale = 1;
    double sliver = 1;     ///< length of a triangle divided by its height
    double uv_sliver = 1;  ///< the same in uv
    double tilt = 1;       ///< the angle between normal and dP/du, in radians; 1: the triangle's own normal
};

Soup make_soup(size_t count, const SoupShape& shape) {
    std::mt19937 random(mesh_seed);
    std::uniform_real_distribution<> share(0, 1), around(-1, 1);
    const auto direction = [&] {
        for (;;) {
            const glm::dvec3 v(around(random), around(random), around(random));
            if (glm::length(v) > 0.1 && glm::length(v) < 1) return glm::normalize(v);
        }
    };
    Soup soup;
    for (size_t i = 0; i < count; ++i) {
        const glm::dvec3 normal = direction(), one = glm::normalize(glm::cross(normal, direction()));
        const glm::dvec3 two = glm::cross(normal, one), middle(around(random), around(random), around(random));
        const double turn = 2 * glm::pi<double>() * share(random), c = std::cos(turn), s = std::sin(turn);
        const double place[3][2] = {{0, 0}, {1, 0.2 * around(random)}, {0.2 + 0.6 * share(random), 1}};
        const double hand = random() % 2 ? 1 : -1;
        const glm::dvec2 uv_middle(around(random), around(random));
        // uv = a rotation of the position in the triangle, flattened across, so that u and v both grow along it.
        glm::dvec2 uv[3];
        for (int k = 0; k < 3; ++k) {
            const double x = place[k][0], y = hand * place[k][1] / shape.uv_sliver;
            uv[k] = shape.uv_scale * (uv_middle + glm::dvec2(c * x - s * y, s * x + c * y));
        }
        const glm::dvec3 along = glm::normalize(one * (c)-two * (hand * s * shape.uv_sliver / shape.sliver));
        const glm::dvec3 vertex_normal =
            shape.tilt < 1 ? std::cos(shape.tilt) * along + std::sin(shape.tilt) * normal : normal;
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3 p = middle + place[k][0] * one + place[k][1] / shape.sliver * two;
            soup.mesh.indices.push_back(uint32_t(soup.mesh.vertices.size()));
            soup.mesh.vertices.push_back(
                {.position = shape.position_scale * p, .normal = vertex_normal, .tangent = {}, .uv = uv[k]});
        }
    }
    add_truth(soup);
    return soup;
}

/// Returns an angle that stays accurate when it is small; acos(dot) does not.
/// Returns whether a tangent is finite and of unit length. A shader turns any other tangent into NaN or black.
bool is_usable(const glm::vec4& tangent) {
    return std::abs(glm::length(glm::dvec3(tangent)) - 1) < 1e-3 && std::abs(tangent.w) == 1;
}

using TangentsOf = std::function<std::vector<glm::vec4>(const Mesh&)>;

Tally tally_of(const Soup& soup, const TangentsOf& method) {
    Tally tally;
    const std::vector<glm::vec4> tangents = method(soup.mesh);
    for (size_t i = 0; i < tangents.size(); ++i)
        if (!is_usable(tangents[i]))
            tally.lost();
        else if (soup.tangents[i] != glm::dvec3(0))
            tally.add(degrees_between(tangents[i], soup.tangents[i]));
    return tally;
}

/// The published semantics (Mikkelsen 2008) in single precision, for separate triangles. The direction is solved
/// without a division, and a number of at most FLT_MIN counts as 0.
std::vector<glm::vec4> published_tangents(const Mesh& mesh) {
    constexpr float least = std::numeric_limits<float>::min();
    const auto unit = [](glm::vec3 v) { return glm::length(v) > least ? v / glm::length(v) : v; };
    std::vector<glm::vec4> result;
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vertex* const corner = &mesh.vertices[i];
        const glm::vec3 edge1 = corner[1].position - corner[0].position,
                        edge2 = corner[2].position - corner[0].position;
        const glm::vec2 uv1 = corner[1].uv - corner[0].uv, uv2 = corner[2].uv - corner[0].uv;
        const float area = uv1.x * uv2.y - uv1.y * uv2.x, hand = area > 0 ? 1.0f : -1.0f;
        const glm::vec3 along = unit((uv2.y * edge1 - uv1.y * edge2) * hand);
        for (size_t k = 0; k < 3; ++k) {
            const glm::vec3 n = corner[k].normal;
            const glm::vec3 tangent = std::abs(area) > least ? unit(along - n * glm::dot(n, along)) : glm::vec3(0);
            result.emplace_back(tangent, hand);
        }
    }
    return result;
}

struct TangentsMethod {
    const char* name;
    TangentsOf tangents;
    bool peer = false;
};

std::vector<TangentsMethod> tangents_methods() {
    std::vector<TangentsMethod> all;
    for (const auto& [name, kind] : {std::pair{"per-face", TangentMethod::per_face},
                                     {"uniform", TangentMethod::uniform},
                                     {"area", TangentMethod::area},
                                     {"angle", TangentMethod::angle},
                                     {"mikktspace", TangentMethod::mikktspace}})
        all.push_back({name, [method = kind](const Mesh& mesh) { return corner_tangents(mesh, method, nullptr, 1); }});
    all.push_back({"usual",
                   [](const Mesh& mesh) {
                       std::vector<glm::vec3> sums;
                       std::vector<glm::vec4> vertices, corners;
                       usual_tangents(mesh, sums, vertices);
                       for (const uint32_t index : mesh.indices) corners.push_back(vertices[index]);
                       return corners;
                   },
                   true});
    if (has_peers())
        all.push_back({"Assimp",
                       [](const Mesh& mesh) {
                           const auto peer = assimp_tangents(mesh);
                           peer->run();
                           return peer->tangents();
                       },
                       true});
    return all;
}

/// Returns a scene of soups. `why` explains, in this order, the course's methods, the usual code, the published code,
/// and Assimp.
BenchScene soup_scene(const char* input, const char* axis, const std::vector<double>& hardness, size_t count,
                      double stated, const std::array<const char*, 4>& why,
                      const std::function<SoupShape(double)>& shape) {
    std::vector<TangentsMethod> all = tangents_methods();
    all.push_back({"published-in-floats", published_tangents, true});
    std::vector<SweptMethod> result;
    for (const TangentsMethod& method : all) {
        const std::string name = method.name;
        const char* const text = !method.peer ? why[0] : name == "usual" ? why[1] : name == "Assimp" ? why[3] : why[2];
        result.push_back({name, stated, text,
                          [=, tangents = method.tangents](double hard) {
                              return tally_of(make_soup(count, shape(hard)), tangents).largest(hard);
                          },
                          method.peer});
    }
    return sweep_scene(input, axis, "degree", hardness, result);
}

/// The mean angle to dP/du, on a torus with increasing jitter. From half a cell on, triangles fold.
BenchScene jitter_scene(const BenchSettings& settings) {
    std::vector<SweptMethod> result;
    for (const TangentsMethod& method : tangents_methods())
        result.push_back({method.name, method.name == std::string("per-face") ? 6.0 : 2.0,
                          method.name == std::string("per-face") ? "Facets: no mean hides that a triangle is flat."
                          : method.peer ? "Sums over a vertex's triangles cancel where one is folded."
                                        : "A folded triangle has the other handedness: its corners have tangents of "
                                          "their own, which point the wrong way.",
                          [tangents = method.tangents, quick = settings.quick](double jitter) {
                              const Mesh mesh = jittered_torus(quick ? 48 : 96, quick ? 24 : 48, mesh_seed, jitter);
                              Tally tally;
                              const std::vector<glm::vec4> found = tangents(mesh);
                              for (size_t i = 0; i < found.size(); ++i)
                                  if (!is_usable(found[i]))
                                      tally.lost();
                                  else
                                      tally.add(degrees_between(found[i], mesh.vertices[mesh.indices[i]].tangent));
                              return tally.mean(jitter);
                          },
                          method.peer});
    return sweep_scene("tangents-jitter", "jitter of the vertices, cells", "degree",
                       {0.01, 0.03, 0.1, 0.2, 0.3, 0.4, 0.5, 0.7, 1}, result);
}

}  // namespace

std::vector<BenchScene> tangent_sweeps(const BenchSettings& settings) {
    const size_t count = settings.quick ? 200 : 2000;
    const double step = settings.quick ? 12 : 2;  // a float ranges from 1e-38 to 1e38
    const char* const squares =
        "Single precision: the square of a length, or a product of two, leaves the range of a float.";
    const char* const products = "The area in uv is a difference of two products: 24 digits do not tell it from 0.";
    return {
        soup_scene("tangents-position-scale", "scale of the positions", decades(-36, 36, step), count, 1e-3,
                   {"Double precision, in which a float can be squared twice.", squares, squares, squares},
                   [](double hard) { return SoupShape{.position_scale = hard}; }),
        soup_scene("tangents-uv-scale", "scale of the uv", decades(-36, 36, step), count, 1e-3,
                   {"Double precision, in which a float can be squared twice.", squares, squares, squares},
                   [](double hard) { return SoupShape{.uv_scale = hard}; }),
        soup_scene("tangents-uv-sliver", "length by height of the triangles' uv",
                   decades(0, 8, settings.quick ? 2 : 0.5), count, 1e-3,
                   {"Products of two floats are exact in double precision, and so is the sign of their difference.",
                    products, products, products},
                   [](double hard) { return SoupShape{.uv_sliver = hard}; }),
        soup_scene("tangents-sliver", "length by height of the triangles", decades(0, 8, settings.quick ? 2 : 0.5),
                   count, 1e-3,
                   {"Edges are differences of floats, and exact.", "The edges are exact; the solution cancels.",
                    "The edges are exact; the solution cancels.", "The edges are exact; the solution cancels."},
                   [](double hard) { return SoupShape{.sliver = hard}; }),
        soup_scene(
            "tangents-along-normal", "1 / angle between normal and dP/du", decades(0.5, 9, settings.quick ? 2 : 0.5),
            count, 1e-3,
            {"What the normal leaves of dP/du is a difference of nearly equal vectors, whose last digits count that "
             "many times. Only mikktspace takes it before dP/du is rounded to floats.",
             "What the normal leaves of dP/du is a difference of nearly equal vectors, in single precision.",
             "What the normal leaves of dP/du is a difference of nearly equal vectors, in single precision.",
             "What the normal leaves of dP/du is a difference of nearly equal vectors, in single precision."},
            [](double hard) { return SoupShape{.tilt = 1 / hard}; }),
        jitter_scene(settings)};
}

}  // namespace relief::measure
