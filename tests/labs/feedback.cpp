#include "tests/labs/feedback.h"

#include <cstring>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "framework/core/gl/object.h"

namespace relief {
namespace {

// Labs call GL through glad's function pointers. A test can therefore intercept calls without changes to the lab.
PFNGLLINKPROGRAMPROC link_program;
PFNGLDRAWARRAYSPROC draw_arrays;
GLuint captured;
constexpr size_t room = size_t(1) << 25;  // bytes of it
std::vector<glm::vec3>* captured_places;

void GLAD_API_PTR link_to_capture(GLuint program) {
    GLuint shaders[8];
    GLsizei count = 0;
    glGetAttachedShaders(program, 8, &count, shaders);
    for (GLsizei i = 0; i < count; ++i) {
        GLint stage = 0;
        glGetShaderiv(shaders[i], GL_SHADER_TYPE, &stage);
        const char* const name = "v_position";
        if (stage == GL_TESS_EVALUATION_SHADER) glTransformFeedbackVaryings(program, 1, &name, GL_INTERLEAVED_ATTRIBS);
    }
    link_program(program);
}

void GLAD_API_PTR draw_and_capture(GLenum mode, GLint first, GLsizei count) {
    if (mode != GL_PATCHES) return draw_arrays(mode, first, count);
    const QueryName written;
    glBindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, captured);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, captured);
    glBeginQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, written);
    glBeginTransformFeedback(GL_TRIANGLES);
    draw_arrays(mode, first, count);
    glEndTransformFeedback();
    glEndQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
    GLuint triangles = 0;
    glGetQueryObjectuiv(written, GL_QUERY_RESULT, &triangles);
    const size_t bytes = triangles * 3 * sizeof(glm::vec3);
    if (bytes > room - 3 * sizeof(glm::vec3)) throw std::length_error("more triangles than a capture has room for");
    const size_t before = captured_places->size();
    captured_places->resize(before + triangles * 3);
    glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, GLsizeiptr(bytes), captured_places->data() + before);
}

}  // namespace

std::vector<glm::vec3> triangles_of(Lab& lab, const Shot& shot) {
    const BufferName buffer;
    std::vector<glm::vec3> result;
    captured = buffer, captured_places = &result;
    glBindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, captured);
    glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, room, nullptr, GL_STREAM_READ);  // slow, so not for each draw
    link_program = std::exchange(glad_glLinkProgram, link_to_capture);
    draw_arrays = std::exchange(glad_glDrawArrays, draw_and_capture);
    const Target target(TargetKind::probe, shot.size);
    try {
        draw_lab(lab, frame_of(shot, target));
    } catch (...) {
        glad_glLinkProgram = link_program, glad_glDrawArrays = draw_arrays;
        throw;
    }
    glad_glLinkProgram = link_program, glad_glDrawArrays = draw_arrays;
    return result;
}

size_t open_edges(const std::vector<glm::vec3>& triangles) {
    struct Bits {
        size_t operator()(const glm::vec3& place) const {
            uint32_t bits[3];
            std::memcpy(bits, &place, sizeof bits);
            return (bits[0] * 73856093u) ^ (bits[1] * 19349663u) ^ (bits[2] * 83492791u);
        }
    };
    std::unordered_map<glm::vec3, uint32_t, Bits> numbers;
    std::unordered_map<uint64_t, int> passes;  // +1 for one direction, -1 for the other
    for (size_t i = 0; i < triangles.size(); i += 3) {
        uint64_t corner[3];
        for (size_t c = 0; c < 3; ++c)
            corner[c] = numbers.emplace(triangles[i + c] + 0.0f, uint32_t(numbers.size())).first->second;
        for (size_t c = 0; c < 3; ++c) {
            const uint64_t a = corner[c], b = corner[(c + 1) % 3];
            if (a != b) passes[std::min(a, b) << 32 | std::max(a, b)] += a < b ? 1 : -1;
        }
    }
    size_t open = 0;
    for (const auto& [edge, sum] : passes) open += size_t(std::abs(sum));
    return open;
}

}  // namespace relief
