// Depth maps: drawing into them, comparisons, and counters.
#include "framework/core/gl/depth_target.h"

#include <gtest/gtest.h>

#include "framework/core/gl/counters.h"
#include "tests/core/gl/fragment_shader.h"

namespace relief {
namespace {

/// Returns one pixel of a shader with a depth comparison.
float compared(const DepthTarget& depth, const glm::vec3& place) {
    const char* const text =
        "uniform sampler2DShadow s_depth;\nuniform vec3 u_place;\nout vec4 o_color;\n"
        "void main() { o_color = vec4(texture(s_depth, u_place)); }\n";
    return draw_fragment(text,
                         [&](const Program& program) {
                             depth.bind(1);
                             program.set("s_depth", 1);
                             program.set("u_place", place);
                         })
        .x;
}

/// Sets the left half to 0.25 and the right half to 0.75.
void draw_halves(const DepthTarget& depth) {
    depth.begin();
    glEnable(GL_SCISSOR_TEST);
    for (int half = 0; half < 2; ++half) {
        glScissor(half * depth.size().x / 2, 0, depth.size().x / 2, depth.size().y);
        glClearDepth(half == 0 ? 0.25 : 0.75);
        glClear(GL_DEPTH_BUFFER_BIT);
    }
    glDisable(GL_SCISSOR_TEST);
    glClearDepth(1);
}

TEST(DepthTarget, AComparisonPassesIfTheReferenceIsAtMostTheNearestDepth) {
    const DepthTarget depth({4, 2});
    draw_halves(depth);
    EXPECT_EQ(compared(depth, {0.2f, 0.5f, 0.25f}), 1);
    EXPECT_EQ(compared(depth, {0.2f, 0.5f, 0.26f}), 0);
    EXPECT_EQ(compared(depth, {0.8f, 0.5f, 0.74f}), 1);
    EXPECT_EQ(compared(depth, {0.8f, 0.5f, 0.76f}), 0);
    EXPECT_EQ(compared(depth, {0.499f, 0.5f, 0.5f}), 0) << "nearest: never between two depths";
    EXPECT_EQ(compared(depth, {0.501f, 0.5f, 0.5f}), 1);
}

TEST(DepthTarget, ComparisonsOutsideItPass) {
    const DepthTarget depth({4, 2});
    draw_halves(depth);
    for (const glm::vec3 place : {glm::vec3(-0.01f, 0.5f, 0.9f), {1.01f, 0.5f, 0.9f}, {0.2f, 1.01f, 1}, {0.2f, -1, 1}})
        EXPECT_EQ(compared(depth, place), 1);
}

TEST(DepthTarget, StoresTheDrawnDepthWithRowZeroAtTheTop) {
    const DepthTarget depth({2, 2});
    depth.begin();
    glClear(GL_DEPTH_BUFFER_BIT);
    const Program program = window_program("void main() {}\n");
    const VertexArrayName layout;
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 1, 2, 1);
    glUseProgram(program);
    glBindVertexArray(layout);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_SCISSOR_TEST);
    const Image image = depth.read();
    EXPECT_EQ(*image.pixel(0, 0), 0.5f);
    EXPECT_EQ(*image.pixel(1, 1), 1.0f);
    EXPECT_EQ(take_gl_errors(), "");
}

TEST(DepthTarget, CountsAndFreesItsBytes) {
    const Counters before = counters();
    {
        const DepthTarget depth({8, 4});
        EXPECT_EQ(counters().texture_bytes - before.texture_bytes, 8 * 4 * 4);
    }
    EXPECT_EQ(counters().texture_bytes, before.texture_bytes);
    EXPECT_EQ(counters().live, before.live);
}

}  // namespace
}  // namespace relief
