#include "framework/core/gl/target.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "framework/core/base/error.h"
#include "framework/core/gl/counters.h"

namespace relief {
namespace {

/// Clears a part of the target, without a shader.
void fill(const Target& target, glm::ivec2 corner, glm::ivec2 size, glm::vec4 value) {
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
    glEnable(GL_SCISSOR_TEST);
    glScissor(corner.x, corner.y, size.x, size.y);
    glClearColor(value.x, value.y, value.z, value.w);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
}

/// Draws a white triangle with two slanted edges.
void draw_triangle(const Target& target) {
    ShaderSource vertex, fragment;
    vertex.stage = "triangle.vert", fragment.stage = "triangle.frag";
    vertex.text =
        "#version 410 core\n"
        "void main() { gl_Position = vec4(vec2[](vec2(-0.9, -0.8), vec2(0.8, -0.3), vec2(-0.2, 0.9))[gl_VertexID], "
        "0.0, "
        "1.0); }\n";
    fragment.text = "#version 410 core\nout vec4 o_color;\nvoid main() { o_color = vec4(1.0); }\n";
    const Program program(std::vector<ShaderSource>{vertex, fragment});
    const VertexArrayName nothing;
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
    glViewport(0, 0, target.size().x, target.size().y);
    glDisable(GL_DEPTH_TEST);
    glUseProgram(program);
    glBindVertexArray(nothing);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glEnable(GL_DEPTH_TEST);
}

TEST(Target, RowZeroOfAPictureIsTheTop) {
    for (const TargetKind kind : {TargetKind::picture, TargetKind::light, TargetKind::probe}) {
        const Target target(kind, {3, 2});
        fill(target, {0, 0}, {3, 2}, {0, 0, 0, 1});
        fill(target, {2, 1}, {1, 1}, {1, 0, 0, 1});  // upper right in GL's coordinates
        const Image image = target.read();
        EXPECT_EQ(image.pixel(2, 0)[0], 1.0f);
        EXPECT_EQ(image.pixel(2, 1)[0], 0.0f);
        EXPECT_EQ(image.pixel(0, 0)[0], 0.0f);
    }
}

/// Hides that textures can have samples, as WebGL does, while it lives.
class NoSamplesInTextures {
public:
    NoSamplesInTextures() : real_(glad_glGetIntegerv) {
        asked() = real_;
        glad_glGetIntegerv = [](GLenum name, GLint* value) {
            if (name == GL_MAX_COLOR_TEXTURE_SAMPLES)
                *value = 1;
            else
                asked()(name, value);
        };
    }
    ~NoSamplesInTextures() { glad_glGetIntegerv = real_; }
    NoSamplesInTextures(const NoSamplesInTextures&) = delete;

private:
    static PFNGLGETINTEGERVPROC& asked() {
        static PFNGLGETINTEGERVPROC function;
        return function;
    }
    PFNGLGETINTEGERVPROC real_;
};

TEST(Target, ABlitTakesTheSameAverageWhereTexturesHaveNoSamples) {
    const auto drawn = [] {
        const Target target(TargetKind::picture, {64, 64});
        fill(target, {0, 0}, {64, 64}, {0, 0, 0, 1});
        draw_triangle(target);
        return target.read();
    };
    const Image by_program = drawn();
    const NoSamplesInTextures hidden;
    const Image by_blit = drawn();
    size_t grey = 0;
    for (size_t i = 0; i < by_blit.values.size(); ++i) {
        EXPECT_NEAR(by_blit.values[i], by_program.values[i], 1.01 / 255);
        grey += by_blit.values[i] > 0.1f && by_blit.values[i] < 0.9f;
    }
    EXPECT_GT(grey, 60u);  // along two edges of the triangle
}

TEST(Target, AProbeKeepsInfinityNanAndEveryBit) {
    const Target target(TargetKind::probe, {2, 1});
    fill(target, {0, 0}, {1, 1}, {no_surface, -1e30f, std::numbers::pi_v<float>, 1e-30f});
    fill(target, {1, 0}, {1, 1}, glm::vec4(NAN));
    const Image image = target.read();
    EXPECT_EQ(image.pixel(0, 0)[0], no_surface);
    EXPECT_EQ(image.pixel(0, 0)[1], -1e30f);
    EXPECT_EQ(image.pixel(0, 0)[2], std::numbers::pi_v<float>);
    EXPECT_EQ(image.pixel(0, 0)[3], 1e-30f);
    EXPECT_TRUE(std::isnan(image.pixel(1, 0)[1]));
}

TEST(Target, AProbeHasOneSampleAndAPictureHasMore) {
    const auto samples = [](TargetKind kind) {
        const Target target(kind, {4, 4});
        glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
        GLint count = 0;
        glGetIntegerv(GL_SAMPLES, &count);
        return count;
    };
    EXPECT_LE(samples(TargetKind::probe), 1) << "numbers must not be averaged";
    EXPECT_GT(samples(TargetKind::picture), 1);
    EXPECT_GT(samples(TargetKind::light), 1);
}

TEST(Target, AnotherPictureOfAnySizeLinksNoProgramWhileOneLives) {
    const Target first(TargetKind::picture, {8, 8});
    const int64_t links = counters().links;
    const Target larger(TargetKind::picture, {16, 4}), light(TargetKind::light, {3, 3});
    EXPECT_EQ(counters().links, links);
}

TEST(Target, DoesNotClampLight) {
    const Target target(TargetKind::light, {2, 2});
    fill(target, {0, 0}, {2, 2}, {12.5f, -2, 0.25f, 1});
    EXPECT_EQ(target.read().pixel(1, 1)[0], 12.5f);
}

TEST(Target, IgnoresAScissorLeftEnabled) {
    const Target target(TargetKind::picture, {4, 4});
    fill(target, {0, 0}, {4, 4}, {0, 1, 0, 1});
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 1, 1);
    EXPECT_EQ(target.read().pixel(3, 0)[1], 1.0f);
    glDisable(GL_SCISSOR_TEST);
}

TEST(Target, AnOversizedTargetThrowsAndLeaksNothing) {
    const Counters before = counters();
    EXPECT_THROW(Target(TargetKind::picture, {1 << 20, 1 << 20}), Error);
    EXPECT_EQ(counters().live, before.live);
}

}  // namespace
}  // namespace relief
