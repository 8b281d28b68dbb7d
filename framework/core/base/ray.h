// A ray, in double precision.
#pragma once

#include <glm/glm.hpp>

namespace relief {

struct Ray {
    glm::dvec3 origin, direction;  ///< the direction need not be normalised: distances are in units of its length

    glm::dvec3 at(double t) const { return origin + t * direction; }
};

}  // namespace relief
