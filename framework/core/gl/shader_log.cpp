// A compiler's log: the first error with advice, and the other messages. See shader_source.h.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>

#include "framework/core/base/code_text.h"
#include "framework/core/base/folded_text.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/source_text.h"
#include "framework/core/base/text.h"
#include "framework/core/gl/glsl_words.h"
#include "framework/core/gl/shader_source.h"

namespace relief {
namespace {

constexpr size_t candidates_shown = 4;

bool has(const std::string& text, std::string_view words) { return text.find(words) != std::string::npos; }

/// A compiler's message: Mesa's "0:12(5): error: x", Nvidia's "0(12) : error C1: x", Apple's "ERROR: 0:12: x".
struct LogLine {
    std::optional<int> line;  ///< in the compiled text
    int column = 0;           ///< from 1; 0 if the compiler reports none
    std::string message;
    bool is_warning = false;
    bool is_candidate = false;  ///< a function that the message before could have meant
};

LogLine parse_log_line(const std::string& whole) {
    std::string_view rest(whole);
    const auto skip = [&](std::string_view text) {
        const bool found = rest.starts_with(text);
        if (found) rest.remove_prefix(text.size());
        return found;
    };
    const auto number = [&]() -> std::optional<int> {
        const size_t end = std::min(rest.find_first_not_of("0123456789"), rest.size());
        const auto value = parse_int(rest.substr(0, end));
        const bool digits = end > 0;
        rest.remove_prefix(end);
        return digits ? value.value_or(0) : std::optional<int>();
    };
    LogLine result{.line = {}, .message = whole, .is_warning = whole.starts_with("WARNING")};
    skip("ERROR: ") || skip("WARNING: ");
    if (!number()) return result;
    std::optional<int> line;
    if (skip(":")) {
        line = number();
        if (line && skip("(")) {
            const auto column = number();
            if (!column || !skip(")")) return result;
            result.column = *column;
        }
    } else if (skip("(")) {
        line = number();
        if (!skip(")")) return result;
    }
    skip(" ");
    if (!line || !skip(":")) return result;
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
    result.line = line;
    result.message = rest;
    result.is_warning |= result.message.starts_with("warning");
    result.is_candidate = result.message.starts_with("error:   ");
    return result;
}

std::vector<LogLine> parse_log(const std::string& log) {
    std::vector<LogLine> messages;
    std::istringstream stream(log);
    for (std::string line; std::getline(stream, line);) {
        const auto end = line.find_last_not_of(" \r\0", std::string::npos, 3);
        line.resize(end == std::string::npos ? 0 : end + 1);
        if (!line.empty()) messages.push_back(parse_log_line(line));
    }
    return messages;
}

/// Returns the identifiers that a message names, such as `march' in "no matching function for call to `march(vec2)'".
std::vector<std::string> names_in(const std::string& message) {
    std::vector<std::string> names;
    const auto add = [&](std::string_view words) {
        words = words.substr(0, words.find('('));
        while (!words.empty() && words.back() == ' ') words.remove_suffix(1);
        size_t begin = words.size();
        while (begin > 0 && is_word_character(words[begin - 1])) --begin;
        const std::string_view name = words.substr(begin);
        if (!name.empty() && !std::isdigit(static_cast<unsigned char>(name[0]))) names.emplace_back(name);
    };
    for (size_t open = message.find_first_of("`'\""); open != std::string::npos;) {
        const size_t close = message.find_first_of(message[open] == '"' ? "\"" : "'", open + 1);
        if (close == std::string::npos) break;
        add(std::string_view(message).substr(open + 1, close - open - 1));
        open = message.find_first_of("`'\"", close + 1);
    }
    if (const size_t at = message.find("identifier: "); names.empty() && at != std::string::npos)  // AMD
        add(std::string_view(message).substr(at + 12, message.find_first_of(" \n", at + 12) - at - 12));
    return names;
}

/// The text of a shader: its tokens, and where each stands.
class ReadShader {
public:
    ReadShader(const std::string& text, const std::vector<Place>& lines)
        : text_(text), lines_(lines), tokens_(code_tokens(text)) {
        begins_.push_back(0);
        for (size_t at = 0; (at = text.find('\n', at)) != std::string::npos;) begins_.push_back(++at);
        std::erase_if(tokens_, [&](const CodeToken& token) { return size_t(line_of(token.begin)) > lines_.size(); });
    }

