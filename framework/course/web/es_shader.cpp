#include "framework/course/web/es_shader.h"

#include <algorithm>
#include <sstream>
#include <string_view>

#include "framework/core/base/code_text.h"

namespace relief::web {
namespace {

// ES has no default precision for these types in fragment stages. Whole numbers would have 16 bits.
constexpr const char* precisions =
    "precision highp float; precision highp int; precision highp sampler2D; precision highp isampler2D; "
    "precision highp usampler2D; precision highp sampler3D; precision highp samplerCube; "
    "precision highp sampler2DArray; precision highp sampler2DShadow;\n"
    "#define precise\n"
    "#define double float\n#define dvec2 vec2\n#define dvec3 vec3\n#define dvec4 vec4\n"
    "#define dmat2 mat2\n#define dmat3 mat3\n#define dmat4 mat4\n";

/// The end of a vertex stage whose own main() has another name.
constexpr const char* moving_main =
    "\n#undef main\nuniform vec2 relief_move;\n"
    "void main() {\n    relief_main();\n    gl_Position.xy += relief_move * gl_Position.w;\n}\n";

bool is_whole(const std::string& type) {
    return type == "int" || type == "uint" || type.starts_with("ivec") || type.starts_with("uvec");
}

/// An edit that keeps the number of lines: text to insert at `at`, after the removal of `removed` characters.
struct Change {
    size_t at, removed;
    std::string text;
};

std::string changed(const std::string& text, const std::vector<Change>& changes) {
    std::string result;
    size_t done = 0;
    for (const Change& change : changes) {
        result += text.substr(done, change.at - done) + change.text;
        done = change.at + change.removed;
    }
    return result + text.substr(done);
}

/// Blanks the lines of #extension. The first line is the version, which the caller replaces.
void blank_extensions(std::string& text) {
    for (size_t begin = 0; begin < text.size();) {
        const size_t end = std::min(text.find('\n', begin), text.size());
        const size_t hash = text.find_first_not_of(" \t", begin);
        if (hash < end && text[hash] == '#') {
            const size_t word = text.find_first_not_of(" \t", hash + 1);
            if (word < end && text.compare(word, 9, "extension") == 0) text.erase(begin, end - begin);
        }
        begin = std::min(text.find('\n', begin), text.size()) + 1;
    }
}

/// Returns the line ends in a part of a text.
std::string lines_of(const std::string& text, size_t begin, size_t end) {
    return std::string(
        size_t(std::count(text.begin() + std::ptrdiff_t(begin), text.begin() + std::ptrdiff_t(end), '\n')), '\n');
}

/// Returns the changes that remove the suffix of numbers in double precision.
std::vector<Change> changed_numbers(const std::vector<CodeToken>& tokens) {
    std::vector<Change> changes;
    for (const CodeToken& token : tokens)
        if (token.kind == CodeToken::number && (token.text.ends_with("lf") || token.text.ends_with("LF")))
            changes.push_back({token.end - 2, 2, ""});
    return changes;
}

/// Returns the changes of declarations outside of functions.
std::vector<Change> changed_declarations(const std::string& text, const std::vector<CodeToken>& tokens, EsStage stage) {
    std::vector<Change> changes;
    int depth = 0;
    for (size_t first = 0, i = 0; i < tokens.size(); ++i) {
        const std::string& token = tokens[i].text;
        depth += (token == "{") - (token == "}");
        if (depth != 0 || (token != ";" && token != "}")) continue;
        const auto begin = tokens.begin() + std::ptrdiff_t(first), end = tokens.begin() + std::ptrdiff_t(i);
        const auto has = [&](std::string_view word) {
            return std::any_of(begin, end, [&](const CodeToken& each) { return each.text == word; });
        };
        first = i + 1;
        if (token == "}" || begin == end) continue;
        if (has("gl_FragDepth"))
            changes.push_back(
                {begin->begin, tokens[i].end - begin->begin, lines_of(text, begin->begin, tokens[i].end)});
        else if (stage == EsStage::vertex && begin->text == "out" && begin + 1 != end && is_whole(begin[1].text))
            changes.push_back({begin->begin, 0, "flat "});
    }
    return changes;
}

}  // namespace

const std::vector<MissingFunction>& missing_functions() {
    static const std::vector<MissingFunction> functions = {
        {"textureGather",
         "vec4 textureGather(sampler2D image, vec2 uv, int channel) {\n"
         "    vec2 size = vec2(textureSize(image, 0)), cell = floor(uv * size - 0.5);\n"
         "    ivec2 low = ivec2(cell - size * floor((cell + 0.5) / size)), high = (low + 1) % ivec2(size);\n"
         "    return vec4(texelFetch(image, ivec2(low.x, high.y), 0)[channel], texelFetch(image, high, 0)[channel],\n"
         "                texelFetch(image, ivec2(high.x, low.y), 0)[channel], texelFetch(image, low, 0)[channel]);\n"
         "}\n"
         "vec4 textureGather(sampler2D image, vec2 uv) { return textureGather(image, uv, 0); }\n",
         false},
        {"textureQueryLod",
         "vec2 textureQueryLod(sampler2D image, vec2 uv) {\n"
         "    vec2 texels = uv * vec2(textureSize(image, 0)), across = dFdx(texels), down = dFdy(texels);\n"
         "    vec2 odd = mod(floor(gl_FragCoord.xy), 2.0);\n"
         "    across -= odd.y * dFdy(across), down -= odd.x * dFdx(down);\n"
         "    float squared = max(max(dot(across, across), dot(down, down)), 1e-30), power = floor(log2(squared));\n"
         "    float level = 0.5 * (power + squared * exp2(-power) - 1.0);\n"
         "    return vec2(max(level, 0.0), level);\n"
         "}\n",
         true},
        {"findMSB",
         "int findMSB(uint bits) {\n"
         "    int found = -1;\n"
         "    for (int i = 0; i < 32; ++i)\n"
         "        if ((bits >> uint(i) & 1u) != 0u) found = i;\n"
         "    return found;\n"
         "}\n"
         "int findMSB(int number) { return findMSB(uint(number < 0 ? ~number : number)); }\n",
         false},
        {"fma",
         "float fma(float a, float b, float c) { return a * b + c; }\n"
         "vec2 fma(vec2 a, vec2 b, vec2 c) { return a * b + c; }\n"
         "vec3 fma(vec3 a, vec3 b, vec3 c) { return a * b + c; }\n"
         "vec4 fma(vec4 a, vec4 b, vec4 c) { return a * b + c; }\n",
         false},
        {"bitCount",
         "int bitCount(uint bits) {\n"
         "    int found = 0;\n"
         "    for (int i = 0; i < 32; ++i) found += int(bits >> uint(i) & 1u);\n"
         "    return found;\n"
         "}\n"
         "int bitCount(int number) { return bitCount(uint(number)); }\n",
         false},
    };
    return functions;
}

std::string es_shader(const std::string& text, EsStage stage) {
    const std::vector<CodeToken> tokens = code_tokens(text);
    std::vector<Change> changes = changed_declarations(text, tokens, stage), numbers = changed_numbers(tokens);
    changes.insert(changes.end(), numbers.begin(), numbers.end());
    std::sort(changes.begin(), changes.end(), [](const Change& a, const Change& b) { return a.at < b.at; });
    std::string body = changed(text, changes);
    blank_extensions(body);
    body.erase(0, std::min(body.find('\n'), body.size() - 1) + 1);  // the version
    std::string head = std::string("#version 300 es\n") + precisions;
    for (const MissingFunction& function : missing_functions()) {
        const auto is_call = [&](const CodeToken& token) { return token.text == function.name; };
        if ((stage == EsStage::fragment || !function.in_fragments_only) &&
            std::any_of(tokens.begin(), tokens.end(), is_call))
            head += function.text;
    }
    const auto is_main = [](const CodeToken& token) { return token.text == "main"; };
    if (stage == EsStage::vertex && std::any_of(tokens.begin(), tokens.end(), is_main)) {
        head += "#define main relief_main\n";
        body += moving_main;
    }
    return head + "#line 2\n" + body;
}

std::string es_log(const std::string& log) {
    std::istringstream lines(log);
    std::string result;
    for (std::string line; std::getline(lines, line);) {
        const auto says = [&](std::string_view part) { return line.find(part) != line.npos; };
        const bool is_about_types = says("wrong operand types") || says("cannot convert from") ||
                                    says("no matching overloaded function") || says("dimension mismatch");
        result += line;
        if (is_about_types && says("int")) result += " (in a browser, write 2.0 instead of 2 where a float is wanted)";
        if (!lines.eof()) result += '\n';
    }
    return result;
}

}  // namespace relief::web
