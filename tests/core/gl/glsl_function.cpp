#include "tests/core/gl/glsl_function.h"

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/gl/shader_source.h"
#include "framework/core/gl/target.h"
#include "tests/support.h"

namespace relief {
namespace {

constexpr const char* attribute_names = "abcdefgh";
constexpr const char* padding =
    "vec4 padded(vec4 v) { return v; }\n"
    "vec4 padded(vec3 v) { return vec4(v, 0.0); }\n"
    "vec4 padded(vec2 v) { return vec4(v, 0.0, 0.0); }\n"
    "vec4 padded(float v) { return vec4(v, 0.0, 0.0, 0.0); }\n"
    "vec4 padded(int v) { return padded(float(v)); }\n"
    "vec4 padded(bool v) { return padded(float(v)); }\n";

std::string with_mistake(std::string text, const PlantedMistake& mistake) {
    if (mistake.find.empty()) return text;
    const size_t at = text.find(mistake.find);
    if (at == std::string::npos || text.find(mistake.find, at + 1) != std::string::npos)
        throw Error("'" + mistake.find + "' is not there exactly once");
    return text.replace(at, mistake.find.size(), mistake.replace);
}

std::string stage_text(const std::string& file, const std::string& expression, const char* other) {
    std::string text = "#version 410 core\n#include \"" + file + "\"\nuniform sampler2D s_map;\nuniform " + other +
                       " s_other;\nout vec4 o_result;\n";
    for (int i = 0; i < 8; ++i)
        text += "layout(location = " + std::to_string(i) + ") in vec4 " + attribute_names[i] + ";\n";
    return text + padding + "void main() { o_result = padded(" + expression + "); }\n";
}

ProgramName link(const std::string& text, const std::vector<Place>& lines) {
    const ShaderName shader(GL_VERTEX_SHADER);
    const char* const source = text.c_str();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    ProgramName program;
    glAttachShader(program, shader);
    const char* const result = "o_result";
    glTransformFeedbackVaryings(program, 1, &result, GL_INTERLEAVED_ATTRIBS);
    glLinkProgram(program);
    GLint done = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &done);
    if (!done) {
        std::string log(4096, '\0');
        GLsizei length = 0;
        glGetShaderInfoLog(shader, GLsizei(log.size()), &length, log.data());
        const ShaderLog said = explain_log(log.substr(0, size_t(length)), lines, text);
        throw Error(said.first, said.first_message + "\n" + said.text);
    }
    return program;
}

}  // namespace

std::vector<glm::vec4> evaluate_glsl(const std::string& file, const std::string& expression,
                                     std::span<const GlslInput> inputs, const PlantedMistake& mistake,
                                     const Texture* map, const Texture* other) {
    const TemporaryFolder folder;
    const std::string name = std::filesystem::path(file).filename().string();
    folder.write(name, with_mistake(read_file(course_root() / "shaders" / file), mistake));
    const char* const sampler = other && other->target() == GL_TEXTURE_2D_ARRAY ? "sampler2DArray" : "sampler2D";
    const ShaderSource source = load_shader(folder.write("call.vert", stage_text(name, expression, sampler)), {});
    const ProgramName program = link(source.text, source.lines);
    glUseProgram(program);
    if (map) bind(0, *map);
    if (other) bind(1, *other);
    glUniform1i(glGetUniformLocation(program, "s_other"), 1);

    // A draw call needs a framebuffer even if nothing is rasterised. A context without a surface has no default one.
    const Target target(TargetKind::probe, {1, 1});
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
    const VertexArrayName layout;
    const BufferName arguments, results;
    glBindVertexArray(layout);
    glBindBuffer(GL_ARRAY_BUFFER, arguments);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(inputs.size_bytes()), inputs.data(), GL_STATIC_DRAW);
    for (GLuint i = 0; i < 8; ++i) {
        glEnableVertexAttribArray(i);
        glVertexAttribPointer(i, 4, GL_FLOAT, GL_FALSE, sizeof(GlslInput),
                              reinterpret_cast<const void*>(i * sizeof(glm::vec4)));
    }
    std::vector<glm::vec4> values(inputs.size());
    const auto bytes = GLsizeiptr(values.size() * sizeof(glm::vec4));
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, results);
    glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, bytes, nullptr, GL_STATIC_READ);
    glEnable(GL_RASTERIZER_DISCARD);
    glBeginTransformFeedback(GL_POINTS);
    glDrawArrays(GL_POINTS, 0, GLsizei(inputs.size()));
    glEndTransformFeedback();
    glDisable(GL_RASTERIZER_DISCARD);
    glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, bytes, values.data());
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    glBindVertexArray(0);
    glUseProgram(0);
    if (const std::string errors = take_gl_errors(); !errors.empty()) throw Error("OpenGL: " + errors);
    return values;
}

}  // namespace relief