    const std::string& text() const { return text_; }
    const std::vector<CodeToken>& tokens() const { return tokens_; }
    bool has_line(int line) const {
        return line >= 1 && size_t(line) <= lines_.size() && size_t(line) < begins_.size();
    }
    /// Without a file for a line that comes from no file.
    Place place_of(int line) const {
        return line >= 1 && size_t(line) <= lines_.size() ? lines_[size_t(line) - 1] : Place{};
    }
    std::string line(int number) const {
        const size_t begin = begins_[size_t(number) - 1];
        return text_.substr(begin, begins_[size_t(number)] - 1 - begin);
    }
    int line_of(size_t offset) const {
        return int(std::upper_bound(begins_.begin(), begins_.end(), offset) - begins_.begin());
    }
    size_t begin_of(int line) const { return begins_[size_t(line) - 1]; }
    const Place& place_of(const CodeToken& token) const { return lines_[size_t(line_of(token.begin)) - 1]; }

    /// Returns the index of the token that a message is about; nothing if it cannot be told.
    std::optional<size_t> token_at(const LogLine& message) const {
        if (!message.line || !has_line(*message.line)) return {};
        const size_t begin = begin_of(*message.line), place = begin + byte_of(line(*message.line), message.column);
        const std::vector<std::string> names = names_in(message.message);
        std::optional<size_t> best;
        const auto first = std::lower_bound(tokens_.begin(), tokens_.end(), begin,
                                            [](const CodeToken& token, size_t at) { return token.begin < at; });
        for (size_t i = size_t(first - tokens_.begin());
             i < tokens_.size() && tokens_[i].begin < begins_[size_t(*message.line)]; ++i) {
            const auto is_named = [&](const std::string& name) { return tokens_[i].text == name; };
            const bool fits = message.column > 0 && tokens_[i].begin == place;
            if (fits && (names.empty() || std::any_of(names.begin(), names.end(), is_named))) return i;
            if (fits && !best) best = i;
            if (std::any_of(names.begin(), names.end(), is_named) &&
                (!best || tokens_[*best].begin == place || distance(i, place) < distance(*best, place)))
                best = i;
        }
        return best;
    }

private:
    size_t distance(size_t token, size_t place) const {
        const size_t at = tokens_[token].begin;
        return at > place ? at - place : place - at;
    }

    /// Converts a compiler's column to an offset in the line. Only Mesa reports columns, and it counts a run of blanks
    /// and comments as one.
    static size_t byte_of(const std::string& line, int column) {
        size_t i = 0;
        while (i < line.size()) {
            if (--column == 0) return i;
            const size_t before = i;
            for (bool more = true; more && i < line.size();) {
                more = line[i] == ' ' || line[i] == '\t' || line.compare(i, 2, "/*") == 0;
                if (line.compare(i, 2, "/*") == 0)
                    i = std::min(line.find("*/", i + 2), line.size() - 2) + 2;
                else if (more)
                    ++i;
            }
            if (i == before) ++i;
        }
        return line.size();
    }

