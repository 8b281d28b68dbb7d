// What one triangle contributes to the tangents at its corners.
#pragma once

#include "framework/staff/reference/tangents.h"

namespace relief {

struct TangentFace {
    glm::vec3 along;           ///< dP/du, normalised; zero if the triangle has none
    int8_t handedness = 0;     ///< the sign of its area in uv; 0 without area, or if it is in no group
    TangentFallback why = {};  ///< why `along` is zero
    bool in_no_group = false;  ///< two corners coincide, or one is not finite: it connects no triangles
    float weight[3] = {};      ///< per corner
};

/// angles[i] = atan2(y[i], x[i]) in [0, pi], for y >= 0; 0 if both are 0. The error is at most 5e-7. Takes many at
/// once: one call of the library's atan2 per angle would cost more than all the rest of a triangle.
void angles_of(const double* y, const double* x, float* angles, int count);

/// The angles at a triangle's corners, each as a sine and a cosine of a common length.
struct FaceAngles {
    double sine[3], cosine[3];
};

/// `normals[i]` is the unit normal at corner i; only mikktspace reads it. For `angle` and `mikktspace` it fills in
/// `angles` and leaves the weights to angles_of(). For `area` the weights are in units of `area_unit`.
TangentFace tangent_face(const Vertex* const corners[3], const glm::dvec3 normals[3], TangentMethod method,
                         double area_unit, FaceAngles& angles);

}  // namespace relief
