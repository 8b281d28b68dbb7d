#include "framework/course/task/rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <vector>

#include "framework/core/base/code_text.h"
#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/core/gl/glsl_words.h"
#include "framework/core/gl/shader_source.h"

namespace relief::check {
namespace {

constexpr std::array interface_words = {"uniform", "layout", "varying",    "attribute", "buffer",
                                        "shared",  "in",     "subroutine", "out",       "inout"};

struct Found {
    std::set<std::string> words, called, defined;  ///< `called` includes the defined functions
    std::set<std::string> macros;                  ///< names in #define and #undef
    std::set<std::string> tested;                  ///< words in conditions of the preprocessor
    std::set<std::string> handed;                  ///< words in a macro or its arguments that no "(" follows there
    std::string interface_word;                    ///< the first that does not qualify a parameter, or empty
    bool joins_words = false;
};

/// Reads code, line by line of the preprocessor and piece by piece between these lines.
class Look {
public:
    explicit Look(const std::string& text) {
        std::vector<CodeToken> code;
        for (CodeToken& token : all_tokens(text)) {
            if (token.kind == CodeToken::comment) continue;
            if (token.kind != CodeToken::directive) {
                code.push_back(std::move(token));
                continue;
            }
            read(code, false);
            code.clear();
            read(tokens_of_directive(token), true);
        }
        read(code, false);
    }
    Found take() { return std::move(found_); }

private:
    static bool is_word(const CodeToken& token) { return is_word_character(token.text[0]); }

    void read(const std::vector<CodeToken>& tokens, bool is_directive) {
        is_directive &= tokens.size() > 1;
        const bool is_definition =
            is_directive && tokens.size() > 2 && (tokens[1].text == "define" || tokens[1].text == "undef");
        if (is_definition) found_.macros.insert(tokens[2].text);
        for (size_t i = 0; i + 1 < tokens.size(); ++i)
            found_.joins_words |= tokens[i].text == "#" && tokens[i + 1].text == "#";
        if (is_directive && (tokens[1].text.starts_with("if") || tokens[1].text == "elif")) {
            for (size_t i = 2; i < tokens.size(); ++i)
                if (tokens[i].kind == CodeToken::word && tokens[i].text != "defined")
                    found_.tested.insert(tokens[i].text);
            found_.words.insert(found_.tested.begin(), found_.tested.end());
            return;
        }
        for (size_t i = 0; i < tokens.size(); ++i) {
            const bool is_called = i + 1 < tokens.size() && tokens[i + 1].text == "(";
            if (is_word(tokens[i]) && !is_called && (in_macro_ > 0 || (is_definition && i > 2)))
                found_.handed.insert(tokens[i].text);
            take(tokens[i], is_directive);
        }
    }

    void take(const CodeToken& token, bool is_directive) {
        const bool is_argument =
            before_ == "(" || before_ == "," || (before_ == "const" && (before_that_ == "(" || before_that_ == ","));
        if (found_.interface_word.empty() &&
            std::find(interface_words.begin(), interface_words.end(), token.text) != interface_words.end() &&
            (!is_argument || (token.text != "in" && token.text != "out" && token.text != "inout")))
            found_.interface_word = token.text;
        if (is_word(token)) found_.words.insert(token.text);
        if (token.text == "(" && (in_macro_ > 0 || (!is_directive && found_.macros.contains(before_)))) ++in_macro_;
        if (token.text == ")" && in_macro_ > 0) --in_macro_;
        if (token.text == "(" && !before_.empty() && is_word_character(before_[0])) {
            found_.called.insert(before_);
            // "float f(" and "float[2] f(", but not "return f(".
            if ((is_word_character(before_that_.empty() ? ' ' : before_that_[0]) && before_that_ != "return" &&
                 before_that_ != "else") ||
                before_that_ == "]")
                found_.defined.insert(before_);
        }
        before_that_ = std::move(before_);
        before_ = token.text;
    }

