#include "framework/staff/reference/bc5.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "framework/core/base/error.h"
#include "framework/core/base/parallel.h"
#include "framework/core/image/dds.h"
#include "framework/core/image/mips.h"
#include "framework/staff/reference/degrees.h"

namespace relief {
namespace {

constexpr size_t bytes_of_block = 16;
constexpr double lowest_z = -1.5 / 127;  // 8 bits may round 0 to this

void append(std::string& bytes, uint32_t number) {
    for (int i = 0; i < 4; ++i) bytes += char(number >> (8 * i));
}

/// Returns the header: DDS_HEADER and DDS_HEADER_DXT10 of the DDS programming guide.
std::string dds_header(const Image& map, RgtcKind kind, size_t levels, size_t bytes_of_level_0) {
    const bool mips = levels > 1;
    constexpr uint32_t caps = 0x1, height = 0x2, width = 0x4, pixel_format = 0x1000, mip_count = 0x20000,
                       linear_size = 0x80000;
    constexpr uint32_t complex = 0x8, texture = 0x1000, mip_map = 0x400000, four_cc = 0x4, texture_2d = 3;
    std::string bytes = "DDS ";
    append(bytes, 124);
    append(bytes, caps | height | width | pixel_format | linear_size | (mips ? mip_count : 0));
    append(bytes, uint32_t(map.height)), append(bytes, uint32_t(map.width));
    append(bytes, uint32_t(bytes_of_level_0));
    append(bytes, 0);  // depth
    append(bytes, uint32_t(levels));
    for (int i = 0; i < 11; ++i) append(bytes, 0);  // reserved
    append(bytes, 32), append(bytes, four_cc), bytes += "DX10";
    for (int i = 0; i < 5; ++i) append(bytes, 0);  // bits and masks of uncompressed formats
    append(bytes, texture | (mips ? complex | mip_map : 0));
    for (int i = 0; i < 4; ++i) append(bytes, 0);  // caps 2 to 4, reserved
    append(bytes, uint32_t(kind == RgtcKind::unorm ? dxgi_bc5_unorm : dxgi_bc5_snorm));
    append(bytes, texture_2d), append(bytes, 0), append(bytes, 1), append(bytes, 0);  // flags, array size, flags
    return bytes;
}

glm::dvec3 direction_of(const float* texel) { return 2.0 * glm::dvec3(texel[0], texel[1], texel[2]) - 1.0; }

glm::dvec3 normal_of(const Image& map, int x, int y) { return glm::normalize(direction_of(map.pixel(x, y))); }

void check(const Image& map) {
    if (map.channels < 3) throw Error("is grey: a normal map has three channels");
    size_t inward = 0;
    for (size_t i = 0; i < map.pixel_count(); ++i) {
        const glm::dvec3 normal = direction_of(map.values.data() + i * size_t(map.channels));
        const double length = glm::length(normal);
        if (!(length > 1e-3 && length < 1e6))
            throw Error(
                fmt::format("has no direction at texel ({}, {})", i % size_t(map.width), i / size_t(map.width)));
        inward += normal.z < lowest_z;
    }
    if (inward > 0)
        throw Error(fmt::format("{} of {} normals point into the surface: BC5 keeps x and y, and z would be wrong",
                                inward, map.pixel_count()));
}

/// A mip level, and its blocks row by row.
struct Level {
    explicit Level(const Image& of)
        : map(of),
          columns((of.width + 3) / 4),
          rows((of.height + 3) / 4),
          blocks(size_t(columns) * size_t(rows) * bytes_of_block, '\0') {}

    const Image& map;
    int columns, rows;
    std::string blocks;
};

void encode_row(Level& level, int row, const Bc5Options& options) {
    for (int column = 0; column < level.columns; ++column) {
        std::array<double, 16> channels[2];
        for (int i = 0; i < 16; ++i) {
            const glm::dvec3 normal = normal_of(level.map, std::min(column * 4 + i % 4, level.map.width - 1),
                                                std::min(row * 4 + i / 4, level.map.height - 1));
            for (int c = 0; c < 2; ++c)
                channels[c][size_t(i)] = options.kind == RgtcKind::unorm ? 0.5 * normal[c] + 0.5 : normal[c];
        }
        char* to = level.blocks.data() + (size_t(row) * size_t(level.columns) + size_t(column)) * bytes_of_block;
        for (const auto& values : channels) {
            const RgtcBlock block =
                options.best ? rgtc_best(values, options.kind) : rgtc_range_fit(values, options.kind);
            const auto bytes = rgtc_bytes(block);
            to = std::copy(bytes.begin(), bytes.end(), to);
        }
    }
}

void measure(Bc5Texture& texture, const Image& map) {
    const Image decoded = decode_dds(texture.file);
    double sum = 0;
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) {
            const glm::dvec3 a = normal_of(map, x, y), b = normal_of(decoded, x, y);
            const double degrees = degrees_between(a, b);
            sum += degrees, texture.largest_degrees = std::max(texture.largest_degrees, degrees);
        }
    texture.mean_degrees = sum / double(map.pixel_count());
}

}  // namespace

Bc5Texture encode_bc5(const Image& normals, const Bc5Options& options) {
    check(normals);
    std::vector<Image> levels;
    if (options.mips) levels = normal_mip_chain(normals);
    if (levels.empty()) levels.push_back(normals);
    std::vector<Level> encoded(levels.begin(), levels.end());
    Bc5Texture texture{.levels = int(encoded.size())};
    // A row of best blocks takes seconds in a large map.
    const int rows = options.best ? 1 : 64;
    int parts = 0, part = 0;
    for (const Level& level : encoded) {
        parts += (level.rows - 1) / rows + 1;
        texture.block_bytes += level.blocks.size();
    }
    for (Level& level : encoded)
        for (int row = 0; row < level.rows; row += rows) {
            if (options.before_part) options.before_part(part++, parts);
            const int count = std::min(rows, level.rows - row);
            parallel_each(size_t(count), 0, [&](size_t i) { encode_row(level, row + int(i), options); });
        }
    texture.file = dds_header(normals, options.kind, encoded.size(), encoded[0].blocks.size());
    for (const Level& level : encoded) texture.file += level.blocks;
    measure(texture, normals);
    return texture;
}

}  // namespace relief
