// Dual quaternions, compared with the matrices of the same motions.
#include "labs/18_moving_frames/dual_quaternion.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

namespace relief {
namespace {

TEST(DualQuaternion, MovesAPlaceAsItsMatrixDoesAtAnyLengthAndSign) {
    glm::dmat4 rigid = glm::translate(glm::dmat4(1), glm::dvec3(3, -2, 0.5));
    for (const double angle : {0.0, 0.4, 3.0, 6.1}) {
        rigid = glm::rotate(rigid, angle, glm::normalize(glm::dvec3(1, 2, -0.7)));
        const DualQuaternion motion = dual_quaternion_of(rigid);
        EXPECT_NEAR(glm::length(motion.real), 1, 1e-12);
        EXPECT_NEAR(glm::dot(motion.real, motion.dual), 0, 1e-12);
        const glm::dvec3 place(0.3, 5, -1), exact(rigid * glm::dvec4(place, 1));
        for (const double factor : {1.0, -1.0, 0.25})
            EXPECT_LT(glm::distance(moved_by({factor * motion.real, factor * motion.dual}, place), exact), 1e-12);
    }
}

TEST(DualQuaternion, HalfwayBetweenTwoMotionsIsTheRigidOneHalfway) {
    const auto turned = [](double angle) {  // about an axis through (1, 0, 0)
        const glm::dmat4 there = glm::translate(glm::dmat4(1), glm::dvec3(1, 0, 0));
        return glm::rotate(there, angle, glm::dvec3(0, 0, 1)) * glm::inverse(there);
    };
    const DualQuaternion a = dual_quaternion_of(turned(0)), b = dual_quaternion_of(turned(2));
    const glm::dvec3 place(2, 1, 4), found = moved_by({a.real + b.real, a.dual + b.dual}, place);
    EXPECT_LT(glm::distance(found, glm::dvec3(turned(1) * glm::dvec4(place, 1))), 1e-12);
}

}  // namespace
}  // namespace relief
