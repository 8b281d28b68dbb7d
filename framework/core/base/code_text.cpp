#include "framework/core/base/code_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string_view>

#include "framework/core/base/text.h"

namespace relief {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_line_end(char c) { return c == '\n' || c == '\r'; }

/// Cuts a text into tokens. Reads it as a compiler does, without the line ends that a backslash joins.
class Lexer {
public:
    /// `line_begins`: whether a '#' at the start begins a preprocessor line.
    Lexer(const std::string& text, bool line_begins) : line_begins_(line_begins) {
        code_.reserve(text.size());
        for (size_t i = text.starts_with("\xef\xbb\xbf") ? 3 : 0; i < text.size(); ++i) {  // a byte order mark
            const size_t end = text[i] == '\\' ? i + 1 + (text.compare(i + 1, 1, "\r") == 0) : text.size();
            if (end < text.size() && text[end] == '\n') {
                i = end;
            } else {
                code_ += text[i];
                at_.push_back(i);
            }
        }
        at_.push_back(text.size());
    }

    std::vector<CodeToken> tokens() {
        for (size_t i = 0; i < code_.size();) i = step(i);
        return std::move(tokens_);
    }

private:
    bool here(size_t i, std::string_view text) const { return code_.compare(i, text.size(), text) == 0; }
    size_t end_of_line(size_t i) const { return std::min(code_.find_first_of("\r\n", i), code_.size()); }
    size_t end_of_comment(size_t i) const {
        const size_t end = code_.find("*/", i + 2);
        return end == std::string::npos ? code_.size() : end + 2;
    }
    /// A quoted text ends at its line's end at the latest.
    size_t end_of_literal(size_t i) const {
        const char quote = code_[i];
        for (++i; i < code_.size() && !is_line_end(code_[i]); ++i) {
            if (code_[i] == quote) return i + 1;
            if (code_[i] == '\\' && i + 1 < code_.size() && !is_line_end(code_[i + 1])) ++i;
        }
        return i;
    }
    size_t end_of_directive(size_t i) const {
        while (i < code_.size() && !is_line_end(code_[i])) {
            if (here(i, "//")) return end_of_line(i);
            if (here(i, "/*"))
                i = end_of_comment(i);
            else
                i = code_[i] == '"' || code_[i] == '\'' ? end_of_literal(i) : i + 1;
        }
        return i;
    }
    size_t end_of_word(size_t i) const {
        while (i < code_.size() && is_word_character(code_[i])) ++i;
        return i;
    }
    /// "1", "1.0e-3", ".5f", "0x1fu", "1'000".
    size_t end_of_number(size_t i) const {
        const bool is_hex = here(i, "0x") || here(i, "0X");
        const auto goes_on = [&](size_t k) { return k < code_.size() && is_word_character(code_[k]); };
        while (goes_on(i) || (i < code_.size() && (code_[i] == '.' || (code_[i] == '\'' && goes_on(i + 1))))) {
            const bool exponent = !is_hex && (code_[i] == 'e' || code_[i] == 'E') && i + 1 < code_.size();
            i += exponent && (code_[i + 1] == '-' || code_[i + 1] == '+') ? 2 : 1;
        }
        return i;
    }

    /// Reads white space or one token. Returns the place after it.
    size_t step(size_t i) {
        const char c = code_[i];
        if (here(i, "//")) return put(CodeToken::comment, i, end_of_line(i));
        if (here(i, "/*")) return put(CodeToken::comment, i, end_of_comment(i));
        if (c == '#' && line_begins_) return put(CodeToken::directive, i, end_of_directive(i));
        if (std::isspace(static_cast<unsigned char>(c))) {
            line_begins_ |= is_line_end(c);
            return i + 1;
        }
        line_begins_ = false;
        if (is_digit(c) || (c == '.' && i + 1 < code_.size() && is_digit(code_[i + 1])))
            return put(CodeToken::number, i, end_of_number(i));
        if (is_word_character(c)) return put(CodeToken::word, i, end_of_word(i));
        if (c == '"' || c == '\'') return put(CodeToken::literal, i, end_of_literal(i));
        return put(CodeToken::symbol, i, i + 1);
    }

    size_t put(CodeToken::Kind kind, size_t begin, size_t end) {
        tokens_.push_back(
            {kind, at_[begin], end > begin ? at_[end - 1] + 1 : at_[begin], code_.substr(begin, end - begin)});
        return end;
    }

    std::string code_;
    std::vector<size_t> at_;  ///< for each character its place in the text, and the text's end
    bool line_begins_;
    std::vector<CodeToken> tokens_;
};

/// Returns the index of the token that closes the bracket at `open`, or nothing if it is never closed.
std::optional<size_t> closing(const std::vector<CodeToken>& tokens, size_t open) {
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
int array_count(const std::vector<CodeToken>& tokens, size_t& i, size_t end) {
    if (i + 2 >= end || tokens[i].text != "[" || tokens[i + 2].text != "]") return 0;
    const auto count = parse_int(tokens[i + 1].text);
    i += 3;
    return count.value_or(0);
}

/// Parses `const in vec3 a[4]` in tokens [i, end).
std::optional<GlslVariable> parse_variable(const std::vector<CodeToken>& tokens, size_t i, size_t end) {
    GlslVariable variable{"in", "", "", 0};
    for (; i < end && is_qualifier(tokens[i].text); ++i)
        if (tokens[i].text == "out" || tokens[i].text == "inout") variable.qualifier = tokens[i].text;
    if (i >= end || tokens[i].kind != CodeToken::word) return {};
    variable.type = tokens[i++].text;
    variable.count = array_count(tokens, i, end);
    if (i >= end || tokens[i].kind != CodeToken::word) return {};
    variable.name = tokens[i++].text;
    if (i < end) variable.count = array_count(tokens, i, end);
    if (i != end) return {};
    return variable;
}

std::optional<std::vector<GlslVariable>> parse_parameters(const std::vector<CodeToken>& tokens, size_t open,
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
std::vector<GlslVariable> parse_fields(const std::vector<CodeToken>& tokens, size_t open, size_t close) {
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

bool is_word_character(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

std::vector<CodeToken> all_tokens(const std::string& text) { return Lexer(text, true).tokens(); }

std::vector<CodeToken> code_tokens(const std::string& text) {
    std::vector<CodeToken> tokens = all_tokens(text);
    std::erase_if(tokens, [](const CodeToken& token) { return !token.is_code(); });
    return tokens;
}

std::vector<CodeToken> tokens_of_directive(const CodeToken& directive) {
    std::vector<CodeToken> tokens = Lexer(directive.text, false).tokens();
    std::erase_if(tokens, [](const CodeToken& token) { return token.kind == CodeToken::comment; });
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
    const std::vector<CodeToken> tokens = code_tokens(text);
    for (size_t i = 0; i < tokens.size(); ++i) {
        const bool two_words = i >= 2 && tokens[i - 1].kind == CodeToken::word && tokens[i - 2].kind == CodeToken::word;
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
