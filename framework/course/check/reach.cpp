#include "framework/course/check/reach.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <vector>

#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/core/gl/shader_source.h"

namespace relief::check {
namespace {

bool is_of_a_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// Returns the text as the compiler reads it: joins lines at a backslash, and replaces each comment with white space.
std::string without_comments(const std::string& text) {
    std::string joined, plain;
    for (size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\r') continue;
        if (text[i] == '\\' && text.find_first_not_of('\r', i + 1) < text.size() &&
            text[text.find_first_not_of('\r', i + 1)] == '\n')
            i = text.find('\n', i);
        else
            joined += text[i];
    }
    for (size_t i = 0; i < joined.size(); ++i) {
        if (joined.compare(i, 2, "//") == 0) {
            i = std::min(joined.find('\n', i), joined.size());
            plain += '\n';
        } else if (joined.compare(i, 2, "/*") == 0) {
            i = std::min(joined.find("*/", i + 2), joined.size() - 1) + 1;
            plain += ' ';
        } else {
            plain += joined[i];
        }
    }
    return plain;
}

/// Splits a line into words and single other characters, without white space.
std::vector<std::string> tokens_of(std::string_view line) {
    std::vector<std::string> tokens;
    for (size_t i = 0; i < line.size(); ++i) {
        if (std::isspace(static_cast<unsigned char>(line[i]))) continue;
        size_t end = i + 1;
        while (is_of_a_word(line[i]) && end < line.size() && is_of_a_word(line[end])) ++end;
        tokens.emplace_back(line.substr(i, end - i));
        i = end - 1;
    }
    return tokens;
}

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

Found look(const std::string& text) {
    Found found;
    std::string before, before_that;  // the previous two tokens
    int in_macro = 0;                 // open brackets of a macro's arguments
    for (const std::string& line : split(without_comments(text), '\n')) {
        const std::vector<std::string> tokens = tokens_of(line);
        const bool is_directive = tokens.size() > 1 && tokens[0] == "#";
        const bool is_definition = is_directive && tokens.size() > 2 && (tokens[1] == "define" || tokens[1] == "undef");
        if (is_definition) found.macros.insert(tokens[2]);
        found.joins_words |= line.find("##") != std::string::npos;
        if (is_directive && (tokens[1].starts_with("if") || tokens[1] == "elif")) {
            for (size_t i = 2; i < tokens.size(); ++i)
                if (is_of_a_word(tokens[i][0]) && !std::isdigit(static_cast<unsigned char>(tokens[i][0])) &&
                    tokens[i] != "defined")
                    found.tested.insert(tokens[i]);
            found.words.insert(found.tested.begin(), found.tested.end());
            continue;
        }
        for (size_t i = 0; i < tokens.size(); ++i) {
            const std::string& token = tokens[i];
            const bool is_argument =
                before == "(" || before == "," || (before == "const" && (before_that == "(" || before_that == ","));
            if (found.interface_word.empty() &&
                std::find(interface_words.begin(), interface_words.end(), token) != interface_words.end() &&
                (!is_argument || (token != "in" && token != "out" && token != "inout")))
                found.interface_word = token;
            const bool is_word = is_of_a_word(token[0]), is_called = i + 1 < tokens.size() && tokens[i + 1] == "(";
            if (is_word) found.words.insert(token);
            if (is_word && !is_called && (in_macro > 0 || (is_definition && i > 2))) found.handed.insert(token);
            if (token == "(" && (in_macro > 0 || (!is_directive && found.macros.contains(before)))) ++in_macro;
            if (token == ")" && in_macro > 0) --in_macro;
            if (token == "(" && !before.empty() && is_of_a_word(before[0])) {
                found.called.insert(before);
                // "float f(" and "float[2] f(", but not "return f(".
                if ((is_of_a_word(before_that.empty() ? ' ' : before_that[0]) && before_that != "return" &&
                     before_that != "else") ||
                    before_that == "]")
                    found.defined.insert(before);
            }
            before_that = std::move(before);
            before = token;
        }
    }
    return found;
}

}  // namespace

bool is_built_in_function(const std::string& name) {
    static const std::vector<std::string> list = split(
        "abs acos acosh all any asin asinh atan atanh bitCount bitfieldExtract bitfieldInsert bitfieldReverse ceil "
        "clamp cos cosh cross dFdx dFdy degrees determinant distance dot equal exp exp2 faceforward findLSB findMSB "
        "floatBitsToInt floatBitsToUint floor fma fract frexp fwidth greaterThan greaterThanEqual imulExtended "
        "intBitsToFloat interpolateAtCentroid interpolateAtOffset interpolateAtSample inverse inversesqrt isinf isnan "
        "ldexp length lessThan lessThanEqual log log2 matrixCompMult max min mix mod modf normalize not notEqual "
        "outerProduct packDouble2x32 packSnorm4x8 packUnorm2x16 packUnorm4x8 pow radians reflect refract round "
        "roundEven sign sin sinh smoothstep sqrt step tan tanh texelFetch texelFetchOffset texture textureGather "
        "textureGatherOffset textureGatherOffsets textureGrad textureGradOffset textureLod textureLodOffset "
        "textureOffset textureProj textureProjGrad textureProjGradOffset textureProjLod textureProjLodOffset "
        "textureProjOffset textureQueryLod textureSize transpose trunc uaddCarry uintBitsToFloat umulExtended "
        "unpackDouble2x32 unpackUnorm2x16 unpackUnorm4x8 unpackSnorm4x8 usubBorrow",
        ' ');
    static const std::set<std::string> names(list.begin(), list.end());
    return names.contains(name);
}

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
    Found found = look(text);
    words_.merge(found.words);
    called_.merge(found.called);
    defined_.merge(found.defined);
    tested_.merge(found.tested);
    macros_.merge(found.macros);
}

std::string reaches_beyond(const std::string& task_file, const OtherShaders& others) {
    for (const std::string& name : included_by(task_file))
        if (!others.lend(name)) return fmt::format("includes {}, which is not part of this task", name);
    const Found found = look(task_file);
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
