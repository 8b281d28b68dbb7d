#include "framework/course/task/task_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "framework/core/base/text.h"

namespace relief::check {
namespace {

bool is_asked(const CodeDefinition& one, const CodeSignature& asked) {
    return one.kind == CodeDefinition::function && asked.fits(one.signature);
}

std::vector<CodeSignature> signatures_of(const TaskInfo& task) {
    std::vector<CodeSignature> signatures;
    for (const std::string& text : task.functions) signatures.push_back(parse_signature(text));
    return signatures;
}

int line_at(const std::string& text, size_t offset) {
    return 1 + int(std::count(text.begin(), text.begin() + std::ptrdiff_t(offset), '\n'));
}

/// A call of unfinished(), at an offset of the text. `is_behind`: a `return` of something else stands before it in the
/// same function.
struct UnfinishedCall {
    size_t at;
    bool is_behind;
};

void add_unfinished_calls(const std::vector<CodeToken>& code, std::vector<UnfinishedCall>& calls) {
    const auto is_call = [&](size_t i) {
        return i + 1 < code.size() && code[i].text == "unfinished" && code[i + 1].text == "(";
    };
    bool has_returned = false;
    for (size_t i = 0; i < code.size(); ++i) {
        if (is_call(i)) calls.push_back({code[i].begin, has_returned});
        if (code[i].text != "return") continue;
        bool returns_other = true;
        for (size_t k = i; k < code.size() && code[k].text != ";"; ++k) returns_other &= !is_call(k);
        has_returned |= returns_other;
    }
}

/// Returns the calls in the task's functions, or in the whole text for a task that names none.
std::vector<UnfinishedCall> unfinished_calls(const std::string& text, const TaskInfo& task) {
    const TaskText parts(text, {task}, task.file);
    std::vector<UnfinishedCall> calls;
    for (size_t i = 0; i < parts.definitions().size(); ++i)
        if (task.functions.empty() || parts.task_of_function(i) == task.id)
            add_unfinished_calls(parts.definitions()[i].tokens, calls);
    return calls;
}

}  // namespace

TaskText::TaskText(const std::string& text, const std::vector<TaskInfo>& tasks, const std::string& file)
    : definitions_(definitions_of(text).list), functions_(definitions_.size()), owners_(definitions_.size()) {
    for (const TaskInfo& task : tasks) {
        if (task.file != file) continue;
        for (const CodeSignature& asked : signatures_of(task))
            for (size_t i = 0; i < definitions_.size(); ++i)
                if (functions_[i].empty() && is_asked(definitions_[i], asked)) functions_[i] = task.id;
    }
    owners_ = functions_;
    for (const TaskInfo& task : tasks) {
        if (task.file != file) continue;
        const std::vector<bool> used = used_by_task(task.id);
        for (size_t i = 0; i < definitions_.size(); ++i)
            if (used[i] && owners_[i].empty()) owners_[i] = task.id;
    }
    // Stray code is the rest of the function before it.
    for (size_t i = 1; i < definitions_.size(); ++i)
        if (definitions_[i].kind == CodeDefinition::stray) owners_[i] = owners_[i - 1];
}

std::vector<bool> TaskText::used_by_task(const std::string& task) const {
    std::vector<bool> roots(definitions_.size()), barriers(definitions_.size());
    for (size_t i = 0; i < definitions_.size(); ++i) {
        roots[i] = functions_[i] == task;
        barriers[i] = !functions_[i].empty() || definitions_[i].kind == CodeDefinition::stray;
    }
    return used_by(definitions_, roots, barriers);
}

std::vector<std::string> missing_functions(const std::string& text, const TaskInfo& task) {
    const std::vector<CodeDefinition> list = definitions_of(text).list;
    std::vector<std::string> missing;
    for (const CodeSignature& asked : signatures_of(task))
        if (std::none_of(list.begin(), list.end(), [&](const CodeDefinition& one) { return is_asked(one, asked); }))
            missing.push_back(asked.text());
    return missing;
}

std::string missing_text(const std::string& text, const TaskInfo& task) {
    const std::vector<std::string> missing = missing_functions(text, task);
    if (missing.empty()) return {};
    return fmt::format("{} has no function `{}`, which task {} asks for: keep the names and signatures", task.file,
                       join(missing, "` and no `"), task.id);
}

bool is_unfinished(const std::string& text, const TaskInfo& task) {
    const std::vector<UnfinishedCall> calls = unfinished_calls(text, task);
    return std::any_of(calls.begin(), calls.end(), [](const UnfinishedCall& call) { return !call.is_behind; });
}

int line_of_unfinished(const std::string& text, const TaskInfo& task) {
    const std::vector<UnfinishedCall> calls = unfinished_calls(text, task);
    return calls.empty() ? 0 : line_at(text, calls.front().at);
}

std::string task_at_line(const std::string& text, const std::vector<TaskInfo>& tasks, const std::string& file,
                         size_t line) {
    const TaskText parts(text, tasks, file);
    size_t begin = 0;
    for (size_t number = 1; number < line && begin != std::string::npos; ++number) {
        begin = text.find('\n', begin);
        if (begin != std::string::npos) ++begin;
    }
    if (begin == std::string::npos || line == 0) return {};
    for (size_t i = 0; i < parts.definitions().size(); ++i)
        if (parts.definitions()[i].end > begin && !parts.owner(i).empty()) return parts.owner(i);
    return {};
}

int line_of_task(const std::string& text, const TaskInfo& task) {
    const TaskText parts(text, {task}, task.file);
    for (size_t i = 0; i < parts.definitions().size(); ++i)
        if (parts.task_of_function(i) == task.id) return line_at(text, parts.definitions()[i].begin);
    return 0;
}

}  // namespace relief::check
