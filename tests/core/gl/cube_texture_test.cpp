// Cube maps: the texel for a direction, levels, edges, and counters.
#include "framework/core/gl/cube_texture.h"

#include <gtest/gtest.h>

#include <atomic>

#include "framework/core/base/error.h"
#include "framework/core/gl/counters.h"
#include "tests/core/gl/fragment_shader.h"

namespace relief {
namespace {

/// Returns the shader's sample in a direction. The fourth component is the level.
glm::vec3 sampled(const CubeTexture& texture, const glm::vec4& direction) {
    const char* const text =
        "uniform samplerCube s_sky;\nuniform vec4 u_direction;\nout vec4 o_color;\n"
        "void main() { o_color = textureLod(s_sky, u_direction.xyz, u_direction.w); }\n";
    return draw_fragment(text, [&](const Program& program) {
        program.set("s_sky", 2, texture);
        program.set("u_direction", direction);
    });
}

CubeTexture directions(int side) {
    return CubeTexture("directions", side, [](const glm::dvec3& direction) { return direction; });
}

TEST(CubeTexture, ADirectionSamplesTheLightFromThatDirection) {
    const CubeTexture cube = directions(64);
    for (const glm::vec3 toward : {glm::vec3(1, 0.2f, -0.4f),
                                   {-3, 1, 2},
                                   {0.1f, 2, 0.7f},
                                   {0.4f, -1, -0.3f},
                                   {-0.3f, 0.5f, 1},
                                   {0.2f, 0.6f, -1}}) {
        // At a texel spacing of 1/32 the chord of a circle has an error below 1/32^2 / 8.
        const glm::vec3 off = sampled(cube, glm::vec4(toward, 0)) - glm::normalize(toward);
        EXPECT_LT(glm::length(off), 2e-4f) << toward.x << " " << toward.y << " " << toward.z;
    }
}

TEST(CubeTexture, FaceCornersAreCubeCorners) {
    for (int face = 0; face < 6; ++face)
        for (const double s : {-1.0, 1.0})
            for (const double t : {-1.0, 1.0}) {
                const glm::dvec3 corner = cube_map_direction(face, s, t);
                EXPECT_EQ(glm::abs(corner), glm::dvec3(1)) << face;
            }
}

TEST(CubeTexture, TheLastLevelIsTheMeanOfAFace) {
    const glm::vec3 up = sampled(directions(8), {0, 1, 0, 3});
    EXPECT_NEAR(up.x, 0, 1e-6);
    EXPECT_NEAR(up.z, 0, 1e-6);
    EXPECT_GT(up.y, 0.75f);
    EXPECT_LT(up.y, 0.85f);
}

TEST(CubeTexture, FiltersAcrossEdgesOnlyIfSeamless) {
    const CubeTexture cube("sides", 1, [](const glm::dvec3& d) { return glm::dvec3(d.x > 0.9 ? 1 : 0); });
    const glm::vec4 edge(1, 0, 0.999f, 0);
    EXPECT_EQ(sampled(cube, edge).x, 1);
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    EXPECT_NEAR(sampled(cube, edge).x, 0.5, 0.01);
    glDisable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
}

TEST(CubeTexture, IsCreatedAtFirstUseAndFreesItsBytes) {
    const Counters before = counters();
    {
        std::atomic<int> calls = 0;
        const CubeTexture cube("counted", 4, [&](const glm::dvec3&) { return ++calls, glm::dvec3(1); });
        EXPECT_EQ(calls, 0);
        GLuint other = 0;
        glGenTextures(1, &other);
        glBindTexture(GL_TEXTURE_CUBE_MAP, other);
        const GLuint name = cube;
        GLint bound = 0;
        glGetIntegerv(GL_TEXTURE_BINDING_CUBE_MAP, &bound);
        EXPECT_EQ(GLuint(bound), other) << "what was bound stays bound";
        glDeleteTextures(1, &other);
        EXPECT_EQ(GLuint(cube), name);
        EXPECT_EQ(calls, 6 * 16) << "once";
        EXPECT_EQ(counters().texture_bytes - before.texture_bytes, 6 * (16 + 4 + 1) * 12);
    }
    EXPECT_EQ(counters().texture_bytes, before.texture_bytes);
    EXPECT_EQ(counters().live, before.live);
}

TEST(CubeTexture, AnInvalidSizeThrows) {
    for (const int side : {0, 1 << 24}) {
        const CubeTexture cube = directions(side);
        EXPECT_THROW((void)GLuint(cube), Error) << side;
    }
}

}  // namespace
}  // namespace relief