    Found found_;
    std::string before_, before_that_;  // the previous two tokens
    int in_macro_ = 0;                  // open brackets of a macro's arguments
};

/// Returns why a token of a C++ task reaches for a file; empty if it does not.
std::string reach_of(const CodeToken& token, const CodeToken* next) {
    if (token.kind == CodeToken::word) {
        for (const char* word : {"asm", "__asm", "__asm__", "__FILE__", "__FILE_NAME__", "__BASE_FILE__"})
            if (token.text == word) return fmt::format("has '{}', which can read files: a task is C++ alone", word);
    } else if (token.kind == CodeToken::literal) {
        for (const char* word : {".incbin", ".include"})
            if (token.text.find(word) != std::string::npos)
                return fmt::format("has '{}', by which an assembler reads files: a task is C++ alone", word);
    } else if (token.text == "#" && next && next->text == "#" && next->begin == token.end) {
        return "has '##': write each name as a whole";
    } else if (token.text == "%" && next && next->text == ":" && next->begin == token.end) {
        return "has '%:': write it as '#'";
    }
    if (token.kind == CodeToken::word && token.text.ends_with('R') && token.text.size() < 4 && next &&
        next->kind == CodeToken::literal && next->begin == token.end && next->text.starts_with('"'))
        return "has a raw string: write it as a plain one";
    return {};
}

/// Returns why a preprocessor line of a C++ task reads a file that is no header; empty if it does not.
std::string reach_of_directive(const CodeToken& directive) {
    const std::vector<CodeToken> tokens = tokens_of_directive(directive);
    for (size_t i = 0; i < tokens.size(); ++i)
        if (const std::string why = reach_of(tokens[i], i + 1 < tokens.size() ? &tokens[i + 1] : nullptr); !why.empty())
            return why;
    if (tokens.size() < 2) return {};
    const std::string& name = tokens[1].text;
    if (name == "embed") return "has '#embed', which reads a file: a task includes headers only";
    if (!name.starts_with("include") && name != "import") return {};
    const size_t begin = directive.text.find_first_not_of(" \t", directive.text.find(name) + name.size());
    const char quote = begin == std::string::npos ? '\0' : directive.text[begin];
    const size_t end = directive.text.find(quote == '<' ? '>' : '"', begin + 1);
    const bool is_named = (quote == '<' || quote == '"') && end != std::string::npos;
    const std::filesystem::path path = is_named ? directive.text.substr(begin + 1, end - begin - 1) : "";
    if (name != "include" || !is_named) return fmt::format("has an '#{}' without the name of a header", name);
    if (path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end())
        return fmt::format("includes {}: a task includes headers of the course by their names, without '..'",
                           path.string());
    return {};
}

}  // namespace

std::optional<SourceFault> fault_of_task(const std::string& text, const std::string& file) {
    if (auto fault = fault_of_source(text, file); fault || is_shader(file)) return fault;
    const std::vector<CodeToken> tokens = all_tokens(text);
    for (size_t i = 0; i < tokens.size(); ++i) {
        const CodeToken& token = tokens[i];
        if (token.kind == CodeToken::comment) continue;
        const std::string why = token.kind == CodeToken::directive
                                    ? reach_of_directive(token)
                                    : reach_of(token, i + 1 < tokens.size() ? &tokens[i + 1] : nullptr);
        if (why.empty()) continue;
        const size_t begin = token.begin == 0 ? 0 : text.rfind('\n', token.begin - 1) + 1,
                     end = std::min(text.find('\n', begin), text.size());
        return SourceFault{1 + int(std::count(text.begin(), text.begin() + long(begin), '\n')), why,
                           marked_line(text.substr(begin, end - begin), token.begin - begin)};
    }
    return {};
}

bool is_built_in_function(const std::string& name) { return built_in_functions().contains(name); }

OtherShaders::OtherShaders(const LabEntry& lab, const Manifest& manifest) {
    std::set<std::filesystem::path> taken;  // also the task files, which must not be read
    for (const TaskInfo& task : manifest.tasks) taken.insert(course_root() / task.file);
    lent_.insert(manifest.task_includes.begin(), manifest.task_includes.end());
    std::vector<std::filesystem::path> waiting;
    std::error_code ignored;  // a lab may have no shaders of its own
    for (const auto& entry : std::filesystem::directory_iterator(course_root() / "shaders" / lab.folder, ignored))
        if (entry.is_regular_file()) waiting.push_back(entry.path());
    for (const std::string& name : lent_) waiting.push_back(course_root() / "shaders" / name);
    while (!waiting.empty()) {
        const std::filesystem::path file = waiting.back();
        waiting.pop_back();
        if (!std::filesystem::is_regular_file(file, ignored) || !taken.insert(file).second) continue;
        const std::string text = read_file(file);
        add(text);
        for (const std::string& name : included_by(text)) waiting.push_back(course_root() / "shaders" / name);
    }
}

void OtherShaders::add(const std::string& text) {
    Found found = Look(text).take();
    words_.merge(found.words);
    called_.merge(found.called);
    defined_.merge(found.defined);
    tested_.merge(found.tested);
    macros_.merge(found.macros);
}

std::string broken_rule(const std::string& task_file, const OtherShaders& others) {
    for (const std::string& name : included_by(task_file))
        if (!others.lend(name)) return fmt::format("includes {}, which is not part of this task", name);
    const Found found = Look(task_file).take();
    if (found.joins_words) return "has '##': write each name as a whole";
    for (const std::string& word : found.words)
        if (others.switch_by(word) || word.starts_with("PROBE_") || word.starts_with("__"))
            return fmt::format("has '{}', by which the lab tells its programs apart: a task is the same in all of them",
                               word);
    for (const std::string& macro : found.macros)
        if (others.use(macro)) return fmt::format("defines '{}', which the lab's shaders use", macro);
    for (const std::string& name : found.defined)
        if (is_built_in_function(name) && others.call(name))
            return fmt::format("defines '{}', a function of the language that the lab's shaders call", name);
    for (const std::string& name : found.handed)
        if (is_built_in_function(name) && others.call(name))
            return fmt::format("has '{}' in a macro, without a '(' after it: that may define the function anew", name);
    if (!found.interface_word.empty())
        return fmt::format("has '{}' outside of a function: what a shader reads and writes is the lab's",
                           found.interface_word);
    return {};
}

}  // namespace relief::check
