// Tangents for a whole mesh, by the functions of task.cpp.
#pragma once

#include "framework/core/base/mesh.h"
#include "framework/library/kit/choices.h"
#include "task.h"

namespace relief::basis {

enum class Axis { tangent, bitangent };

/// Returns a mesh with a vertex for each corner, which has the frame of its triangle: T in `tangent.xyz`, or B.
Mesh with_faces(const Mesh& mesh, Axis axis = Axis::tangent);

/// Returns a mesh with the weighted mean of the triangles' T or B at each vertex, in `tangent.xyz`. Mirrored triangles
/// have a mean, and a vertex, of their own, since together with the others they would cancel out.
Mesh with_means(const Mesh& mesh, Weight weight, Axis axis = Axis::tangent);

/// The sources of a tangent. The last is no method: B of each face, for a probe.
enum Method { per_face, uniform, area, angle, mikktspace, derivatives, analytic, of_file, solved_bitangent };
inline constexpr auto methods = choices<Method>({{per_face, "per-face"},
                                                 {uniform, "uniform"},
                                                 {area, "area"},
                                                 {angle, "angle"},
                                                 {mikktspace, "mikktspace"},
                                                 {derivatives, "derivatives", "DERIVATIVES"},
                                                 {analytic, "analytic"},
                                                 {of_file, "file"}});
/// Returns the mesh with the tangents of a method. With Axis::bitangent and the method `angle`, they are the
/// bitangents. Methods that need no tangents at vertices, or find them in the mesh, return it unchanged.
Mesh with_tangents(const Mesh& mesh, Method method, Axis axis = Axis::tangent);

/// Returns how far the tangents of two meshes with the same corners are apart, over all corners.
struct TangentDifference {
    double mean_degrees = 0;
    size_t mirrored = 0;  ///< corners with opposite handedness
};
TangentDifference difference_of(const Mesh& given, const Mesh& made);

}  // namespace relief::basis
