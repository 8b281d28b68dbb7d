#include <algorithm>
#include <cmath>

#include "framework/course/inspect/inspect.h"
#include "framework/course/inspect/reading.h"

namespace relief::inspect {
namespace {

/// Returns the grey of a texel: its normal lit from the upper left, or the mean of its channels in other kinds of map.
float grey_of(const Image& map, const Recognition& as, const float* texel) {
    if (as.kind == MapKind::normals) {
        const glm::dvec3 n = as.reading.vector(texel);
        const double length = glm::length(n);
        if (!(length > 0)) return 0;
        return float(0.08 + 0.72 * std::max(0.0, glm::dot(n / length, glm::normalize(glm::dvec3(-0.5, 0.6, 1)))));
    }
    double sum = 0;
    const int channels = std::min(map.channels, 3);
    for (int c = 0; c < channels; ++c) sum += std::isfinite(texel[c]) ? std::clamp(double(texel[c]), 0.0, 1.0) : 0;
    return float(0.1 + 0.7 * sum / channels);
}

}  // namespace

const std::vector<MarkColor>& mark_colors() {
    static const std::vector<MarkColor> colors = {
        {mark_not_finite, "magenta", "infinity, NaN or a void", 1, 0, 1},
        {mark_side, "yellow", "into the surface", 1, 0.9f, 0},
        {mark_length, "red", "length off by more than 0.1", 0.95f, 0.1f, 0.1f},
        {mark_green, "cyan", "green points the other way", 0, 0.85f, 0.95f},
        {mark_heights, "orange", "far from what the heights give", 1, 0.55f, 0},
        {mark_seam, "green", "a border that does not repeat", 0.1f, 0.9f, 0.2f},
    };
    return colors;
}

Image picture_of_marks(const Image& map, const Inspection& inspection) {
    const Recognition as = recognize(map);
    Image picture(map.width, map.height, 3, 8);
    for (size_t i = 0; i < map.pixel_count(); ++i) {
        const float grey = grey_of(map, as, map.values.data() + i * size_t(map.channels));
        float color[3] = {grey, grey, grey};
        for (const MarkColor& one : mark_colors())
            if (inspection.marks[i] & one.mark) {
                const float full[3] = {one.red, one.green, one.blue};
                for (int c = 0; c < 3; ++c) color[c] = 0.8f * full[c] + 0.2f * grey;
                break;
            }
        std::copy_n(color, 3, picture.values.begin() + std::ptrdiff_t(i * 3));
    }
    return picture;
}

}  // namespace relief::inspect
