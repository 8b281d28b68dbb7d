// The cameras of lab 14, and the inputs of its control shader: the planes of the view frustum, and the measured bounds
// of each patch.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "framework/library/kit/displaced_surface.h"
#include "patch_heights.h"

namespace relief::adaptive {

/// Returns the six planes of the camera's view frustum, in the coordinates of a model that stands at `origin`. xyz has
/// unit length and points inwards.
std::array<glm::vec4, 6> planes_of(const Camera& camera, const glm::dvec3& origin);

/// Returns the camera that shows the patches of `eye`'s picture. It looks at the ground from above and behind the eye,
/// and at other shapes from the side, so that patches that face away from the eye are visible.
Camera camera_above(const Frame& eye, bool is_ground);

/// Returns the pixels that an angle of one radian covers in the middle of the picture.
double pixels_per_radian(const Frame& frame);
/// Returns the same for the corners of the picture, where it has its maximum: perspective stretches a picture radially
/// by 1 / cos² of the angle from its middle.
double most_pixels_per_radian(const Frame& frame);

/// The bounds of all patches in a texture of four floats a texel: see shaders/14_adaptive_displacement/patch_rows.glsl.
/// Infinity is stored as 1e30.
class PatchTexture {
public:
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
