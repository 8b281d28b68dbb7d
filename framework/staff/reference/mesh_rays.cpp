#include "framework/staff/reference/mesh_rays.h"

#include <algorithm>
#include <cmath>

namespace relief {

RayAxes axes_of(const glm::dvec3& direction) {
    const glm::dvec3 size = glm::abs(direction);
    const int z = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const int x = (z + 1) % 3, y = (z + 2) % 3;
    return {{x, y, z}, {direction[x] / direction[z], direction[y] / direction[z], 1 / direction[z]}};
}

glm::dvec4 triangle_hit(const Ray& ray, const RayAxes& axes, const glm::dvec3& a, const glm::dvec3& b,
                        const glm::dvec3& c) {
    const auto sheared = [&](const glm::dvec3& corner) {
        const glm::dvec3 away = corner - ray.origin;
        const double z = away[axes.along[2]];
        return glm::dvec3(away[axes.along[0]] - axes.shear.x * z, away[axes.along[1]] - axes.shear.y * z,
                          axes.shear.z * z);
    };
    const glm::dvec3 p = sheared(a), q = sheared(b), r = sheared(c);
    // A product of rounded numbers has the right sign or is 0. So two triangles agree about the edge that they share.
    const glm::dvec3 weights(r.x * q.y - r.y * q.x, p.x * r.y - p.y * r.x, q.x * p.y - q.y * p.x);
    const bool any_below = weights.x < 0 || weights.y < 0 || weights.z < 0;
    const bool any_above = weights.x > 0 || weights.y > 0 || weights.z > 0;
    const double sum = weights.x + weights.y + weights.z;
    if ((any_below && any_above) || sum == 0) return glm::dvec4(0);
    const glm::dvec3 shares = weights / sum;
    const double t = shares.x * p.z + shares.y * q.z + shares.z * r.z;
    // The axes are a right-handed permutation. Seen along a negative z, the winding is reversed.
    return {t, shares.x, shares.y, (sum > 0) == (axes.shear.z > 0) ? 1 : -1};
}

glm::dvec3 inverse_direction(const glm::dvec3& direction) {
    const auto inverse = [](double d) { return std::abs(d) > 1e-18 ? 1 / d : d < 0 ? -1e18 : 1e18; };
    return {inverse(direction.x), inverse(direction.y), inverse(direction.z)};
}

bool meets_box(const glm::dvec3& origin, const glm::dvec3& inverse, double end, const glm::dvec3& low,
               const glm::dvec3& high) {
    const glm::dvec3 a = (low - origin) * inverse, b = (high - origin) * inverse;
    const glm::dvec3 near = glm::min(a, b), far = glm::max(a, b);
    const double enters = std::max({near.x, near.y, near.z, 0.0}), leaves = std::min({far.x, far.y, far.z, end});
    // Three float roundings may reverse the order of both (Ize 2013).
    return enters <= leaves * 1.0000004;
}

namespace {

/// Calls `take` for hits with t in [0, end]. A call may reduce `end`.
template <class Take>
void walk(const TriangleTree& tree, const Mesh& mesh, const Ray& ray, double& end, const Take& take) {
    const RayAxes axes = axes_of(ray.direction);
    const glm::dvec3 inverse = inverse_direction(ray.direction);
    const auto position = [&](uint32_t triangle, uint32_t corner) {
        return glm::dvec3(mesh.vertices[mesh.indices[triangle * 3 + corner]].position);
    };
    for (size_t i = 0; i < tree.nodes.size();) {
        const TreeNode& node = tree.nodes[i];
        if (!meets_box(ray.origin, inverse, end, node.low, node.high)) {
            i = node.skip;
            continue;
        }
        for (uint32_t k = node.first; k < node.first + node.count; ++k) {
            const uint32_t triangle = tree.triangles[k];
            const glm::dvec4 hit =
                triangle_hit(ray, axes, position(triangle, 0), position(triangle, 1), position(triangle, 2));
            if (hit.w != 0 && hit.x >= 0 && hit.x <= end)
                take({hit.x, {hit.y, hit.z, 1 - hit.y - hit.z}, triangle, hit.w > 0});
        }
        ++i;
    }
}

}  // namespace

void each_hit(const TriangleTree& tree, const Mesh& mesh, const Ray& ray, double end,
              const std::function<void(const MeshHit&)>& take) {
    walk(tree, mesh, ray, end, take);
}

std::optional<MeshHit> first_hit(const TriangleTree& tree, const Mesh& mesh, const Ray& ray, double end,
                                 bool front_only) {
    std::optional<MeshHit> first;
    walk(tree, mesh, ray, end, [&](const MeshHit& hit) {
        if (front_only && !hit.is_front) return;
        if (!first || hit.t < first->t || (hit.t == first->t && hit.is_front && !first->is_front)) first = hit;
        end = first->t;
    });
    return first;
}

glm::dvec3 normal_at(const Mesh& mesh, const MeshHit& hit) {
    glm::dvec3 sum(0);
    for (int corner = 0; corner < 3; ++corner)
        sum += hit.weights[corner] *
               glm::dvec3(mesh.vertices[mesh.indices[size_t(hit.triangle) * 3 + size_t(corner)]].normal);
    return glm::normalize(sum);
}

}  // namespace relief
