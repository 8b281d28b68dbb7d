// Images in files. PNG is handled by libpng, and PPM, PFM, plain OpenEXR and normal maps in DDS by our own code. JPEG
// and all other OpenEXR are read by OpenImageIO. It is optional, and opened at first use, because it loads 260
// libraries in a sixth of a second.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "framework/core/image/image.h"

namespace relief {

enum class ImageFormat { png, exr, ppm, pfm };

/// Names and values that are stored with the pixels (PNG and EXR only).
using Notes = std::vector<std::pair<std::string, std::string>>;

/// Largest side and largest memory of an image that is read.
constexpr int max_image_side = 16384;
constexpr size_t max_image_bytes = size_t{1} << 30;

/// Returns the image in PNG, OpenEXR, JPEG, PPM, PGM, PFM or DDS (BC5) bytes; the format is detected from the content.
/// A JPEG or PNG is turned as its EXIF orientation says; an OpenEXR is its display window. `notes` receives the notes
/// that write_image() stored. Throws Error without a place when the bytes are damaged, too large, or of another format.
Image decode_image(const std::string& bytes, Notes* notes = nullptr);

/// Returns the image in a file. The name does not matter. Throws Error that names the file, also when it is missing.
Image read_image(const std::filesystem::path& path, Notes* notes = nullptr);

/// Returns the format for a file name's ending. Throws UsageError for another ending than .png, .exr, .ppm, .pfm.
ImageFormat format_of(const std::filesystem::path& path);

/// Returns the encoded image. The same image, notes and library give the same bytes. PNG takes 1 to 4 channels in [0,
/// 1] and stores 16 bits when `image.bits` is 16, else 8. EXR stores 32-bit floats. PPM stores 8 bits and PFM 32-bit
/// floats (PF for 3 channels, Pf for 1), both without alpha. `space` is the colour space that a PNG declares; our own
/// reader ignores it.
std::string encode_image(const Image& image, ImageFormat format, const Notes& notes = {},
                         ColorSpace space = ColorSpace::srgb);

/// Writes encode_image() to the file, whole or not at all.
void write_image(const std::filesystem::path& path, const Image& image, const Notes& notes = {},
                 ColorSpace space = ColorSpace::srgb);

}  // namespace relief
