// An evening sky, in closed form.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace relief {

/// A spherical Gaussian: color exp(sharpness (dot(direction, middle) - 1)). Its integral over the sphere is
/// color 2 pi / sharpness (1 - exp(-2 sharpness)), or 4 pi color where the sharpness is 0.
struct Lobe {
    glm::dvec3 color;
    double sharpness;
    glm::dvec3 middle;  ///< unit length
};

/// Returns the lobes that add up to the sky. The sun's azimuth is +z.
const std::vector<Lobe>& evening_lobes();

/// Returns the linear light of the sky in a unit direction: the sum of its lobes, without terms below exp(-40).
glm::dvec3 evening_sky(const glm::dvec3& direction);

}  // namespace relief
