#include "framework/gl/counters.h"

#include <gtest/gtest.h>

#include "framework/gl/gpu_mesh.h"
#include "framework/gl/texture.h"
#include "framework/mesh/shapes.h"

namespace relief {
namespace {

TEST(Counters, SeeWhatRawCallsMakeAndDelete) {
    const int64_t before = counters().live_objects();
    GLuint names[3];
    glGenTextures(3, names);
    EXPECT_EQ(counters().live_objects(), before + 3);
    const GLuint shader = glCreateShader(GL_VERTEX_SHADER), program = glCreateProgram();
    EXPECT_EQ(counters().live_objects(), before + 5);
    glDeleteTextures(3, names);
    glDeleteShader(shader), glDeleteProgram(program);
    EXPECT_EQ(counters().live_objects(), before);
}

TEST(Counters, DeletingNameZeroIsNotADeletion) {
    const int64_t before = counters().live_objects();
    const GLuint zero = 0;
    glDeleteBuffers(1, &zero);
    glDeleteProgram(0);
    EXPECT_EQ(counters().live_objects(), before);
}

TEST(Counters, CountEachDrawOnce) {
    const int64_t before = counters().draw_calls;
    const VertexArrayName layout;
    glBindVertexArray(layout);
    glDrawArrays(GL_TRIANGLES, 0, 0);
    glDrawArraysInstanced(GL_TRIANGLES, 0, 0, 5);
    EXPECT_EQ(counters().draw_calls, before + 2);
    take_gl_errors();  // without a program the draws are refused, but they were made
}

TEST(Counters, OwnersGiveBackEveryObjectAndByte) {
    const Counters before = counters();
    {
        const GpuMesh mesh = upload([] { return make_quad({}); });
        const Texture texture("grey", [] { return Image(4, 4, 3, 8); });
        EXPECT_EQ(counters().live_objects(), before.live_objects()) << "made before first use";
        EXPECT_GT(mesh.count(), 0);
        bind(0, texture);
        EXPECT_EQ(counters().live_objects(), before.live_objects() + 4);
        EXPECT_EQ(counters().texture_bytes, before.texture_bytes + 3 * (16 + 4 + 1)) << "4x4, 2x2 and 1x1 of RGB8";
    }
    EXPECT_EQ(counters().live, before.live);
    EXPECT_EQ(counters().texture_bytes, before.texture_bytes);
}

TEST(GlErrors, AreToldOnceWithTheirText) {
    glEnable(0xFFFF);
    EXPECT_NE(take_gl_errors().find("GL_INVALID_ENUM"), std::string::npos);
    EXPECT_EQ(take_gl_errors(), "");
}

}  // namespace
}  // namespace relief
