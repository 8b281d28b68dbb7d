// The driver's decoder of RGTC against the specification's, in double precision.
#include "framework/staff/reference/rgtc.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "framework/core/gl/counters.h"
#include "framework/core/gl/program.h"
#include "framework/library/kit/drawn_numbers.h"
#include "framework/library/kit/window_triangle.h"
#include "labs/02_normal_map_storage/encoded_texture.h"
#include "tests/support.h"

namespace relief {
namespace {

/// Returns the texels of a texture as a shader reads them. Row 0 is the texture's upper one.
Image texels_of(const EncodedTexture& texture, glm::ivec2 size) {
    TemporaryFolder folder;
    folder.write("a.vert",
                 "#version 410 core\nvoid main() {\n"
                 " gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);\n}\n");
    folder.write("a.frag",
                 "#version 410 core\nuniform sampler2D s_map;\nout vec4 o_color;\n"
                 "void main() { o_color = texelFetch(s_map, ivec2(gl_FragCoord.xy), 0); }\n");
    const Program program({folder.path() / "a.vert", folder.path() / "a.frag"}, {});
    WindowTriangle window;
    return draw_numbers(size, [&] {
        glUseProgram(program);
        texture.bind(3);
        program.set("s_map", 3);
        window.draw();
    });
}

TEST(RgtcTexture, TheDriverDecodesEachTexelWithinItsRounding) {
    constexpr int blocks = 16;  // in a row and in a column
    for (const RgtcKind kind : {RgtcKind::unorm, RgtcKind::snorm}) {
        const int low = kind == RgtcKind::unorm ? 0 : -127, high = kind == RgtcKind::unorm ? 255 : 127;
        std::mt19937 random(5);
        std::uniform_int_distribution<> end(low, high), index(0, 7);
        std::vector<uint8_t> bytes;
        std::vector<RgtcBlock> stored;
        for (int i = 0; i < 2 * blocks * blocks; ++i) {
            RgtcBlock block{end(random), end(random), {}};
            if (i % 8 == 0) block.second = block.first;
            for (int& one : block.indices) one = index(random);
            stored.push_back(block);
            for (const uint8_t byte : rgtc_bytes(block)) bytes.push_back(byte);
        }
        const EncodedTexture texture(glm::ivec2(4 * blocks), bytes, kind == RgtcKind::snorm);
        EXPECT_EQ(texture.bytes(), 16 * blocks * blocks);
        texture.bind(0);
        GLint compressed = 0;
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_COMPRESSED, &compressed);
        EXPECT_TRUE(compressed);
        const Image drawn = texels_of(texture, glm::ivec2(4 * blocks));
        double largest = 0, largest_at_ends = 0;
        for (int y = 0; y < 4 * blocks; ++y)
            for (int x = 0; x < 4 * blocks; ++x)
                for (int channel = 0; channel < 2; ++channel) {
                    const RgtcBlock& block = stored[size_t(2 * (y / 4 * blocks + x / 4) + channel)];
                    const size_t texel = size_t(y % 4 * 4 + x % 4);
                    const double off =
                        std::abs(drawn.pixel(x, 4 * blocks - 1 - y)[channel] - rgtc_decode(block, kind)[texel]);
                    largest = std::max(largest, off);
                    if (block.indices[texel] < 2) largest_at_ends = std::max(largest_at_ends, off);
                }
        // Both ends are exact. Mesa's renderer computes the values between them in integers, with rounded weights: it
        // is off by up to 1.6 steps. An NVIDIA H200 (driver 580.159) has weights of its own, such as 96/257 for 2/5.
        const bool in_software = is_software_renderer();
        EXPECT_LE(largest * high, in_software ? 1.601 : 6.8) << "kind " << int(kind);
        EXPECT_LE(largest_at_ends, in_software ? 1e-6 : 2e-5) << "kind " << int(kind);
    }
}

TEST(EncodedTexture, HoldsVectorsInSignedBytesAndCountsThem) {
    Image vectors(5, 3, 3);  // rows of 15 bytes, which no alignment may pad
    for (size_t i = 0; i < vectors.values.size(); ++i) vectors.values[i] = float(i) / 22 - 1;
    const int64_t before = counters().texture_bytes;
    {
        const EncodedTexture texture(vectors);
        EXPECT_EQ(counters().texture_bytes - before, 45);
        const Image read = texels_of(texture, {5, 3});
        for (int y = 0; y < 3; ++y)
            for (int x = 0; x < 5; ++x)
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(read.pixel(x, y)[c], std::round(127 * vectors.pixel(x, y)[c]) / 127, 1e-6);
    }
    EXPECT_EQ(counters().texture_bytes, before);
}

}  // namespace
}  // namespace relief
