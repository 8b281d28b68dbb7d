// Tangents for any mesh: solved from the uv of each triangle, averaged at the vertices, with fallbacks for degenerate
// triangles.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "framework/core/base/mesh.h"

namespace relief {

/// How the triangles' tangents are averaged at a vertex. A triangle's tangent is dP/du, normalised (Lengyel 2001 solves
/// the same equations). The mean is over the vertex's triangles of one handedness. It is then made perpendicular to the
/// vertex's normal.
enum class TangentMethod {
    per_face,   ///< no averaging: each corner has its triangle's tangent
    uniform,    ///< equal weights
    area,       ///< weighted by the triangles' areas
    angle,      ///< weighted by the angles at the vertex: closest to dP/du on smooth surfaces
    mikktspace  ///< by angle, and only among triangles that share edges (Mikkelsen 2008): the standard of bakers
};

/// Why a corner's triangle has no usable tangent.
enum class TangentFallback : uint8_t {
    none,
    bad_normal,          ///< zero or NaN: replaced by the mean of the triangles' geometric normals
    not_finite,          ///< a position or a uv is NaN or infinite
    zero_area,           ///< two corners coincide, or all three lie on a line
    degenerate_uv,       ///< the uv lie on a line, so u has no direction
    parallel_to_normal,  ///< dP/du runs along the normal
    count
};

/// Number of corners that used a fallback, by reason. A corner takes the tangent of a neighbour at the same vertex if
/// it can (`inherited`), else an arbitrary direction perpendicular to its normal.
struct TangentReport {
    size_t corners = 0;
    size_t fell_back[size_t(TangentFallback::count)] = {};
    size_t inherited = 0;

    size_t total() const;
    /// One line: "12 of 300 corners fell back: 9 degenerate uv, 3 zero area; 6 of them took a neighbour's tangent".
    std::string text() const;
};

/// Returns the tangent of each corner, three per triangle, in the order of the indices. xyz is perpendicular to the
/// normal of its vertex; w is the handedness, 1 or -1: the sign of the triangle's area in uv. For every mesh, the
/// result is finite, and of unit length and perpendicular within 1e-6. Positions and uv can have any finite float
/// magnitude.
///
/// All corners of a triangle have one handedness. A triangle without area in uv takes that of the first group that
/// reaches it. For this, triangles with area are visited in index order, and each triangle's corners in order. If no
/// group reaches it, the handedness is 1. It is also 1 for a triangle with a NaN or an infinity. The exception is an
/// invisible triangle, two of whose corners coincide: its corners may differ.
///
/// Vertices with equal position, normal and uv count as one, so the result does not depend on how the mesh shares
/// vertices. `mikktspace` follows the published semantics. A group at a vertex is a set of triangles of one handedness,
/// connected by edges that two of them share in opposite directions. Each dP/du is projected onto the vertex's tangent
/// plane, normalised, and weighted by the angle between the projected edges. A triangle with two equal positions
/// belongs to no group and inherits. If more than two triangles share an edge, all are connected.
///
/// Throws Error if an index has no vertex, or if the number of indices is not a multiple of three. The result does not
/// depend on the number of threads (0: one per processor). Needs about 12 bytes per triangle and 25 per vertex, besides
/// the result's 48 per triangle.
std::vector<glm::vec4> corner_tangents(const Mesh& mesh, TangentMethod method, TangentReport* report = nullptr,
                                       unsigned threads = 0);

/// Writes into an existing vector; its memory is reused.
void corner_tangents(const Mesh& mesh, TangentMethod method, std::vector<glm::vec4>& result,
                     TangentReport* report = nullptr, unsigned threads = 0);

/// Returns the mesh with tangents at its vertices. A vertex whose corners have different tangents is split; new
/// vertices come after the old ones, which keep their indices. Normals that are zero, not finite or not of unit length
/// are repaired.
Mesh with_tangents(const Mesh& mesh, TangentMethod method, TangentReport* report = nullptr, unsigned threads = 0);

}  // namespace relief
