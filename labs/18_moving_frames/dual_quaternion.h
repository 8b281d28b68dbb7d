// Rigid motions that can be blended: dual quaternions.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace relief {

/// A rotation, and half the translation times the rotation; components x, y, z, w. It has unit length if `real` has. A
/// weighted sum, component by component, is a blend of motions (Kavan et al. 2007). Negated, it is the same motion.
struct DualQuaternion {
    glm::dvec4 real{0}, dual{0};
};

/// Returns the dual quaternion of a matrix that rotates and then moves.
inline DualQuaternion dual_quaternion_of(const glm::dmat4& rigid) {
    const auto as_vector = [](const glm::dquat& q) { return glm::dvec4(q.x, q.y, q.z, q.w); };
    const glm::dquat real = glm::quat_cast(glm::dmat3(rigid));
    const glm::dvec3 moved(rigid[3]);
    return {as_vector(real), as_vector(glm::dquat(0, moved.x, moved.y, moved.z) * real * 0.5)};
}

/// Returns a place after the motion. It need not have unit length, but `real` must not be 0.
inline glm::dvec3 moved_by(const DualQuaternion& motion, const glm::dvec3& place) {
    const glm::dvec3 v(motion.real), d(motion.dual);
    const double w = motion.real.w;
    const glm::dvec3 turned =
        place * (w * w - glm::dot(v, v)) + 2.0 * (glm::dot(v, place) * v + w * glm::cross(v, place));
    const glm::dvec3 moved = 2.0 * (w * d - motion.dual.w * v + glm::cross(v, d));
    return (turned + moved) / glm::dot(motion.real, motion.real);
}

}  // namespace relief
