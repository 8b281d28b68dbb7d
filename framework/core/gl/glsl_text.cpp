#include "framework/core/gl/glsl_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string_view>

#include "framework/core/base/text.h"

namespace relief {
namespace {

bool is_word_character(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Returns the offset after a number that starts at `i`: "1", "1.0e-3", ".5f", "0x1fu".
size_t end_of_number(const std::string& text, size_t i) {
    while (i < text.size() && (is_word_character(text[i]) || text[i] == '.')) {
        const bool exponent = (text[i] == 'e' || text[i] == 'E') && i + 1 < text.size();
        i += exponent && (text[i + 1] == '-' || text[i + 1] == '+') ? 2 : 1;
    }
    return i;
}

/// Returns the offset after a preprocessor line, including continuation lines.
size_t end_of_directive(const std::string& text, size_t i) {
    for (; i < text.size() && text[i] != '\n'; ++i)
        if (text[i] == '\\') ++i;
    return std::min(i, text.size());
}

/// Returns the index of the token that closes the bracket at `open`, or nothing if it is never closed.
std::optional<size_t> closing(const std::vector<GlslToken>& tokens, size_t open) {
    const std::string& opens = tokens[open].text;
    const std::string closes = opens == "(" ? ")" : opens == "[" ? "]" : "}";
    int depth = 0;
    for (size_t i = open; i < tokens.size(); ++i) {
        if (tokens[i].text == opens) ++depth;
        if (tokens[i].text == closes && --depth == 0) return i;
    }
    return {};
}

bool is_qualifier(const std::string& word) {
    constexpr std::array<std::string_view, 8> words = {"const",   "in",    "out",     "inout",
                                                       "precise", "highp", "mediump", "lowp"};
    return std::find(words.begin(), words.end(), word) != words.end();
}

/// Parses an array size such as `[9]` at token i and moves i past it. Returns 0 if there is none.
int array_count(const std::vector<GlslToken>& tokens, size_t& i, size_t end) {
    if (i + 2 >= end || tokens[i].text != "[" || tokens[i + 2].text != "]") return 0;
    const auto count = parse_int(tokens[i + 1].text);
    i += 3;
    return count.value_or(0);
}

/// Parses `const in vec3 a[4]` in tokens [i, end).
std::optional<GlslVariable> parse_variable(const std::vector<GlslToken>& tokens, size_t i, size_t end) {
    GlslVariable variable{"in", "", "", 0};
    for (; i < end && is_qualifier(tokens[i].text); ++i)
        if (tokens[i].text == "out" || tokens[i].text == "inout") variable.qualifier = tokens[i].text;
    if (i >= end || tokens[i].kind != GlslToken::word) return {};
    variable.type = tokens[i++].text;
    variable.count = array_count(tokens, i, end);
    if (i >= end || tokens[i].kind != GlslToken::word) return {};
    variable.name = tokens[i++].text;
    if (i < end) variable.count = array_count(tokens, i, end);
    if (i != end) return {};
    return variable;
}

std::optional<std::vector<GlslVariable>> parse_parameters(const std::vector<GlslToken>& tokens, size_t open,
                                                          size_t close) {
    std::vector<GlslVariable> parameters;
    if (close == open + 1 || (close == open + 2 && tokens[open + 1].text == "void")) return parameters;
    for (size_t begin = open + 1; begin <= close; ++begin) {
        size_t end = begin;
        while (end < close && tokens[end].text != ",") ++end;
        auto parameter = parse_variable(tokens, begin, end);
        if (!parameter) return {};
        parameters.push_back(*std::move(parameter));
        begin = end;
    }
    return parameters;
}

/// Parses declarations such as `vec2 start, along;`.
std::vector<GlslVariable> parse_fields(const std::vector<GlslToken>& tokens, size_t open, size_t close) {
    std::vector<GlslVariable> fields;
    for (size_t i = open + 1; i < close; ++i) {
        while (i < close && is_qualifier(tokens[i].text)) ++i;
        const std::string type = tokens[i++].text;
        for (; i < close && tokens[i].text != ";";) {
            GlslVariable field{"in", type, tokens[i++].text, 0};
            field.count = array_count(tokens, i, close);
            fields.push_back(std::move(field));
            if (i < close && tokens[i].text == ",") ++i;
        }
    }
    return fields;
}

}  // namespace

std::vector<GlslToken> glsl_tokens(const std::string& text) {
    std::vector<GlslToken> tokens;
    const auto put = [&](GlslToken::Kind kind, size_t begin, size_t end) {
        tokens.push_back({kind, begin, end, text.substr(begin, end - begin)});
        return end;
    };
    bool line_begins = true;
    for (size_t i = 0; i < text.size();) {
        const char c = text[i];
        if (text.compare(i, 2, "//") == 0) {
            i = std::min(text.find('\n', i), text.size());
        } else if (text.compare(i, 2, "/*") == 0) {
            const size_t end = text.find("*/", i + 2);
            i = end == std::string::npos ? text.size() : end + 2;
        } else if (c == '#' && line_begins) {
            i = end_of_directive(text, i);
        } else if (std::isspace(static_cast<unsigned char>(c))) {
            line_begins |= c == '\n';
            ++i;
        } else {
            line_begins = false;
            if (is_digit(c) || (c == '.' && i + 1 < text.size() && is_digit(text[i + 1]))) {
                i = put(GlslToken::number, i, end_of_number(text, i));
            } else if (is_word_character(c)) {
                size_t end = i;
                while (end < text.size() && is_word_character(text[end])) ++end;
                i = put(GlslToken::word, i, end);
            } else {
                i = put(GlslToken::symbol, i, i + 1);
            }
        }
    }
    return tokens;
}

std::string GlslFunction::signature() const {
    std::vector<std::string> types;
    for (const GlslVariable& parameter : parameters)
        types.push_back(parameter.type + (parameter.count > 0 ? "[" + std::to_string(parameter.count) + "]" : ""));
    return name + "(" + join(types, ",") + ")";
}

bool GlslFunction::has_result_only() const {
    return type != "void" && std::all_of(parameters.begin(), parameters.end(),
                                         [](const GlslVariable& parameter) { return parameter.qualifier == "in"; });
}

GlslText parse_glsl(const std::string& text) {
    GlslText result;
    const std::vector<GlslToken> tokens = glsl_tokens(text);
    for (size_t i = 0; i < tokens.size(); ++i) {
        const bool two_words = i >= 2 && tokens[i - 1].kind == GlslToken::word && tokens[i - 2].kind == GlslToken::word;
        if (tokens[i].text == "struct" && i + 2 < tokens.size() && tokens[i + 2].text == "{") {
            const auto close = closing(tokens, i + 2);
            if (!close || *close + 1 >= tokens.size()) break;
            result.structs.push_back(
                {tokens[i + 1].text, parse_fields(tokens, i + 2, *close), tokens[i].begin, tokens[*close + 1].end});
            i = *close + 1;
        } else if (tokens[i].text == "(") {
            const auto close = closing(tokens, i);
            if (!close) break;
            const bool defines = two_words && *close + 1 < tokens.size() && tokens[*close + 1].text == "{";
            const auto parameters = parse_parameters(tokens, i, *close);
            if (defines && parameters) {
                const auto end = closing(tokens, *close + 1);
                if (!end) break;
                size_t first = i - 2;
                while (first > 0 && is_qualifier(tokens[first - 1].text)) --first;
                result.functions.push_back({tokens[i - 2].text, tokens[i - 1].text, *parameters, tokens[first].begin,
                                            tokens[i - 1].begin, tokens[*end].end});
                i = *end;
            } else {
                i = *close;
            }
        } else if (tokens[i].text == "{") {  // a uniform block or an initialiser
            const auto close = closing(tokens, i);
            if (!close) break;
            i = *close;
        }
    }
    return result;
}

}  // namespace relief
