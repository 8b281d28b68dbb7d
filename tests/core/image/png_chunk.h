// Chunks of PNG files (ISO 15948): length, name, bytes, CRC-32 of the last two.
#pragma once

#include <cstdint>
#include <string>

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

}  // namespace relief
