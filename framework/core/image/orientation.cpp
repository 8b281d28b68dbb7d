#include "framework/core/image/orientation.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace relief {
namespace {

using namespace std::string_view_literals;

/// Returns the unsigned number in up to four bytes from `at` on; 0 beyond the end.
uint32_t number_in(std::string_view bytes, size_t at, size_t count, bool big_endian) {
    uint32_t number = 0;
    if (at > bytes.size() || bytes.size() - at < count) return 0;
    for (size_t i = 0; i < count; ++i)
        number = number << 8 | static_cast<unsigned char>(bytes[big_endian ? at + i : at + count - 1 - i]);
    return number;
}

/// Returns the orientation in EXIF data: a TIFF header, and a directory of 12 bytes a tag.
int orientation_in(std::string_view tiff) {
    const bool big = tiff.starts_with("MM\0*"sv);
    if (!big && !tiff.starts_with("II*\0"sv)) return 1;
    const size_t directory = number_in(tiff, 4, 4, big), tags = number_in(tiff, directory, 2, big);
    for (size_t i = 0; i < tags; ++i) {
        const size_t at = directory + 2 + 12 * i;
        if (number_in(tiff, at, 2, big) != 0x112) continue;
        const uint32_t value = number_in(tiff, at + 8, 2, big);
        return value >= 1 && value <= 8 ? int(value) : 1;
    }
    return 1;
}

std::string_view exif_of_png(std::string_view bytes) {
    for (size_t at = 8; at + 8 < bytes.size();) {  // length, name, bytes, checksum
        const size_t length = number_in(bytes, at, 4, true);
        if (bytes.substr(at + 4, 4) == "eXIf") return bytes.substr(at + 8, length);
        at += length + 12;
    }
    return {};
}

}  // namespace

std::string_view jpeg_segment(std::string_view bytes, int marker, std::string_view name) {
    for (size_t at = 2; at + 4 < bytes.size() && bytes[at] == '\xff';) {  // 255, kind, length, bytes
        const auto kind = static_cast<unsigned char>(bytes[at + 1]);
        if (kind == 0xff) {  // fill bytes may precede a segment
            ++at;
            continue;
        }
        if (kind == 0xda) break;  // the pixels
        const size_t length = number_in(bytes, at + 2, 2, true);
        const std::string_view segment = bytes.substr(at + 4, std::max<size_t>(length, 2) - 2);
        if (kind == marker && segment.starts_with(name)) return segment.substr(name.size());
        at += 2 + std::max<size_t>(length, 2);
    }
    return {};
}

int exif_orientation(std::string_view bytes) {
    if (bytes.starts_with("\x89PNG"sv)) return orientation_in(exif_of_png(bytes));
    if (bytes.starts_with("\xff\xd8"sv)) return orientation_in(jpeg_segment(bytes, 0xe1, "Exif\0\0"sv));
    return 1;
}

Image oriented(Image stored, int orientation) {
    if (orientation == 1) return stored;
    const bool on_its_side = orientation >= 5;
    const int right = stored.width - 1, bottom = stored.height - 1;
    Image shown(on_its_side ? stored.height : stored.width, on_its_side ? stored.width : stored.height, stored.channels,
                stored.bits);
    // Where the first row and the first column of the file belong (EXIF names these sides).
    const bool from_right = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
    const bool from_bottom = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
    for (int y = 0; y < shown.height; ++y)
        for (int x = 0; x < shown.width; ++x) {
            const int column = on_its_side ? y : x, row = on_its_side ? x : y;
            const float* const from =
                stored.pixel(from_right ? right - column : column, from_bottom ? bottom - row : row);
            std::copy_n(from, stored.channels, shown.pixel(x, y));
        }
    return shown;
}

}  // namespace relief
