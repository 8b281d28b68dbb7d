#include "framework/core/image/file.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/module.h"
#include "framework/core/base/text.h"
#include "framework/core/image/color_profile.h"
#include "framework/core/image/dds.h"
#include "framework/core/image/exr.h"
#include "framework/core/image/netpbm.h"
#include "framework/core/image/openimageio.h"
#include "framework/core/image/orientation.h"
#include "framework/core/image/png.h"

namespace relief {

using namespace std::string_view_literals;

namespace {

const Module& openimageio() {
    static const Module module = open_own_module("relief-openimageio.so", "libopenimageio-dev");
    return module;
}

// Detects the format from the first bytes, because a file's name may be wrong.
const char* format_by_content(const std::string& bytes) {
    const std::string_view start(bytes);
    if (start.starts_with("\x89PNG\r\n\x1a\n"sv)) return "png";
    if (start.starts_with("\x76\x2f\x31\x01"sv)) return "openexr";
    if (start.starts_with("\xff\xd8\xff"sv)) return "jpeg";
    constexpr std::pair<std::string_view, const char*> others[] = {
        {"II*\0"sv, "TIFF"}, {"MM\0*"sv, "TIFF"}, {"II+\0"sv, "TIFF"},      {"MM\0+"sv, "TIFF"},
        {"GIF8"sv, "GIF"},   {"8BPS"sv, "PSD"},   {"\xabKTX"sv, "KTX"},     {"#?"sv, "Radiance HDR"},
        {"qoif"sv, "QOI"},   {"BM"sv, "BMP"},     {"\xff\x0a"sv, "JPEG XL"}};
    const auto refuse = [](const char* name) {
        throw Error(fmt::format("{} is not read: save the picture as PNG, or floats as OpenEXR", name));
    };
    for (const auto& [first, name] : others)
        if (start.starts_with(first)) refuse(name);
    if (start.starts_with("RIFF"sv) && start.find("WEBP"sv) == 8) refuse("WebP");
    if (start.find("ftyp"sv) == 4) refuse("HEIF or AVIF");
    throw Error("neither PNG, OpenEXR, JPEG, PPM, PFM nor DDS");
}

/// Returns the size in bytes of an OpenEXR header value of a fixed-size type, or nothing for a type of variable size.
/// OpenEXR reads this many bytes even if the file states another size, and would then misread the bytes that follow.
std::optional<uint32_t> openexr_size(std::string_view type) {
    constexpr std::pair<std::string_view, uint32_t> sizes[] = {{"box2i", 16},
                                                               {"box2f", 16},
                                                               {"chromaticities", 32},
                                                               {"compression", 1},
                                                               {"deepImageState", 1},
                                                               {"double", 8},
                                                               {"envmap", 1},
                                                               {"float", 4},
                                                               {"int", 4},
                                                               {"keycode", 28},
                                                               {"lineOrder", 1},
                                                               {"m33f", 36},
                                                               {"m33d", 72},
                                                               {"m44f", 64},
                                                               {"m44d", 128},
                                                               {"rational", 8},
                                                               {"tiledesc", 9},
                                                               {"timecode", 8},
                                                               {"v2i", 8},
                                                               {"v2f", 8},
                                                               {"v2d", 16},
                                                               {"v3i", 12},
                                                               {"v3f", 12},
                                                               {"v3d", 24}};
    for (const auto& [name, size] : sizes)
        if (name == type) return size;
    return {};
}

/// A rectangle of pixels, all sides inclusive.
struct Window {
    int64_t left = 0, top = 0, right = -1, bottom = -1;
    bool operator==(const Window&) const = default;
    std::string text() const {
        return fmt::format("{} x {} from {}, {}", right - left + 1, bottom - top + 1, left, top);
    }
    bool contains(const Window& other) const {
        return left <= other.left && top <= other.top && right >= other.right && bottom >= other.bottom;
    }
};
struct Windows {
    Window data, display;
};

/// OpenEXR allocates memory for the sizes in its header before it checks them against the file, and before OpenImageIO
/// reports them: a few bytes could cost gigabytes. Walks the header. Throws Error for a value that is larger than the
/// file, for sides, tiles or channels beyond the limits, for files of several or deep images, and for pixels that do
/// not fill the display window, which is the picture. Returns the windows.
Windows check_openexr_header(std::string_view bytes) {
    Windows windows;
    const auto number_at = [&](size_t at) {
        if (at > bytes.size() || bytes.size() - at < 4) throw Error("damaged: its header has no end");
        uint32_t number = 0;
        for (size_t i = 4; i-- > 0;) number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
        return number;
    };
    const auto refuse = [](const char* what) {
        throw Error(fmt::format("{}: only one flat image of at most {}x{} with 4 channels is supported", what,
                                max_image_side, max_image_side));
    };
    constexpr uint32_t deep_or_several = 0x1800;
    if (number_at(4) & deep_or_several) refuse("deep, or several images");

    size_t at = 8;  // after the magic number and the version
    const auto word = [&] {
        const size_t end = bytes.find('\0', at);
        if (end == std::string_view::npos) throw Error("damaged: its header has no end");
        const std::string_view found = bytes.substr(at, end - at);
        at = end + 1;
        return found;
    };
    for (std::string_view name = word(); !name.empty(); name = word()) {  // name, type, size, value
        const std::string_view type = word();
        const size_t size = number_at(at), begin = at += 4;
        const auto inconsistent = [&] { throw Error(fmt::format("damaged: {} bytes are no {}", size, type)); };
        if (const auto right = openexr_size(type); right && *right != size) inconsistent();
        if (size > bytes.size() - begin)
            throw Error(fmt::format("damaged: a value of its header has {} bytes, more than the file", size));
        const auto side = [&](size_t low, size_t high) {
            return int64_t(int32_t(number_at(begin + high))) - int32_t(number_at(begin + low)) + 1;
        };
        if (name == "dataWindow" && (side(0, 8) > max_image_side || side(4, 12) > max_image_side)) refuse("too large");
        if (name == "dataWindow" || name == "displayWindow") {
            const auto edge = [&](size_t offset) { return int64_t(int32_t(number_at(begin + offset))); };
            (name == "dataWindow" ? windows.data : windows.display) = {edge(0), edge(4), edge(8), edge(12)};
        }
        if (name == "tiles" && (number_at(begin) > max_image_side || number_at(begin + 4) > max_image_side))
            refuse("its tiles are too large");
        if (type == "preview" && (size < 8 || uint64_t{number_at(begin)} * number_at(begin + 4) * 4 + 8 != size))
            inconsistent();
        if (type == "chlist") {
            bool has_integers = false;
            int channels = 0;  // each is a name and 16 bytes, first its type; an empty name ends them
            for (at = begin; at < begin + size && !word().empty(); at += 16) {
                if (++channels > 4) refuse("more than 4 channels");
                has_integers |= number_at(at) == 0;
            }
            if (at != begin + size) inconsistent();
            if (has_integers) throw Error("its numbers are integers of 32 bits: save them as floats");
        }
        at = begin + size;
    }
    if (windows.display.right < windows.display.left || windows.display.bottom < windows.display.top)
        throw Error("damaged: it has no pixels");
    if (!windows.data.contains(windows.display))
        throw Error(
            fmt::format("its pixels (data window: {}) do not fill the picture (display window: {}): save the "
                        "whole picture",
                        windows.data.text(), windows.display.text()));
    return windows;
}

/// Returns the part of the data window's pixels that the display window shows.
Image cropped(const Image& image, const Windows& windows) {
    Image part(int(windows.display.right - windows.display.left + 1),
               int(windows.display.bottom - windows.display.top + 1), image.channels, image.bits);
    const int left = int(windows.display.left - windows.data.left), top = int(windows.display.top - windows.data.top);
    for (int y = 0; y < part.height; ++y)
        std::copy_n(image.pixel(left, top + y), size_t(part.width) * size_t(part.channels), part.pixel(0, y));
    return part;
}

/// libpng allocates memory for a chunk before it reads it. Throws Error for a chunk that is larger than the rest of the
/// file.
void check_png_chunks(std::string_view bytes) {
    for (size_t at = 8; bytes.size() - at >= 8;) {  // length, name, bytes, checksum
        uint32_t length = 0;
        for (size_t i = 0; i < 4; ++i) length = length << 8 | static_cast<unsigned char>(bytes[at + i]);
        if (length > bytes.size() - at - 8)
            throw Error(fmt::format("damaged: a chunk has {} bytes, more than the file", length));
        if (bytes.substr(at + 4, 4) == "IEND") return;
        at += std::min<size_t>(bytes.size() - at, size_t{length} + 12);
    }
}

}  // namespace

Image decode_image(const std::string& bytes, Notes* notes) {
    if (is_netpbm(bytes)) return decode_netpbm(bytes);
    if (is_dds(bytes)) return decode_dds(bytes);
    const char* const format = format_by_content(bytes);
    Windows windows;
    if (format == "openexr"sv) windows = check_openexr_header(bytes);
    if (format == "png"sv) check_png_chunks(bytes);
    Notes found;
    std::optional<Image> image;
    if (format == "png"sv) image = decode_png(bytes, found);
    if (format == "openexr"sv) image = decode_plain_exr(bytes, found);
    if (!image && !opens_own_modules())
        throw Error(format == "jpeg"sv ? "this program reads no JPEG: save the picture as PNG"
                                       : "this program reads no OpenEXR of this kind: save the picture as PNG");
    if (!image) image = openimageio().function<DecodeImage>("relief_decode_image")(bytes, format, found);
    if (notes) *notes = std::move(found);
    std::string profile = format == "jpeg"sv ? jpeg_profile_name(bytes) : std::move(image->profile);
    Image shown = windows.display != windows.data ? cropped(*image, windows)
                                                  : oriented(*std::move(image), exif_orientation(bytes));
    shown.profile = std::move(profile);
    return shown;
}

Image read_image(const std::filesystem::path& path, Notes* notes) {
    const std::string bytes = read_file(path, max_image_bytes);
    try {
        return decode_image(bytes, notes);
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
            return encode_png(image, notes, space);
        case ImageFormat::exr:
            break;
    }
    return encode_exr(image, notes);
}

void write_image(const std::filesystem::path& path, const Image& image, const Notes& notes, ColorSpace space) {
    write_file(path, encode_image(image, format_of(path), notes, space));
}

}  // namespace relief
