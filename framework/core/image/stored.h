// Rules that the library-based readers and writers of image files share.
#pragma once

#include <fmt/format.h>

#include <string_view>

#include "framework/core/base/error.h"
#include "framework/core/image/file.h"

namespace relief {

/// Prefix of our notes' names in a file. Only notes with this prefix are read back.
constexpr std::string_view note_prefix = "relief:";

/// Throws Error without a place for an image that exceeds the limits of read_image().
inline void check_image_size(int width, int height, int channels) {
    const bool fits = width >= 1 && height >= 1 && width <= max_image_side && height <= max_image_side &&
                      channels >= 1 && channels <= 4 &&
                      size_t(width) * size_t(height) * size_t(channels) * sizeof(float) <= max_image_bytes;
    if (!fits)
        throw Error(fmt::format("{}x{} with {} channels: at most {}x{}, 4 channels and {} MiB are supported", width,
                                height, channels, max_image_side, max_image_side, max_image_bytes >> 20));
}

}  // namespace relief
