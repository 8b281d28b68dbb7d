// The tessellator for browsers, compared with OpenGL's.
#include "framework/course/web/tessellator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "framework/core/gl/object.h"
#include "framework/core/gl/target.h"
#include "tests/support.h"

namespace relief::web {
namespace {

using Triangle = std::array<std::array<float, 3>, 3>;
constexpr std::array spacings = {TessellationSpacing::equal, TessellationSpacing::fractional_odd,
                                 TessellationSpacing::fractional_even};
constexpr std::array spacing_names = {"equal_spacing", "fractional_odd_spacing", "fractional_even_spacing"};

/// Returns the least of the three ways to begin with a corner. The order of the corners stays the same.
Triangle turned(const Triangle& triangle) {
    const auto& [a, b, c] = triangle;
    return std::min({triangle, Triangle{b, c, a}, Triangle{c, a, b}});
}

std::vector<Triangle> triangles_of(const Tessellation& tessellation) {
    std::vector<Triangle> triangles;
    for (const auto& corners : tessellation.triangles) {
        Triangle triangle;
        for (size_t c = 0; c < 3; ++c) {
            const glm::vec3& point = tessellation.points.at(corners[c]);
            triangle[c] = {point.x, point.y, point.z};
        }
        triangles.push_back(turned(triangle));
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

/// OpenGL's own tessellator, for one domain and spacing.
class Reference {
public:
    Reference(int corners, const std::string& spacing) {
        const std::string version = "#version 410 core\n", domain = corners == 4 ? "quads" : "triangles";
        add(GL_VERTEX_SHADER, version + "void main() { gl_Position = vec4(0.0); }\n");
        add(GL_TESS_CONTROL_SHADER,
            version +
                "layout(vertices = 1) out;\nuniform float u_outer[4], u_inner[2];\nvoid main() {\n"
                "    for (int i = 0; i < 4; ++i) gl_TessLevelOuter[i] = u_outer[i];\n"
                "    for (int i = 0; i < 2; ++i) gl_TessLevelInner[i] = u_inner[i];\n}\n");
        add(GL_TESS_EVALUATION_SHADER, version + "layout(" + domain + ", " + spacing +
                                           ", ccw) in;\nvoid main() { gl_Position = vec4(gl_TessCoord, 1.0); }\n");
        const char* const output = "gl_Position";
        glTransformFeedbackVaryings(program_, 1, &output, GL_INTERLEAVED_ATTRIBS);
        glLinkProgram(program_);
    }

    std::vector<Triangle> triangles(const TessellationLevels& levels) const {
        constexpr size_t most = 3 * 2 * 64 * 64 + 3;
        const BufferName buffer;
        const VertexArrayName none;
        const QueryName written;
        glBindFramebuffer(GL_FRAMEBUFFER, target_.framebuffer());  // a context may have none of its own
        glUseProgram(program_);
        glUniform1fv(glGetUniformLocation(program_, "u_outer"), 4, levels.outer.data());
        glUniform1fv(glGetUniformLocation(program_, "u_inner"), 2, levels.inner.data());
        glBindVertexArray(none);
        glPatchParameteri(GL_PATCH_VERTICES, 1);
        glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
        glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, most * sizeof(glm::vec4), nullptr, GL_STREAM_READ);
        glEnable(GL_RASTERIZER_DISCARD);
        glBeginQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, written);
        glBeginTransformFeedback(GL_TRIANGLES);
        glDrawArrays(GL_PATCHES, 0, 1);
        glEndTransformFeedback();
        glEndQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
        glDisable(GL_RASTERIZER_DISCARD);
        GLuint count = 0;
        glGetQueryObjectuiv(written, GL_QUERY_RESULT, &count);
        std::vector<glm::vec4> points(3 * count);
        glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, GLsizeiptr(points.size() * sizeof(glm::vec4)),
                           points.data());
        std::vector<Triangle> triangles;
        for (size_t i = 0; i < points.size(); i += 3) {
            Triangle triangle;
            for (size_t c = 0; c < 3; ++c) triangle[c] = {points[i + c].x, points[i + c].y, points[i + c].z};
            triangles.push_back(turned(triangle));
        }
        std::sort(triangles.begin(), triangles.end());
        return triangles;
    }

private:
    void add(GLenum stage, const std::string& text) {
        const ShaderName shader(stage);
        const char* const begin = text.c_str();
        glShaderSource(shader, 1, &begin, nullptr);
        glCompileShader(shader);
        glAttachShader(program_, shader);
    }

    ProgramName program_;
    Target target_{TargetKind::probe, {1, 1}};
};

std::vector<TessellationLevels> many_levels() {
    std::vector<TessellationLevels> all;
    const auto same = [&](float level) { all.push_back({{level, level, level, level}, {level, level}}); };
    for (int quarter = 1; quarter <= 4 * 66; quarter += tests_all() ? 1 : 7) same(float(quarter) / 4);
    for (const float level : {1e-30f, 0.999f, 1.0f, 1.000001f, 1.00001f, 1.0001f, 2.00001f, 2.9999f, 3.0001f, 62.99f,
                              63.01f, 63.99f, 64.0f, 64.01f, 1e30f, INFINITY})
        same(level);
    // Each level differs from the others.
    uint32_t state = 1;
    const auto random = [&](float highest) {
        state = state * 1664525u + 1013904223u;
        return 0.7f + (highest - 0.7f) * float(state >> 8) / float(1 << 24);
    };
    for (int i = 0; i < (tests_all() ? 400 : 80); ++i) {
        const float highest = i % 4 == 0 ? 66 : i % 4 == 1 ? 16 : i % 4 == 2 ? 4.5f : 1.6f;
        TessellationLevels levels;
        for (float& level : levels.outer) level = random(highest);
        for (float& level : levels.inner) level = random(highest);
        all.push_back(levels);
    }
    for (const float inner : {-1.0f, 0.0f, float(NAN), 1.0f, 2.0f, 3.0f, 64.0f})
        for (const float outer : {1.0f, 1.5f, 2.0f, 7.0f}) all.push_back({{outer, outer, outer, outer}, {inner, 5}});
    for (const float none : {0.0f, -1.0f, float(NAN), -INFINITY})  // drops the patch, if it has this edge
        for (size_t edge = 0; edge < 4; ++edge) all.push_back({{2, 2, 2, 2}, {2, 2}}), all.back().outer[edge] = none;
    return all;
}

std::string where(int corners, size_t spacing, const TessellationLevels& levels) {
    return std::to_string(corners) + " corners, " + spacing_names[spacing] + ", outer " +
           testing::PrintToString(levels.outer) + ", inner " + testing::PrintToString(levels.inner);
}

TEST(Tessellator, GivesTheSameTrianglesAsOpenGLs) {
    for (const int corners : {3, 4})
        for (size_t s = 0; s < spacings.size(); ++s) {
            const Reference reference(corners, spacing_names[s]);
            size_t triangles = 0;
            for (const TessellationLevels& levels : many_levels()) {
                const auto ours = triangles_of(tessellate(corners, spacings[s], levels));
                const auto theirs = reference.triangles(levels);
                ASSERT_EQ(ours.size(), theirs.size()) << where(corners, s, levels);
                const auto [some, others] = std::mismatch(ours.begin(), ours.end(), theirs.begin());
                ASSERT_EQ(some, ours.end()) << where(corners, s, levels) << ": " << testing::PrintToString(*some)
                                            << " instead of " << testing::PrintToString(*others);
                triangles += ours.size();
            }
            EXPECT_GT(triangles, 100000u);
        }
}

}  // namespace
}  // namespace relief::web