    const std::string& text_;
    const std::vector<Place>& lines_;
    std::vector<CodeToken> tokens_;
    std::vector<size_t> begins_;  ///< offset of each line, and of the end
};

/// What is said of the first error.
struct Explained {
    Place place;
    std::string message, details;
};

bool is_of_a_task(const Place& place) { return place.file.filename() == "task.glsl"; }

/// Returns the index of the bracket that a closing one belongs to; nothing if there is none.
std::optional<size_t> opening(const std::vector<CodeToken>& tokens, size_t close) {
    int depth = 0;
    for (size_t i = close + 1; i-- > 0;) {
        if (tokens[i].text == ")") ++depth;
        if (tokens[i].text == "(" && --depth == 0) return i;
    }
    return {};
}

/// Returns whether a statement or a declaration may end behind this token, so that a ; can be missing there.
bool may_end_at(const std::vector<CodeToken>& tokens, size_t i) {
    if (tokens[i].kind == CodeToken::word) return tokens[i].text != "else" && tokens[i].text != "do";
    if (tokens[i].kind == CodeToken::number || tokens[i].text == "]") return true;
    if (tokens[i].text != ")")
        return i > 0 && (tokens[i].text == "+" || tokens[i].text == "-") &&
               tokens[i - 1].text == tokens[i].text;  // ++ and --
    const auto open = opening(tokens, i);
    if (!open || *open == 0) return false;
    const std::string& word = tokens[*open - 1].text;
    return word != "if" && word != "for" && word != "while" && word != "switch";
}

/// Returns the words of a compiler in those of the text: Mesa's "unexpected NEW_IDENTIFIER" becomes "unexpected `x'".
std::string with_token(std::string message, const CodeToken& token) {
    constexpr std::string_view unexpected = "unexpected ";
    const size_t at = message.find(unexpected);
    if (at == std::string::npos) return message;
    const size_t begin = at + unexpected.size();
    size_t end = begin;
    while (end < message.size() && (std::isupper(static_cast<unsigned char>(message[end])) || message[end] == '_'))
        ++end;
    return end > begin + 1 ? message.replace(begin, end - begin, fmt::format("`{}'", token.text)) : message;
}

/// Explains the first error of a shader's log.
class Explainer {
public:
    Explainer(const ReadShader& shader, const LogLine& said) : shader_(shader), said_(said) {}

    Explained explain() {
        token_ = shader_.token_at(said_);
        result_.place = said_.line ? shader_.place_of(*said_.line) : Place{};
        result_.message = said_.message;
        if (said_.line && shader_.has_line(*said_.line) && !result_.place.file.empty()) {
            if (is_syntax_error() && token_) result_.message = with_token(result_.message, shader_.tokens()[*token_]);
            quote(*said_.line, token_ ? std::optional<size_t>(shader_.tokens()[*token_].begin) : std::nullopt);
            if (!find_end_of_task() && !find_missing_end() && !find_name_of_task()) advise();
        }
        return result_;
    }

private:
    bool is_syntax_error() const { return has(said_.message, "syntax error"); }

    void quote(int line, std::optional<size_t> offset) {
        result_.details =
            marked_line(shader_.line(line), offset ? *offset - shader_.begin_of(line) : std::string::npos);
    }
    void move_to(size_t offset, std::string message) {
        const int line = shader_.line_of(offset);
        result_.place = shader_.place_of(line);
        result_.message = std::move(message);
        quote(line, offset);
    }

    /// An error of syntax behind a task's file, or in its last function, whose brackets are not closed.
    bool find_end_of_task() {
        if (!is_syntax_error()) return false;
        const std::vector<CodeToken>& tokens = shader_.tokens();
        std::vector<size_t> open;
        std::optional<size_t> last;  // of the task's file
        const size_t stop = token_.value_or(tokens.size());
        for (size_t i = 0; i < tokens.size() && i < stop; ++i) {
            if (!is_of_a_task(shader_.place_of(tokens[i]))) continue;
            last = i;
            const std::string& text = tokens[i].text;
            if (text == "(" || text == "[" || text == "{") open.push_back(i);
            if ((text == ")" || text == "]" || text == "}") && !open.empty()) open.pop_back();
        }
        const bool is_behind = last && !is_of_a_task(result_.place);
        // A function in a function: the one before it is not closed.
        const bool is_in_function = !open.empty() && tokens[open.front()].text == "{" && token_ &&
                                    tokens[*token_].text == "{" && *token_ > 0 && tokens[*token_ - 1].text == ")" &&
                                    !may_begin_block(*token_ - 1);
        if (!open.empty() && (is_behind || is_in_function)) {
            const CodeToken& bracket = tokens[open.front()];
            move_to(bracket.begin, fmt::format("error: this {} is never closed", bracket.text));
            return true;
        }
        // Other tokens of a branch of #if that is not compiled may stand between.
        if (!is_behind || tokens[*last].text == "}" || tokens[*last].text == ";") return false;
        move_to(tokens[*last].end, "error: the file ends in the middle of a declaration: is a ; missing here?");
        return true;
    }

