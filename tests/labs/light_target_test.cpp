// Light in floats: blending, samples, and counters.
#include "labs/08_obj_materials/light_target.h"

#include <gtest/gtest.h>

#include "framework/core/gl/counters.h"
#include "framework/core/gl/program.h"
#include "framework/core/gl/texel_target.h"

namespace relief {
namespace {

/// Draws one triangle over the whole target, or over half of it, that writes `color` at a depth.
void paint(const char* color, float depth, bool is_half = false) {
    ShaderSource vertex, fragment;
    vertex.stage = "paint.vert";
    vertex.text =
        "#version 410 core\nuniform float u_depth;\nvoid main() {\n"
        "    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, u_depth, 1.0);\n}\n";
    fragment.stage = "paint.frag";
    fragment.text = std::string("#version 410 core\nuniform float u_end;\nout vec4 o_color;\nvoid main() {\n") +
                    "    if (gl_FragCoord.x > u_end) discard;\n    o_color = vec4(" + color + ");\n}\n";
    const Program program({vertex, fragment});
    glUseProgram(program);
    program.set("u_depth", depth);
    program.set("u_end", is_half ? 2.0f : 100.0f);
    const VertexArrayName nothing;
    glBindVertexArray(nothing);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glUseProgram(0);
}

/// Returns the mean of the samples at the four texels of the lowest row.
std::vector<glm::vec4> read(const LightTarget& target, int attachment = 0) {
    ShaderSource vertex, fragment;
    vertex.stage = "read.vert";
    vertex.text =
        "#version 410 core\nvoid main() {\n"
        "    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);\n}\n";
    fragment.stage = "read.frag";
    fragment.text = target.samples() > 1
                        ? "#version 410 core\nuniform sampler2DMS s_light;\nout vec4 o_color;\nvoid main() {\n"
                          "    o_color = vec4(0.0);\n    for (int i = 0; i < 4; ++i)\n"
                          "        o_color += 0.25 * texelFetch(s_light, ivec2(gl_FragCoord.xy), i);\n}\n"
                        : "#version 410 core\nuniform sampler2D s_light;\nout vec4 o_color;\nvoid main() {\n"
                          "    o_color = texelFetch(s_light, ivec2(gl_FragCoord.xy), 0);\n}\n";
    const TexelTarget texels(target.size(), {GL_RGBA32F});
    texels.begin();
    const Program program({vertex, fragment});
    glUseProgram(program);
    target.bind(0, attachment);
    const VertexArrayName nothing;
    glBindVertexArray(nothing);
    glDisable(GL_DEPTH_TEST);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glUseProgram(0);
    const Image image = texels.read();
    std::vector<glm::vec4> row;
    for (int x = 0; x < image.width; ++x) {
        const float* at = image.pixel(x, image.height - 1);
        row.emplace_back(at[0], at[1], at[2], at[3]);
    }
    return row;
}

TEST(LightTarget, KeepsUnclampedLightAndTestsDepthAtAnySampleCount) {
    for (const int samples : {1, 4}) {
        const LightTarget target({4, 2}, samples);
        EXPECT_EQ(target.samples(), samples);
        target.begin();
        glViewport(0, 0, 4, 2);
        glEnable(GL_DEPTH_TEST);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        paint("40.0, -2.0, 1e-6, 1.0", 0.5f);
        paint("0.0, 0.0, 0.0, 1.0", 0.75f);  // behind it
        EXPECT_EQ(read(target)[3], glm::vec4(40, -2, 1e-6f, 1)) << samples;
    }
    EXPECT_EQ(take_gl_errors(), "");
}

TEST(LightTarget, BlendsInFloats) {
    const LightTarget target({4, 2}, 4);
    target.begin();
    glViewport(0, 0, 4, 2);
    glDisable(GL_DEPTH_TEST);
    paint("1.0, 0.5, 0.1, 0.0", 0);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    paint("0.0001, 0.0, 0.0, 0.25", 0, true);
    glDisable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ZERO);
    const auto row = read(target);
    EXPECT_NEAR(row[0].x, 0.7501f, 1e-6f);
    EXPECT_NEAR(row[0].y, 0.375f, 1e-6f);
    EXPECT_EQ(row[3].x, 1);
}

TEST(LightTarget, DrawsOnlyIntoTheSelectedAttachments) {
    const LightTarget target({4, 2}, 1, 3);
    const float one[] = {1, 1, 1, 1}, two[] = {2, 2, 2, 2}, three[] = {3, 3, 3, 3};
    target.begin();
    glClearBufferfv(GL_COLOR, 0, one);
    target.begin(1, 2);
    glClearBufferfv(GL_COLOR, 0, two);
    glClearBufferfv(GL_COLOR, 1, three);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(read(target, i)[0], glm::vec4(float(i + 1)));
}

TEST(LightTarget, CountsAndFreesItsBytes) {
    const Counters before = counters();
    {
        const LightTarget one({8, 4}, 1), four({8, 4}, 4, 3);
        EXPECT_EQ(counters().texture_bytes - before.texture_bytes, 8 * 4 * 16 * (1 + 12));
    }
    EXPECT_EQ(counters().texture_bytes, before.texture_bytes);
    EXPECT_EQ(counters().live, before.live);
}

}  // namespace
}  // namespace relief
