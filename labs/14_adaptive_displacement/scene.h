// What the control shader of lab 14 is told: the planes of the picture, and what is known of each patch.
#pragma once

#include <array>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>

#include "framework/image/patch_heights.h"
#include "framework/lab/displaced_surface.h"

namespace relief::adaptive {

/// The sides of what a camera sees, as planes in a model that stands at `origin`: xyz is unit and points inwards.
inline std::array<glm::vec4, 6> planes_of(const Camera& camera, const glm::dvec3& origin) {
    const glm::dmat4 clip_from_model = camera.clip_from_world() * glm::translate(glm::dmat4(1), origin);
    const glm::dvec4 w = glm::row(clip_from_model, 3);
    std::array<glm::vec4, 6> planes;
    for (int i = 0; i < 6; ++i) {
        const glm::dvec4 plane = w + (i % 2 ? -1.0 : 1.0) * glm::row(clip_from_model, i / 2);
        planes[size_t(i)] = glm::vec4(plane / glm::length(glm::dvec3(plane)));
    }
    return planes;
}

/// What an angle of one radian is wide at the middle of the picture.
inline double pixels_per_radian(const Frame& frame) {
    return frame.size.y / (2 * std::tan(glm::radians(frame.camera.orbit().field_of_view) / 2));
}

/// PatchHeights as texels of four floats, `rows` of them a patch, 64 patches a line: bounds and slope; the errors of
/// the inside, of levels 1 to 8 and of 16 to 64; those of edges 0 to 3.
class PatchTexture {
public:
    static constexpr int rows = 12, patches_a_line = 64;

    /// Binds s_patches; the program is in use.
    void set(const Program& program, const DisplacedSurface& surface, int unit) {
        if (!texture_ || version_ != surface.version()) {
            version_ = surface.version();
            texture_.emplace(
                "patches", [&surface] { return image(known_of(surface)); }, TextureOptions{.mips = false});
        }
        program.set("s_patches", unit, *texture_);
    }

private:
    static std::vector<PatchHeights> known_of(const DisplacedSurface& surface) {
        std::vector<HeightCorner> corners;
        for (const PatchCorner& point : surface.patches().points)
            corners.push_back({point.vertex.position, point.vertex.uv, point.height_uv, point.edge_uv});
        return measure_patches(corners, surface.corners(), surface.heights());
    }

    static Image image(const std::vector<PatchHeights>& patches) {
        const int lines = int((patches.size() + patches_a_line - 1) / patches_a_line);
        Image image(rows * patches_a_line, std::max(1, lines), 4);
        for (size_t i = 0; i < patches.size(); ++i) {
            // Row 0 of an image is the top, that of a texture the lowest.
            float* texel = image.pixel(int(i % patches_a_line) * rows, image.height - 1 - int(i / patches_a_line));
            const auto& [lowest, highest, slope, inside, edge_heights, edges] = patches[i];
            texel[0] = lowest, texel[1] = highest, texel[2] = slope;
            const auto put = [&](const LevelErrors& errors, float last) {
                texel = std::copy(errors.begin(), errors.end(), texel);
                *texel++ = last;
            };
            texel += 4;
            put(inside, 0);
            for (size_t k = 0; k < edges.size(); ++k) put(edges[k], edge_heights[k]);
        }
        return image;
    }

    std::optional<Texture> texture_;
    int version_ = 0;
};

}  // namespace relief::adaptive
