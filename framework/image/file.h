// Images in files: PNG by libpng; OpenEXR and JPEG through OpenImageIO, which is opened at first use (it brings 260
// libraries and costs a sixth of a second); PPM and PFM by ourselves.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "framework/image/image.h"

namespace relief {

enum class ImageFormat { png, exr, ppm, pfm };

/// Names and values kept beside the pixels (PNG and EXR only).
using Notes = std::vector<std::pair<std::string, std::string>>;

/// Largest side and largest memory of an image that is read.
constexpr int max_image_side = 16384;
constexpr size_t max_image_bytes = size_t{1} << 30;

/// PNG, OpenEXR, JPEG, PPM, PGM or PFM, told apart by content. `notes` gets what write_image kept. Throws Error without
/// a place: damaged, too large, of another kind.
Image decode_image(const std::string& bytes, Notes* notes = nullptr);

/// The image in a file, whatever its name. Throws Error that names the file, missing or not.
Image read_image(const std::filesystem::path& path, Notes* notes = nullptr);

/// The format that a file name asks for; throws UsageError for another ending than .png, .exr, .ppm, .pfm.
ImageFormat format_of(const std::filesystem::path& path);

/// The same bytes for the same image, notes and library. PNG takes 1 to 4 channels in [0, 1] and stores 16
/// bits when `image.bits` is 16, else 8; EXR stores 32-bit floats; PPM 8 bits and PFM 32-bit floats (PF with
/// 3 channels, Pf with 1), both without alpha. `space` is how a PNG says it is to be shown; our own reader does not
/// ask.
std::string encode_image(const Image& image, ImageFormat format, const Notes& notes = {},
                         ColorSpace space = ColorSpace::srgb);

/// encode_image into the file, whole or not at all.
void write_image(const std::filesystem::path& path, const Image& image, const Notes& notes = {},
                 ColorSpace space = ColorSpace::srgb);

}  // namespace relief
