#include "framework/staff/reference/tangent_faces.h"

#include <algorithm>
#include <cmath>

namespace relief {
namespace {

constexpr double pi = 3.14159265358979323846;

bool is_finite(const Vertex& vertex) {
    // A sum is finite only if all its terms are; six floats cannot overflow a double.
    return std::isfinite(double(vertex.position.x) + vertex.position.y + vertex.position.z + vertex.uv.x + vertex.uv.y);
}

}  // namespace

// Without branches, so that compilers make vectors of it.
void angles_of(const double* __restrict y, const double* __restrict x, float* __restrict angles, int count) {
    for (int i = 0; i < count; ++i) {
        const double size = std::abs(x[i]), low = y[i] < size ? y[i] : size, high = y[i] < size ? size : y[i];
        const float a = float(low / (high > 0 ? high : 1)), s = a * a;
        // Chebyshev's polynomial for atan(a) / a over s = a² in [0, 1], 7.5e-8 off at most.
        float p = -0.0046687733f;
        p = p * s + 0.02416619f;
        p = p * s - 0.0593671f;
        p = p * s + 0.09906097f;
        p = p * s - 0.14016585f;
        p = p * s + 0.19969235f;
        p = p * s - 0.3333196f;
        p = (p * s + 0.9999999f) * a;
        const float first = y[i] > size ? float(pi / 2) - p : p;
        angles[i] = x[i] < 0 ? float(pi) - first : first;
    }
}

// In double precision all sizes of floats can be squared twice over: nothing needs scaling. Differences of floats are
// exact but for extreme sizes; what is made of two of them is made of the triangle's two shorter edges, so that a
// sliver keeps its digits: at a sphere's pole one edge is 1e-17 long, and any other two leave nothing but rounding.
TangentFace tangent_face(const Vertex* const corners[3], const glm::dvec3 normals[3], TangentMethod method,
                         double area_unit, FaceAngles& angles) {
    TangentFace face{};
    angles = {};
    if (!is_finite(*corners[0]) || !is_finite(*corners[1]) || !is_finite(*corners[2])) {
        face.why = TangentFallback::not_finite, face.in_no_group = true;
        return face;
    }
    // Edge i runs from corner i to the next.
    const glm::dvec3 p[3] = {glm::dvec3(corners[0]->position), glm::dvec3(corners[1]->position),
                             glm::dvec3(corners[2]->position)};
    const glm::dvec3 edges[3] = {p[1] - p[0], p[2] - p[1], p[0] - p[2]};
    const double lengths[3] = {glm::dot(edges[0], edges[0]), glm::dot(edges[1], edges[1]),
                               glm::dot(edges[2], edges[2])};
    const int longest = lengths[0] > lengths[1] ? (lengths[0] > lengths[2] ? 0 : 2) : (lengths[1] > lengths[2] ? 1 : 2);
    const int first = longest == 2 ? 0 : longest + 1, second = first == 2 ? 0 : first + 1;  // the edges after it
    const glm::dvec3 &one = edges[first], &two = edges[second];
    const glm::dvec3 across = glm::cross(one, two);
    const double twice_area = std::sqrt(glm::dot(across, across));
    face.in_no_group = lengths[0] == 0 || lengths[1] == 0 || lengths[2] == 0;

    if (method == TangentMethod::angle) {
        angles = {{twice_area, twice_area, twice_area},
                  {-glm::dot(edges[0], edges[2]), -glm::dot(edges[1], edges[0]), -glm::dot(edges[2], edges[1])}};
    } else if (method == TangentMethod::mikktspace) {
        // Between edges that are projected onto the tangent plane: their cross product is what `across` has along the
        // normal, their dot product loses what both have along it.
        for (int i = 0; i < 3; ++i) {
            const glm::dvec3 &leaving = edges[i], &arriving = edges[i == 0 ? 2 : i - 1], &n = normals[i];
            angles.sine[i] = std::abs(glm::dot(n, across));
            angles.cosine[i] = glm::dot(n, leaving) * glm::dot(n, arriving) - glm::dot(leaving, arriving);
        }
    } else {
        const float weight = method == TangentMethod::area ? float(twice_area / area_unit) : 1;
        face.weight[0] = face.weight[1] = face.weight[2] = weight;
    }

    const glm::dvec2 uv[3] = {glm::dvec2(corners[0]->uv), glm::dvec2(corners[1]->uv), glm::dvec2(corners[2]->uv)};
    const glm::dvec2 uv_one = uv[second] - uv[first], uv_two = uv[longest] - uv[second];
    const double uv_area = uv_one.x * uv_two.y - uv_one.y * uv_two.x;
    face.handedness = face.in_no_group ? int8_t(0) : int8_t((uv_area > 0) - (uv_area < 0));
    const glm::dvec3 along = (uv_two.y * one - uv_one.y * two) * double(face.handedness);
    const double squared = glm::dot(along, along);
    if (squared > 0)
        face.along = along * (1 / std::sqrt(squared));
    else
        face.why = face.in_no_group || twice_area == 0 ? TangentFallback::zero_area : TangentFallback::degenerate_uv;
    return face;
}

}  // namespace relief
