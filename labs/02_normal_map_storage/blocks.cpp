#include "blocks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/core/base/error.h"

namespace relief::storage {

std::array<uint8_t, 8> packed(const ChannelBlock& block, bool is_signed) {
    const int low = is_signed ? -127 : 0, high = is_signed ? 127 : 255;
    for (const int end : {block.first, block.second})
        if (end < low || end > high)
            throw Error(fmt::format("encode_channel: the end {} is not in {} to {}", end, low, high));
    std::array<uint8_t, 8> bytes = {uint8_t(block.first), uint8_t(block.second)};
    uint64_t bits = 0;
    for (size_t i = 0; i < block.indices.size(); ++i) {
        const int index = block.indices[i];
        if (index < 0 || index > 7) throw Error(fmt::format("encode_channel: the index {} is not in 0 to 7", index));
        bits |= uint64_t(index) << (3 * i);
    }
    for (size_t i = 0; i < 6; ++i) bytes[2 + i] = uint8_t(bits >> (8 * i));
    return bytes;
}

BlockMap compress(const Image& normals, bool is_signed) {
    for (int y = 0; y < normals.height; ++y)
        for (int x = 0; x < normals.width; ++x)
            if (const float* n = normals.pixel(x, y); !std::isfinite(n[0]) || !std::isfinite(n[1]))
                throw Error(fmt::format("the normal in column {}, row {} of the map is not finite", x, y));
    BlockMap map{normals.width, normals.height, {}};
    for (int bottom = 0; bottom < map.height; bottom += 4)
        for (int left = 0; left < map.width; left += 4)
            for (int channel = 0; channel < 2; ++channel) {
                std::array<double, 16> values;
                for (int i = 0; i < 16; ++i) {
                    const int x = std::min(left + i % 4, map.width - 1), y = std::min(bottom + i / 4, map.height - 1);
                    const double n = std::clamp(double(normals.pixel(x, map.height - 1 - y)[channel]), -1.0, 1.0);
                    values[size_t(i)] = is_signed ? 127 * n : 127.5 * (n + 1);
                }
                const std::array<uint8_t, 8> bytes = packed(encode_channel(values), is_signed);
                map.bytes.insert(map.bytes.end(), bytes.begin(), bytes.end());
            }
    return map;
}

}  // namespace relief::storage
