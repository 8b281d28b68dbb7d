// The inputs of lab 14's control shader: the planes of the view frustum, and the measured bounds of each patch.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "framework/height/patches.h"
#include "framework/kit/displaced_surface.h"

namespace relief::adaptive {

/// Returns the six planes of the camera's view frustum, in the coordinates of a model that stands at `origin`. xyz has
/// unit length and points inwards.
std::array<glm::vec4, 6> planes_of(const Camera& camera, const glm::dvec3& origin);

/// Returns the pixels that an angle of one radian covers in the middle of the picture.
double pixels_per_radian(const Frame& frame);
/// Returns the same for the corners of the picture, where it has its maximum: perspective stretches a picture radially
/// by 1 / cos² of the angle from its middle.
double most_pixels_per_radian(const Frame& frame);

/// Bounds of the directions that the triangles of a patch can face.
struct Facing {
    glm::dvec4 sphere;  ///< around the corners: centre and radius
    glm::dvec3 axis;    ///< unit: the normal of the patch if it is flat
    double spread;      ///< upper bound of |direction - axis| over the directions of displacement; 2 if unknown
    /// Upper bounds for a chord, in metres per metre that it goes across the axis. Without displacement: its rise along
    /// the axis.
    double flat_rise;
    /// With displacement, per metre of the chord on the smooth patch of facing_of(): the rise along the axis, and how
    /// far the unevenness of the relief shifts the chord across the axis.
    double rise, shift;
    double skew, length;  ///< of the patch's shape: factors by which a thin triangle is steeper than its edges
};

/// Returns the bounds of a patch whose heights lie between `heights.lowest` and `heights.highest` and change by up to
/// `heights.slope` per metre. `scale` is the depth of the relief in metres.
///
/// Let p be the undisplaced patch, E the mean of the lowest and the highest depth, and D the direction of displacement,
/// linear between the corners. The displaced patch is the smooth patch p - E D, which is bilinear, plus a remainder.
/// Between two points the remainder changes by a bounded multiple of their distance on the smooth patch. A bilinear
/// difference equals the midpoint derivative times the offset. Seen along the axis, the derivatives are quotients of
/// bilinear means, so the maximum over the corners bounds them everywhere.
///
/// A triangle is steeper than its edges if its corners are almost collinear. The shader derives from the levels how
/// thin the triangles are. `skew` and `length` add the shape of the patch.
///
/// `flat_rise` and `rise` are infinite if the patch folds over as seen along its axis. `rise` is infinite, too, if an
/// edge or a corner reads heights elsewhere on the map than the inside does.
Facing facing_of(std::span<const PatchCorner> patch, const PatchHeights& heights, double scale);

/// The bounds of all patches in a texture of four floats a texel. Each patch has `rows` texels side by side, and each
/// line of the texture has `patches_a_line` patches. The texels of a patch:
///   0        lowest, highest, spread, 0
///   1        sphere
///   2        axis, flat_rise
///   3        rise, shift, skew, length
///   4, 5     the inside: errors of levels 1 to 8; errors of levels 16 to 64, mean of the lowest and highest height
///   6 to 13  the same of edges 0 to 3, two texels each
/// Infinity is stored as 1e30.
class PatchTexture {
public:
    static constexpr int rows = 14, patches_a_line = 64;

    /// Binds the texture to s_patches at texture unit `unit`. Measures the patches if the surface has changed.
    /// Precondition: the program is in use. `with_errors` asks for the errors, which take a while to measure and which
    /// only one method needs; without it they may be 0.
    void set(const Program& program, const DisplacedSurface& surface, bool with_errors, int unit);

    /// Measures all patches. Errors include the effect of a direction of displacement that turns along a patch.
    static std::vector<PatchHeights> known_of(const DisplacedSurface& surface, bool with_errors);
    static Image image(const PatchMesh& patches, const std::vector<PatchHeights>& known, double scale);

private:
    std::optional<Texture> texture_;
    std::vector<PatchHeights> known_;
    int version_ = 0;
    float scale_ = 0;
    bool has_errors_ = false;
};

}  // namespace relief::adaptive
