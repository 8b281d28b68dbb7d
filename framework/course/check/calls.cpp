#include "framework/course/check/calls.h"

#include <fmt/format.h>

#include "framework/core/base/error.h"
#include "framework/core/base/paths.h"
#include "framework/core/kit/window_triangle.h"
#include "framework/core/lab/manifest.h"

namespace relief::check {
namespace {

namespace fs = std::filesystem;

/// Returns a fragment shader that writes the value of call x at column x.
std::string shader_of(const Calls& calls) {
    std::string text = "#version 410 core\n";
    for (const std::string& file : calls.includes) text += "#include \"" + file + "\"\n";
    text += "#include \"" + fs::path(calls.file).filename().string() + R"("

out vec4 o_value;

vec4 as_pixel(bool value) { return vec4(value, 0.0, 0.0, 0.0); }
vec4 as_pixel(int value) { return vec4(value, 0.0, 0.0, 0.0); }
vec4 as_pixel(float value) { return vec4(value, 0.0, 0.0, 0.0); }
vec4 as_pixel(vec2 value) { return vec4(value, 0.0, 0.0); }
vec4 as_pixel(vec3 value) { return vec4(value, 0.0); }
vec4 as_pixel(vec4 value) { return value; }

void main() {
    switch (int(gl_FragCoord.x)) {
)";
    for (size_t i = 0; i < calls.texts.size(); ++i)
        text += fmt::format("    case {}: o_value = as_pixel({}); break;\n", i, calls.texts[i]);
    return text + "    }\n    o_value = measured(o_value);\n}\n";
}

class CallsOfShader final : public Lab {
public:
    explicit CallsOfShader(Calls calls) : calls_(std::move(calls)) {}

    void draw(const Frame& frame) override {
        const fs::path stage = (course_root() / calls_.file).parent_path() / "calls.frag";
        const Program program({load_shader(course_root() / "shaders/common/window.vert", {}),
                               load_shader_text(shader_of(calls_), stage, {})});
        glUseProgram(program);
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glViewport(0, 0, frame.size.x, frame.size.y);
        triangle_.draw();
    }

private:
    WindowTriangle triangle_;
    Calls calls_;
};

class CallsOfProgram final : public Lab {
public:
    explicit CallsOfProgram(Calls calls) : calls_(std::move(calls)) {}

    void draw(const Frame& frame) override {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glEnable(GL_SCISSOR_TEST);
        for (size_t i = 0; i < calls_.texts.size(); ++i) {
            const std::optional<glm::dvec4> value = value_of_call(calls_.texts[i]);
            if (!value) throw Error("only the grader calls the functions of " + calls_.file);
            glScissor(GLint(i), 0, 1, frame.size.y);
            glClearColor(float(value->x), float(value->y), float(value->z), float(value->w));
            glClear(GL_COLOR_BUFFER_BIT);
        }
    }

private:
    Calls calls_;
};

}  // namespace

std::unique_ptr<Lab> make_drawer(const LabEntry& lab, const Shot& shot) {
    if (!shot.calls) return make_lab(lab, shot);
    if (is_shader(shot.calls.file)) return std::make_unique<CallsOfShader>(shot.calls);
    return std::make_unique<CallsOfProgram>(shot.calls);
}

}  // namespace relief::check
