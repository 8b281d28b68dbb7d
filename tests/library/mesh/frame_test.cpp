#include "framework/library/mesh/frame.h"

#include <random>

#include "tests/support.h"

namespace relief {
namespace {

TEST(AnyPerpendicular, IsUnitAndPerpendicularForEveryNormal) {
    std::vector<glm::dvec3> normals = {{0, 0, 1},  {0, 0, -1},    {0, 0, -0.0}, {1, 0, 0},
                                       {0, -1, 0}, {1e-9, 0, -1}, {0, 1, -0.0}};
    constexpr unsigned seed = 7;
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::normal_distribution<double> coordinate;
    for (int i = 0; i < 100'000; ++i) {
        // Half of them near the lower pole, where frames with a branch lose precision.
        const double flat = i % 2 == 0 ? 1 : std::exp2(-i % 60);
        normals.push_back({flat * coordinate(random), flat * coordinate(random), i % 2 == 0 ? coordinate(random) : -1});
    }
    for (const glm::dvec3& any : normals) {
        if (glm::length(any) == 0) continue;
        const glm::dvec3 normal = glm::normalize(any), tangent = any_perpendicular(normal);
        // Allows for a few roundings of numbers up to 2: 2^-53 each.
        ASSERT_NEAR(glm::length(tangent), 1, 2e-15) << any.x << ' ' << any.y << ' ' << any.z;
        ASSERT_NEAR(glm::dot(tangent, normal), 0, 2e-15) << any.x << ' ' << any.y << ' ' << any.z;
    }
}

}  // namespace
}  // namespace relief
