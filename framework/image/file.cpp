#include "framework/image/file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "framework/base/error.h"
#include "framework/base/file.h"
#include "framework/base/module.h"
#include "framework/base/text.h"
#include "framework/image/openimageio.h"

namespace relief {
namespace {

const Module& openimageio() {
    static const Module module = open_own_module("relief-openimageio.so", "libopenimageio-dev");
    return module;
}

// The first bytes say what a file is; its name may lie.
const char* format_by_content(const std::string& bytes) {
    using namespace std::string_view_literals;
    const std::string_view start(bytes);
    if (start.starts_with("\x89PNG\r\n\x1a\n"sv)) return "png";
    if (start.starts_with("\x76\x2f\x31\x01"sv)) return "openexr";
    if (start.starts_with("\xff\xd8\xff"sv)) return "jpeg";
    throw Error("neither PNG, OpenEXR nor JPEG");
}

std::string encode_ppm(const Image& image) {
    std::string bytes = fmt::format("P6\n{} {}\n255\n", image.width, image.height);
    bytes.reserve(bytes.size() + image.pixel_count() * 3);
    for (size_t i = 0; i < image.pixel_count(); ++i)
        for (int c = 0; c < 3; ++c) {
            const float value = image.values[i * image.channels + (image.channels >= 3 ? c : 0)];
            bytes += static_cast<char>(std::lround(std::clamp(std::isnan(value) ? 0.0f : value, 0.0f, 1.0f) * 255));
        }
    return bytes;
}

// Rows go from the bottom to the top; the scale's sign says little-endian.
std::string encode_pfm(const Image& image) {
    static_assert(std::endian::native == std::endian::little);
    const int channels = image.channels >= 3 ? 3 : image.channels == 2 ? 3 : 1;
    std::string bytes = fmt::format("{}\n{} {}\n-1.0\n", channels == 3 ? "PF" : "Pf", image.width, image.height);
    bytes.reserve(bytes.size() + image.pixel_count() * channels * sizeof(float));
    for (int y = image.height - 1; y >= 0; --y)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < channels; ++c) {
                const float value = c < image.channels ? image.pixel(x, y)[c] : 0.0f;
                bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
            }
    return bytes;
}

}  // namespace

Image read_image(const std::filesystem::path& path, Notes* notes) {
    const std::string bytes = read_file(path, max_image_bytes);
    Notes found;
    try {
        const char* format = format_by_content(bytes);
        Image image = openimageio().function<DecodeImage>("relief_decode_image")(bytes, format, found);
        if (notes) *notes = std::move(found);
        return image;
    } catch (const Error& error) {
        throw Error({path}, error.what());
    }
}

ImageFormat format_of(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
    if (ending == ".png") return ImageFormat::png;
    if (ending == ".exr") return ImageFormat::exr;
    if (ending == ".ppm") return ImageFormat::ppm;
    if (ending == ".pfm") return ImageFormat::pfm;
    throw UsageError(fmt::format("'{}' must end in .png, .exr, .ppm or .pfm", path.string()));
}

std::string encode_image(const Image& image, ImageFormat format, const Notes& notes, ColorSpace space) {
    switch (format) {
        case ImageFormat::ppm:
            return encode_ppm(image);
        case ImageFormat::pfm:
            return encode_pfm(image);
        case ImageFormat::png:
        case ImageFormat::exr:
            break;
    }
    const char* const name = format == ImageFormat::png ? "png" : "openexr";
    return openimageio().function<EncodeImage>("relief_encode_image")(image, name, notes, space);
}

void write_image(const std::filesystem::path& path, const Image& image, const Notes& notes, ColorSpace space) {
    write_file(path, encode_image(image, format_of(path), notes, space));
}

}  // namespace relief
