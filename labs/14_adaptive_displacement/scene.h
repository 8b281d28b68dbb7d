// The inputs of lab 14's control shader: the planes of the picture, and the measured bounds of each patch.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "framework/height/patches.h"
#include "framework/kit/displaced_surface.h"

namespace relief::adaptive {

/// The sides of what a camera sees, as planes in a model at `origin`: xyz has unit length and points inwards.
std::array<glm::vec4, 6> planes_of(const Camera& camera, const glm::dvec3& origin);

/// What an angle of one radian is wide in the middle of the picture, in pixels.
double pixels_per_radian(const Frame& frame);
/// The same in its corners, where that is the most: sideways and along the line of sight a metre grows there.
double most_pixels_per_radian(const Frame& frame);

/// Which way the triangles of a patch can face.
struct Facing {
    glm::dvec4 sphere;    ///< around the corners: centre and radius
    glm::dvec3 axis;      ///< unit: what a flat patch faces
    double spread;        ///< the longest difference between a direction of the relief and the axis
    double flat_rise;     ///< undisplaced, of a chord along the axis: metres per metre across it
    double rise, shift;   ///< displaced: the same beside what it is without the relief's unevenness; and how far across
    double skew, length;  ///< of the patch: what a triangle may make of a slope
};

/// Heights change by up to `heights.slope` per metre, and lie between lowest and highest. With the middle of these, E,
/// and the directions D (linear between the corners) the displaced patch is the patch p - E D, which is bilinear, and a
/// rest that changes by a known part of what one goes along that patch. What is bilinear changes between two places as
/// its derivatives half-way say; seen along the axis those are quotients of bilinear means, and so nowhere worse than
/// at the worst corner. A triangle's plane through three such places is steeper than its sides when these lie almost in
/// a line: the shader knows from the levels how thin triangles are, and `skew` and `length` what the patch's shape
/// adds. A patch that folds over as seen along its axis has an infinite rise.
Facing facing_of(std::span<const PatchCorner> patch, const PatchHeights& heights, double scale);

/// All of that as texels of four floats, `rows` a patch, 64 patches a line: lowest, highest, spread; sphere; axis and
/// flat_rise; rise, shift, skew, length; the errors of the inside, of levels 1 to 8 and of 16 to 64 with the middle of
/// its heights; the same of edges 0 to 3.
class PatchTexture {
public:
    static constexpr int rows = 14, patches_a_line = 64;

    /// Binds s_patches; the program is in use. Errors take a while, and only one method asks for them.
    void set(const Program& program, const DisplacedSurface& surface, bool with_errors, int unit);

    /// Errors are those of what is pressed in along turning directions, too.
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
