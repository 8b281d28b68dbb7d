#include "framework/staff/grade/transplant.h"

#include <algorithm>
#include <map>
#include <set>

#include "framework/course/task/task_text.h"

namespace relief::grade {
namespace {

using check::TaskText;

std::string definition_text(const std::string& text, const CodeDefinition& one) {
    return text.substr(one.begin, one.end - one.begin);
}

/// Returns the text below the preprocessor's conditions of a definition.
std::string under_conditions(const CodeDefinition& one, const std::string& text) {
    std::string result;
    for (const std::string& condition : one.conditions) result += condition + '\n';
    result += text + '\n';
    for (size_t i = 0; i < one.conditions.size(); ++i) result += "#endif\n";
    return result;
}

class Transplant {
public:
    Transplant(const std::string& solution, const std::string& submitted, const std::vector<TaskInfo>& tasks,
               const TaskInfo& task)
        : solution_(solution),
          submitted_(submitted),
          task_(task.id),
          theirs_(solution, tasks, task.file),
          own_(submitted, tasks, task.file) {
        const std::vector<bool> used = own_.used_by_task(task_), unused = nobodys();
        for (size_t i = 0; i < used.size(); ++i) pieces_.push_back(new_piece(i, used[i], unused[i]));
        move_up();
        add_missing();
        if (is_shader(task.file)) add_prototypes();
    }

    std::string text() const {
        std::string text;
        size_t at = 0;
        for (size_t i = 0; i < pieces_.size(); ++i) {
            const CodeDefinition& own = own_.definitions()[i];
            text += submitted_.substr(at, own.begin - at) + pieces_[i].before + pieces_[i].text + pieces_[i].after;
            at = own.end;
            const bool is_gone = pieces_[i].before.empty() && pieces_[i].text.empty() && pieces_[i].after.empty();
            if (is_gone && (text.empty() || text.back() == '\n') && submitted_.compare(at, 1, "\n") == 0) ++at;
        }
        return text + submitted_.substr(at);
    }

private:
    /// The text that replaces a definition of the submission.
    struct Piece {
        std::string text;
        const CodeDefinition* is = nullptr;  ///< the definition in that text; null for an empty text
        std::string before = {}, after = {};
    };

    /// `is_nobodys`: see nobodys(); a definition of the solution's replaces it.
    Piece new_piece(size_t i, bool is_kept, bool is_nobodys) {
        const CodeDefinition& one = own_.definitions()[i];
        const std::string& function_of = own_.task_of_function(i);
        const bool is_nameless = one.kind == CodeDefinition::directive || one.kind == CodeDefinition::other;
        const bool is_own_stray = one.kind == CodeDefinition::stray && own_.owner(i) == task_;
        if (is_kept || function_of == task_ || is_nameless || is_own_stray || declares_function(one))
            return {definition_text(submitted_, one), &one};
        for (size_t k = 0; k < theirs_.definitions().size(); ++k) {
            const CodeDefinition& other = theirs_.definitions()[k];
            if (function_of.empty() ? other.key() == one.key()
                                    : theirs_.task_of_function(k) == function_of && other.names == one.names)
                return {definition_text(solution_, other), &other};
        }
        return is_nobodys ? Piece{definition_text(submitted_, one), &one} : Piece();
    }

    /// Returns for each definition of the submission whether it is a variable or type that no task uses, or such a one
    /// uses it. A variable's initializer runs all the same, and a type can keep the file from compiling.
    std::vector<bool> nobodys() const {
        const std::vector<CodeDefinition>& all = own_.definitions();
        std::vector<bool> roots(all.size()), barriers(all.size());
        for (size_t i = 0; i < all.size(); ++i) {
            const bool is_data = all[i].kind == CodeDefinition::variable || all[i].kind == CodeDefinition::type;
            roots[i] = is_data && own_.owner(i).empty();
            barriers[i] = !own_.task_of_function(i).empty();
        }
        std::vector<bool> kept = used_by(all, roots, barriers);
        for (size_t i = 0; i < all.size(); ++i) kept[i] = kept[i] || roots[i];
        return kept;
    }

    /// Returns whether it is the prototype of a task's function.
    bool declares_function(const CodeDefinition& one) const {
        if (one.kind != CodeDefinition::prototype) return false;
        for (size_t k = 0; k < theirs_.definitions().size(); ++k)
            if (!theirs_.task_of_function(k).empty() && theirs_.definitions()[k].names == one.names) return true;
        return false;
    }

    bool has(const CodeDefinition& other, const std::string& task) const {
        for (size_t i = 0; i < pieces_.size(); ++i) {
            if (!pieces_[i].is) continue;
            const bool is_same = task.empty() ? pieces_[i].is->key() == other.key()
                                              : own_.task_of_function(i) == task && pieces_[i].is->names == other.names;
            if (is_same) return true;
        }
        return false;
    }

