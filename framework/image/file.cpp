#include "framework/image/file.h"

#include <fmt/format.h>

#include <algorithm>

#include "framework/base/error.h"
#include "framework/base/file.h"
#include "framework/base/module.h"
#include "framework/base/text.h"
#include "framework/image/netpbm.h"
#include "framework/image/openimageio.h"

namespace relief {

using namespace std::string_view_literals;

namespace {

const Module& openimageio() {
    static const Module module = open_own_module("relief-openimageio.so", "libopenimageio-dev");
    return module;
}

// The first bytes say what a file is; its name may lie.
const char* format_by_content(const std::string& bytes) {
    const std::string_view start(bytes);
    if (start.starts_with("\x89PNG\r\n\x1a\n"sv)) return "png";
    if (start.starts_with("\x76\x2f\x31\x01"sv)) return "openexr";
    if (start.starts_with("\xff\xd8\xff"sv)) return "jpeg";
    throw Error("neither PNG, OpenEXR, JPEG, PPM nor PFM");
}

/// OpenEXR takes memory for an attribute before it looks whether the file has so much: a few bytes could ask for 2 GB.
/// Throws Error when an attribute of the header is larger than what is left.
void check_openexr_header(std::string_view bytes) {
    size_t at = 8;  // magic number and version
    const auto skip_word = [&] {
        const size_t end = bytes.find('\0', at);
        if (end == std::string_view::npos) throw Error("damaged: its header has no end");
        const bool empty = end == at;
        at = end + 1;
        return !empty;
    };
    while (skip_word()) {  // a name, its type, its size, its value; the last name is empty
        skip_word();
        if (bytes.size() - at < 4) throw Error("damaged: its header has no end");
        uint32_t size = 0;
        for (int i = 3; i >= 0; --i) size = size << 8 | static_cast<unsigned char>(bytes[at + size_t(i)]);
        at += 4;
        if (size > bytes.size() - at)
            throw Error(fmt::format("damaged: a header's value has {} bytes, more than the file", size));
        at += size;
    }
}

}  // namespace

Image decode_image(const std::string& bytes, Notes* notes) {
    if (is_netpbm(bytes)) return decode_netpbm(bytes);
    const char* const format = format_by_content(bytes);
    if (format == "openexr"sv) check_openexr_header(bytes);
    Notes found;
    Image image = openimageio().function<DecodeImage>("relief_decode_image")(bytes, format, found);
    if (notes) *notes = std::move(found);
    return image;
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
