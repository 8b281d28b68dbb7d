#include "scene.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "facing.h"

namespace relief::adaptive {
namespace {

#include "shaders/14_adaptive_displacement/patch_rows.glsl"

/// Adds the error at each level of a direction of displacement that turns from `from` to `to`. Errors are in heights,
/// that is, per metre of scale.
void add_turn(LevelErrors& errors, const glm::vec3& from, const glm::vec3& to) {
    // The chord of a unit circle's arc is off by angle²/8, and a relief by as much times its depth, which is 1 at most.
    // The factor 1.2 is for `turn`, which is the length of a chord and not an angle. Both orders of the ends give the
    // same bits, because the differences are squared.
    const glm::dvec3 turn = glm::dvec3(from) - glm::dvec3(to);
    double bend = std::min(1.0, glm::dot(turn, turn) / 8 * 1.2);
    for (float& error : errors) {
        error += float(bend);
        bend /= 4;
    }
}

}  // namespace

std::array<glm::vec4, 6> planes_of(const Camera& camera, const glm::dvec3& origin) {
    const glm::dmat4 clip_from_model = camera.clip_from_world() * glm::translate(glm::dmat4(1), origin);
    const glm::dvec4 w = glm::row(clip_from_model, 3);
    std::array<glm::vec4, 6> planes;
    for (size_t i = 0; i < planes.size(); ++i) {
        const glm::dvec4 plane = w + (i % 2 ? -1.0 : 1.0) * glm::row(clip_from_model, int(i / 2));
        planes[i] = glm::vec4(plane / glm::length(glm::dvec3(plane)));
    }
    return planes;
}

Camera camera_above(const Frame& eye, bool is_ground) {
    Orbit orbit = eye.camera.orbit();
    orbit.field_of_view = 40, orbit.target = {0, -0.6, 0};
    if (is_ground)
        orbit.pitch = 50, orbit.distance = 19;
    else
        orbit.yaw += 105, orbit.pitch = 25, orbit.distance = 5, orbit.target = {0, 0, 0};
    return Camera(orbit, double(eye.size.x) / std::max(1, eye.size.y));
}

double pixels_per_radian(const Frame& frame) {
    return frame.size.y / (2 * std::tan(glm::radians(frame.camera.orbit().field_of_view) / 2));
}

double most_pixels_per_radian(const Frame& frame) {
    const double up = std::tan(glm::radians(frame.camera.orbit().field_of_view) / 2),
                 across = up * frame.size.x / std::max(1, frame.size.y);
    return pixels_per_radian(frame) * (1 + up * up + across * across);
}

void PatchTexture::set(const Program& program, const DisplacedSurface& surface, bool with_errors, int unit) {
    const bool is_old = version_ != surface.version() || (with_errors && !has_errors_);
    if (!texture_ || is_old || scale_ != surface.scale()) {
        if (is_old) {
            known_.clear();
            has_errors_ = with_errors;
        }
        version_ = surface.version();
        scale_ = surface.scale();
        const auto make = [this, &surface] {
            if (known_.empty()) known_ = known_of(surface, has_errors_);
            return image(surface.patches(), known_, double(scale_));
        };
        texture_.emplace("patches", make, TextureOptions{.mips = false});
    }
    program.set("s_patches", unit, *texture_);
}

std::vector<PatchHeights> PatchTexture::known_of(const DisplacedSurface& surface, bool with_errors) {
    std::vector<HeightCorner> corners;
    const std::vector<PatchCorner>& points = surface.patches().points;
    for (const PatchCorner& point : points)
        corners.push_back({point.vertex.position, point.vertex.uv, point.height_uv, point.edge_uv});
    std::vector<PatchHeights> known = measure_patches(corners, surface.corners(), surface.heights(), with_errors);
    const size_t n = size_t(surface.corners());
    for (size_t i = 0; i < known.size(); ++i) {
        const PatchCorner* const patch = &points[i * n];
        for (size_t k = 0; k < n; ++k) add_turn(known[i].edges[k], patch[k].direction, patch[(k + 1) % n].direction);
        add_turn(known[i].inside, patch[0].direction, patch[n / 2].direction);
        add_turn(known[i].inside, patch[1].direction, patch[n - 1].direction);
    }
    return known;
}

Image PatchTexture::image(const PatchMesh& patches, const std::vector<PatchHeights>& known, double scale) {
    const size_t n = size_t(patches.corners);
    const int lines = int((known.size() + patches_a_line - 1) / patches_a_line);
    Image image(rows_a_patch * patches_a_line, std::max(1, lines), 4);
    for (size_t i = 0; i < known.size(); ++i) {
        // Line 0 is the top line of an image, but the bottom line of a texture.
        float* const texels =
            image.pixel(int(i % patches_a_line) * rows_a_patch, image.height - 1 - int(i / patches_a_line));
        const auto put = [&](int row, const glm::dvec4& values) {
            // Clamps infinity, so that the shader computes with finite numbers.
            for (int k = 0; k < 4; ++k) texels[4 * row + k] = float(std::min(values[k], 1e30));
        };
        const auto put_errors = [&](int row, const LevelErrors& errors, float height) {
            *std::copy(errors.begin(), errors.end(), texels + 4 * row) = height;
        };
        const PatchHeights& heights = known[i];
        const Facing facing = facing_of({&patches.points[i * n], n}, heights, scale);
        put(row_heights, {heights.lowest, heights.highest, facing.spread, 0});
        put(row_sphere, facing.sphere);
        put(row_axis, {facing.axis, facing.flat_rise});
        put(row_steepness, {facing.rise, facing.shift, facing.skew, facing.length});
        put_errors(row_inside, heights.inside, (heights.lowest + heights.highest) / 2);
        for (int k = 0; k < 4; ++k)
            put_errors(row_edges + 2 * k, heights.edges[size_t(k)], heights.edge_heights[size_t(k)]);
    }
    return image;
}

}  // namespace relief::adaptive