    bool is_theirs(const CodeDefinition* one) const {
        const std::vector<CodeDefinition>& all = theirs_.definitions();
        return std::find_if(all.begin(), all.end(), [&](const CodeDefinition& other) { return &other == one; }) !=
               all.end();
    }

    /// Takes out a helper of the solution's that a function of the solution above it uses: add_missing() adds it above
    /// all functions.
    void move_up() {
        for (size_t i = 0; i < pieces_.size(); ++i) {
            if (!is_theirs(pieces_[i].is) || !own_.task_of_function(i).empty()) continue;
            const CodeDefinition& helper = *pieces_[i].is;
            const bool is_late = std::any_of(pieces_.begin(), pieces_.begin() + long(i), [&](const Piece& above) {
                return is_theirs(above.is) && above.is->kind == CodeDefinition::function &&
                       std::any_of(helper.names.begin(), helper.names.end(),
                                   [&](const std::string& name) { return above.is->words.contains(name); });
            });
            if (is_late) pieces_[i] = {};
        }
    }

    /// Adds the functions of other tasks that the submission lacks, and what these tasks need.
    void add_missing() {
        const std::vector<CodeDefinition>& theirs = theirs_.definitions();
        std::vector<bool> roots(theirs.size()), barriers(theirs.size());
        for (size_t k = 0; k < theirs.size(); ++k) {
            barriers[k] = !theirs_.task_of_function(k).empty();
            roots[k] = barriers[k] && theirs_.task_of_function(k) != task_;
        }
        const std::vector<bool> needed = used_by(theirs, roots, barriers);
        size_t first = pieces_.size(), last = pieces_.size();
        for (size_t i = 0; i < pieces_.size(); ++i) {
            if (!own_.definitions()[i].conditions.empty() || own_.task_of_function(i).empty()) continue;
            first = std::min(first, i), last = i;
        }
        if (first == pieces_.size()) return;
        for (size_t k = 0; k < theirs.size(); ++k) {
            const std::string& task = theirs_.task_of_function(k);
            if ((!roots[k] && !needed[k]) || has(theirs[k], task)) continue;
            const std::string text = under_conditions(theirs[k], definition_text(solution_, theirs[k]));
            if (roots[k])
                pieces_[last].after += '\n' + text, added_.push_back(&theirs[k]);
            else
                pieces_[first].before += text;
        }
    }

    /// Declares functions before the first definition that calls them, if they are defined below it.
    void add_prototypes() {
        struct Function {
            const CodeDefinition* is;
            size_t place;
        };
        std::map<std::string, Function> functions;
        for (size_t i = 0; i < pieces_.size(); ++i)
            if (pieces_[i].is && !own_.task_of_function(i).empty())
                functions[pieces_[i].is->names[0]] = {pieces_[i].is, i};
        for (const CodeDefinition* const one : added_) functions[one->names[0]] = {one, pieces_.size()};
        std::set<std::string> declared;
        for (size_t i = 0; i < pieces_.size(); ++i) {
            const CodeDefinition* const one = pieces_[i].is;
            if (!one) continue;
            if (one->kind == CodeDefinition::prototype) declared.insert(one->names[0]);
            for (const std::string& name : one->called) {
                const auto function = functions.find(name);
                if (function == functions.end() || function->second.place <= i) continue;
                if (function->second.is->conditions.empty() && declared.insert(name).second)
                    pieces_[i].before += prototype_of(*function->second.is);
            }
        }
    }

    std::string prototype_of(const CodeDefinition& one) const {
        return (is_theirs(&one) ? solution_ : submitted_).substr(one.begin, one.body - one.begin) + ";\n";
    }

    const std::string &solution_, &submitted_;
    std::string task_;
    TaskText theirs_, own_;
    std::vector<Piece> pieces_;  ///< one for each definition of the submission
    std::vector<const CodeDefinition*> added_;
};

}  // namespace

std::optional<std::string> with_one_task(const std::string& solution, const std::string& submitted,
                                         const std::vector<TaskInfo>& tasks, const TaskInfo& task) {
    if (task.functions.empty() || !check::missing_functions(submitted, task).empty()) return {};
    return Transplant(solution, submitted, tasks, task).text();
}

std::string without_task(const std::string& solution, const std::vector<TaskInfo>& tasks, const TaskInfo& task) {
    const TaskText parts(solution, tasks, task.file);
    std::string text;
    size_t at = 0;
    for (size_t i = 0; i < parts.definitions().size(); ++i) {
        if (parts.task_of_function(i) != task.id) continue;
        text += solution.substr(at, parts.definitions()[i].begin - at);
        at = parts.definitions()[i].end;
    }
    return text + solution.substr(at);
}

}  // namespace relief::grade
