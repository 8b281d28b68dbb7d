#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "framework/core/base/code_text.h"
#include "framework/core/gl/shader_source.h"

namespace relief {
namespace {

struct Function {
    size_t begin, end;
    std::string name;
    std::set<std::string> words = {};
    int open_conditions = 0;  ///< #if lines without their #endif
    bool is_whole = true;     ///< neither defines macros nor begins or ends inside of an #if
};

/// A text and its functions, which do not depend on the definitions that a program adds.
struct Parsed {
    std::string text;  ///< with blanks in place of comments
    std::vector<Function> functions;
    std::set<std::string> words;  ///< outside of functions
};

/// Puts blanks in place of a range of the text, but for its line ends.
void blank_out(std::string& text, size_t begin, size_t end) {
    std::replace_if(
        text.begin() + ptrdiff_t(begin), text.begin() + ptrdiff_t(end), [](char c) { return c != '\n'; }, ' ');
}

void note_directive(Function& function, const CodeToken& directive) {
    const std::vector<CodeToken> words = tokens_of_directive(directive);
    const std::string name = words.size() < 2 ? "" : words[1].text;
    if (name.starts_with("if")) ++function.open_conditions;
    if (name == "endif") --function.open_conditions;
    if (function.open_conditions < 0 || name == "define" || name == "undef" ||
        (function.open_conditions == 0 && name.starts_with("el")))
        function.is_whole = false;
}

Parsed parse(const std::string& text) {
    Parsed parsed{.text = text, .functions = {}, .words = {}};
    for (const GlslFunction& function : parse_glsl(text).functions)
        parsed.functions.push_back({.begin = function.begin, .end = function.end, .name = function.name});
    auto function = parsed.functions.begin();
    for (const CodeToken& token : all_tokens(text)) {
        while (function != parsed.functions.end() && token.begin >= function->end) ++function;
        const bool is_inside = function != parsed.functions.end() && token.begin >= function->begin;
        std::set<std::string>& words = is_inside ? function->words : parsed.words;
        if (token.kind == CodeToken::comment)
            blank_out(parsed.text, token.begin, token.end);
        else if (token.kind == CodeToken::word)
            words.insert(token.text);
        else if (token.kind == CodeToken::directive) {
            if (is_inside) note_directive(*function, token);
            for (const CodeToken& word : tokens_of_directive(token)) words.insert(word.text);
        }
    }
    for (Function& each : parsed.functions) each.is_whole &= each.open_conditions == 0;
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

/// Returns for each function whether it is reached from main() or from `roots`, by name.
std::vector<bool> reached_of(const Parsed& parsed, const std::set<std::string>& roots) {
    std::vector<bool> reached(parsed.functions.size());
    std::vector<const std::set<std::string>*> left = {&roots, &parsed.words};
    const auto reach = [&](size_t i) {
        if (reached[i]) return;
        reached[i] = true;
        left.push_back(&parsed.functions[i].words);
    };
    for (size_t i = 0; i < parsed.functions.size(); ++i)
        if (parsed.functions[i].name == "main" || !parsed.functions[i].is_whole) reach(i);
    while (!left.empty()) {
        const std::set<std::string>& words = *left.back();
        left.pop_back();
        for (size_t i = 0; i < parsed.functions.size(); ++i)
            if (words.contains(parsed.functions[i].name)) reach(i);
    }
    return reached;
}

}  // namespace

ShaderSource reached_source(const ShaderSource& source) {
    ShaderSource result{.stage = source.stage, .text = {}, .lines = {}, .names = source.names};
    // The definitions follow the first line.
    size_t line = 0, begin = 0;
    std::set<std::string> roots;
    const auto is_definition = [&] {
        return line == 0 || (line < source.lines.size() && source.lines[line].file.empty());
    };
    for (; is_definition(); ++line) {
        const size_t end = source.text.find('\n', begin);
        if (end == std::string::npos) return source;
        for (const CodeToken& token : all_tokens(source.text.substr(begin, end + 1 - begin)))
            for (const CodeToken& word : tokens_of_directive(token)) roots.insert(word.text);
        begin = end + 1;
        result.lines.push_back(source.lines.empty() ? Place{} : source.lines[line]);
    }
    result.text = source.text.substr(0, begin);

    const Parsed& body = parsed(source.text.substr(begin));
    const std::vector<bool> reached = reached_of(body, roots);
    std::string text = body.text;
    for (size_t i = 0; i < reached.size(); ++i)
        if (!reached[i]) blank_out(text, body.functions[i].begin, body.functions[i].end);
    bool is_joined = false;  // the line before ends in a backslash
    for (size_t at = 0; at < text.size(); ++line) {
        const size_t end = std::min(text.find('\n', at), text.size());
        std::string_view shown = std::string_view(text).substr(at, end - at);
        shown = shown.substr(0, shown.find_last_not_of(" \t\r") + 1);
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
