#include "framework/core/image/dds.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "framework/core/base/error.h"
#include "framework/core/image/file.h"

namespace relief {
namespace {

constexpr size_t block_bytes = 16;  // of two channels

/// The places of the header's numbers, in bytes from the start of the file.
enum Field : size_t { height_at = 12, width_at = 16, four_cc_at = 84, dxgi_format_at = 128, dx9_header_bytes = 128 };

uint32_t number_at(std::string_view bytes, size_t at) {
    uint32_t number = 0;
    for (size_t i = 4; i-- > 0;) number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
    return number;
}

struct Layout {
    bool is_signed;
    size_t begin;  ///< of the first block
};
Layout layout_of(std::string_view bytes) {
    const std::string_view four_cc = bytes.substr(four_cc_at, 4);
    if (four_cc == "ATI2" || four_cc == "BC5U") return {false, dx9_header_bytes};
    if (four_cc == "BC5S") return {true, dx9_header_bytes};
    if (four_cc == "DX10") {
        if (bytes.size() < dds_header_bytes) throw Error("damaged: its header has no end");
        const uint32_t format = number_at(bytes, dxgi_format_at);
        if (format == dxgi_bc5_unorm || format == dxgi_bc5_snorm) return {format == dxgi_bc5_snorm, dds_header_bytes};
        throw Error(fmt::format("its DXGI_FORMAT is {}: of DDS files only BC5 is supported ({} or {})", format,
                                dxgi_bc5_unorm, dxgi_bc5_snorm));
    }
    throw Error("of DDS files only BC5 is supported");
}

/// Returns the values, in [-1, 1], of the 16 texels of one channel's block (OpenGL 4.1, appendix C.1).
std::array<float, 16> decode_channel(std::string_view block, bool is_signed) {
    const auto end_of = [&](char byte) {
        return is_signed ? std::max(float(int8_t(byte)) / 127, -1.0f) : 2 * float(uint8_t(byte)) / 255 - 1;
    };
    const int first = is_signed ? int(int8_t(block[0])) : int(uint8_t(block[0]));
    const int second = is_signed ? int(int8_t(block[1])) : int(uint8_t(block[1]));
    const float a = end_of(block[0]), b = end_of(block[1]);
    std::array<float, 8> ramp = {a, b, 0, 0, 0, 0, -1, 1};
    const int steps = first > second ? 7 : 5;
    for (int i = 1; i < steps; ++i) ramp[size_t(i) + 1] = (float(steps - i) * a + float(i) * b) / float(steps);
    uint64_t bits = 0;
    for (size_t i = 0; i < 6; ++i) bits |= uint64_t(uint8_t(block[2 + i])) << (8 * i);
    std::array<float, 16> values;
    for (size_t i = 0; i < 16; ++i) values[i] = ramp[bits >> (3 * i) & 7];
    return values;
}

}  // namespace

bool is_dds(std::string_view bytes) { return bytes.starts_with("DDS "); }

Image decode_dds(std::string_view bytes) {
    if (bytes.size() < dx9_header_bytes) throw Error("damaged: its header has no end");
    const auto [is_signed, begin] = layout_of(bytes);
    const uint32_t width = number_at(bytes, width_at), height = number_at(bytes, height_at);
    if (width < 1 || height < 1 || width > max_image_side || height > max_image_side ||
        size_t{width} * height * 3 * sizeof(float) > max_image_bytes)
        throw Error(fmt::format("{} x {} texels: a side is from 1 to {}, and floats of at most {} MiB are supported",
                                width, height, max_image_side, max_image_bytes >> 20));
    const size_t columns = (size_t{width} + 3) / 4, rows = (size_t{height} + 3) / 4;
    if (const size_t needed = columns * rows * block_bytes; bytes.size() - begin < needed)
        throw Error(fmt::format("damaged: {} bytes of {} are missing", needed - (bytes.size() - begin), needed));
    Image image(int(width), int(height), 3);
    for (size_t row = 0; row < rows; ++row)
        for (size_t column = 0; column < columns; ++column) {
            const std::string_view block = bytes.substr(begin + (row * columns + column) * block_bytes, block_bytes);
            const auto xs = decode_channel(block, is_signed), ys = decode_channel(block.substr(8), is_signed);
            for (size_t i = 0; i < 16; ++i) {
                const size_t x = column * 4 + i % 4, y = row * 4 + i / 4;
                if (x >= width || y >= height) continue;
                float* const texel = image.pixel(int(x), int(y));
                const float z = std::sqrt(std::max(0.0f, 1 - xs[i] * xs[i] - ys[i] * ys[i]));
                texel[0] = 0.5f * xs[i] + 0.5f, texel[1] = 0.5f * ys[i] + 0.5f, texel[2] = 0.5f * z + 0.5f;
            }
        }
    return image;
}

}  // namespace relief
