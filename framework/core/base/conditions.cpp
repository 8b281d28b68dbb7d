#include "framework/core/base/conditions.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "framework/core/base/text.h"

namespace relief {
namespace {

using Value = std::optional<int64_t>;

Value is_defined(const std::string& name, const Macros& macros) {
    const auto macro = macros.find(name);
    if (name.starts_with("GL_") || name.starts_with("__")) return {};
    if (macro != macros.end() && macro->second.empty()) return {};
    return macro != macros.end();
}

/// Appends the tokens with 1 or 0 in place of `defined NAME`, and with macros replaced. Names of unknown value stay.
/// Returns false for what is too long to be an #if of a shader, or has no end.
bool expand(std::span<const CodeToken> tokens, const Macros& macros, std::vector<CodeToken>& expanded, int depth = 0) {
    constexpr size_t most_tokens = 200;
    constexpr int most_depth = 16;
    if (depth > most_depth) return false;
    for (size_t i = 0; i < tokens.size(); ++i) {
        if (expanded.size() > most_tokens) return false;
        expanded.push_back(tokens[i]);
        if (tokens[i].text == "defined") {
            const bool has_brackets = i + 1 < tokens.size() && tokens[i + 1].text == "(";
            i += has_brackets ? 2 : 1;
            if (i + (has_brackets ? 1 : 0) >= tokens.size()) return false;
            if (const Value value = is_defined(tokens[i].text, macros))
                expanded.back() = {CodeToken::number, 0, 0, *value != 0 ? "1" : "0"};
            i += has_brackets ? 1 : 0;
        } else if (const auto macro = macros.find(tokens[i].text); macro != macros.end()) {
            // After '#', "define" and the name. An open bracket at the name is that of a macro with parameters.
            const auto& line = macro->second;
            if (line.size() < 4 || (line[3].text == "(" && line[3].begin == line[2].end)) continue;
            expanded.pop_back();
            if (!expand(std::span(line).subspan(3), macros, expanded, depth + 1)) return false;
        }
    }
    return true;
}

/// An expression of integers. Its value may be known although that of a part is not: `defined A && A == 2` is 0 without
/// an A.
class Expression {
public:
    explicit Expression(std::span<const CodeToken> tokens) : tokens_(tokens) {}

    Value value() {
        const Value whole = binary(0);
        return at_ == tokens_.size() ? whole : Value();
    }

private:
    using Operators = std::array<std::string_view, 4>;
    /// From the one that binds least. Of two with one beginning, the longer one comes first.
    static constexpr std::array<Operators, 7> operators = {
        {{"||"}, {"&&"}, {"|"}, {"&"}, {"==", "!="}, {"<=", ">=", "<", ">"}, {"+", "-"}}};

    static Value apply(std::string_view name, Value a, Value b) {
        if (name == "&&" && (a == 0 || b == 0)) return 0;
        if (name == "||" && (a.value_or(0) != 0 || b.value_or(0) != 0)) return 1;
        if (!a || !b) return {};
        if (name == "&&") return 1;
        if (name == "||") return 0;
        if (name == "|") return *a | *b;
        if (name == "&") return *a & *b;
        if (name == "==") return *a == *b;
        if (name == "!=") return *a != *b;
        if (name == "<=") return *a <= *b;
        if (name == ">=") return *a >= *b;
        if (name == "<") return *a < *b;
        if (name == ">") return *a > *b;
        return name == "+" ? *a + *b : *a - *b;
    }

    /// Each token of symbols is a single character.
    bool follows(std::string_view symbols) const {
        if (symbols.empty() || at_ + symbols.size() > tokens_.size()) return false;
        for (size_t i = 0; i < symbols.size(); ++i)
            if (tokens_[at_ + i].text != symbols.substr(i, 1)) return false;
        return true;
    }
    bool take(std::string_view symbols) {
        const bool is_here = follows(symbols);
        if (is_here) at_ += symbols.size();
        return is_here;
    }
    std::string_view take_operator(size_t precedence) {
        for (const std::string_view name : operators[precedence]) {
            const bool is_twice = name.size() == 1 && follows(std::string(2, name[0]));  // "||" is not "|" and "|"
            if (!is_twice && take(name)) return name;
        }
        return {};
    }

    Value binary(size_t precedence) {
        if (precedence == operators.size()) return unary();
        Value left = binary(precedence + 1);
        for (std::string_view name; !(name = take_operator(precedence)).empty();)
            left = apply(name, left, binary(precedence + 1));
        return left;
    }

    Value unary() {
        if (take("!")) return apply("==", 0, unary());
        if (take("-")) return apply("-", 0, unary());
        if (take("(")) {
            const Value inner = binary(0);
            return take(")") ? inner : Value();
        }
        if (at_ == tokens_.size()) return {};
        const std::string& number = tokens_[at_++].text;
        if (number.size() > 1 && number.starts_with('0')) return {};  // octal
        return parse_int(number);
    }

    std::span<const CodeToken> tokens_;
    size_t at_ = 0;
};

/// Returns whether the branch after an #if, #ifdef, #ifndef, #elif or #else is compiled if none before it was.
Value holds(const std::vector<CodeToken>& tokens, const Macros& macros) {
    const std::string& name = tokens[1].text;
    if (name == "else") return 1;
    if (tokens.size() < 3) return {};
    if (name == "ifdef") return is_defined(tokens[2].text, macros);
    if (name == "ifndef") {
        const Value defined = is_defined(tokens[2].text, macros);
        return defined ? Value(*defined == 0) : Value();
    }
    std::vector<CodeToken> expanded;
    if (!expand(std::span(tokens).subspan(2), macros, expanded)) return {};
    return Expression(expanded).value();
}

}  // namespace

void define(Macros& macros, const std::vector<CodeToken>& tokens) {
    if (tokens.size() < 3) return;
    if (tokens[1].text == "define") macros[tokens[2].text] = tokens;
    if (tokens[1].text == "undef") macros.erase(tokens[2].text);
}

std::optional<std::vector<std::pair<size_t, size_t>>> left_out(const std::vector<Directive>& lines, Macros macros) {
    enum Taken { none, perhaps, one };
    std::vector<Taken> taken;  // for each open #if outside of what is left out: of its branches so far
    bool is_out = false;       // the last of `ranges` goes on
    size_t inside = 0;         // open #if lines in it
    std::vector<std::pair<size_t, size_t>> ranges;
    for (const auto& [at, end, tokens] : lines) {
        const std::string name = tokens.size() < 2 ? "" : tokens[1].text;
        const bool opens = name.starts_with("if"), closes = name == "endif";
        if (is_out && (opens || inside > 0)) {
            inside += opens ? 1 : 0;
            inside -= closes ? 1 : 0;
        } else if (opens || closes || name == "else" || name == "elif") {
            if (opens) taken.push_back(none);
            if (taken.empty()) return {};
            if (is_out) ranges.back().second = at;
            is_out = false;
            if (closes) {
                taken.pop_back();
                continue;
            }
            const Value value = taken.back() == one ? 0 : holds(tokens, macros);
            is_out = value == 0;
            if (is_out)
                ranges.emplace_back(end, end);
            else
                taken.back() = value && taken.back() == none ? one : perhaps;
        } else if (!is_out) {
            const bool is_certain = std::find(taken.begin(), taken.end(), perhaps) == taken.end();
            if (is_certain)
                define(macros, tokens);
            else if ((name == "define" || name == "undef") && tokens.size() > 2)
                macros[tokens[2].text] = {};
        }
    }
    if (!taken.empty()) return {};
    return ranges;
}

}  // namespace relief
