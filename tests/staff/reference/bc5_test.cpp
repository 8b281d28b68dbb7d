// BC5 textures: their DDS header, their blocks, and the reader in core/image/dds.h.
#include "framework/staff/reference/bc5.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <glm/glm.hpp>
#include <random>

#include "framework/core/image/dds.h"
#include "tests/support.h"

namespace relief {
namespace {

uint32_t number_at(const std::string& bytes, size_t at) {
    uint32_t number;  // DDS and this machine are little-endian
    std::memcpy(&number, bytes.data() + at, 4);
    return number;
}

/// Returns unit normals of waves, 0.5 n + 0.5, of 8 bits or unrounded.
Image waves(int width, int height, bool rounded) {
    Image map(width, height, 3, rounded ? 8 : 32);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const glm::dvec3 n =
                glm::normalize(glm::dvec3(0.8 * std::sin(x * 0.7 + y * 0.2), 0.6 * std::cos(y * 0.5), 1));
            for (int c = 0; c < 3; ++c) {
                const double stored = 0.5 * n[c] + 0.5;
                map.pixel(x, y)[c] = float(rounded ? std::round(stored * 255) / 255 : stored);
            }
        }
    return map;
}

/// Returns the 16 values of a channel of a block, which begins at this byte of a file.
std::array<double, 16> values_at(const std::string& file, size_t block, size_t channel, RgtcKind kind) {
    std::array<uint8_t, 8> bytes;
    std::memcpy(bytes.data(), file.data() + block + 8 * channel, 8);
    return rgtc_decode(rgtc_block(bytes, kind), kind);
}

TEST(Bc5Texture, HasTheHeaderOfTheProgrammingGuide) {
    for (const bool mips : {false, true})
        for (const RgtcKind kind : {RgtcKind::unorm, RgtcKind::snorm}) {
            const Bc5Texture texture = encode_bc5(waves(20, 9, true), {.kind = kind, .mips = mips});
            const std::string& file = texture.file;
            EXPECT_EQ(file.substr(0, 4), "DDS ");
            EXPECT_EQ(number_at(file, 4), 124u) << "size of DDS_HEADER";
            EXPECT_EQ(number_at(file, 8), mips ? 0xa1007u : 0x81007u) << "flags";
            EXPECT_EQ(number_at(file, 12), 9u) << "height";
            EXPECT_EQ(number_at(file, 16), 20u) << "width";
            EXPECT_EQ(number_at(file, 20), 5u * 3 * 16) << "bytes of level 0";
            EXPECT_EQ(number_at(file, 28), mips ? 5u : 1u) << "levels: 20, 10, 5, 2, 1";
            EXPECT_EQ(number_at(file, 76), 32u) << "size of DDS_PIXELFORMAT";
            EXPECT_EQ(number_at(file, 80), 4u) << "DDPF_FOURCC";
            EXPECT_EQ(file.substr(84, 4), "DX10");
            EXPECT_EQ(number_at(file, 108), mips ? 0x401008u : 0x1000u) << "caps";
            EXPECT_EQ(number_at(file, 128), kind == RgtcKind::unorm ? 83u : 84u) << "DXGI_FORMAT";
            EXPECT_EQ(number_at(file, 132), 3u) << "a 2D texture";
            EXPECT_EQ(number_at(file, 140), 1u) << "array size";
            // Blocks of 20 x 9, 10 x 4, 5 x 2, 2 x 1 and 1 x 1 texels.
            EXPECT_EQ(texture.block_bytes, mips ? 16u * (15 + 3 + 2 + 1 + 1) : 16u * 15);
            EXPECT_EQ(file.size(), 148 + texture.block_bytes);
        }
}

TEST(Bc5Texture, StatesTheErrorOfItsBlocks) {
    const Image map = waves(10, 6, false);  // sides that are not multiples of 4
    for (const RgtcKind kind : {RgtcKind::unorm, RgtcKind::snorm})
        for (const bool best : {false, true}) {
            const Bc5Texture texture = encode_bc5(map, {.kind = kind, .best = best});
            double sum = 0, largest = 0;
            for (int y = 0; y < map.height; ++y)
                for (int x = 0; x < map.width; ++x) {
                    const size_t block = size_t(148 + 16 * (y / 4 * 3 + x / 4)), texel = size_t(x % 4 + y % 4 * 4);
                    glm::dvec3 n(0);
                    for (int c = 0; c < 2; ++c) {
                        const double value = values_at(texture.file, block, size_t(c), kind)[texel];
                        n[c] = kind == RgtcKind::unorm ? 2 * value - 1 : value;
                    }
                    n.z = std::sqrt(std::max(0.0, 1 - n.x * n.x - n.y * n.y));
                    const float* const stored = map.pixel(x, y);
                    const glm::dvec3 exact = glm::normalize(2.0 * glm::dvec3(stored[0], stored[1], stored[2]) - 1.0);
                    const double degrees = glm::degrees(std::acos(std::min(1.0, glm::dot(n, exact))));
                    sum += degrees, largest = std::max(largest, degrees);
                }
            EXPECT_NEAR(texture.mean_degrees, sum / 60, 1e-4);
            EXPECT_NEAR(texture.largest_degrees, largest, 1e-3);
            EXPECT_GT(largest, 0.1) << "the map is not trivial";
        }
}

TEST(Bc5Texture, OfBestBlocksIsNotWorseAndOfAFlatMapIsExactIfSigned) {
    const Image map = waves(8, 8, false);
    EXPECT_LT(encode_bc5(map, {.best = true}).mean_degrees, encode_bc5(map).mean_degrees);
    Image flat(4, 4, 3);
    for (size_t i = 0; i < 48; ++i) flat.values[i] = i % 3 == 2 ? 1 : 0.5f;
    EXPECT_EQ(encode_bc5(flat, {.kind = RgtcKind::snorm}).largest_degrees, 0);
    // 128 / 255 is off by 1 / 255 in x and in y.
    EXPECT_NEAR(encode_bc5(flat).largest_degrees, glm::degrees(std::asin(std::sqrt(2.0) / 255)), 1e-4);
}

TEST(Bc5Texture, KeepsTheMeansOfUnitNormalsInItsMipLevels) {
    // Two normals that lean by 30 degrees to the left and right: the mean points straight up.
    Image map(8, 8, 3);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) {
            float* const texel = map.pixel(x, y);
            texel[0] = x % 2 ? 0.75f : 0.25f, texel[1] = 0.5f, texel[2] = float(0.5 + 0.25 * std::sqrt(3.0));
        }
    const Bc5Texture texture = encode_bc5(map, {.kind = RgtcKind::snorm, .mips = true});
    EXPECT_EQ(texture.levels, 4);
    for (size_t block = 4; block < 7; ++block)  // after the four of level 0
        for (size_t c = 0; c < 2; ++c)
            for (const double value : values_at(texture.file, 148 + 16 * block, c, RgtcKind::snorm))
                EXPECT_NEAR(value, 0, 1e-6);
}

