#include "framework/core/gl/counters.h"

#include <gtest/gtest.h>

#include "framework/core/gl/gpu_mesh.h"
#include "framework/core/gl/texture.h"
#include "framework/library/mesh/shapes.h"

namespace relief {
namespace {

TEST(Counters, CountObjectsOfRawGlCalls) {
    const int64_t before = counters().live_objects();
    GLuint names[3];
    glGenTextures(3, names);
    EXPECT_EQ(counters().live_objects(), before + 3);
    const GLuint shader = glCreateShader(GL_VERTEX_SHADER), program = glCreateProgram();
    GLuint sampler = 0, pipeline = 0, feedback = 0;
    glGenSamplers(1, &sampler), glGenProgramPipelines(1, &pipeline), glGenTransformFeedbacks(1, &feedback);
    EXPECT_EQ(counters().live_objects(), before + 8);
    glDeleteSamplers(1, &sampler), glDeleteProgramPipelines(1, &pipeline), glDeleteTransformFeedbacks(1, &feedback);
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
    glDrawElements(GL_TRIANGLES, 0, GL_UNSIGNED_INT, nullptr);
    glDrawElementsInstanced(GL_TRIANGLES, 0, GL_UNSIGNED_INT, nullptr, 3);
    EXPECT_EQ(counters().draw_calls, before + 4);
    take_gl_errors();  // without a program the draws fail, but they count as calls
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

TEST(Counters, AMovedTextureIsCountedOnce) {
    const Counters before = counters();
    {
        Texture first("grey", [] { return Image(4, 4, 3, 8); });
        bind(0, first);
        const Texture second(std::move(first));
    }
    EXPECT_EQ(counters().texture_bytes, before.texture_bytes);
    EXPECT_EQ(counters().live, before.live);
}

TEST(GlErrors, AreReportedOnceWithTheirText) {
    glEnable(0xFFFF);
    const std::string text = take_gl_errors();
    EXPECT_NE(text.find("GL_INVALID_ENUM"), std::string::npos) << text;
    if (GLAD_GL_KHR_debug && is_software_renderer()) {
        EXPECT_NE(text.find("glEnable"), std::string::npos) << "Mesa says where: " << text;
    }
    EXPECT_EQ(take_gl_errors(), "");
}

}  // namespace
}  // namespace relief
