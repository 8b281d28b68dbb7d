// The axes of a camera's picture.
#include "framework/library/kit/view_axes.h"

#include <gtest/gtest.h>

namespace relief {
namespace {

TEST(ViewAxes, GiveTheCamerasRayOfEachPointOfThePicture) {
    constexpr double aspect = 1.75;
    for (const Orbit& orbit :
         {Orbit{}, Orbit{.yaw = -130, .pitch = 80, .distance = 7, .field_of_view = 12},
          Orbit{.yaw = 10, .pitch = -89, .distance = 2, .target = {5, -3, 1}, .field_of_view = 90}}) {
        const Camera camera(orbit, aspect);
        const ViewAxes axes = view_axes(camera);
        for (const glm::dvec2 point : {glm::dvec2(0, 0), {1, 0}, {-1, 1}, {0.3, -0.8}}) {
            const glm::dvec3 along =
                axes.forward + axes.half_height * (aspect * point.x * axes.right + point.y * axes.up);
            // A product of matrices and its inverse, in double precision.
            EXPECT_LT(glm::distance(glm::normalize(along), camera.ray(point).direction), 1e-12);
        }
    }
}

}  // namespace
}  // namespace relief
