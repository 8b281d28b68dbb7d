// Places on a patch, and the relief on it, in double precision. The twin of shaders/common/patch.glsl.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "framework/image/image.h"
#include "framework/mesh/patches.h"
#include "framework/staff/reference/displaced.h"
#include "framework/staff/reference/height_field.h"

namespace relief {

/// Of the four corners at (0, 0), (1, 0), (1, 1) and (0, 1).
glm::dvec4 quad_weights(glm::dvec2 place);
glm::dvec4 blend(const glm::dvec4& weights, const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4& c,
                 const glm::dvec4& d);
/// Edge i goes from corner i to the next; -1 within. A corner is on either of its edges.
int edge_of_triangle(const glm::dvec3& weights);
int edge_of_quad(glm::dvec2 place);
/// Between the uv of an edge's ends; at an end where that corner reads its height.
glm::dvec2 uv_on_edge(double here, double there, const glm::dvec4& edge_uv, glm::dvec2 uv_here, glm::dvec2 uv_there);

/// dF/du and dF/dv where F and uv change so along two directions; 0 where the uv do not tell them apart.
std::array<glm::dvec3, 2> by_uv(const glm::dvec3& along_x, const glm::dvec3& along_y, glm::dvec2 uv_x, glm::dvec2 uv_y);
/// The derivative of a normalised vector, from that of the vector itself; 0 for the vector 0.
glm::dvec3 turn_of_unit(const glm::dvec3& vector, const glm::dvec3& change);

/// What gl_TessCoord says: the weights of three corners, or x and y in the domain of four.
using PatchPlace = glm::dvec3;

/// The surface that all levels of tessellation approach: heights of the bilinear map itself, at every place of a patch.
/// Its normal is that of the inside, also on an edge whose heights are another patch's.
DisplacedPoint displaced_on(const PatchMesh& mesh, size_t patch, const PatchPlace& place, const HeightField& heights,
                            double scale);

/// That surface as a mesh of n x n squares of two triangles on each patch of four corners, at float positions, with
/// normals of its own, the places on the patch as uv, and no tangents. Patch i has (n + 1)² vertices from i (n + 1)²
/// on.
Mesh micro_polygons(const PatchMesh& mesh, const HeightField& heights, double scale, int n);

/// A pixel, and the place of that surface which it shows.
struct ShownPlace {
    glm::ivec2 pixel;     ///< from the upper left corner
    glm::dvec3 position;  ///< in the model, metres
};

/// Of each pixel that shows a surface, row by row. `places` holds PatchPlace.x and .y and the number of the patch for
/// each pixel (4 channels), and no_surface elsewhere. For patches of four corners.
std::vector<ShownPlace> shown_places(const Image& places, const PatchMesh& mesh, const HeightField& heights,
                                     double scale);

/// How far each of these pixels is, in pixels, from where its place should be seen.
std::vector<double> screen_errors(const Image& places, const PatchMesh& mesh, const HeightField& heights, double scale,
                                  const glm::dmat4& clip_from_model);

}  // namespace relief