    /// Returns whether a { may follow this ) inside of a function.
    bool may_begin_block(size_t close) const {
        const auto open = opening(shader_.tokens(), close);
        if (!open || *open == 0) return true;
        const std::string& word = shader_.tokens()[*open - 1].text;
        return word == "if" || word == "for" || word == "while" || word == "switch";
    }

    /// A ; that is missing at the end of the line before.
    bool find_missing_end() {
        const std::vector<CodeToken>& tokens = shader_.tokens();
        if (!is_syntax_error() || !token_ || *token_ == 0) return false;
        if (has(said_.message, "expecting") && !has(said_.message, "';'")) return false;
        const CodeToken &before = tokens[*token_ - 1], &here = tokens[*token_];
        const int line = shader_.line_of(before.begin);
        if (line == shader_.line_of(here.begin) || here.text == "{" || !may_end_at(tokens, *token_ - 1) ||
            shader_.place_of(before).file != result_.place.file)
            return false;
        const std::string said = result_.message.substr(result_.message.find("syntax error"));
        move_to(before.end, fmt::format("error: is a ; missing at the end of this line? Line {} has a {}",
                                        result_.place.line, said));
        return true;
    }

    /// An error in the lab's own shader about a name of the task's file.
    bool find_name_of_task() {
        if (is_of_a_task(result_.place)) return false;
        const Place lab = result_.place;
        const auto there = [&] { return fmt::format("{}:{}: {}", shown(lab.file), lab.line, said_.message); };
        const std::vector<CodeToken>& tokens = shader_.tokens();
        std::filesystem::path task;
        for (const CodeToken& token : tokens)
            if (is_of_a_task(shader_.place_of(token))) task = shader_.place_of(token).file;
        if (task.empty()) return false;
        for (const std::string& name : names_in(said_.message))
            for (size_t i = 1; i < tokens.size(); ++i) {
                if (tokens[i].text != name || tokens[i - 1].kind != CodeToken::word || tokens[i - 1].text == "return" ||
                    !is_of_a_task(shader_.place_of(tokens[i])))
                    continue;
                const bool is_again = has(said_.message, "redefin") || has(said_.message, "redeclar");
                move_to(tokens[i].begin,
                        is_again ? fmt::format("error: the lab's shaders define `{}' too: choose another name", name)
                                 : fmt::format("error: `{}' does not fit its use by the lab: keep the names, types and "
                                               "parameters of the file as you got it",
                                               name));
                result_.details += there() + "\n";
                return true;
            }
        if (is_unknown_name() && token_ && is_call(*token_)) {
            const std::string& name = tokens[*token_].text;
            // One letter from another function: the call has the mistake, and the task lacks nothing.
            const auto near = near_name(name, names_in_scope());
            if (near && edit_distance(name, *near) == 1) return false;
            result_.place = {task, 0};
            result_.message = fmt::format(
                "error: `{}' is missing, which the lab calls: keep the names and parameters of the functions", name);
            result_.details = there() + "\n" + result_.details;
            return true;
        }
        return false;
    }

