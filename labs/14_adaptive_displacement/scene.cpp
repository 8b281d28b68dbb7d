// Planes, cones and errors for the control shader of lab 14.
#include "scene.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

namespace relief::adaptive {
namespace {

/// Returns the largest singular value of the matrix with the columns u and v.
double most_of(const glm::dvec3& u, const glm::dvec3& v) {
    const double uu = glm::dot(u, u), vv = glm::dot(v, v), uv = glm::dot(u, v);
    return std::sqrt((uu + vv + std::hypot(uu - vv, 2 * uv)) / 2);
}

/// The sides of a patch at a corner: a leads to the next corner, b to the previous one. `area` is the signed area of
/// their parallelogram as seen along an axis.
struct Span {
    glm::dvec3 a, b;
    double area;
};

/// The corners of a patch and the axis along which they are seen. Numbers of corners wrap around.
class Corners {
public:
    Corners(std::span<const PatchCorner> patch, const glm::dvec3& axis)
        : patch_(patch),
          axis_(axis),
          e_(glm::normalize(glm::cross(axis, std::abs(axis.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)))),
          f_(glm::cross(axis, e_)) {}

    glm::dvec3 direction(size_t i) const { return glm::dvec3(patch_[i % patch_.size()].direction); }
    glm::dvec3 before(size_t i) const { return direction(i + patch_.size() - 1); }

    /// Returns the sides at corner i of the patch whose corners are moved `depth` metres against their directions.
    Span span(size_t i, double depth) const {
        const auto place = [&](size_t k) {
            return glm::dvec3(patch_[k % patch_.size()].vertex.position) - depth * direction(k);
        };
        Span span{place(i + 1) - place(i), place(i + patch_.size() - 1) - place(i), 0};
        span.area = glm::dot(axis_, glm::cross(span.a, span.b));
        return span;
    }

