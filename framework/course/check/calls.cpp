#include "framework/course/check/calls.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "framework/core/base/code_text.h"
#include "framework/core/base/error.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/core/gl/texture.h"
#include "framework/course/manifest/manifest.h"
#include "framework/library/kit/window_triangle.h"

namespace relief::check {
namespace {

namespace fs = std::filesystem;

/// Returns the height map `example_heights`, which calls may pass to a function: 8 x 4 texels in fifths, row 0 at v =
/// 0. It is sampled with nearest filtering, so that every renderer returns the same heights.
Texture example_heights() {
    static constexpr int fifths[4][8] = {
        {1, 1, 1, 3, 5, 3, 1, 1}, {0, 0, 0, 0, 0, 0, 0, 0}, {5, 5, 4, 3, 2, 1, 0, 0}, {0, 0, 1, 2, 3, 4, 4, 5}};
    Texture texture("example heights",
                    [] {
                        Image image(8, 4, 1);
                        for (int x = 0; x < 8; ++x)
                            for (int row = 0; row < 4; ++row)
                                image.values[size_t(8 * (3 - row) + x)] =
                                    float(fifths[row][x]) / 5;  // an image begins at the top
                        return image;
                    },
                    {.mips = false});
    bind(0, texture);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    return texture;
}

/// Distinct values of the literals in calls. A shader reads them as uniforms.
struct Literals {
    std::vector<float> numbers;
    std::vector<int> wholes;  ///< also bool, as 0 or 1, and the bits of uint
};

template <class Value>
size_t index_of(const Value& value, std::vector<Value>& all) {
    const auto found = std::find(all.begin(), all.end(), value);
    if (found != all.end()) return size_t(found - all.begin());
    all.push_back(value);
    return all.size() - 1;
}

/// Returns the expression that replaces a number or a bool, and adds its value to the literals.
std::string as_uniform(const std::string& literal, Literals& literals) {
    const auto whole = [&](int value) { return fmt::format("u_call_whole[{}]", index_of(value, literals.wholes)); };
    if (literal == "true" || literal == "false") return fmt::format("({} != 0)", whole(literal == "true" ? 1 : 0));
    const bool is_hexadecimal = literal.starts_with("0x") || literal.starts_with("0X");
    if (!is_hexadecimal && literal.find_first_of(".eEfF") != std::string::npos) {
        const size_t digits = std::min(literal.find_first_of("fF"), literal.size());
        const std::optional<double> value = parse_number(literal.substr(0, digits));
        return value ? fmt::format("u_call_number[{}]", index_of(float(*value), literals.numbers)) : literal;
    }
    const bool has_sign = !literal.ends_with('u') && !literal.ends_with('U');
    const auto value = int(uint32_t(std::strtoul(literal.c_str(), nullptr, 0)));
    return has_sign ? whole(value) : fmt::format("uint({})", whole(value));
}

/// Replaces the literals of a call by uniforms: a driver computes calls with constant arguments when it compiles them,
/// by other code. Mesa 22.3 does that wrongly for exp2(60.0 * log2(v)). Sizes of arrays and indices stay.
std::string with_uniforms(const std::string& call, Literals& literals) {
    std::string text;
    size_t taken = 0;
    const std::vector<CodeToken> tokens = code_tokens(call);
    for (size_t i = 0; i < tokens.size(); ++i) {
        const CodeToken& token = tokens[i];
        if (token.kind != CodeToken::number && token.text != "true" && token.text != "false") continue;
        if (i > 0 && i + 1 < tokens.size() && tokens[i - 1].text == "[" && tokens[i + 1].text == "]") continue;
        text += call.substr(taken, token.begin - taken) + as_uniform(token.text, literals);
        taken = token.end;
    }
    return text + call.substr(taken);
}

/// Returns a fragment shader that writes the value of call x at column x, and the literals in its uniforms.
std::string shader_of(const Calls& calls, Literals& literals) {
    std::string cases;
    for (size_t i = 0; i < calls.texts.size(); ++i)
        cases +=
            fmt::format("    case {}: o_value = as_pixel({}); break;\n", i, with_uniforms(calls.texts[i], literals));
    std::string text = "#version 410 core\n";
    for (const std::string& file : calls.includes) text += "#include \"" + file + "\"\n";
    text += "#include \"" + fs::path(calls.file).filename().string() + "\"\n";
    if (!literals.numbers.empty()) text += fmt::format("uniform float u_call_number[{}];\n", literals.numbers.size());
    if (!literals.wholes.empty()) text += fmt::format("uniform int u_call_whole[{}];\n", literals.wholes.size());
    text += R"(
uniform sampler2D example_heights;
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
    return text + cases + "    }\n    o_value = measured(o_value);\n}\n";
}

/// Returns a vertex shader for a triangle over the whole viewport. It has the includes, too: what the task's file can
/// read from a vertex stage must be written by one, also if no call reads it (GLSL ES 3.00, section 4.3.4).
std::string vertex_shader_of(const Calls& calls) {
    std::string text = "#version 410 core\n#define VERTEX_STAGE\n";
    for (const std::string& file : calls.includes) text += "#include \"" + file + "\"\n";
    return text +
           "void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); "
           "}\n";
}

class CallsOfShader final : public Lab {
public:
    explicit CallsOfShader(Calls calls) : calls_(std::move(calls)) {}

