// Points on a patch and its displacement, in double precision. The twin of shaders/common/patch.glsl.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "framework/core/image/image.h"
#include "framework/library/mesh/patches.h"
#include "framework/staff/reference/displaced.h"
#include "framework/staff/reference/height_field.h"

namespace relief {

/// Returns the bilinear weights of the corners (0, 0), (1, 0), (1, 1) and (0, 1) at a point in [0, 1]².
glm::dvec4 quad_weights(glm::dvec2 place);
glm::dvec4 blend(const glm::dvec4& weights, const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4& c,
                 const glm::dvec4& d);
/// Returns the edge that a point lies on; -1 inside. Edge i goes from corner i to the next. A corner gives one of its
/// two edges.
int edge_of_triangle(const glm::dvec3& weights);
int edge_of_quad(glm::dvec2 place);
/// Returns the uv at which a point of an edge reads its height, interpolated between the uv of the edge's ends
/// (`edge_uv`). At an end it is the corner's own uv (`uv_here`, `uv_there`). `here` and `there` are the weights of the
/// two ends.
glm::dvec2 uv_on_edge(double here, double there, const glm::dvec4& edge_uv, glm::dvec2 uv_here, glm::dvec2 uv_there);

/// Returns dF/du and dF/dv from the changes of F and uv along two directions; 0 if the changes of uv are parallel.
std::array<glm::dvec3, 2> by_uv(const glm::dvec3& along_x, const glm::dvec3& along_y, glm::dvec2 uv_x, glm::dvec2 uv_y);
/// Returns the derivative of normalize(vector), where `change` is the vector's derivative; 0 for the zero vector.
glm::dvec3 turn_of_unit(const glm::dvec3& vector, const glm::dvec3& change);

/// Like gl_TessCoord: the weights of the three corners of a triangle, or x and y in [0, 1] on a quad.
using PatchPlace = glm::dvec3;

/// Returns a point of the surface that tessellation converges to: the bilinear height map displaces every point of the
/// patch. On an edge whose heights belong to another patch, the normal is still derived from this patch's interior.
DisplacedPoint displaced_on(const PatchMesh& mesh, size_t patch, const PatchPlace& place, const HeightField& heights,
                            double scale);

/// Returns that surface as a mesh: n x n squares of two triangles per patch, for patches of four corners. Positions are
/// rounded to float, normals are the surface's, uv are positions in the patch, and there are no tangents. Patch i has
/// the (n + 1)² vertices from i (n + 1)² on.
Mesh micro_polygons(const PatchMesh& mesh, const HeightField& heights, double scale, int n);

/// A pixel, and the point of that surface that it shows.
struct ShownPlace {
    glm::ivec2 pixel;     ///< from the upper left corner
    glm::dvec3 position;  ///< in the model, metres
};

/// Returns all pixels that show the surface, row by row. `places` has 4 channels: PatchPlace.x, PatchPlace.y and the
/// patch's index, or no_surface. For patches of four corners.
std::vector<ShownPlace> shown_places(const Image& places, const PatchMesh& mesh, const HeightField& heights,
                                     double scale);

/// Returns, for each of these pixels, the distance in pixels to the exact screen position of the point that it shows.
std::vector<double> screen_errors(const Image& places, const PatchMesh& mesh, const HeightField& heights, double scale,
                                  const glm::dmat4& clip_from_model);

}  // namespace relief
