// Tangents for any mesh: solved from the uv of each triangle, averaged at the vertices, and made usable where there is
// nothing to solve.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "framework/mesh/mesh.h"

namespace relief {

/// A triangle's tangent is dP/du, normalised (Lengyel 2001 solves the same equations). A vertex takes the mean of those
/// of its triangles with the same handedness, made perpendicular to its normal.
enum class TangentMethod {
    per_face,   ///< no mean at all: facets
    uniform,    ///< all triangles alike
    area,       ///< by their areas
    angle,      ///< by their angles at the vertex: nearest to dP/du on smooth surfaces
    mikktspace  ///< by angles, and only among triangles that share edges: what bakers write (Mikkelsen 2008)
};

/// Corners whose triangle has no tangent of its own, or none that can be used.
enum class TangentFallback : uint8_t {
    none,
    bad_normal,          ///< zero or not a number: replaced by the mean of the triangles' own
    not_finite,          ///< a position or a uv is not a number, or infinite
    zero_area,           ///< two corners in one place, or all three on a line
    degenerate_uv,       ///< the uv lie on a line: there is no direction of u
    parallel_to_normal,  ///< dP/du runs along the normal
    count
};

/// How many corners fell back, by reason. Those that could take the tangent of a neighbour at the same vertex did so
/// (`inherited`), the others have any direction perpendicular to their normal.
struct TangentReport {
    size_t corners = 0;
    size_t fell_back[size_t(TangentFallback::count)] = {};
    size_t inherited = 0;

    size_t total() const;
    /// One line: "12 of 300 corners fell back: 9 degenerate uv, 3 zero area; 6 of them took a neighbour's tangent".
    std::string text() const;
};

/// The tangent of each corner (three a triangle, in the order of the indices): xyz unit and perpendicular to the normal
/// of its vertex, w the handedness, 1 or -1, from the sign of the triangle's area in uv. Always finite, normalised and
/// at right angles within 1e-6, whatever the mesh holds; positions and uv may have any size that floats have.
///
/// A triangle without area in uv has one handedness, too: that of the first group that reaches it, with the triangles
/// that have area taken in their order, and the corners of each; 1 where none does. Only a triangle with two corners in
/// one place, which nobody sees, may have a corner of each.
///
/// Vertices with equal position, normal and uv are one, so it does not matter how the mesh shares them. For
/// `mikktspace` the published semantics: groups at a vertex are triangles connected by edges there that both run along
/// in opposite directions, of one handedness; each dP/du is projected onto the vertex's tangent plane and normalised
/// before it is weighed by the angle between the projected edges; a triangle with two equal positions belongs to no
/// group and inherits. Where more than two triangles share an edge all are connected.
///
/// Throws Error when an index has no vertex or the last triangle is not whole. The same for any number of threads (0:
/// all). Takes some 40 bytes a triangle and 25 a vertex besides the result's 48 a triangle.
std::vector<glm::vec4> corner_tangents(const Mesh& mesh, TangentMethod method, TangentReport* report = nullptr,
                                       unsigned threads = 0);

/// The same into memory that is there.
void corner_tangents(const Mesh& mesh, TangentMethod method, std::vector<glm::vec4>& result,
                     TangentReport* report = nullptr, unsigned threads = 0);

/// The mesh with tangents at its vertices: a vertex whose corners have several is split, one for each, and the others
/// keep their places. Normals that are zero, not finite or not normalised are repaired. New vertices come after the old
/// ones.
Mesh with_tangents(const Mesh& mesh, TangentMethod method, TangentReport* report = nullptr, unsigned threads = 0);

}  // namespace relief
