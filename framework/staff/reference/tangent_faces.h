// What one triangle says about the tangents at its corners.
#pragma once

#include "framework/staff/reference/tangents.h"

namespace relief {

struct TangentFace {
    glm::vec3 along;           ///< unit dP/du; zero where the triangle has none
    int8_t handedness = 0;     ///< sign of the area in uv; 0 where that has none, and in no group
    TangentFallback why = {};  ///< why `along` is zero
    bool in_no_group = false;  ///< two corners in one place, or not finite: it connects nothing
    float weight[3] = {};      ///< of its three corners
};

/// The angles in [0, pi] whose sines and cosines are as y >= 0 to x; 0 for 0 and 0. Within 5e-7, and many at once: a
/// library's atan2, one by one, costs more than all the rest of a triangle.
void angles_of(const double* y, const double* x, float* angles, int count);

/// What a triangle says, but for the weights of its corners; these, or the sines and cosines of the angles that they
/// are.
struct FaceAngles {
    double sine[3], cosine[3];
};

/// `normals[i]` are the unit normals of the corners' vertices, for mikktspace. For `angle` and `mikktspace` the weights
/// are left to angles_of(); weights of `area` are relative to `area_unit`.
TangentFace tangent_face(const Vertex* const corners[3], const glm::dvec3 normals[3], TangentMethod method,
                         double area_unit, FaceAngles& angles);

}  // namespace relief
