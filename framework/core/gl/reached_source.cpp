#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "framework/core/base/code_text.h"
#include "framework/core/base/conditions.h"
#include "framework/core/gl/shader_source.h"

namespace relief {
namespace {

using Range = std::pair<size_t, size_t>;

struct Function {
    size_t begin, end;
    /// Whether `end` is certain: the function begins after a ; or a }, defines no macros, ends no #if that began before
    /// it, and no branch of its #if lines opens or closes a brace alone.
    bool is_whole = true;
    int depth = 0;                     ///< of braces
    std::vector<int> conditions = {};  ///< for each open #if the depth before it
};

/// A text and its functions, which do not depend on the definitions that a program adds.
struct Parsed {
    std::string text;  ///< with blanks in place of comments
    std::vector<Function> functions;
    std::vector<Directive> directives;
    /// A word, also in a directive, with its place and the function around it; -1 outside of functions.
    struct Word {
        size_t at;
        int name, function;
    };
    std::vector<Word> words;
    std::map<std::string, int, std::less<>> names;    ///< numbers of the words
    std::vector<std::vector<size_t>> functions_of{};  ///< by the number of their name

    int number_of(const std::string& word) { return names.try_emplace(word, int(names.size())).first->second; }
};

/// Puts blanks in place of a range of the text, but for its line ends.
void blank_out(std::string& text, size_t begin, size_t end) {
    std::replace_if(
        text.begin() + ptrdiff_t(begin), text.begin() + ptrdiff_t(end), [](char c) { return c != '\n'; }, ' ');
}

void note_directive(Function& function, const std::vector<CodeToken>& words) {
    const std::string name = words.size() < 2 ? "" : words[1].text;
    if (name == "define" || name == "undef") function.is_whole = false;
    if (name.starts_with("if")) function.conditions.push_back(function.depth);
    if (name != "endif" && !name.starts_with("el")) return;
    if (function.conditions.empty() || function.conditions.back() != function.depth) function.is_whole = false;
    if (name == "endif" && !function.conditions.empty()) function.conditions.pop_back();
}

/// Returns whether a macro's line joins names by ## or has unbalanced braces: parse_glsl() may then find wrong
/// functions.
bool hides_functions(const std::vector<CodeToken>& words) {
    int depth = 0;
    for (size_t i = 1; i < words.size(); ++i) {
        if (words[i].text == "#" && words[i - 1].text == "#") return true;
        depth += words[i].text == "{" ? 1 : words[i].text == "}" ? -1 : 0;
    }
    return depth != 0;
}

Parsed parse(const std::string& text) {
    Parsed parsed{.text = text, .functions = {}, .directives = {}, .words = {}, .names = {}};
    const GlslText glsl = parse_glsl(text);
    for (const GlslFunction& function : glsl.functions)
        parsed.functions.push_back({.begin = function.begin, .end = function.end});
    size_t next = 0;
    bool are_hidden = false;
    bool ends_before = true;  // the code token before this one is a ; or a }, or there is none
    for (const CodeToken& token : all_tokens(text)) {
        while (next < parsed.functions.size() && token.begin >= parsed.functions[next].end) ++next;
        const bool is_inside = next < parsed.functions.size() && token.begin >= parsed.functions[next].begin;
        const auto note = [&](const std::string& word) {
            parsed.words.push_back({token.begin, parsed.number_of(word), is_inside ? int(next) : -1});
        };
        if (is_inside && token.begin == parsed.functions[next].begin) parsed.functions[next].is_whole = ends_before;
        if (is_inside && token.text == "{") ++parsed.functions[next].depth;
        if (is_inside && token.text == "}") --parsed.functions[next].depth;
        if (token.is_code()) ends_before = token.text == ";" || token.text == "}";
        if (token.kind == CodeToken::comment)
            blank_out(parsed.text, token.begin, token.end);
        else if (token.kind == CodeToken::word)
            note(token.text);
        else if (token.kind == CodeToken::directive) {
            parsed.directives.push_back({token.begin, token.end, tokens_of_directive(token)});
            const std::vector<CodeToken>& words = parsed.directives.back().tokens;
            if (is_inside) note_directive(parsed.functions[next], words);
            are_hidden |= hides_functions(words);
            for (const CodeToken& word : words) note(word.text);
        }
    }
    for (Function& each : parsed.functions) each.is_whole &= each.conditions.empty() && !are_hidden;
    parsed.functions_of.resize(parsed.names.size());
    for (size_t i = 0; i < glsl.functions.size(); ++i)
        parsed.functions_of[size_t(parsed.number_of(glsl.functions[i].name))].push_back(i);
    return parsed;
}

/// Permutations of a stage differ only in their definitions, so that one text is asked for often.
const Parsed& parsed(const std::string& text) {
    constexpr size_t most = 64;  // of an editor in a window, which saves many texts
    static thread_local std::map<std::string, Parsed, std::less<>> texts;
    const auto found = texts.find(text);
    if (found != texts.end()) return found->second;
    if (texts.size() >= most) texts.clear();
    return texts.emplace(text, parse(text)).first->second;
}

/// Returns for each function whether main(), the text outside of functions or `roots` reach it, by name. Words in the
/// ranges `out` do not count.
std::vector<bool> reached_of(const Parsed& parsed, const std::vector<std::string>& roots,
                             const std::vector<Range>& out) {
    std::vector<std::vector<int>> named(parsed.functions.size());
    std::vector<bool> is_named(parsed.names.size()), reached(parsed.functions.size());
    std::vector<int> left;
    const auto name = [&](int word) {
        if (is_named[size_t(word)]) return;
        is_named[size_t(word)] = true;
        left.push_back(word);
    };
    auto range = out.begin();
    for (const auto& [at, word, function] : parsed.words) {
        while (range != out.end() && at >= range->second) ++range;
        if (range != out.end() && at >= range->first) continue;
        if (function >= 0)
            named[size_t(function)].push_back(word);
        else
            name(word);
    }
    const auto reach = [&](size_t function) {
        if (reached[function]) return;
        reached[function] = true;
        for (const int word : named[function]) name(word);
    };
    for (const std::string& root : roots)
        if (const auto found = parsed.names.find(root); found != parsed.names.end()) name(found->second);
    for (size_t i = 0; i < parsed.functions.size(); ++i)
        if (!parsed.functions[i].is_whole) reach(i);
    while (!left.empty()) {
        const int word = left.back();
        left.pop_back();
        for (const size_t function : parsed.functions_of[size_t(word)]) reach(function);
    }
    return reached;
}

}  // namespace

ShaderSource reached_source(const ShaderSource& source) {
    ShaderSource result{.stage = source.stage, .text = {}, .lines = {}, .names = source.names};
    // The definitions follow the first line.
    size_t line = 0, begin = 0;
    std::vector<std::string> roots = {"main"};
    Macros macros;
    const auto is_definition = [&] {
        return line == 0 || (line < source.lines.size() && source.lines[line].file.empty());
    };
    for (; is_definition(); ++line) {
        const size_t end = source.text.find('\n', begin);
        if (end == std::string::npos) return source;
        for (const CodeToken& token : all_tokens(source.text.substr(begin, end + 1 - begin))) {
            const std::vector<CodeToken> words = tokens_of_directive(token);
            define(macros, words);
            for (const CodeToken& word : words) roots.push_back(word.text);
        }
        begin = end + 1;
        result.lines.push_back(source.lines.empty() ? Place{} : source.lines[line]);
    }
    result.text = source.text.substr(0, begin);

    const Parsed& body = parsed(source.text.substr(begin));
    const std::vector<Range> out = left_out(body.directives, std::move(macros)).value_or(std::vector<Range>());
    const std::vector<bool> reached = reached_of(body, roots, out);
    std::string text = body.text;
    for (const auto& [from, to] : out) blank_out(text, from, to);
    for (size_t i = 0; i < reached.size(); ++i)
        if (!reached[i]) blank_out(text, body.functions[i].begin, body.functions[i].end);
    bool is_joined = false;  // the line before ends in a backslash
    for (size_t at = 0; at < text.size(); ++line) {
        const size_t end = std::min(text.find('\n', at), text.size());
        std::string_view shown = std::string_view(text).substr(at, end - at);
        const size_t used = shown.find_last_not_of(" \t\r") + 1;
        // A blank after a backslash keeps it from joining lines.
        shown = shown.substr(0, used > 0 && shown[used - 1] == '\\' ? std::min(used + 1, shown.size()) : used);
        if (!shown.empty() || is_joined) {
            result.text.append(shown) += '\n';
            result.lines.push_back(line < source.lines.size() ? source.lines[line] : Place{});
        }
        is_joined = shown.ends_with('\\');
        at = end + 1;
    }
    return result;
}

}  // namespace relief