    void draw(const Frame& frame) override {
        const fs::path folder = (course_root() / calls_.file).parent_path();
        Literals literals;
        const std::string text = shader_of(calls_, literals);
        const Program program({load_shader_text(vertex_shader_of(calls_), folder / "calls.vert", {}),
                               load_shader_text(text, folder / "calls.frag", {})});
        glUseProgram(program);
        for (size_t i = 0; i < literals.numbers.size(); ++i)
            program.set(fmt::format("u_call_number[{}]", i).c_str(), literals.numbers[i]);
        for (size_t i = 0; i < literals.wholes.size(); ++i)
            program.set(fmt::format("u_call_whole[{}]", i).c_str(), literals.wholes[i]);
        const Texture heights = example_heights();  // at unit 0, which samplers read unless told otherwise
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glViewport(0, 0, frame.size.x, frame.size.y);
        triangle_.draw();
    }

private:
    WindowTriangle triangle_;
    Calls calls_;
};

std::vector<ProvidedCalls::Value*>& providers() {
    static std::vector<ProvidedCalls::Value*> all;
    return all;
}

class CallsOfProgram final : public Lab {
public:
    explicit CallsOfProgram(Calls calls) : calls_(std::move(calls)) {}

    void draw(const Frame& frame) override {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glEnable(GL_SCISSOR_TEST);
        for (size_t i = 0; i < calls_.texts.size(); ++i) {
            const std::optional<glm::dvec4> value = value_of_call(calls_.texts[i]);
            if (!value) throw Error(fmt::format("this program has no call '{}'", calls_.texts[i]));
            glScissor(GLint(i), 0, 1, frame.size.y);
            glClearColor(float(value->x), float(value->y), float(value->z), float(value->w));
            glClear(GL_COLOR_BUFFER_BIT);
        }
    }

private:
    Calls calls_;
};

}  // namespace

ProvidedCalls::ProvidedCalls(Value* value) { providers().push_back(value); }

std::optional<glm::dvec4> value_of_call(const std::string& call) {
    for (ProvidedCalls::Value* const value : providers())
        if (const auto found = value(call)) return found;
    return {};
}

std::unique_ptr<Lab> make_drawer(const LabEntry& lab, const Shot& shot) {
    if (!shot.calls) return make_lab(lab, shot);
    if (is_shader(shot.calls.file)) return std::make_unique<CallsOfShader>(shot.calls);
    return std::make_unique<CallsOfProgram>(shot.calls);
}

}  // namespace relief::check
