// Framebuffers of textures: drawing into each attachment, levels, and counters.
#include "framework/core/gl/texel_target.h"

#include <gtest/gtest.h>

#include "framework/core/gl/counters.h"
#include "framework/core/gl/gl.h"

namespace relief {
namespace {

TEST(TexelTarget, EachAttachmentKeepsItsOwnFloatsOfAnyMagnitude) {
    const TexelTarget target({4, 2}, {GL_RGBA32F, GL_RGBA32F});
    target.begin();
    const float small[] = {-3, 1e-20f, 2, 0}, large[] = {1e20f, 0.1f, -1, 7};
    glClearBufferfv(GL_COLOR, 0, small);
    glClearBufferfv(GL_COLOR, 1, large);
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(target.read(0).pixel(3, 1)[i], small[i]);
        EXPECT_EQ(target.read(1).pixel(0, 0)[i], large[i]);
    }
    EXPECT_EQ(take_gl_errors(), "");
}

TEST(TexelTarget, EachMipLevelAveragesTheOneBeforeAndRowZeroIsTheTop) {
    const TexelTarget target({2, 2}, {GL_RGBA8}, true);
    target.begin();
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 1, 2, 1);  // the upper row
    glClearColor(1, 0.2f, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
    glClearColor(0, 0, 0, 0);
    EXPECT_EQ(target.read().pixel(0, 0)[0], 1);
    EXPECT_EQ(target.read().pixel(0, 1)[0], 0);
    target.make_mips();
    float texel[4] = {};
    target.bind(0);
    glGetTexImage(GL_TEXTURE_2D, 1, GL_RGBA, GL_FLOAT, texel);
    EXPECT_NEAR(texel[0], 0.5, 1.0 / 255);
    EXPECT_NEAR(texel[1], 0.1, 1.0 / 255);
}

TEST(TexelTarget, HasADepthBufferOnlyOnRequest) {
    for (const bool has_depth : {false, true}) {
        const TexelTarget target({2, 2}, {GL_RGBA32F}, false, has_depth);
        target.begin();
        GLint kind = 0;
        glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT,
                                              GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &kind);
        EXPECT_EQ(kind, has_depth ? GL_RENDERBUFFER : GL_NONE);
        EXPECT_EQ(take_gl_errors(), "");
    }
}

TEST(TexelTarget, CountsAndFreesTheBytesOfAllLevels) {
    const Counters before = counters();
    {
        const TexelTarget plain({8, 4}, {GL_RGBA32F, GL_RGBA8});
        EXPECT_EQ(counters().texture_bytes - before.texture_bytes, 8 * 4 * (16 + 4));
        const TexelTarget levels({4, 4}, {GL_RGBA16}, true);
        EXPECT_EQ(counters().texture_bytes - before.texture_bytes, 8 * 4 * 20 + (16 + 4 + 1) * 8);
    }
    EXPECT_EQ(counters().texture_bytes, before.texture_bytes);
    EXPECT_EQ(counters().live, before.live);
}

}  // namespace
}  // namespace relief