    bool is_call(size_t token) const {
        return token + 1 < shader_.tokens().size() && shader_.tokens()[token + 1].text == "(";
    }
    bool is_unknown_name() const {
        for (const char* words : {"undeclared", "Undeclared", "undefined", "no function with name", "no matching",
                                  "unable to find", "no overloaded", "unknown", "reserved word"})
            if (has(said_.message, words)) return true;
        return false;
    }

    void say(const std::string& advice) { result_.message += ": " + advice; }

    void advise() {
        if (is_syntax_error()) return advise_syntax();
        const std::vector<std::string> names = names_in(said_.message);
        if (names.empty()) return;
        if (has(said_.message, "access field") || has(said_.message, "no such field")) return advise_field(names[0]);
        if (!is_unknown_name() || is_known(names[0])) return;
        if (const std::string word = glsl_for(names[0]); !word.empty()) return say("in GLSL it is " + word);
        if (!token_) return;
        if (const auto line = line_of_later_function(names[0]))
            return say(fmt::format("line {} defines it: move that above this function", *line));
        if (const auto guess = near_name(names[0], names_in_scope())) say(fmt::format("did you mean `{}'?", *guess));
    }

    /// A word of another language on the line is the likely cause of an error of syntax.
    void advise_syntax() {
        const int line = *said_.line;
        for (const CodeToken& token : shader_.tokens()) {
            if (token.kind != CodeToken::word || shader_.line_of(token.begin) != line || is_known(token.text)) continue;
            if (token_ && token.begin > shader_.tokens()[*token_].begin) break;
            if (const std::string word = glsl_for(token.text); !word.empty()) {
                quote(line, token.begin);
                return say(fmt::format("in GLSL `{}' is {}", token.text, word));
            }
        }
    }

    void advise_field(const std::string& name) {
        std::vector<std::string> fields;
        for (const GlslStruct& one : parse_glsl(shader_.text()).structs)
            for (const GlslVariable& field : one.fields) fields.push_back(field.name);
        if (const auto guess = near_name(name, fields)) say(fmt::format("did you mean `{}'?", *guess));
    }

    static std::optional<std::string> near_name(const std::string& name, const std::vector<std::string>& known) {
        const auto guess = nearest(name, known);
        // Names of one or two letters resemble too many others.
        return guess && *guess != name && (name.size() > 2 || edit_distance(name, *guess) == 0) ? guess : std::nullopt;
    }

    /// Returns whether the text itself defines the name before the error.
    bool is_known(const std::string& name) const {
        const std::vector<CodeToken>& tokens = shader_.tokens();
        const size_t end = token_.value_or(tokens.size());
        for (size_t i = 1; i < end; ++i)
            if (tokens[i].text == name && declares(i)) return true;
        return false;
    }
    /// Returns whether the token is a name behind its type.
    bool declares(size_t i) const {
        const std::vector<CodeToken>& tokens = shader_.tokens();
        if (i == 0 || tokens[i].kind != CodeToken::word || is_glsl_keyword(tokens[i].text)) return false;
        const std::string& before = tokens[i - 1].text;
        return (tokens[i - 1].kind == CodeToken::word && before != "return" && before != "else" && before != "do" &&
                before != "case") ||
               (before == "]" && i + 1 < tokens.size() && tokens[i + 1].text != ".");
    }

    std::optional<int> line_of_later_function(const std::string& name) const {
        if (!is_call(*token_)) return {};
        for (const GlslFunction& function : parse_glsl(shader_.text()).functions)
            if (function.name == name && function.begin > shader_.tokens()[*token_].begin) {
                const Place place = shader_.place_of(shader_.line_of(function.name_at));
                if (place.file == result_.place.file) return place.line;
            }
        return {};
    }

