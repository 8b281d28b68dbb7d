#include "framework/staff/originality/winnowing.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>

#include "framework/core/base/text.h"
#include "framework/course/task/code_definitions.h"
#include "framework/course/task/rules.h"
#include "framework/course/task/starter.h"

namespace relief::grade {
namespace {

using Code = std::vector<CodeToken>;

bool is_here(const Code& code, size_t i, std::string_view text) { return i < code.size() && code[i].text == text; }

bool is_word_of_the_language(const std::string& word) {
    static const auto words = [] {
        const std::vector<std::string> list = split(
            "auto bool break bvec2 bvec3 bvec4 case class const constexpr continue default discard do dmat2 dmat3 "
            "dmat4 "
            "double dvec2 dvec3 dvec4 else enum false float for if in inout int ivec2 ivec3 ivec4 long mat2 mat2x2 "
            "mat2x3 mat2x4 mat3 mat3x2 mat3x3 mat3x4 mat4 mat4x2 mat4x3 mat4x4 namespace out return sampler2D "
            "sampler2DArray sampler2DShadow samplerCube size_t static static_cast std struct switch template true "
            "typename uint unsigned using uvec2 uvec3 uvec4 vec2 vec3 vec4 void while",
            ' ');
        return std::set<std::string>(list.begin(), list.end());
    }();
    return words.contains(word) || word.starts_with("gl_");
}

/// Returns the number's value, so that all its spellings are equal.
std::string value_of(std::string text) {
    if (text.starts_with("0x") || text.starts_with("0X")) return text;
    while (!text.empty() && std::string_view("fFuUlL").find(text.back()) != std::string_view::npos) text.pop_back();
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() ? fmt::format("{}", value) : text;
}

/// Returns a swizzle with the letters of a position: "xyz" for "rgb". Nothing for any other name.
std::string swizzle(const std::string& name) {
    for (const std::string_view letters : {"xyzw", "rgba", "stpq"})
        if (name.size() <= 4 && name.find_first_not_of(letters) == std::string::npos) {
            std::string position;
            for (const char c : name) position += "xyzw"[letters.find(c)];
            return position;
        }
    return {};
}

std::string normal_form(const Code& code, size_t i, const GivenNames& given) {
    const std::string& text = code[i].text;
    if (code[i].kind == CodeToken::number) return value_of(text);
    if (code[i].kind == CodeToken::symbol || is_word_of_the_language(text)) return text;
    const bool is_member =
        i > 0 && (code[i - 1].text == "." || (i > 1 && code[i - 1].text == ">" && code[i - 2].text == "-"));
    const bool is_scoped =
        (i > 0 && code[i - 1].text == ":") || (is_here(code, i + 1, ":") && is_here(code, i + 2, ":"));
    const bool is_called = is_here(code, i + 1, "(");
    if (is_scoped) return text;
    if (is_member) {
        if (given.has_field(text) || is_called) return text;
        const std::string position = swizzle(text);
        return position.empty() ? "I" : position;
    }
    if (is_called && (check::is_built_in_function(text) || given.has_function(text))) return text;
    return given.has_global(text) ? text : "I";
}

}  // namespace

void GivenNames::add(const std::string& text) {
    const Code code = code_tokens(text);
    int depth = 0;
    bool is_struct = false;
    for (size_t i = 0; i < code.size(); ++i) {
        const std::string& token = code[i].text;
        is_struct |= depth == 0 && (token == "struct" || token == "class" || token == "enum");
        if (code[i].kind == CodeToken::word) {
            if (i > 0 && code[i - 1].text == ".")
                fields_.insert(token);
            else if (is_here(code, i + 1, "("))
                functions_.insert(token);
            else if (depth == 0)
                globals_.insert(token);
            else if (is_struct && (is_here(code, i + 1, ";") || is_here(code, i + 1, ",") || is_here(code, i + 1, "=")))
                fields_.insert(token);
        }
        const bool is_namespace =
            i > 1 && token == "{" && depth == 0 &&
            (code[i - 1].text == "namespace" || code[i - 2].text == "namespace" || code[i - 2].text == ":");
        if ((token == "{" && !is_namespace) || token == "(") ++depth;
        if ((token == "}" || token == ")") && depth > 0) --depth;
        if (depth == 0 && token == ";") is_struct = false;
    }
}

std::vector<NormalToken> normal_tokens(const std::string& text, const GivenNames& given) {
    const Code code = code_tokens(text);
    std::vector<NormalToken> tokens;
    for (size_t i = 0; i < code.size(); ++i)
        tokens.push_back({normal_form(code, i, given), code[i].begin, code[i].end});
    return tokens;
}

std::map<std::string, std::string> tasks_of_functions(const std::string& starter) {
    std::map<std::string, std::string> tasks;
    for (const check::TaskPart& part : check::task_parts(starter))
        if (!part.task.empty())
            for (const CodeDefinition& one : definitions_of(part.text).list)
                if (one.kind == CodeDefinition::function) tasks.emplace(one.signature.name, part.task);
    return tasks;
}

namespace {

/// Returns the task of each definition: of the starter's functions, then of what they use, then of the next function.
std::vector<std::string> owners(const std::vector<CodeDefinition>& list,
                                const std::map<std::string, std::string>& task_of_function) {
    std::vector<std::string> tasks(list.size());
    std::vector<bool> barriers(list.size());
    std::set<std::string> known;
    for (size_t i = 0; i < list.size(); ++i) {
        const auto own = task_of_function.find(list[i].signature.name);
        barriers[i] = list[i].kind == CodeDefinition::function && own != task_of_function.end();
        if (!barriers[i]) continue;
        tasks[i] = own->second;
        known.insert(own->second);
    }
    const std::vector<std::string> functions = tasks;
    for (const std::string& task : known) {
        std::vector<bool> roots(list.size());
        for (size_t i = 0; i < list.size(); ++i) roots[i] = functions[i] == task;
        const std::vector<bool> used = used_by(list, roots, barriers);
        for (size_t i = 0; i < list.size(); ++i)
            if (used[i] && tasks[i].empty()) tasks[i] = task;
    }
    for (size_t i = list.size(); i-- > 1;)
        if (tasks[i - 1].empty()) tasks[i - 1] = tasks[i];
    return tasks;
}

}  // namespace

std::map<std::string, TaskCode> code_by_task(const std::string& text,
                                             const std::map<std::string, std::string>& task_of_function,
                                             const GivenNames& given) {
    std::map<std::string, TaskCode> tasks;
    const std::vector<CodeDefinition> list = definitions_of(text).list;
    const std::vector<std::string> task_of = owners(list, task_of_function);
    for (size_t i = 0; i < list.size(); ++i) {
        const Code& code = list[i].tokens;
        if (task_of[i].empty() || code.empty()) continue;
        TaskCode& task = tasks[task_of[i]];
        task.pieces.push_back({list[i].begin, list[i].end});
        for (size_t k = 0; k < code.size(); ++k)
            task.tokens.push_back({normal_form(code, k, given), code[k].begin, code[k].end});
    }
    return tasks;
}

std::vector<uint64_t> gram_hashes(const std::vector<NormalToken>& tokens) {
    std::vector<uint64_t> hashes;
    for (size_t i = 0; i + gram_tokens <= tokens.size(); ++i) {
        uint64_t hash = 0xcbf29ce484222325u;  // FNV-1a
        const auto add = [&](char c) { hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u; };
        for (size_t k = i; k < i + gram_tokens; ++k) {
            for (const char c : tokens[k].text) add(c);
            add(' ');
        }
        // FNV's high bits depend little on the last characters, so mix them (the end of MurmurHash3).
        hash = (hash ^ hash >> 33) * 0xff51afd7ed558ccdu;
        hashes.push_back(hash ^ hash >> 33);
    }
    return hashes;
}

std::vector<CodeFingerprint> winnow(const std::vector<uint64_t>& grams, const Grams& given) {
    std::vector<CodeFingerprint> taken;
    for (size_t begin = 0; begin < grams.size(); ++begin) {
        const size_t end = std::min(begin + window_grams, grams.size());
        if (begin > 0 && begin + window_grams > grams.size()) break;
        size_t least = end;
        for (size_t i = begin; i < end; ++i)
            if (!given.contains(grams[i]) && (least == end || grams[i] <= grams[least])) least = i;
        if (least < end && (taken.empty() || taken.back().token < least)) taken.push_back({grams[least], least});
    }
    return taken;
}

}  // namespace relief::grade
