// The stages around the tessellator as vertex stages: what their texts become.
#include "framework/course/web/patch_shader.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "framework/core/base/error.h"
#include "tests/support.h"

namespace relief::web {
namespace {

constexpr const char* corner_struct = "struct Corner {\n    vec3 position;\n    vec2 uv;\n};\n";

std::string control(const std::string& vertices = "4", const std::string& more = "") {
    return "#version 410 core\n" + std::string(corner_struct) + more + "layout(vertices = " + vertices +
           ") out;\nin Corner v_corner[];\nin int v_vertex[];\nout Corner c_corner[];\npatch out int c_patch;\n"
           "void main() {\n    c_corner[gl_InvocationID] = v_corner[gl_InvocationID];\n"
           "    c_patch = v_vertex[0] / gl_PatchVerticesIn;\n    gl_TessLevelOuter[0] = gl_TessLevelInner[0] = "
           "3.0;\n}\n";
}
std::string evaluation(const std::string& layout, const std::string& defines = "") {
    return "#version 410 core\n" + defines + corner_struct + layout +
           "in Corner c_corner[];\npatch in int c_patch;\nout vec2 v_place;\n"
           "void main() { v_place = gl_TessCoord.xy + c_corner[1].uv; }\n";
}

/// Returns the number of the line with `word`, counted as a compiler does.
long line_of(const std::string& text, const std::string& word) {
    const std::string mark = "#line 2\n";
    const size_t marked = text.rfind(mark), begin = marked == text.npos ? 0 : marked + mark.size();
    const size_t at = text.find(word, begin);
    EXPECT_NE(at, text.npos) << word;
    return std::count(text.begin() + long(begin), text.begin() + long(at), '\n') + (begin == 0 ? 1 : 2);
}

TEST(PatchShader, EveryLineKeepsItsNumber) {
    const std::string before = control();
    const std::string after = patch_shader(before, PatchStage::control).text;
    for (const char* word : {"vec2 uv", "c_corner[", "v_vertex[0] /", "= 3.0"})
        EXPECT_EQ(line_of(after, word), line_of(before, word)) << word << "\n" << after;
    const std::string of_two_lines = evaluation("layout(quads,\n    equal_spacing, ccw) in;\n");
    EXPECT_EQ(line_of(patch_shader(of_two_lines, PatchStage::evaluation).text, "v_place = "),
              line_of(of_two_lines, "v_place = "));
}

TEST(PatchShader, AControlStageWritesItsCornerThePatchAndTheLevels) {
    const PatchShader stage = patch_shader(control(), PatchStage::control);
    EXPECT_EQ(stage.corners, 4);
    EXPECT_EQ(stage.read, (std::vector<PatchVariable>{{"Corner", "v_corner", false}, {"int", "v_vertex", false}}));
    EXPECT_EQ(stage.written, (std::vector<PatchVariable>{{"Corner", "c_corner", false}, {"int", "c_patch", true}}));
    EXPECT_EQ(stage.values, 5u);
    for (const char* line : {"v_corner[r_i].uv = vec2(r_value((r_number * r_corners + r_i) * 3 + 1).xy);",
                             "r_value_1 = vec4(c_corner[gl_VertexID % r_corners].uv, 0.0, 0.0);",
                             "r_value_2 = vec4(c_patch, 0.0, 0.0, 0.0);",
                             "r_value_3 = vec4(r_outer[0], r_outer[1], r_outer[2], r_outer[3]);",
                             "c_corner[r_invocation] = v_corner[r_invocation];", "r_outer[0] = r_inner[0] = 3.0;"})
        EXPECT_TRUE(contains(stage.text, line)) << line << "\n" << stage.text;
}

TEST(PatchShader, AnEvaluationStageReadsWhatTheControlStageWrites) {
    const PatchShader before = patch_shader(control(), PatchStage::control);
    const PatchShader stage =
        patch_shader(evaluation("layout(quads, fractional_odd_spacing, ccw) in;\n"), PatchStage::evaluation);
    EXPECT_EQ(stage.read, before.written);
    EXPECT_TRUE(contains(stage.text, "c_patch = int(r_value((r_number * r_corners + r_i) * " +
                                         std::to_string(before.values) + " + 2).x);"))
        << stage.text;
    EXPECT_TRUE(contains(stage.text, "v_place = r_point.xy"));
    EXPECT_TRUE(contains(stage.text, "\nout vec2 v_place;"));
}

TEST(PatchShader, TheLayoutMayBeMacros) {
    EXPECT_EQ(patch_shader(control("CORNERS", "#define CORNERS 3\n"), PatchStage::control).corners, 3);
    const std::string other = "const int vertices = 7;\nfloat quads = 9.0;\n";
    EXPECT_EQ(patch_shader(control() + other, PatchStage::control).corners, 4);
    const std::string both =
        "#if CORNERS == 4\nlayout(quads, SPACING, ccw) in;\n#else\nlayout(triangles, SPACING, ccw) in;\n#endif\n";
    for (const int corners : {3, 4}) {
        const PatchShader stage = patch_shader(evaluation(both, "#define CORNERS " + std::to_string(corners) +
                                                                    "\n#define SPACING fractional_even_spacing\n"),
                                               PatchStage::evaluation);
        EXPECT_EQ(stage.corners, corners);
        EXPECT_EQ(stage.spacing, TessellationSpacing::fractional_even);
    }
    EXPECT_EQ(patch_shader(evaluation("layout(triangles, equal_spacing, ccw) in;\n"), PatchStage::evaluation).corners,
              3);
}

TEST(PatchShader, AVertexStageWritesItsOutputs) {
    const PatchShader stage = patch_shader(
        "#version 410 core\nlayout(location = 0) in vec3 a_position;\nout vec3 v_position;\nflat out int v_vertex;\n"
        "void main() { v_position = a_position; v_vertex = gl_VertexID; }\n",
        PatchStage::vertex);
    EXPECT_EQ(stage.written, (std::vector<PatchVariable>{{"vec3", "v_position", false}, {"int", "v_vertex", false}}));
    EXPECT_TRUE(contains(stage.text, "layout(location = 0) in vec3 a_position;"));
    EXPECT_TRUE(contains(stage.text, "r_value_1 = vec4(v_vertex, 0.0, 0.0, 0.0);"));
}

TEST(PatchShader, WhatCannotBePassedIsNamed) {
    const std::string matrix = "#version 410 core\nout mat3 v_frame;\nvoid main() { v_frame = mat3(1.0); }\n";
    try {
        patch_shader(matrix, PatchStage::vertex);
        FAIL();
    } catch (const Error& error) {
        EXPECT_TRUE(contains(error.what(), "mat3: v_frame")) << error.what();
    }
    EXPECT_THROW(patch_shader(control("COUNT"), PatchStage::control), Error);
}

}  // namespace
}  // namespace relief::web
