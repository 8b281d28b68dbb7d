// The skin of lab 18: a tube or a serpent at rest, the chain of bones in it, its weights, and the flock.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "framework/mesh/mesh.h"

namespace relief::moving_frames {

/// A body of revolution around the x axis. Its bones lie in a row; the chain begins at the tail, where x is smallest.
struct Body {
    bool is_serpent;
    double length, radius;  ///< metres
    int joints;             ///< at equal distances; there is one bone more

    double spacing() const { return length / (joints + 1); }
    double joint(int i) const { return spacing() * (i + 1) - length / 2; }  ///< its x
};
inline constexpr Body tube{false, 2, 0.3, 1}, serpent{true, 9, 0.32, 13};

/// A place of the skin at rest. u runs around the body from its belly, v along it from tail to head, both from 0 to 1.
struct Rest {
    glm::dvec3 position, normal;  ///< of unit length
    glm::dvec3 along_u, along_v;  ///< derivatives of the position, metres
};
Rest rest_at(const Body& body, glm::dvec2 uv);

/// Weights of four neighbouring bones, and their derivatives along x. They depend on x alone.
struct Influence {
    int first;
    glm::dvec4 weights, slopes;
};
/// Each joint passes the skin on from one bone to the next by a smooth step, `over` metres long; 0 counts as a
/// thousandth of the radius, more than three bones as three. With `uneven` the weights do not sum to 1 (0.65 to 0.95).
Influence influence_at(const Body& body, double x, double over, bool uneven);

/// A unit dual quaternion, x, y, z, w: a rotation, and half the translation times the rotation.
struct Motion {
    glm::dvec4 real, dual;
};

struct Bone {
    glm::dmat4 matrix;   ///< from rest to pose, stretched
    glm::dmat3 normals;  ///< its cofactors
    Motion motion;       ///< without the stretch
};

struct Pose {
    double bend = 90, twist = 0;  ///< degrees, of the tube's joint; a serpent's joints share in it
    double stretch = 1;           ///< of the bone in the middle of the chain, along it
    double over = 4;              ///< length of a joint, radii
    bool dual = false;            ///< blended by dual quaternions
    bool uneven = false;          ///< weights that do not sum to 1
    bool opposite = false;        ///< every second dual quaternion has the other sign: the same motion

    bool is_rest() const { return bend == 0 && twist == 0 && stretch == 1; }
    bool operator==(const Pose&) const = default;
};
constexpr int most_bones = 16;
/// At least 4: behind the last one there are copies of it.
std::vector<Bone> bones_of(const Body& body, const Pose& pose);

/// Where the skin's place is in the pose, in metres.
glm::dvec3 posed(const Body& body, const Pose& pose, const std::vector<Bone>& bones, glm::dvec2 uv);

/// Four bones that move a vertex.
struct Bound {
    std::array<uint8_t, 4> bones;
    glm::vec4 weights;
};

/// The skin as triangles, at rest: 2 * rings * sides. Vertices on both sides of the seam agree.
Mesh make_skin(const Body& body, int rings, int sides);
std::vector<Bound> bind_skin(const Body& body, const Mesh& mesh, double over, bool uneven);

/// One body of the flock.
struct Instance {
    glm::dmat4 world_from_model{1};
    glm::dmat3 texture{1};  ///< places the texture on this body
    int material = 0;
};
constexpr int most_instances = 200, material_count = 8;
/// Those behind the first one; every fourth is mirrored. They differ in place, size, texture and material.
std::vector<Instance> make_flock(int count);

/// Turns by degrees, after scaling.
glm::dmat3 texture_transform(double turn, glm::dvec2 scale, glm::dvec2 shift = {0, 0});

}  // namespace relief::moving_frames
