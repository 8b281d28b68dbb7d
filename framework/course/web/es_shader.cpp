#include "framework/course/web/es_shader.h"

#include <algorithm>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

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

/// Returns the line ends of a text.
std::string line_ends(std::string_view text) {
    return std::string(size_t(std::count(text.begin(), text.end(), '\n')), '\n');
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
            changes.push_back({begin->begin, tokens[i].end - begin->begin,
                               line_ends(text.substr(begin->begin, tokens[i].end - begin->begin))});
        else if (stage == EsStage::vertex && begin->text == "out" && begin + 1 != end && is_whole(begin[1].text))
            changes.push_back({begin->begin, 0, "flat "});
    }
    return changes;
}

/// Finds the loops of a text that may not end.
class LoopReader {
public:
    explicit LoopReader(const std::vector<CodeToken>& tokens) : tokens_(tokens) {}

    /// Returns the changes that let each loop in a half-open range of the text go on only while rounds are left.
    std::vector<Change> changes(size_t from, size_t to) const {
        std::vector<Change> changes;
        for (size_t i = 0; i < tokens_.size(); ++i) {
            const bool is_for = is(i, "for");
            if (tokens_[i].begin < from || tokens_[i].begin >= to) continue;
            if ((!is_for && !is(i, "while")) || !is(i + 1, "(")) continue;
            const size_t close = closing(i + 1), begin = is_for ? next(i + 2, ";") + 1 : i + 2;
            const size_t end = is_for ? next(begin, ";") : close;
            if (close >= tokens_.size() || end > close || (is_for && counts(i, end, close))) continue;
            const bool declares = is_word(begin) && is_word(begin + 1);
            if (begin == end && is_for)
                changes.push_back({tokens_[end].begin, 0, "relief_goes_on()"});
            else if (begin != end && !declares)
                changes.insert(changes.end(),
                               {{tokens_[begin].begin, 0, "relief_goes_on() && ("}, {tokens_[end].begin, 0, ")"}});
        }
        return changes;
    }

private:
    bool is(size_t i, std::string_view text) const { return i < tokens_.size() && tokens_[i].text == text; }
    bool is_word(size_t i) const { return i < tokens_.size() && tokens_[i].kind == CodeToken::word; }
    bool is_number(size_t i) const { return i < tokens_.size() && tokens_[i].kind == CodeToken::number; }
    size_t next(size_t from, std::string_view text) const {
        while (from < tokens_.size() && !is(from, text)) ++from;
        return from;
    }
    /// Returns the index of the bracket that closes the one at `open`, or the number of tokens.
    size_t closing(size_t open) const {
        const std::string_view opens = tokens_[open].text, closes = opens == "(" ? ")" : "}";
        int depth = 0;
        for (size_t i = open; i < tokens_.size(); ++i) {
            depth += int(is(i, opens)) - int(is(i, closes));
            if (depth == 0) return i;
        }
        return tokens_.size();
    }

