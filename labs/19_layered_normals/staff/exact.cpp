#include "exact.h"

#include <algorithm>
#include <cmath>

#include "framework/core/image/mips.h"

namespace relief::layered_normals {
namespace {

/// Returns v rotated by the shortest rotation from z to the unit vector `to`, whose z is above -1 (Rodrigues).
glm::dvec3 rotated_from_z(const glm::dvec3& to, const glm::dvec3& v) {
    const glm::dvec3 axis = glm::cross(glm::dvec3(0, 0, 1), to);  // its length is the sine, to.z the cosine
    return to.z * v + glm::cross(axis, v) + glm::dot(axis, v) / (1 + to.z) * axis;
}

glm::dvec4 bilinear(const Image& image, glm::dvec2 uv) {
    const glm::dvec2 size(image.width, image.height), place = (uv - glm::floor(uv)) * size - 0.5,
                                                      low = glm::floor(place), share = place - low;
    const auto texel = [&](int dx, int dy) {
        const int x = (int(low.x) + dx + image.width) % image.width,
                  y = (int(low.y) + dy + image.height) % image.height;
        const float* values = image.pixel(x, image.height - 1 - y);
        return glm::dvec4(values[0], values[1], values[2], values[3]);
    };
    return glm::mix(glm::mix(texel(0, 0), texel(1, 0), share.x), glm::mix(texel(0, 1), texel(1, 1), share.x), share.y);
}

}  // namespace

glm::dvec3 with_slope(glm::dvec2 slope) { return glm::normalize(glm::dvec3(-slope, 1)); }

glm::dvec3 blended(Settings::Blend blend, const glm::dvec3& base, const glm::dvec3& detail) {
    const glm::dvec3 &a = base, &b = detail;
    switch (blend) {
        case Settings::linear:
            return glm::normalize(a + b);
        case Settings::overlay: {
            glm::dvec3 color;
            for (int i = 0; i < 3; ++i) {
                const double low = 0.5 + 0.5 * a[i], high = 0.5 + 0.5 * b[i];
                color[i] = low < 0.5 ? 2 * low * high : 1 - 2 * (1 - low) * (1 - high);
            }
            return glm::normalize(2.0 * color - 1.0);
        }
        case Settings::whiteout:
            return glm::normalize(glm::dvec3(a.x + b.x, a.y + b.y, a.z * b.z));
        case Settings::udn:
            return glm::normalize(glm::dvec3(a.x + b.x, a.y + b.y, a.z));
        case Settings::rnm:
            return rotated_from_z(a, b);
        case Settings::swizzle:
            return glm::normalize(b.x * glm::dvec3(a.z, a.y, -a.x) + b.y * glm::dvec3(a.x, a.z, -a.y) + b.z * a);
        default:
            return with_slope(-glm::dvec2(a) / a.z - glm::dvec2(b) / b.z);
    }
}

glm::dvec3 exact_blend(Settings::Question question, const glm::dvec3& base, const glm::dvec3& detail, double height,
                       const glm::dvec3& bend) {
    const glm::dvec2 first = -glm::dvec2(base) / base.z, second = -glm::dvec2(detail) / detail.z;
    if (question == Settings::heights_add) return with_slope(first + second);
    if (question == Settings::shortest_arc) return rotated_from_z(base, detail);
    if (question == Settings::in_frame) {
        const glm::dvec3 right = glm::normalize(glm::dvec3(1, 0, first.x));
        return glm::dmat3(right, glm::cross(base, right), base) * detail;
    }
    // n = m / |m| with m = (-slope, 1) has the derivative (m' - n (n m')) / |m|, and 1 / |m| is base.z.
    const auto turn = [&](glm::dvec2 change) {
        const glm::dvec3 m(-change, 0);
        return base.z * (m - base * glm::dot(base, m));
    };
    const glm::dvec3 along_u = glm::dvec3(1, 0, first.x) + second.x * base + height * turn({bend.x, bend.y}),
                     along_v = glm::dvec3(0, 1, first.y) + second.y * base + height * turn({bend.y, bend.z});
    return glm::normalize(glm::cross(along_u, along_v));
}

glm::dvec3 plane_weights(const glm::dvec3& normal, double sharpness) {
    const glm::dvec3 power = glm::pow(glm::abs(normal), glm::dvec3(sharpness));
    return power / (power.x + power.y + power.z);
}

glm::dmat3 weight_gradients(const glm::dvec3& normal, const glm::dmat3& turns, double sharpness) {
    const glm::dvec3 weights = plane_weights(normal, sharpness);
    glm::dmat3 changes(0);
    for (int i = 0; i < 3; ++i)
        if (normal[i] != 0) changes[i] = weights[i] * sharpness / normal[i] * turns[i];
    return changes - glm::outerProduct(changes[0] + changes[1] + changes[2], weights);
}

glm::dmat3 plane_frame(int axis, double side) {
    glm::dmat3 frame(0);
    frame[2][axis] = side;
    frame[1] = axis == 1 ? glm::dvec3(0, 0, -side) : glm::dvec3(0, 1, 0);
    frame[0] = glm::cross(frame[1], frame[2]);
    return frame;
}

glm::dvec3 bumped(const glm::dvec3& normal, const glm::dvec3& gradient) {
    return glm::normalize(normal - (gradient - glm::dot(gradient, normal) * normal));
}

double lost_variance(const glm::dvec3& mean_normal) {
    const double length = glm::length(mean_normal);
    return (1 - length) / length;
}

double turning_variance(const glm::dvec3& across, const glm::dvec3& up) {
    return std::min(0.25 * (glm::dot(across, across) + glm::dot(up, up)), 0.09);
}

double falls(Settings::Brdf brdf, double spread) {
    if (brdf == Settings::blinn_phong) return std::exp(-0.5 * spread);
    const double tail = 1 + 0.5 * spread;  // alpha² is twice the variance
    return 1 / (tail * tail);
}

Map::Map(const Image& image) : levels_(mip_chain(image, ColorSpace::linear)) {}

glm::dvec4 Map::at(glm::dvec2 uv, double level) const {
    const double clamped = std::clamp(level, 0.0, double(levels_.size() - 1));
    const auto low = size_t(clamped);
    const double share = clamped - double(low);
    const glm::dvec4 fine = bilinear(levels_[low], uv);
    return share == 0 ? fine : glm::mix(fine, bilinear(levels_[low + 1], uv), share);
}

}  // namespace relief::layered_normals
