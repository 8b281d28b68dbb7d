// Patches, drawn together and one by one.
#include "framework/library/kit/gpu_patches.h"

#include <gtest/gtest.h>

#include <cmath>

#include "framework/core/gl/gpu_mesh.h"
#include "framework/core/gl/program.h"
#include "framework/core/gl/target.h"
#include "framework/core/image/compare.h"
#include "framework/library/mesh/shapes.h"
#include "tests/support.h"

namespace relief {
namespace {

constexpr int columns = 16, patch_count = columns * columns;

/// 16 x 16 quad patches over the whole picture, bent by a wave. The output is each fragment's position on its patch and
/// its height, so any misplaced vertex is visible.
class Patches : public testing::Test {
protected:
    Patches() {
        folder_.write("patch.vert",
                      "#version 410 core\nlayout(location = 0) in vec3 a_position;\nout vec3 v_position;\n"
                      "void main() { v_position = a_position; }\n");
        folder_.write("patch.tesc",
                      "#version 410 core\nlayout(vertices = 4) out;\nin vec3 v_position[];\nout vec3 c_position[];\n"
                      "uniform float u_level;\nvoid main() {\n"
                      "    c_position[gl_InvocationID] = v_position[gl_InvocationID];\n"
                      "    for (int i = 0; i < 4; ++i) gl_TessLevelOuter[i] = u_level;\n"
                      "    for (int i = 0; i < 2; ++i) gl_TessLevelInner[i] = u_level;\n}\n");
        folder_.write("patch.tese",
                      "#version 410 core\nlayout(quads, equal_spacing, ccw) in;\nin vec3 c_position[];\n"
                      "out vec3 v_place;\nvoid main() {\n"
                      "    vec2 uv = gl_TessCoord.xy;\n"
                      "    vec3 p = mix(mix(c_position[0], c_position[1], uv.x), mix(c_position[2], c_position[3], "
                      "uv.x), uv.y);\n"
                      "    v_place = vec3(uv, 0.5 * sin(20.0 * p.x) * cos(17.0 * p.y));\n"
                      "    gl_Position = vec4(p.xy * 1.8, v_place.z, 1.0);\n}\n");
        folder_.write("patch.frag",
                      "#version 410 core\nin vec3 v_place;\nlayout(location = 0) out vec4 o_color;\n"
                      "void main() { o_color = vec4(v_place, 1.0); }\n");
        std::vector<glm::vec3> corners;
        for (int y = 0; y < columns; ++y)
            for (int x = 0; x < columns; ++x)
                for (const glm::ivec2 corner : {glm::ivec2(0, 0), {1, 0}, {0, 1}, {1, 1}})
                    corners.emplace_back(glm::vec2(glm::ivec2(x, y) + corner) / float(columns) - 0.5f, 0);
        glBindVertexArray(layout_);
        glBindBuffer(GL_ARRAY_BUFFER, vertices_);
        glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(corners.size() * sizeof(glm::vec3)), corners.data(), GL_STATIC_DRAW);
        glEnableVertexAttribArray(0);
        glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
    }

    template <class Draw>
    Image drawn(float level, const Draw& draw) {
        const std::vector<std::filesystem::path> stages = {folder_.path() / "patch.vert", folder_.path() / "patch.tesc",
                                                           folder_.path() / "patch.tese",
                                                           folder_.path() / "patch.frag"};
        const Program program(stages, {});
        const Target target(TargetKind::probe, {256, 256});
        glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
        glViewport(0, 0, 256, 256);
        glClearColor(9, 9, 9, 9);
        glEnable(GL_DEPTH_TEST);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glUseProgram(program);
        program.set("u_level", level);
        glBindVertexArray(layout_);
        draw();
        return target.read();
    }

    TemporaryFolder folder_;
    VertexArrayName layout_;
    BufferName vertices_;
};

TEST_F(Patches, OneDrawEqualsSingleDrawsBitForBit) {
    for (const float level : {1.0f, 16.0f, 64.0f}) {
        const Image together = drawn(level, [] { draw_patches(patch_count, 4); });
        const Image one_by_one = drawn(level, [] {
            glPatchParameteri(GL_PATCH_VERTICES, 4);
            for (int i = 0; i < patch_count; ++i) glDrawArrays(GL_PATCHES, i * 4, 4);
        });
        EXPECT_EQ(difference(together, one_by_one, 0).pixels_over, 0u) << "level " << level;
        size_t covered = 0;
        for (size_t i = 0; i < together.values.size(); i += 4) covered += together.values[i] != 9;
        EXPECT_GT(covered, together.pixel_count() * 3 / 4);
    }
}

TEST_F(Patches, AreDrawnFromTheGivenFirstVertexToTheGivenCount) {
    const Image all = drawn(4, [] { draw_patches(patch_count, 4); });
    const Image two = drawn(4, [] {
        draw_patches(100, 4);
        draw_patches(patch_count - 100, 4, 100 * 4);
    });
    EXPECT_EQ(difference(all, two, 0).pixels_over, 0u);
    const Image some = drawn(4, [] { draw_patches(patch_count - columns, 4); });
    EXPECT_GT(difference(all, some, 0).pixels_over, all.pixel_count() / 40) << "a row is missing";
    EXPECT_TRUE(is_one_color(drawn(4, [] { draw_patches(0, 4); })));
}

TEST_F(Patches, ClampLevelsTo1To64AndCullAtLevel0) {
    const auto all = [] { draw_patches(patch_count, 4); };
    EXPECT_EQ(drawn(65, all).values, drawn(64, all).values);
    EXPECT_EQ(drawn(1e30f, all).values, drawn(64, all).values);
    EXPECT_EQ(drawn(0.5f, all).values, drawn(1, all).values);
    for (const float nothing : {0.0f, -1.0f, -INFINITY, NAN}) EXPECT_TRUE(is_one_color(drawn(nothing, all))) << nothing;
}

}  // namespace
}  // namespace relief
