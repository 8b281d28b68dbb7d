// A picture, a map or a probe in memory.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace relief {

/// How stored numbers stand for light. Normal and height maps are linear, always.
enum class ColorSpace { linear, srgb };

/// Row 0 is the top; `channels` floats a pixel, without padding. Values that come from, or go to, integers are in [0,
/// 1]; probes have the units of their quantity, with no_surface or not_written in every channel where there is none.
struct Image {
    int width = 0;
    int height = 0;
    int channels = 0;
    /// Precision of the stored values: 8 or 16 (integers in [0, 1]) or 32 (floats).
    int bits = 32;
    std::vector<float> values;

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

/// What a probe holds where no surface is.
constexpr float no_surface = std::numeric_limits<float>::infinity();
/// What a probe holds where its value comes from a task that is not written: see shaders/common/unfinished.glsl.
constexpr float not_written = -std::numeric_limits<float>::infinity();

}  // namespace relief