    /// Returns the upper bound of the change per metre, seen along the axis, of a vector that is linear over the corner
    /// and changes by da along span.a and by db along span.b.
    double rate(const Span& span, const glm::dvec3& da, const glm::dvec3& db) const {
        const auto along = [&](const glm::dvec3& way) {  // multiplied by the area
            return da * glm::dot(axis_, glm::cross(way, span.b)) + db * glm::dot(axis_, glm::cross(span.a, way));
        };
        return most_of(along(e_), along(f_)) / span.area;
    }

private:
    std::span<const PatchCorner> patch_;
    glm::dvec3 axis_, e_, f_;
};

/// Returns the sphere, axis and spread of a patch. The other members have the values of a patch that folds over.
Facing folded(std::span<const PatchCorner> patch) {
    const size_t n = patch.size();
    const auto position = [&](size_t i) { return glm::dvec3(patch[i % n].vertex.position); };
    const auto direction = [&](size_t i) { return glm::dvec3(patch[i % n].direction); };
    Facing facing{};
    glm::dvec3 centre(0);
    for (size_t i = 0; i < n; ++i) centre += position(i) / double(n);
    double radius = 0;
    for (size_t i = 0; i < n; ++i) radius = std::max(radius, glm::distance(centre, position(i)));
    facing.sphere = {centre, radius * (1 + 1e-5)};  // for rounding to float
    const glm::dvec3 across = n == 4 ? glm::cross(position(2) - position(0), position(3) - position(1))
                                     : glm::cross(position(1) - position(0), position(2) - position(0));
    facing.axis = glm::length(across) > 0 ? glm::normalize(across) : direction(0);
    for (size_t i = 0; i < n; ++i) facing.spread = std::max(facing.spread, glm::distance(facing.axis, direction(i)));
    // Between directions that differ by 90 degrees or more any direction may lie. NaN becomes 2, too.
    if (!(facing.spread < std::sqrt(2.0))) facing.spread = 2;
    facing.flat_rise = facing.rise = std::numeric_limits<double>::infinity();
    facing.skew = facing.length = 1;
    return facing;
}

/// Returns whether an edge or a corner reads heights elsewhere on the map than the inside does. Then the slope of the
/// inside does not bound the steps between them. Offsets by whole tiles do not count.
bool has_jump(std::span<const PatchCorner> patch) {
    const auto is_whole = [](glm::vec2 tiles) { return tiles == glm::round(tiles); };
    for (size_t i = 0; i < patch.size(); ++i) {
        const PatchCorner &here = patch[i], &there = patch[(i + 1) % patch.size()];
        const glm::vec2 begin = glm::vec2(here.edge_uv) - here.vertex.uv,
                        end = glm::vec2(here.edge_uv.z, here.edge_uv.w) - there.vertex.uv;
        if (begin != end || !is_whole(begin) || !is_whole(here.height_uv - here.vertex.uv)) return true;
    }
    return false;
}

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

double pixels_per_radian(const Frame& frame) {
    return frame.size.y / (2 * std::tan(glm::radians(frame.camera.orbit().field_of_view) / 2));
}

double most_pixels_per_radian(const Frame& frame) {
    const double up = std::tan(glm::radians(frame.camera.orbit().field_of_view) / 2),
                 across = up * frame.size.x / std::max(1, frame.size.y);
    return pixels_per_radian(frame) * (1 + up * up + across * across);
}

Facing facing_of(std::span<const PatchCorner> patch, const PatchHeights& heights, double scale) {
    Facing facing = folded(patch);
    const glm::dvec3 axis = facing.axis;
    const double shortest = 1 - facing.spread * facing.spread / 2;  // lower bound of the length of D, see scene.h
    if (shortest <= 0) return facing;

    const Corners corners(patch, axis);
    const double middle = scale * (1 - (double(heights.lowest) + double(heights.highest)) / 2),
                 uneven = scale * (double(heights.highest) - double(heights.lowest)) / 2;
    double flat_rise = 0, rise = 0, stretch = 0, turn = 0, longest = 0, cosine = 0;
    double area = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < patch.size(); ++i) {
        const Span flat = corners.span(i, 0), inner = corners.span(i, middle);
        if (!(flat.area > 0 && inner.area > 0)) return facing;
        flat_rise =
            std::max(flat_rise, corners.rate(flat, axis * glm::dot(axis, flat.a), axis * glm::dot(axis, flat.b)));
        rise = std::max(rise, corners.rate(inner, axis * glm::dot(axis, inner.a), axis * glm::dot(axis, inner.b)));
        stretch = std::max(stretch, corners.rate(inner, flat.a, flat.b));
        turn = std::max(turn, corners.rate(inner, corners.direction(i + 1) - corners.direction(i),
                                           corners.before(i) - corners.direction(i)));
        for (const Span& span : {flat, inner}) {
            const glm::dvec3 a = span.a - axis * glm::dot(axis, span.a), b = span.b - axis * glm::dot(axis, span.b);
            longest = std::max({longest, glm::dot(a, a), glm::dot(b, b)});
            area = std::min(area, span.area);
            cosine = std::max(cosine, std::abs(glm::dot(a, b)) / (glm::length(a) * glm::length(b)));
        }
    }
    facing.flat_rise = flat_rise;
    facing.length = longest / area;
    facing.skew = 1 / std::sqrt(std::max(1 - cosine, 1e-12));
    if (has_jump(patch)) return facing;
    // The displaced patch is p - depth d with a unit direction d. The smooth patch p - middle D differs from it
    // by (depth - middle) d + middle (d - D). The second term is not 0, because D is not of unit length.
    const double deeper = scale * double(heights.slope) * stretch;
    const double turned = uneven * turn / shortest +
                          std::abs(middle) * turn * (facing.spread * facing.spread / 2 + 2 * facing.spread) / shortest;
    facing.rise = rise + deeper + turned;
    facing.shift = deeper * facing.spread + turned;
    return facing;
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
    Image image(rows * patches_a_line, std::max(1, lines), 4);
    for (size_t i = 0; i < known.size(); ++i) {
        // Row 0 is the top row of an image, but the bottom row of a texture.
        float* texel = image.pixel(int(i % patches_a_line) * rows, image.height - 1 - int(i / patches_a_line));
        const auto put = [&](std::initializer_list<double> values) {
            // Clamps infinity, so that the shader computes with finite numbers.
            for (const double value : values) *texel++ = float(std::min(value, 1e30));
        };
        const Facing facing = facing_of({&patches.points[i * n], n}, known[i], scale);
        put({double(known[i].lowest), double(known[i].highest), facing.spread, 0});
        put({facing.sphere.x, facing.sphere.y, facing.sphere.z, facing.sphere.w});
        put({facing.axis.x, facing.axis.y, facing.axis.z, facing.flat_rise});
        put({facing.rise, facing.shift, facing.skew, facing.length});
        const auto put_errors = [&](const LevelErrors& errors, float height) {
            texel = std::copy(errors.begin(), errors.end(), texel);
            *texel++ = height;
        };
        put_errors(known[i].inside, (known[i].lowest + known[i].highest) / 2);
        for (size_t k = 0; k < known[i].edges.size(); ++k) put_errors(known[i].edges[k], known[i].edge_heights[k]);
    }
    return image;
}

}  // namespace relief::adaptive