    /// Returns the names that may stand where the error is: of functions for a call, else of variables, which the
    /// function itself or the text outside of all functions declares before.
    std::vector<std::string> names_in_scope() const {
        const std::vector<CodeToken>& tokens = shader_.tokens();
        std::set<std::string> names;
        const bool for_call = is_call(*token_);
        if (for_call) names = built_in_functions();
        int depth = 0;
        std::set<std::string> local;
        for (size_t i = 0; i < *token_; ++i) {
            const std::string& text = tokens[i].text;
            if (text == "{" || text == "(") ++depth;
            if (text == "}" || text == ")") --depth;
            if (text == "}" && depth == 0) local.clear();
            if (is_call(i) == for_call && declares(i)) (depth == 0 ? names : local).insert(text);
            // "float a = 0.0, b = 1.0;"
            if (depth > 0 && !for_call && tokens[i].kind == CodeToken::word && i + 1 < tokens.size() && i > 0 &&
                tokens[i - 1].text == "," && tokens[i + 1].text == "=")
                local.insert(text);
        }
        names.insert(local.begin(), local.end());
        return {names.begin(), names.end()};
    }

    const ReadShader& shader_;
    const LogLine& said_;
    std::optional<size_t> token_;
    Explained result_;
};

std::string in_one_line(const LogLine& message, const Place& place) {
    return place.file.empty() ? message.message
                              : fmt::format("{}:{}: {}", shown(place.file), place.line, message.message);
}

/// Finds the definition in a task's file of a function that a linker's message names.
void find_function(const std::string& message, const ReadShader& shader, ShaderLog& log) {
    for (const std::string& name : names_in(message))
        for (const GlslFunction& function : parse_glsl(shader.text()).functions) {
            const int line = shader.line_of(function.name_at);
            if (function.name != name || !is_of_a_task(shader.place_of(line))) continue;
            log.first = shader.place_of(line);
            log.text = marked_line(shader.line(line), function.name_at - shader.begin_of(line));
            return;
        }
}

}  // namespace

ShaderLog explain_log(const std::string& log, const std::vector<Place>& lines, const std::string& source) {
    const std::vector<LogLine> messages = parse_log(log);
    const auto place_of = [&](const LogLine& message) {
        const bool is_known = message.line && *message.line >= 1 && size_t(*message.line) <= lines.size();
        return is_known ? lines[size_t(*message.line) - 1] : Place{};
    };
    // A message with a place is more useful than a heading without one.
    std::optional<size_t> first;
    for (size_t i = 0; i < messages.size(); ++i)
        if (!messages[i].is_warning &&
            (!first || (place_of(messages[*first]).file.empty() && !place_of(messages[i]).file.empty())))
            first = i;
    if (!first && !messages.empty()) first = 0;
    ShaderLog result;
    if (!first) return result;
    const LogLine& said = messages[*first];
    const ReadShader shader(source, lines);
    const Explained explained = Explainer(shader, said).explain();
    result.first = explained.place, result.first_message = explained.message, result.text = explained.details;
    if (result.first.file.empty()) find_function(said.message, shader, result);
    if (has(said.message, "recursion")) result.first_message += ": GLSL has no recursion, so write a loop";
    size_t candidates = 0;
    while (*first + 1 + candidates < messages.size() && messages[*first + 1 + candidates].is_candidate) ++candidates;
    const bool shows_candidates = candidates > 0 && candidates <= candidates_shown;
    std::vector<std::string> folded;
    for (size_t i = 0; i < messages.size(); ++i)
        if (shows_candidates && i > *first && i <= *first + candidates)
            result.text +=
                "    there is " + messages[i].message.substr(messages[i].message.find_first_not_of(" ", 6)) + "\n";
        else if (i != *first)
            folded.push_back(in_one_line(messages[i], place_of(messages[i])));
    constexpr std::string_view announcement = "; candidates are:";
    if (candidates > 0 && result.first_message.ends_with(announcement))
        result.first_message.resize(result.first_message.size() - announcement.size());
    result.text = folded_text({result.text, folded});
    return result;
}

}  // namespace relief
