// Bytes of image files: chunks of PNG (ISO 15948: length, name, bytes, CRC-32 of the last two), windows of OpenEXR.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string>

#include "framework/core/image/file.h"

namespace relief {

inline std::string big_endian(uint32_t number) {
    return {char(number >> 24), char(number >> 16), char(number >> 8), char(number)};
}

inline std::string png_chunk(const std::string& name, const std::string& bytes) {
    uint32_t crc = ~0u;
    for (const unsigned char byte : name + bytes) {
        crc ^= byte;
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
    }
    return big_endian(uint32_t(bytes.size())) + name + bytes + big_endian(~crc);
}

/// Returns a PNG file with one more chunk, behind its header.
inline std::string with_png_chunk(std::string png, const std::string& name, const std::string& bytes) {
    return png.insert(33, png_chunk(name, bytes));
}

/// Returns a PNG file without chunks about colours.
inline std::string bare_png(const Image& image) {
    std::string png = encode_image(image, ImageFormat::png);
    return png.erase(png.find("sRGB") - 4, 13);
}

/// Returns an OpenEXR file with other windows, each four numbers: left, top, right, bottom.
inline std::string with_windows(std::string exr, const std::array<int32_t, 4>& data,
                                const std::array<int32_t, 4>& display) {
    using namespace std::string_literals;
    for (const auto& [name, window] :
         {std::pair("dataWindow\0box2i\0\x10\0\0\0"s, data), {"displayWindow\0box2i\0\x10\0\0\0"s, display}})
        std::memcpy(&exr[exr.find(name) + name.size()], window.data(), 16);
    return exr;
}

}  // namespace relief
