// A check's allowance for the renderer where it cannot choose one: in a browser, and in a window on a GPU. Renderers
// draw a surface at slightly different places, and differ in their filters and derivatives.
#pragma once

#include <array>
#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "framework/core/image/compare.h"
#include "framework/core/image/image.h"
#include "framework/course/manifest/manifest.h"

namespace relief::check {

/// How a renderer draws: `exact` like the one that drew the expected pictures (Mesa's llvmpipe); `usual` like a GPU;
/// `coarse` with vertices rounded to 1/16 pixel, 16 times as coarsely as usual (SwiftShader). A surface that reaches
/// behind the eye can then move by half a pixel, and where a texture is not filtered, any pixel can change.
enum class Rasteriser { exact, usual, coarse };
Rasteriser rasteriser_of(const std::string& renderer);

/// The renderer of the checks' pictures.
struct NamedRenderer {
    std::string name = {};
    /// Moves all vertices of later drawings, also of those into textures, by a part of a pixel. May be empty.
    std::function<void(glm::vec2 pixels)> move_vertices = {};
};

/// Parts of a pixel that each make a coarse renderer round about half of all coordinates to another side.
inline constexpr std::array<glm::vec2, 4> vertex_moves = {
    {{1 / 32.0f, 1 / 64.0f}, {-1 / 64.0f, 1 / 32.0f}, {-1 / 32.0f, -1 / 64.0f}, {1 / 64.0f, -1 / 32.0f}}};

/// Returns the picture to judge instead of `drawn`. `exact`: `drawn` itself. `usual`: without_shifts() of half a pixel,
/// then without_outliers() of 1 %. `coarse`: without_rounding() in the drawings `moved`, then without_shifts() of an
/// eighth of a pixel, and without_outliers() of 2 %: of a probe, among the pixels that differ in `moved`. Two pictures
/// that must differ (Limits::at_least) are judged as they are, and so are pictures of different shapes.
Image with_allowance(Rasteriser rasteriser, const CheckInfo& check, ErrorMetric metric, const Image& drawn,
                     const Image& expected, const std::vector<Image>& moved = {});

/// Returns `drawn` without the part of each pixel's error that the rounding of vertices can explain. `moved` has the
/// same shot, drawn with each of vertex_moves. In each channel, `drawn` and `moved` span a range, which is widened by a
/// quarter of its length on either side: five samples of a random error span most of its distribution, and not all. A
/// pixel becomes the value of the widened range that is nearest to the expected one. So a picture that does not depend
/// on the rounding keeps all its errors. Directions (ErrorMetric::angle) keep their length. A pixel that has a surface
/// in some drawings only becomes the expected one. NaN and not_written stay. Precondition: all have the same shape.
Image without_rounding(const Image& drawn, const std::vector<Image>& moved, const Image& expected, ErrorMetric metric);

/// Returns `drawn` without the part of each pixel's error that a shift of the picture by `pixels` (0 to 1) can explain.
/// The expected pixel and its eight neighbours span a range in each channel. Towards the pixel's own value, the range
/// is shortened to the share `pixels`. A value in that range becomes the expected value. A value outside of it keeps
/// its distance from the range as its error. So errors count in full where the expected picture is smooth, and less
/// along its edges and in its noise. Directions (ErrorMetric::angle) keep their length. A surface in only one of both
/// pictures is allowed where the expected picture has an outline. NaN and not_written stay. Precondition: the same
/// width and height, and the channels that the metric reads.
Image without_shifts(const Image& drawn, const Image& expected, ErrorMetric metric, float pixels);

/// Returns `drawn` with the expected values in the `share` of its pixels whose errors are largest, for checks that
/// limit the largest error. NaN and not_written stay, and so do surfaces in only one of both pictures.
/// Pixels that are true in `stays` keep their errors; none if it is empty.
Image without_outliers(const Image& drawn, const Image& expected, ErrorMetric metric, double share,
                       const std::vector<bool>& stays = {});

}  // namespace relief::check
