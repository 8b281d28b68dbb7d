// The skin of lab 18: a tube or a serpent at rest, its chain of bones, its weights, and the flock.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "dual_quaternion.h"
#include "framework/core/base/mesh.h"

namespace relief::moving_frames {

/// A body of revolution around the x axis. Its bones form a chain along the axis from the tail, where x is smallest.
struct Body {
    bool is_serpent;
    double length, radius;  ///< metres
    int joints;             ///< evenly spaced; there are joints + 1 bones

    double spacing() const { return length / (joints + 1); }
    double joint(int i) const { return spacing() * (i + 1) - length / 2; }  ///< x of joint i
};
inline constexpr Body tube{false, 2, 0.3, 1}, serpent{true, 9, 0.32, 13};

/// A place of the skin at rest. u goes around the body from the belly, v along it from tail to head, both from 0 to 1.
struct Rest {
    glm::dvec3 position, normal;  ///< metres; unit length
    glm::dvec3 along_u, along_v;  ///< derivatives of the position, metres
};
Rest rest_at(const Body& body, glm::dvec2 uv);

/// The weights of four consecutive bones from `first` on, and their derivatives along x, per metre.
struct Influence {
    int first;
    glm::dvec4 weights, slopes;
};
/// Returns the weights at x, in metres; they depend on x only. At each joint a smooth step hands the skin from one bone
/// to the next. The step is `over` metres long, clamped to [a thousandth of the radius, three bones]. With `uneven` the
/// sum of the weights is not 1 but in [0.65, 0.95].
Influence influence_at(const Body& body, double x, double over, bool uneven);

struct Bone {
    glm::dmat4 matrix;      ///< from rest to pose, with the stretch
    glm::dmat3 normals;     ///< its cofactors
    DualQuaternion motion;  ///< without the stretch
};

struct Pose {
    double bend = 90, twist = 0;  ///< of the tube's joint, degrees; scales the turns of a serpent's joints
    double stretch = 1;           ///< of the bone in the middle of the chain, along its length
    double over = 4;              ///< length of a joint, radii
    bool dual = false;            ///< blend dual quaternions instead of matrices
    bool uneven = false;          ///< weights that do not sum to 1
    bool opposite = false;        ///< every second dual quaternion is negated, which is the same motion

    bool is_rest() const { return bend == 0 && twist == 0 && stretch == 1; }
    bool operator==(const Pose&) const = default;
};
constexpr int most_bones = 16;
/// Returns the bones of a pose. There are at least 4: copies of the last one pad the chain.
std::vector<Bone> bones_of(const Body& body, const Pose& pose);

/// Returns the posed position of a place of the skin, in metres.
glm::dvec3 posed(const Body& body, const Pose& pose, const std::vector<Bone>& bones, glm::dvec2 uv);

/// A bounding sphere of a posed body, in the body's coordinates.
struct Ball {
    glm::dvec3 centre;
    double radius;
};
Ball ball_of(const Body& body, const Pose& pose);

/// The four bones that move a vertex, and their weights.
struct Bound {
    std::array<uint8_t, 4> bones;
    glm::vec4 weights;
};

/// The number of rings and sides of a skin's triangles.
struct Fineness {
    int rings, sides;
    int triangles() const { return 2 * rings * sides; }
    bool operator==(const Fineness&) const = default;
};

/// Returns the skin at rest, as 2 * rings * sides triangles. Vertices on both sides of the seam have the same position.
Mesh make_skin(const Body& body, int rings, int sides);
/// Returns the bones and weights of each vertex of make_skin(). `over` is in metres.
std::vector<Bound> bind_skin(const Body& body, const Mesh& mesh, double over, bool uneven);

/// One body of the flock.
struct Instance {
    glm::dmat4 world_from_model{1};
    glm::dmat3 texture{1};  ///< places the texture on this body
    int material = 0;
};
constexpr int most_instances = 200, material_count = 8;
/// Returns `count` instances behind the first one. Every fourth is mirrored. They differ in place, size, texture and
/// material.
std::vector<Instance> make_flock(int count);

/// Returns the transform of uv that scales, then turns by `turn` degrees, then shifts.
glm::dmat3 texture_transform(double turn, glm::dvec2 scale, glm::dvec2 shift = {0, 0});

}  // namespace relief::moving_frames
