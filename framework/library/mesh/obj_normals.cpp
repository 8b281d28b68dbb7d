// Computes normals for the corners of an OBJ model that have none.
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <span>
#include <unordered_map>

#include "framework/library/mesh/obj_parts.h"
#include "framework/library/mesh/polygon.h"

namespace relief::obj {
namespace {

struct PositionHash {
    size_t operator()(const std::array<float, 3>& position) const {
        uint64_t hash = 0;
        for (const float x : position) hash = mix(hash ^ glm::floatBitsToUint(x + 0.0f));  // -0 becomes 0
        return hash;
    }
};

struct Mix {
    size_t operator()(uint64_t key) const { return mix(key); }
};

/// Returns for each position the first equal one, so that normals are smooth across uv seams with repeated positions.
std::vector<uint32_t> welded(const std::vector<glm::vec3>& positions) {
    std::unordered_map<std::array<float, 3>, uint32_t, PositionHash> first;
    std::vector<uint32_t> result;
    result.reserve(positions.size());
    for (const glm::vec3& p : positions)
        result.push_back(first.try_emplace({p.x, p.y, p.z}, uint32_t(result.size())).first->second);
    return result;
}

/// Returns the interior angle of the polygon at a corner, in [0, 2 pi).
double angle_at(const glm::dvec3& before, const glm::dvec3& at, const glm::dvec3& after, const glm::dvec3& normal) {
    const glm::dvec3 to_after = after - at, to_before = before - at, across = glm::cross(to_after, to_before);
    const double angle = std::atan2(glm::length(across), glm::dot(to_after, to_before));
    return glm::dot(across, normal) < 0 ? 2 * std::acos(-1.0) - angle : angle;
}

glm::dvec3 unit_or(const glm::dvec3& vector, const glm::dvec3& otherwise) {
    const double length = glm::length(vector);
    return length > 0 ? vector / length : otherwise;
}

/// Sums over faces: weighted normals, and weights.
struct Sum {
    glm::dvec3 normal{0};
    double weight = 0;
    int32_t index = -1;
};

}  // namespace

void add_missing_normals(Faces& faces) {
    const std::vector<uint32_t> same = welded(faces.positions);
    std::unordered_map<uint64_t, Sum, Mix> sums;
    const auto key = [&](const Face& face, const Corner& corner) {
        return uint64_t(face.smoothing) << 32 | same[size_t(corner.position)];
    };
    std::vector<glm::dvec3> polygon;
    const auto normal_of = [&](const Face& face) {
        polygon.clear();
        for (uint32_t i = face.first; i < face.first + face.count; ++i)
            polygon.push_back(faces.positions[size_t(faces.corners[i].position)]);
        return unit_or(vector_area(polygon), glm::dvec3(0));
    };

    for (const Face& face : faces.faces) {
        if (face.smoothing == 0) continue;
        const glm::dvec3 normal = normal_of(face);
        for (uint32_t i = 0; i < face.count; ++i) {
            const double weight =
                angle_at(polygon[(i + face.count - 1) % face.count], polygon[i], polygon[(i + 1) % face.count], normal);
            Sum& sum = sums[key(face, faces.corners[face.first + i])];
            sum.normal += weight * normal, sum.weight += weight;
        }
    }
    const auto add = [&](const glm::dvec3& normal) {
        faces.normals.push_back(normal);
        return int32_t(faces.normals.size() - 1);
    };
    for (const Face& face : faces.faces) {
        int32_t own = -1;
        for (uint32_t i = face.first; i < face.first + face.count; ++i) {
            Corner& corner = faces.corners[i];
            if (corner.normal >= 0) continue;
            Sum* sum = face.smoothing == 0 ? nullptr : &sums[key(face, corner)];
            // The normals of opposite faces cancel out except for rounding.
            if (sum && glm::length(sum->normal) > 1e-6 * sum->weight) {
                if (sum->index < 0) sum->index = add(glm::normalize(sum->normal));
                corner.normal = sum->index;
            } else {
                if (own < 0) own = add(unit_or(normal_of(face), glm::dvec3(0, 0, 1)));
                corner.normal = own;
            }
        }
    }
}

}  // namespace relief::obj
