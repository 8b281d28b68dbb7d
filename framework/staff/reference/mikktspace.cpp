#include "framework/staff/reference/mikktspace.h"

#include <cmath>
#include <set>

namespace relief {
namespace {

struct Triangle {
    glm::dvec3 position[3], normal[3];
    glm::dvec2 uv[3];
    glm::dvec3 along{0};  // dP/du, unit length
    int handedness = 0;
    bool degenerate = false;  // two equal positions
};

struct Corner {
    size_t triangle;
    int k;
    bool operator<(const Corner& other) const {
        return triangle != other.triangle ? triangle < other.triangle : k < other.k;
    }
};

bool same(const Vertex& a, const Vertex& b) { return a.position == b.position && a.normal == b.normal && a.uv == b.uv; }

glm::dvec3 on_plane(const glm::dvec3& v, const glm::dvec3& normal) { return v - normal * glm::dot(normal, v); }
glm::dvec3 unit(const glm::dvec3& v) { return glm::length(v) > 0 ? v / glm::length(v) : glm::dvec3(0); }

class Semantics {
public:
    explicit Semantics(const Mesh& mesh) : mesh_(mesh) {
        for (size_t i = 0; i < mesh.indices.size(); i += 3) {
            Triangle t;
            for (int k = 0; k < 3; ++k) {
                const Vertex& v = vertex({i / 3, k});
                t.position[k] = v.position, t.normal[k] = unit(glm::dvec3(v.normal)), t.uv[k] = v.uv;
            }
            t.degenerate =
                t.position[0] == t.position[1] || t.position[1] == t.position[2] || t.position[2] == t.position[0];
            // Two edges in space and in uv, from the corner opposite the longest edge, so that slivers keep precision.
            // The result is dP/du without the division by the area.
            const auto length = [&](int k) { return glm::length(t.position[(k + 1) % 3] - t.position[(k + 2) % 3]); };
            const int a = length(0) >= length(1) && length(0) >= length(2) ? 0 : length(1) >= length(2) ? 1 : 2;
            const int b = (a + 1) % 3, c = (a + 2) % 3;
            const glm::dvec3 d1 = t.position[b] - t.position[a], d2 = t.position[c] - t.position[a];
            const glm::dvec2 t21 = t.uv[b] - t.uv[a], t31 = t.uv[c] - t.uv[a];
            const double area = t21.x * t31.y - t21.y * t31.x;
            t.handedness = area > 0 ? 1 : area < 0 ? -1 : 0;
            t.along = unit((t31.y * d1 - t21.y * d2) * double(t.handedness));
            triangles_.push_back(t);
        }
    }

    std::vector<glm::dvec4> tangents() {
        std::vector<glm::dvec4> result(mesh_.indices.size(), glm::dvec4(0));
        for (const Triangle& t : triangles_) handedness_.push_back(t.handedness);
        std::set<Corner> done;
        for (size_t i = 0; i < triangles_.size(); ++i)
            for (int k = 0; k < 3; ++k) {
                const Corner corner{i, k};
                if (triangles_[i].degenerate || triangles_[i].handedness == 0 || done.contains(corner)) continue;
                std::set<Corner> group;
                flood(corner, group);
                const glm::dvec3 tangent = sum(group);
                for (const Corner& one : group) {
                    result[one.triangle * 3 + size_t(one.k)] = glm::dvec4(tangent, handedness_[i]);
                    done.insert(one);
                }
            }
        inherit(result);
        return result;
    }

private:
    const Vertex& vertex(Corner c) const { return mesh_.vertices[mesh_.indices[c.triangle * 3 + size_t(c.k)]]; }

    /// Returns corners at the same vertex across the edge that leaves it (or arrives). That edge arrives (leaves) at
    /// the other corner.
    std::vector<Corner> across(Corner c, bool leaving) const {
        std::vector<Corner> found;
        const Vertex& end = vertex({c.triangle, (c.k + (leaving ? 1 : 2)) % 3});
        for (size_t i = 0; i < triangles_.size(); ++i)
            for (int k = 0; k < 3; ++k) {
                const Corner other{i, k};
                if ((i == c.triangle && k == c.k) || triangles_[i].degenerate || !same(vertex(other), vertex(c)))
                    continue;
                if (same(vertex({i, (k + (leaving ? 2 : 1)) % 3}), end)) found.push_back(other);
            }
        return found;
    }

    /// Adds all corners connected with this one. A triangle without area in uv takes the handedness of its first group.
    void flood(Corner c, std::set<Corner>& group) {
        if (!group.insert(c).second) return;
        for (const bool leaving : {true, false})
            for (const Corner& other : across(c, leaving)) {
                int& theirs = handedness_[other.triangle];
                if (theirs == 0) theirs = handedness_[c.triangle];
                if (theirs == handedness_[c.triangle]) flood(other, group);
            }
    }

    glm::dvec3 sum(const std::set<Corner>& group) const {
        glm::dvec3 total(0);
        for (const Corner& c : group) {
            const Triangle& t = triangles_[c.triangle];
            const glm::dvec3 n = t.normal[c.k], here = t.position[c.k];
            const glm::dvec3 one = unit(on_plane(t.position[(c.k + 1) % 3] - here, n)),
                             two = unit(on_plane(t.position[(c.k + 2) % 3] - here, n));
            const double angle = std::atan2(glm::length(glm::cross(one, two)), glm::dot(one, two));
            total += angle * unit(on_plane(t.along, n));
        }
        return unit(total);
    }

    /// Corners without a tangent take it from the first corner at the same vertex that has one. Degenerate triangles
    /// also take its handedness.
    void inherit(std::vector<glm::dvec4>& result) const {
        const std::vector<glm::dvec4> own = result;
        for (size_t i = 0; i < own.size(); ++i) {
            if (glm::dvec3(own[i]) != glm::dvec3(0)) continue;
            for (size_t j = 0; j < own.size() && glm::dvec3(result[i]) == glm::dvec3(0); ++j)
                if (glm::dvec3(own[j]) != glm::dvec3(0) &&
                    same(mesh_.vertices[mesh_.indices[i]], mesh_.vertices[mesh_.indices[j]]))
                    result[i] = triangles_[i / 3].degenerate
                                    ? own[j]
                                    : glm::dvec4(glm::dvec3(own[j]), handedness_[i / 3] < 0 ? -1 : 1);
        }
    }

    const Mesh& mesh_;
    std::vector<Triangle> triangles_;
    std::vector<int> handedness_;  // its own, or the inherited one
};

}  // namespace

std::vector<glm::dvec4> mikktspace_reference(const Mesh& mesh) { return Semantics(mesh).tangents(); }

}  // namespace relief
