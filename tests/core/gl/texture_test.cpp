#include "framework/core/gl/texture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "framework/core/base/error.h"
#include "framework/core/base/paths.h"
#include "framework/core/gl/counters.h"
#include "framework/core/image/color.h"
#include "framework/core/image/file.h"
#include "tests/core/gl/fragment_shader.h"

namespace relief {
namespace {

/// Returns the shader's sample of the texture at (u, v) on a level.
glm::vec4 sampled(const Texture& texture, float u, float v, float level = 0) {
    const char* const text =
        "uniform sampler2D s_map;\nuniform vec3 u_place;\nout vec4 o_color;\n"
        "void main() { o_color = textureLod(s_map, u_place.xy, u_place.z); }\n";
    return draw_fragment(text, [&](const Program& program) {
        program.set("s_map", 3, texture);
        program.set("u_place", glm::vec3(u, v, level));
    });
}

Image grey(std::vector<float> values, int width, int bits) {
    Image image(width, int(values.size()) / width, 1, bits);
    image.values = std::move(values);
    return image;
}

TEST(Texture, RowZeroIsTheTopAndVGrowsUp) {
    const Texture texture("rows", [] { return grey({1.0f, 0.0f}, 1, 8); }, {.mips = false});
    EXPECT_EQ(sampled(texture, 0.5f, 0.75f).r, 1.0f);
    EXPECT_EQ(sampled(texture, 0.5f, 0.25f).r, 0.0f);
}

TEST(Texture, EveryPrecisionKeepsItsValues) {
    for (const int bits : {8, 16, 32}) {
        const float value = bits == 8 ? 77.0f / 255 : bits == 16 ? 12345.0f / 65535 : -3.25f;
        const Texture texture("value", [&] { return grey({value}, 1, bits); });
        // The filter's weights add up to 1 within two ulps of a float.
        EXPECT_NEAR(sampled(texture, 0.5f, 0.5f).r, value, 3e-7 * std::abs(value)) << bits << " bits";
    }
}

TEST(Texture, SrgbColourIsReadAsLight) {
    Image image(1, 1, 3, 8);
    image.values = {188.0f / 255, 0, 1};
    const Texture texture("colour", [&] { return image; }, {.space = ColorSpace::srgb});
    const glm::vec4 light = sampled(texture, 0.5f, 0.5f);
    // The renderer approximates the curve. Its specification allows an error of half an 8-bit step.
    EXPECT_NEAR(light.r, linear_from_srgb(188.0 / 255), 0.5 / 255);
    EXPECT_EQ(light.g, 0.0f);
    EXPECT_NEAR(light.b, 1.0f, 1e-6);
}

TEST(Texture, TheLastLevelIsTheMeanOfAll) {
    const Texture texture("mips", [] { return grey({0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0}, 4, 32); });
    EXPECT_NEAR(sampled(texture, 0.5f, 0.5f, 2).r, 5.0f / 16, 1e-7);
}

TEST(Texture, CreationKeepsTheBoundTexture) {
    const Texture first("first", [] { return grey({0.25f}, 1, 32); }),
        second("second", [] { return grey({1}, 1, 32); });
    bind(2, first);
    const GLuint made = second;
    EXPECT_NE(made, 0u);
    GLint bound = 0;
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
    EXPECT_EQ(GLuint(bound), GLuint(first));
}

TEST(Texture, UsesTheRequestedAnisotropyAndDefaultsToNoneWhenPicturesAreCompared) {
    if (!GLAD_GL_EXT_texture_filter_anisotropic) GTEST_SKIP() << "this driver has no anisotropic filter";
    const auto anisotropy = [](TextureOptions options) {
        const Texture texture(
            "grey", [] { return grey({1}, 1, 8); }, options);
        bind(0, texture);
        float value = 0;
        glGetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, &value);
        return value;
    };
    EXPECT_EQ(anisotropy({.anisotropy = 4}), 4);
    EXPECT_EQ(anisotropy({.anisotropy = 1}), 1);
    EXPECT_EQ(anisotropy({}), 1);
}

TEST(Texture, WrapsOrClampsAsRequested) {
    const auto two = [] { return grey({0.0f, 1.0f}, 2, 32); };
    const Texture repeated("repeat", two, {.wrap = Wrap::repeat, .mips = false}),
        clamped("clamp", two, {.wrap = Wrap::clamp, .mips = false});
    EXPECT_EQ(sampled(repeated, 1.25f, 0.5f).r, 0.0f);
    EXPECT_EQ(sampled(clamped, 1.25f, 0.5f).r, 1.0f);
}

TEST(Texture, SizesNeedNotBePowersOfTwo) {
    const Texture texture("odd", [] { return grey(std::vector<float>(35, 0.5f), 7, 16); });
    EXPECT_NEAR(sampled(texture, 0.3f, 0.9f, 2).r, 0.5f, 1e-4);
}

TEST(Texture, AssetsWithEqualOptionsShareOneTextureWhileItLives) {
    const Counters before = counters();
    {
        const Texture first = load_texture("labels.png", {.wrap = Wrap::clamp});
        const GLuint name = first;
        const Counters one = counters();
        {
            const Texture second = load_texture("labels.png", {.wrap = Wrap::clamp});
            EXPECT_EQ(GLuint(second), name);
            EXPECT_EQ(counters().live, one.live);
            EXPECT_EQ(counters().texture_bytes, one.texture_bytes);
            const Texture other = load_texture("labels.png", {.wrap = Wrap::repeat});
            EXPECT_NE(GLuint(other), name) << "another texture: it repeats";
        }
        EXPECT_EQ(counters().live, one.live);
        EXPECT_EQ(glIsTexture(name), GL_TRUE);
    }
    EXPECT_EQ(counters().live, before.live);
    EXPECT_EQ(counters().texture_bytes, before.texture_bytes);
}

TEST(Texture, AnAssetEqualsATextureOfItsPicture) {
    for (const bool mips : {true, false}) {
        const Texture asset = load_texture("quilt_world.png", {.mips = mips});
        const Texture made("made", [] { return read_image(course_root() / "assets/quilt_world.png"); }, {.mips = mips});
        for (GLint level = 0; level < (mips ? 10 : 1); ++level) {
            const auto texels = [&](const Texture& texture) {
                bind(0, texture);
                GLint width = 0, internal = 0;
                glGetTexLevelParameteriv(GL_TEXTURE_2D, level, GL_TEXTURE_WIDTH, &width);
                glGetTexLevelParameteriv(GL_TEXTURE_2D, level, GL_TEXTURE_INTERNAL_FORMAT, &internal);
                EXPECT_EQ(width, 512 >> level);
                EXPECT_EQ(internal, GL_RGB8);
                std::vector<uint8_t> bytes(size_t(width) * size_t(width) * 4);
                glGetTexImage(GL_TEXTURE_2D, level, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
                return bytes;
            };
            EXPECT_EQ(texels(asset), texels(made)) << "level " << level;
        }
        bind(0, asset);
        GLint levels = 0;
        glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, &levels);
        EXPECT_EQ(levels, mips ? 9 : 0);
    }
}

TEST(Texture, AMissingFileNamesItself) {
    const Texture texture = load_texture("no_such_texture.png", ColorSpace::linear);
    try {
        bind(0, texture);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("assets/no_such_texture.png"), std::string::npos) << error.what();
    }
}

TEST(Texture, SrgbWithOneChannelIsRefused) {
    const Texture texture("grey", [] { return grey({0.5f}, 1, 8); }, {.space = ColorSpace::srgb});
    EXPECT_THROW(bind(0, texture), Error);
}

TEST(Texture, AFailedLoadLeavesNoObject) {
    const Counters before = counters();
    const Texture texture("broken", []() -> Image { throw Error("no"); });
    EXPECT_THROW(bind(0, texture), Error);
    EXPECT_EQ(counters().live, before.live);
}

}  // namespace
}  // namespace relief
