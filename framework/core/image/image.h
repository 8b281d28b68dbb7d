// A picture, a map or a probe in memory.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace relief {

/// How stored numbers represent light. Normal and height maps are always linear.
enum class ColorSpace { linear, srgb };

/// Row 0 is the top. Each pixel has `channels` floats, without padding. Values from or for integer formats are in [0,
/// 1]. Probes have the units of their quantity; no_surface or not_written fills every channel of a pixel without a
/// value.
struct Image {
    int width = 0;
    int height = 0;
    int channels = 0;
    /// Precision of the stored values: 8 or 16 (integers in [0, 1]) or 32 (floats).
    int bits = 32;
    std::vector<float> values;
    /// Name of the colour profile in the picture's file, which was not applied: see color_profile.h. Empty for none and
    /// for sRGB.
    std::string profile = {};

    Image() = default;
    Image(int columns, int rows, int channel_count, int precision = 32)
        : width(columns),
          height(rows),
          channels(channel_count),
          bits(precision),
          values(static_cast<size_t>(columns) * rows * channel_count) {}

    float* pixel(int x, int y) { return values.data() + offset(x, y); }
    const float* pixel(int x, int y) const { return values.data() + offset(x, y); }
    size_t pixel_count() const { return static_cast<size_t>(width) * height; }
    bool same_shape(const Image& other) const {
        return width == other.width && height == other.height && channels == other.channels;
    }

private:
    size_t offset(int x, int y) const { return (static_cast<size_t>(y) * width + x) * channels; }
};

/// The value of a probe where there is no surface.
constexpr float no_surface = std::numeric_limits<float>::infinity();
/// The value of a probe where a task is not written: see shaders/common/unfinished.glsl.
constexpr float not_written = -std::numeric_limits<float>::infinity();

}  // namespace relief
