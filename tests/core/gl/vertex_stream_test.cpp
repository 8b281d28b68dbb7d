// Streams in addition to a mesh: their values reach the shader unchanged, per vertex and per instance.
#include "framework/core/gl/vertex_stream.h"

#include <gtest/gtest.h>

#include "framework/core/base/error.h"
#include "framework/core/gl/counters.h"
#include "framework/core/gl/program.h"
#include "framework/core/gl/target.h"
#include "tests/support.h"

namespace relief {
namespace {

int64_t live_buffers() { return counters().live[size_t(GlKind::buffer)]; }

struct Bones {
    std::array<uint8_t, 4> bones;
    glm::vec4 weights;
};
struct Placed {
    glm::vec2 place;
    int32_t number;
};

/// One pixel for each vertex of each instance: its last weight, its last bone, its instance's x and number.
class VertexStreams : public testing::Test {
protected:
    VertexStreams() {
        folder_.write(
            "points.vert",
            "#version 410 core\nlayout(location = 4) in uvec4 a_bones;\nlayout(location = 5) in vec4 a_weights;\n"
            "layout(location = 6) in vec2 a_place;\nlayout(location = 7) in int a_number;\n"
            "flat out vec4 v_found;\nvoid main() {\n"
            "    v_found = vec4(a_weights.w, float(a_bones.w), a_place.x, float(a_number / 2));\n"
            "    vec2 pixel = vec2(gl_VertexID, gl_InstanceID) + 0.5;\n"
            "    gl_Position = vec4(pixel / 4.0 - 1.0, 0.0, 1.0);\n}\n");
        folder_.write("points.frag",
                      "#version 410 core\nflat in vec4 v_found;\nlayout(location = 0) out vec4 o_color;\n"
                      "void main() { o_color = v_found; }\n");
    }

    /// Draws 2 vertices and 3 instances; pixel (x, y) is vertex x of instance y.
    Image drawn() {
        const Program program({folder_.path() / "points.vert", folder_.path() / "points.frag"}, {});
        const Target target(TargetKind::probe, {8, 8});
        glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
        glViewport(0, 0, 8, 8);
        glClearColor(9, 9, 9, 9);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glUseProgram(program);
        glBindVertexArray(layout_);
        glDrawArraysInstanced(GL_POINTS, 0, 2, 3);
        return target.read();
    }
    static glm::vec4 pixel(const Image& image, int x, int y) {
        const float* const at = image.pixel(x, image.height - 1 - y);
        return {at[0], at[1], at[2], at[3]};
    }

    TemporaryFolder folder_;
    VertexArrayName layout_;
    VertexStream bones_{{{4, 4, GL_UNSIGNED_BYTE, offsetof(Bones, bones)}, {5, 4, GL_FLOAT, offsetof(Bones, weights)}}};
    VertexStream instances_{{{6, 2, GL_FLOAT, offsetof(Placed, place)}, {7, 1, GL_INT, offsetof(Placed, number)}}, 1};
};

TEST_F(VertexStreams, PassEachVertexAndInstanceItsValuesUnchanged) {
    const std::array<Bones, 2> bones = {{{{1, 2, 3, 255}, {0, 0, 0, 0.25f}}, {{0, 0, 0, 7}, {0, 0, 0, 0.75f}}}};
    // A float would round the last number.
    const std::array<Placed, 3> placed = {{{{0.5f, 0}, 4}, {{1.5f, 0}, -6}, {{2.5f, 0}, 33554434 + 16777216}}};
    bones_.fill<Bones>(bones), bones_.attach(layout_);
    instances_.fill<Placed>(placed), instances_.attach(layout_);
    EXPECT_EQ(bones_.count(), 2);
    EXPECT_EQ(instances_.count(), 3);
    const Image image = drawn();
    for (int x = 0; x < 2; ++x)
        for (int y = 0; y < 3; ++y)
            EXPECT_EQ(pixel(image, x, y), glm::vec4(bones[size_t(x)].weights.w, bones[size_t(x)].bones[3],
                                                    placed[size_t(y)].place.x, placed[size_t(y)].number / 2))
                << x << ' ' << y;
    EXPECT_EQ(pixel(image, 2, 0), glm::vec4(9)) << "nothing else is drawn";
}

TEST_F(VertexStreams, UseNewDataAfterARefill) {
    bones_.fill<Bones>(std::array<Bones, 2>{}), bones_.attach(layout_);
    instances_.fill<Placed>(std::array<Placed, 3>{}), instances_.attach(layout_);
    EXPECT_EQ(pixel(drawn(), 1, 2), glm::vec4(0));
    instances_.fill<Placed>(std::array<Placed, 4>{{{}, {}, {{3, 0}, 8}, {}}});
    EXPECT_EQ(pixel(drawn(), 1, 2), glm::vec4(0, 0, 3, 4));
    EXPECT_EQ(instances_.count(), 4);
}

TEST_F(VertexStreams, CreateTheirBufferAtTheFirstFillAndFreeIt) {
    const int64_t before = live_buffers();
    {
        VertexStream stream({{4, 1, GL_FLOAT, 0}});
        EXPECT_EQ(live_buffers(), before);
        EXPECT_THROW(stream.attach(layout_), Error);
        for (int turn = 0; turn < 3; ++turn) stream.fill<float>(std::array{1.0f, 2.0f});
        EXPECT_EQ(live_buffers(), before + 1);
    }
    EXPECT_EQ(live_buffers(), before);
}

TEST_F(VertexStreams, KeepTheBoundVertexArray) {
    const VertexArrayName other;
    glBindVertexArray(other);
    VertexStream stream({{4, 1, GL_FLOAT, 0}});
    stream.fill<float>(std::array{1.0f});
    stream.attach(layout_);
    GLint bound = 0;
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &bound);
    EXPECT_EQ(GLuint(bound), GLuint(other));
    glBindVertexArray(0);
}

}  // namespace
}  // namespace relief