    /// Returns whether a loop counts from a number to a constant: `for (int i = 0; i < 8; ++i)`. Only a body that
    /// assigns to the counter keeps it from ending.
    bool counts(size_t loop, size_t second, size_t close) const {
        const size_t name = loop + 3, first = name + 3;
        if (!is(name + 1, "=") || !is_number(name + 2) || !is(first, ";") || second + 4 != close) return false;
        const std::string& counter = tokens_[name].text;
        const size_t bound = second - 1;
        const bool is_below = is(first + 1, counter) && is(first + 2, "<") &&
                              (bound == first + 3 || (bound == first + 4 && is(first + 3, "=")));
        const bool steps = is(second + 1, "+") ? is(second + 2, "+") && is(second + 3, counter)
                                               : is(second + 1, counter) && is(second + 2, "+") && is(second + 3, "+");
        return is_below && steps && is_constant(bound) && !assigns(counter, close + 1, end_of_statement(close + 1));
    }
    /// Returns whether a token is a number below most_rounds, or the name of a constant that is not a larger number.
    bool is_constant(size_t i) const {
        if (is_number(i)) return tokens_[i].text.size() < std::to_string(most_rounds).size();
        for (size_t k = 0; k + 4 < tokens_.size(); ++k)
            if (is(k, "const") && is(k + 2, tokens_[i].text))
                return !is_number(k + 4) || !is(k + 5, ";") || is_constant(k + 4);
        return false;
    }
    size_t end_of_statement(size_t i) const {
        for (; i < tokens_.size() && !is(i, ";"); ++i) {
            if (is(i, "{")) return closing(i);
            if (is(i, "(")) i = closing(i);
        }
        return i;
    }
    bool assigns(const std::string& counter, size_t i, size_t end) const {
        const auto is_one_of = [&](size_t at, std::string_view symbols) {
            return at < tokens_.size() && tokens_[at].text.size() == 1 &&
                   symbols.find(tokens_[at].text) != symbols.npos;
        };
        for (; i < end; ++i) {
            if (!is(i, counter)) continue;
            if (is(i + 1, "=") && !is(i + 2, "=")) return true;
            if (is_one_of(i + 1, "+-*/%&|^") &&
                (is(i + 2, "=") || (is(i + 2, tokens_[i + 1].text) && is_one_of(i + 1, "+-"))))
                return true;
            if (is_one_of(i - 1, "+-") && is(i - 2, tokens_[i - 1].text)) return true;
        }
        return false;
    }

    const std::vector<CodeToken>& tokens_;
};

/// Returns the change that limits the loops of a macro, in place of its #define line; nothing if it has no loops.
std::optional<Change> limited_macro(const std::string& text, const CodeToken& line) {
    const std::vector<CodeToken> tokens = tokens_of_directive(line);
    const std::vector<Change> loops = LoopReader(tokens).changes(0, line.text.size());
    if (loops.empty()) return {};
    std::string limited = changed(line.text, loops);
    const std::string ends = line_ends(text.substr(line.begin, line.end - line.begin));
    limited += ends.substr(line_ends(limited).size());  // lines that a backslash joined
    return Change{line.begin, line.end - line.begin, limited};
}

/// Returns the changes of the loops of a task file. Its lines after the last #include stand in the text as they are;
/// if they do not, all loops count.
std::vector<Change> limited_loops(const std::string& text, const std::vector<CodeToken>& tokens,
                                  const std::vector<CodeToken>& directives, const std::string& task) {
    if (task.empty()) return {};
    const size_t last = task.rfind("#include"),
                 own = last == task.npos ? 0 : std::min(task.find('\n', last), task.size());
    const size_t at = text.find(task.substr(own));
    const size_t begin = at == text.npos ? 0 : at, end = at == text.npos ? text.size() : at + task.size() - own;
    std::vector<Change> changes = LoopReader(tokens).changes(begin, end);
    for (const CodeToken& line : directives)
        if (line.begin >= begin && line.begin < end)
            if (const auto macro = limited_macro(text, line)) changes.push_back(*macro);
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

std::string es_shader(const std::string& text, EsStage stage, const std::string& task) {
    std::vector<CodeToken> tokens, directives;
    for (CodeToken& token : all_tokens(text))
        if (token.kind == CodeToken::directive)
            directives.push_back(std::move(token));
        else if (token.is_code())
            tokens.push_back(std::move(token));
    std::vector<Change> changes = changed_declarations(text, tokens, stage);
    const std::vector<Change> numbers = changed_numbers(tokens), loops = limited_loops(text, tokens, directives, task);
    changes.insert(changes.end(), numbers.begin(), numbers.end());
    changes.insert(changes.end(), loops.begin(), loops.end());
    std::stable_sort(changes.begin(), changes.end(), [](const Change& a, const Change& b) { return a.at < b.at; });
    std::string body = changed(text, changes);
    blank_extensions(body);
    body.erase(0, std::min(body.find('\n'), body.size() - 1) + 1);  // the version
    std::string head = std::string("#version 300 es\n") + precisions;
    if (!loops.empty())
        head += "int relief_rounds = 0;\nbool relief_goes_on() { return ++relief_rounds < " +
                std::to_string(most_rounds) + "; }\n";
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
