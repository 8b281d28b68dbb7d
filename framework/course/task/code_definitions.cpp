#include "framework/course/task/code_definitions.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "framework/core/base/text.h"

namespace relief {
namespace {

template <size_t count>
bool is_one_of(const std::string& word, const std::array<std::string_view, count>& words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

constexpr std::array<std::string_view, 4> type_words = {"struct", "class", "enum", "union"};
constexpr std::array<std::string_view, 14> statement_words = {"return", "if",      "else",    "for",   "while",
                                                              "do",     "switch",  "case",    "break", "continue",
                                                              "goto",   "discard", "default", "throw"};
constexpr std::array<std::string_view, 9> parameter_words = {"const", "in",      "out",  "inout",   "precise",
                                                             "highp", "mediump", "lowp", "volatile"};

bool opens(const CodeToken& token) { return token.text == "(" || token.text == "[" || token.text == "{"; }
bool closes(const CodeToken& token) { return token.text == ")" || token.text == "]" || token.text == "}"; }

/// Joins tokens as a person writes a type: "const std::array<double, 16>&".
std::string joined_tokens(const std::vector<CodeToken>& tokens) {
    std::string text;
    for (size_t i = 0; i < tokens.size(); ++i) {
        const auto is_name = [](const CodeToken& token) { return is_word_character(token.text[0]); };
        const bool blank = i > 0 && ((is_name(tokens[i]) && is_name(tokens[i - 1])) || tokens[i - 1].text == ",");
        text += (blank ? " " : "") + tokens[i].text;
    }
    return text;
}

/// Returns a parameter's type: "float[9]" for `in float h[9]`.
std::string type_of_parameter(std::vector<CodeToken> tokens) {
    const auto assigned =
        std::find_if(tokens.begin(), tokens.end(), [](const CodeToken& token) { return token.text == "="; });
    tokens.erase(assigned, tokens.end());
    std::vector<CodeToken> array;
    const auto bracket =
        std::find_if(tokens.begin(), tokens.end(), [](const CodeToken& token) { return token.text == "["; });
    array.assign(bracket, tokens.end());
    tokens.erase(bracket, tokens.end());
    if (!array.empty() && array.back().kind == CodeToken::word) array.pop_back();  // float[9] h
    const auto is_qualifier = [](const CodeToken& token) {
        return is_one_of(token.text, parameter_words) && token.text != "const";
    };
    std::erase_if(tokens, is_qualifier);
    const auto words = std::count_if(tokens.begin(), tokens.end(), [](const CodeToken& token) {
        return token.kind == CodeToken::word && token.text != "const";
    });
    const bool has_name = tokens.size() > 1 && tokens.back().kind == CodeToken::word && words > 1 &&
                          tokens[tokens.size() - 2].text != ":" && tokens.back().text != "const";
    if (has_name) tokens.pop_back();
    return joined_tokens(tokens) + joined_tokens(array);
}

/// Reads the signature whose name is at tokens[open - 1], and whose parentheses are at `open` and `close`.
CodeSignature signature_at(const std::vector<CodeToken>& tokens, size_t open, size_t close) {
    CodeSignature signature{tokens[open - 1].text, {}};
    std::vector<CodeToken> parameter;
    int depth = 0;
    const auto finish = [&] {
        const bool is_void = parameter.size() == 1 && parameter[0].text == "void";
        if (!parameter.empty() && !is_void) signature.types.push_back(type_of_parameter(std::move(parameter)));
        parameter.clear();
    };
    for (size_t i = open + 1; i < close; ++i) {
        depth += opens(tokens[i]) || tokens[i].text == "<";
        depth -= closes(tokens[i]) || tokens[i].text == ">";
        if (tokens[i].text == "," && depth == 0)
            finish();
        else
            parameter.push_back(tokens[i]);
    }
    finish();
    return signature;
}

/// A type without qualifiers, namespaces, references and the size of an array.
struct PlainType {
    std::string name;
    bool is_array = false;
    bool operator==(const PlainType&) const = default;
};

PlainType plain_type(const std::string& text) {
    PlainType type;
    for (const CodeToken& token : code_tokens(text)) {
        if (token.text == "[") {
            type.is_array = true;
            break;
        }
        if (token.text == ":")
            type.name.clear();
        else if (token.text != "const" && token.text != "&")
            type.name += token.text;
    }
    return type;
}

/// Returns whether it is a type of the language GLSL, of which no other name exists.
bool is_built_in_type(const std::string& name) {
    static const std::set<std::string> types = [] {
        std::set<std::string> all = {"float",     "double",         "int",         "uint",           "bool",
                                     "sampler2D", "sampler2DArray", "samplerCube", "sampler2DShadow"};
        for (const char* const letter : {"", "d", "i", "u", "b"})
            for (const char* const size : {"2", "3", "4"}) all.insert(std::string(letter) + "vec" + size);
        for (const char* const columns : {"2", "3", "4"}) {
            all.insert(std::string("mat") + columns);
            for (const char* const rows : {"2", "3", "4"}) all.insert(std::string("mat") + columns + "x" + rows);
        }
        return all;
    }();
    return types.contains(name);
}

/// The preprocessor's conditions around a place.
class Conditions {
public:
    /// Reads a preprocessor line. Returns false if it is no condition.
    bool read(const CodeToken& directive) {
        const std::vector<CodeToken> words = tokens_of_directive(directive);
        const std::string word = words.size() > 1 ? words[1].text : "";
        if (word == "if" || word == "ifdef" || word == "ifndef") {
            const std::string value = word == "if" && words.size() == 3 ? words[2].text : "";
            frames_.push_back({directive.text, value == "0", value == "1"});
        } else if (word == "else" || word == "elif") {
            if (frames_.empty()) return true;
            Frame& frame = frames_.back();
            frame.text += '\n' + directive.text;
            frame.is_dead = frame.was_taken;
        } else if (word == "endif") {
            if (!frames_.empty()) frames_.pop_back();
        } else {
            return false;
        }
        return true;
    }
    bool is_dead() const {
        return std::any_of(frames_.begin(), frames_.end(), [](const Frame& frame) { return frame.is_dead; });
    }
    std::vector<std::string> texts() const {
        std::vector<std::string> texts;
        for (const Frame& frame : frames_) texts.push_back(frame.text);
        return texts;
    }

private:
    struct Frame {
        std::string text;
        bool is_dead, was_taken;
    };
    std::vector<Frame> frames_;
};

class DefinitionReader {
public:
    DefinitionReader(const std::string& text, bool recovers) : text_(text), recovers_(recovers) {
        Conditions conditions;
        for (CodeToken& token : all_tokens(text)) {
            if (token.kind == CodeToken::comment) continue;
            const bool is_condition = token.kind == CodeToken::directive && conditions.read(token);
            if (is_condition || !conditions.is_dead()) tokens_.push_back(std::move(token));
        }
    }

    CodeDefinitions take() {
        for (size_t i = 0; i < tokens_.size();) i = step(i);
        result_.is_balanced &= namespaces_ == 0;
        return std::move(result_);
    }

private:
    bool is(size_t i, std::string_view text) const { return i < tokens_.size() && tokens_[i].text == text; }
    bool is_word(size_t i) const { return i < tokens_.size() && tokens_[i].kind == CodeToken::word; }

    CodeDefinition begun(size_t i) const {
        CodeDefinition one;
        one.begin = tokens_[i].begin, one.end = tokens_[i].end;
        one.conditions = conditions_.texts();
        return one;
    }

    size_t step(size_t i) {
        if (tokens_[i].kind == CodeToken::directive) {
            if (!conditions_.read(tokens_[i])) directive(i);
            return i + 1;
        }
        if (is(i, "namespace") || (is(i, "inline") && is(i + 1, "namespace"))) {
            size_t k = i + (is(i, "inline") ? 2 : 1);
            while (is_word(k) || is(k, ":")) ++k;
            if (is(k, "{")) {
                ++namespaces_;
                return k + 1;
            }
        }
        if (is(i, "}") && namespaces_ > 0) {
            --namespaces_;
            return i + 1;
        }
        if (closes(tokens_[i])) {
            result_.is_balanced = false;
            CodeDefinition one = begun(i);
            one.kind = CodeDefinition::stray;
            result_.list.push_back(std::move(one));
            return i + 1;
        }
        if (is(i, ";")) return i + 1;
        return definition(i);
    }

    void directive(size_t i) {
        CodeDefinition one = begun(i);
        one.kind = CodeDefinition::directive;
        const std::vector<CodeToken> words = tokens_of_directive(tokens_[i]);
        if (words.size() > 2 && (words[1].text == "define" || words[1].text == "undef")) {
            one.kind = CodeDefinition::macro;
            one.names = {words[2].text};
        }
        add_words(one, words);
        result_.list.push_back(std::move(one));
    }

    static void add_words(CodeDefinition& one, const std::vector<CodeToken>& tokens) {
        for (size_t i = 0; i < tokens.size(); ++i) {
            if (tokens[i].kind != CodeToken::word) continue;
            one.words.insert(tokens[i].text);
            if (i + 1 < tokens.size() && tokens[i + 1].text == "(") one.called.insert(tokens[i].text);
        }
    }

    /// Returns whether the first tokens of a line look like those of a function's definition.
    bool is_header(size_t i) const {
        const size_t line_end = text_.find_last_of("\r\n", tokens_[i].begin);
        const size_t first = line_end == std::string::npos ? 0 : line_end + 1;
        if (text_.find_first_not_of(" \t", first) != tokens_[i].begin) return false;
        size_t k = i;
        int words = 0;
        for (; k < tokens_.size() && !is(k, "("); ++k) {
            static const std::set<std::string> signs = {":", "<", ">", ",", "&", "*", "[", "]"};
            if (tokens_[k].kind == CodeToken::word)
                words += !is_one_of(tokens_[k].text, parameter_words);
            else if (tokens_[k].kind != CodeToken::number && !signs.contains(tokens_[k].text))
                return false;
            if (is_one_of(tokens_[k].text, statement_words)) return false;
        }
        if (words < 2 || !is_word(k - 1)) return false;
        int depth = 0;
        for (; k < tokens_.size() && !is(k, ";"); ++k) {
            if (is(k, "{")) return depth == 0;
            depth += is(k, "("), depth -= is(k, ")");
        }
        return false;
    }

    /// Reads a definition. Returns the index after it.
    size_t definition(size_t i) {
        CodeDefinition one = begun(i);
        size_t open = 0, close = 0, k = i;
        int depth = 0;
        bool is_assigned = false, is_type = false, ends = false;
        Conditions inside;
        for (; k < tokens_.size() && !ends; ++k) {
            const CodeToken& token = tokens_[k];
            if (token.kind == CodeToken::directive) {
                if (!inside.texts().empty() || !token_ends_condition(token)) {
                    inside.read(token);
                    add_words(one, tokens_of_directive(token));
                } else {
                    conditions_.read(token);
                }
                continue;
            }
            if (recovers_ && open > 0 && depth > 0 && is_header(k)) break;
            if (depth == 0 && is(k, "}")) break;
            if (depth == 0) {
                is_type |= open == 0 && is_one_of(token.text, type_words);
                is_assigned |= is(k, "=");
                if (is(k, "(") && open == 0 && !is_assigned && k > i + 1 && is_word(k - 1)) open = k;
                if (is(k, "{") && close > 0 && !is_assigned && one.body == 0) one.body = token.begin;
            }
            depth += opens(token), depth -= closes(token);
            if (depth == 0 && is(k, ")") && close == 0 && open > 0) close = k;
            ends = depth == 0 && (is(k, ";") || (is(k, "}") && one.body > 0));
        }
        result_.is_balanced &= ends;
        if (k == i) return i + 1;
        one.end = tokens_[k - 1].end;
        for (size_t t = i; t < k; ++t)
            if (tokens_[t].kind != CodeToken::directive) one.tokens.push_back(tokens_[t]);
        add_words(one, one.tokens);
        if (open > 0 && close == 0) {  // a parenthesis that is never closed: the parameters end at the body
            const auto is_brace = [](const CodeToken& token) { return token.text == "{"; };
            const auto brace = std::find_if(tokens_.begin() + long(open), tokens_.begin() + long(k), is_brace);
            close = size_t(brace - tokens_.begin());
            if (close < k) one.body = brace->begin;
        }
        name(one, i, open, close, is_type, is_assigned);
        result_.list.push_back(std::move(one));
        return k;
    }

    /// Returns whether a preprocessor line ends or changes a condition that began before.
    static bool token_ends_condition(const CodeToken& directive) {
        const std::vector<CodeToken> words = tokens_of_directive(directive);
        return words.size() > 1 && (words[1].text == "endif" || words[1].text == "else" || words[1].text == "elif");
    }

    void name(CodeDefinition& one, size_t first, size_t open, size_t close, bool is_type, bool is_assigned) const {
        if (is_one_of(tokens_[first].text, statement_words)) {
            one.kind = CodeDefinition::stray;
        } else if (close > 0 && (one.body > 0 || !is_assigned)) {
            one.kind = one.body > 0 ? CodeDefinition::function : CodeDefinition::prototype;
            one.signature = signature_at(tokens_, open, close);
            one.names = {one.signature.name};
        } else if (!(is(first, "using") && is(first + 1, "namespace"))) {
            one.kind = is_type ? CodeDefinition::type : CodeDefinition::variable;
            name_declarators(one, is_type);
        }
    }

    /// Finds the names of `float a = 1.0, b[2];`, and of `struct S { } s;`.
    static void name_declarators(CodeDefinition& one, bool is_type) {
        int depth = 0, angles = 0;
        std::string last;
        bool is_named = false;
        const auto finish = [&] {
            if (!is_named && !last.empty()) one.names.push_back(last);
            is_named = true;
        };
        for (const CodeToken& token : one.tokens) {
            if (depth == 0 && !is_named) {
                angles += token.text == "<", angles -= token.text == ">";
                const bool is_name = token.kind == CodeToken::word && !is_one_of(token.text, type_words);
                if (is_name && angles == 0) last = token.text;
                if (token.text == "=" || token.text == "{" || token.text == "(") finish();
            }
            if (depth == 0 && token.text == ";") finish();
            if (depth == 0 && token.text == "," && angles == 0) {
                finish();
                is_named = false, last.clear();
            }
            depth += opens(token), depth -= closes(token);
            if (is_type && depth == 0 && token.text == "}") is_named = false, last.clear();
        }
    }

    const std::string& text_;
    bool recovers_;
    std::vector<CodeToken> tokens_;
    Conditions conditions_;
    int namespaces_ = 0;  ///< the open ones
    CodeDefinitions result_;
};

}  // namespace

std::string CodeSignature::text() const { return name + "(" + join(types, ", ") + ")"; }

bool CodeSignature::fits(const CodeSignature& other) const {
    if (name != other.name || types.size() != other.types.size()) return false;
    for (size_t i = 0; i < types.size(); ++i) {
        const PlainType a = plain_type(types[i]), b = plain_type(other.types[i]);
        if (a != b && is_built_in_type(a.name) && is_built_in_type(b.name)) return false;
    }
    return true;
}

CodeSignature parse_signature(const std::string& text) {
    const std::vector<CodeToken> tokens = code_tokens(text);
    if (tokens.size() < 3 || tokens[1].text != "(" || tokens.back().text != ")") return {text, {}};
    return signature_at(tokens, 1, tokens.size() - 1);
}

std::string CodeDefinition::key() const {
    if (kind != function && kind != prototype) return std::to_string(kind) + " " + join(names, " ");
    std::string key = (kind == function ? "function " : "prototype ") + signature.name;
    for (const std::string& one : signature.types) key += " " + plain_type(one).name;
    return key;
}

bool CodeDefinition::defines(const std::string& name) const {
    return std::find(names.begin(), names.end(), name) != names.end();
}

CodeDefinitions definitions_of(const std::string& text) {
    CodeDefinitions found = DefinitionReader(text, false).take();
    return found.is_balanced ? found : DefinitionReader(text, true).take();
}

std::vector<bool> used_by(const std::vector<CodeDefinition>& list, const std::vector<bool>& roots,
                          const std::vector<bool>& barriers) {
    std::vector<bool> used(list.size());
    std::set<std::string> wanted;
    for (size_t i = 0; i < list.size(); ++i)
        if (roots[i]) wanted.insert(list[i].words.begin(), list[i].words.end());
    for (bool grows = true; grows;) {
        grows = false;
        for (size_t i = 0; i < list.size(); ++i) {
            if (used[i] || roots[i] || barriers[i]) continue;
            const std::vector<std::string>& names = list[i].names;
            if (std::none_of(names.begin(), names.end(), [&](const std::string& one) { return wanted.contains(one); }))
                continue;
            used[i] = grows = true;
            wanted.insert(list[i].words.begin(), list[i].words.end());
        }
    }
    return used;
}

}  // namespace relief