TEST(Bc5Texture, RepeatsTheLastColumnAndRowBeyondTheMap) {
    const Bc5Texture texture = encode_bc5(waves(5, 5, false));
    const auto values_of = [&](size_t block, size_t channel) {
        return values_at(texture.file, 148 + 16 * block, channel, RgtcKind::unorm);
    };
    for (size_t channel = 0; channel < 2; ++channel)
        for (size_t i = 0; i < 16; ++i) {
            EXPECT_EQ(values_of(1, channel)[i], values_of(1, channel)[i / 4 * 4]) << "right";
            EXPECT_EQ(values_of(2, channel)[i], values_of(2, channel)[i % 4]) << "below";
            EXPECT_EQ(values_of(3, channel)[i], values_of(3, channel)[0]) << "at the corner";
        }
}

TEST(Bc5Texture, RefusesMapsThatXAndYDoNotDescribe) {
    Image map = waves(4, 4, true);
    map.pixel(1, 2)[2] = 0.2f;
    EXPECT_EQ(message_of([&] { encode_bc5(map); }),
              "1 of 16 normals point into the surface: BC5 keeps x and y, and z would be wrong");
    map.pixel(1, 2)[2] = NAN;
    EXPECT_EQ(message_of([&] { encode_bc5(map); }), "has no direction at texel (1, 2)");
    EXPECT_TRUE(contains(message_of([&] { encode_bc5(Image(4, 4, 1)); }), "is grey"));
}

TEST(Dds, IsDecodedAsTheReferenceDecodesItsBlocks) {
    std::mt19937 random(11);
    for (const RgtcKind kind : {RgtcKind::unorm, RgtcKind::snorm}) {
        std::string file = encode_bc5(waves(32, 32, true), {.kind = kind}).file;
        for (size_t i = 148; i < file.size(); ++i) file[i] = char(random());
        // Ends that are equal, and -128, which is -1 as -127 is.
        std::memset(file.data() + 148, 0x80, 2);
        const Image decoded = decode_dds(file);
        ASSERT_EQ(decoded.width, 32);
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x) {
                const size_t block = size_t(148 + 16 * (y / 4 * 8 + x / 4));
                for (int c = 0; c < 2; ++c) {
                    const double value = values_at(file, block, size_t(c), kind)[size_t(x % 4 + y % 4 * 4)];
                    EXPECT_NEAR(decoded.pixel(x, y)[c], kind == RgtcKind::unorm ? value : 0.5 * value + 0.5, 1e-6);
                }
                EXPECT_GE(decoded.pixel(x, y)[2], 0.5f) << "z is rebuilt, and not negative";
            }
    }
}

TEST(Dds, RefusesOtherFormatsAndMissingBytes) {
    const std::string file = encode_bc5(waves(8, 8, true)).file;
    const auto refusal = [](const std::string& bytes) { return message_of([&] { decode_dds(bytes); }); };
    EXPECT_EQ(refusal(file.substr(0, 100)), "damaged: its header has no end");
    EXPECT_EQ(refusal(file.substr(0, file.size() - 3)), "damaged: 3 bytes of 64 are missing");
    std::string other = file;
    other[128] = 98;  // BC7
    EXPECT_EQ(refusal(other), "its DXGI_FORMAT is 98: of DDS files only BC5 is supported (83 or 84)");
    other.replace(84, 4, "DXT1");
    EXPECT_EQ(refusal(other), "of DDS files only BC5 is supported");
    other = file;
    other[18] = 1;
    EXPECT_TRUE(contains(refusal(other), "65544 x 8 texels: a side is from 1 to 16384"));
    other = file.substr(0, 128) + file.substr(148);
    other.replace(84, 4, "ATI2");
    EXPECT_EQ(decode_dds(other).values, decode_dds(file).values) << "an older header";
}

}  // namespace
}  // namespace relief
