#include "framework/staff/grade/transplant.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "framework/course/check/starter.h"

namespace relief::grade {
namespace {

using Names = std::set<std::string>;

bool is_of_a_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// One top-level definition in GLSL or C++: a function, a constant, a type, a macro, or an unnamed namespace with its
/// contents.
struct Definition {
    std::string text;
    Names defines;  ///< the defined names; empty if unknown
    Names uses;     ///< all words in the text
};

/// The definitions in one part of a task file. A part may close a bracket that an earlier part has opened; the text
/// after that bracket is ignored.
class Definitions {
public:
    explicit Definitions(std::string_view text) : text_(text) {
        while (step()) {
        }
    }
    const std::vector<Definition>& list() const { return list_; }
    /// Returns the position of the part's end, or of the bracket that closes an earlier part's.
    size_t end() const { return at_; }
    /// Returns whether the part has a directive other than #define, such as #if. Then no definition can be taken out of
    /// it.
    bool has_conditions() const { return has_conditions_; }

private:
    bool here(std::string_view word) const { return text_.substr(at_).starts_with(word); }
    void skip_to(std::string_view end) {
        const size_t found = text_.find(end, at_);
        at_ = found == std::string_view::npos ? text_.size() : found + end.size();
    }

    /// Reads a token, a comment or a preprocessor line. Returns false at the end.
    bool step() {
        if (at_ >= text_.size()) return false;
        const char c = text_[at_];
        if (here("//")) {
            skip_to("\n");
        } else if (here("/*")) {
            skip_to("*/");
        } else if (c == '#' && depth_ == 0 && words_.empty()) {
            directive();
        } else if (c == '"' || c == '\'') {
            for (++at_; at_ < text_.size() && text_[at_] != c; ++at_) at_ += text_[at_] == '\\';
            at_ = std::min(at_ + 1, text_.size());
        } else if (is_of_a_word(c)) {
            const size_t begin = begin_word();
            while (at_ < text_.size() && is_of_a_word(text_[at_])) ++at_;
            word(std::string(text_.substr(begin, at_ - begin)));
        } else if (c == '}' && depth_ == 0) {
            return false;
        } else {
            sign(c);
        }
        return true;
    }

    size_t begin_word() {
        if (words_.empty() && depth_ == 0) begin_ = at_;
        return at_;
    }

    void directive() {
        const size_t begin = at_;
        do {
            skip_to("\n");
        } while (at_ >= 2 && at_ < text_.size() && text_[at_ - 2] == '\\');
        const std::string_view line = text_.substr(begin, at_ - begin);
        Words words;
        for (size_t i = 0; i < line.size(); ++i) {
            if (!is_of_a_word(line[i])) continue;
            size_t end = i;
            while (end < line.size() && is_of_a_word(line[end])) ++end;
            words.emplace_back(line.substr(i, end - i));
            i = end;
        }
        has_conditions_ |= words.empty() || words.front() != "define";
        if (words.size() > 1 && words.front() == "define")
            list_.push_back({std::string(line), {words[1]}, Names(words.begin(), words.end())});
    }

    void word(const std::string& name) {
        words_.push_back(name);
        if (!is_named_) last_ = name;
        is_type_ |= depth_ == 0 && (name == "struct" || name == "class" || name == "enum" || name == "union");
        is_namespace_ |= depth_ == 0 && name == "namespace";
    }

    void sign(char c) {
        ++at_;
        const bool opens = c == '(' || c == '[' || c == '{', closes = c == ')' || c == ']' || c == '}';
        // The defined name precedes the first of these signs, also inside a namespace.
        if ((opens || c == '=' || c == ';') && !is_named_ && depth_ == (is_namespace_ ? 1 : 0) && !last_.empty()) {
            if (!(is_namespace_ && depth_ == 0)) names_.insert(last_), is_named_ = true;
        }
        depth_ += opens, depth_ -= closes;
        if (is_namespace_ && depth_ == 1 && (c == ';' || c == '}')) is_named_ = false;
        if (depth_ == 0 && (c == ';' || (c == '}' && !is_type_ && !ends_later()))) finish();
    }

    /// Returns whether the definition continues after the closing brace: a ';' or ',' follows.
    bool ends_later() const {
        const size_t next = text_.find_first_not_of(" \t\r\n", at_);
        return next != std::string_view::npos && (text_[next] == ';' || text_[next] == ',');
    }

    void finish() {
        if (!words_.empty())
            list_.push_back({std::string(text_.substr(begin_, at_ - begin_)) + '\n', std::move(names_),
                             Names(words_.begin(), words_.end())});
        words_.clear(), names_ = {}, last_.clear();
        is_named_ = is_type_ = is_namespace_ = false;
    }

    using Words = std::vector<std::string>;
    std::string_view text_;
    size_t at_ = 0, begin_ = 0;
    int depth_ = 0;
    Words words_;
    Names names_;
    std::string last_;
    bool is_named_ = false, is_type_ = false, is_namespace_ = false, has_conditions_ = false;
    std::vector<Definition> list_;
};

bool have_common(const Names& some, const Names& others) {
    return std::any_of(some.begin(), some.end(), [&](const std::string& one) { return others.contains(one); });
}

Names words_of(std::string_view text) {
    Names words;
    for (size_t i = 0; i < text.size(); ++i) {
        size_t end = i;
        while (end < text.size() && is_of_a_word(text[end])) ++end;
        if (end > i) words.emplace(text.substr(i, end - i));
        i = end;
    }
    return words;
}

/// Returns for each submitted part the text of the definitions that the task needs from it. These are used by the task
/// directly or through each other, and the solution does not define them.
std::vector<std::string> helpers(const std::vector<check::TaskPart>& submitted, const std::string& task,
                                 const std::vector<check::TaskPart>& solution) {
    Names known, wanted;
    for (const check::TaskPart& part : solution) {
        const Definitions definitions(part.text);
        for (const Definition& one : definitions.list()) known.insert(one.defines.begin(), one.defines.end());
    }
    std::vector<std::vector<Definition>> candidates;
    for (const check::TaskPart& part : submitted) {
        std::vector<Definition>& own = candidates.emplace_back();
        if (part.task == task) wanted = words_of(part.text);
        if (part.task.empty() || part.task == task) continue;
        const Definitions definitions(part.text);
        if (!definitions.has_conditions()) own = definitions.list();
        std::erase_if(own, [&](const Definition& one) { return have_common(one.defines, known); });
    }
    for (size_t before = 0; before != wanted.size();) {
        before = wanted.size();
        for (const std::vector<Definition>& part : candidates)
            for (const Definition& one : part)
                if (have_common(one.defines, wanted)) wanted.insert(one.uses.begin(), one.uses.end());
    }
    std::vector<std::string> texts;
    for (const std::vector<Definition>& part : candidates) {
        std::string& text = texts.emplace_back();
        for (const Definition& one : part)
            if (have_common(one.defines, wanted)) text += one.text;
    }
    return texts;
}

}  // namespace

std::optional<std::string> with_one_task(const std::string& solution, const std::string& submitted,
                                         const std::string& task) {
    const std::vector<check::TaskPart> own = check::task_parts(submitted), others = check::task_parts(solution);
    const auto part_of = [&](const std::string& id) {
        return std::find_if(own.begin(), own.end(), [&](const check::TaskPart& one) { return one.task == id; });
    };
    if (task.empty() || part_of(task) == own.end()) return {};
    const std::vector<std::string> used = helpers(own, task, others);
    std::string text;
    for (const check::TaskPart& part : others) {
        const auto mine = part_of(part.task);
        if (part.task.empty() || part.task == task) {
            text += mine->text;
            continue;
        }
        const std::string& more = mine == own.end() ? std::string() : used[size_t(mine - own.begin())];
        const size_t end = more.empty() ? part.text.size() : Definitions(part.text).end();
        text += part.text.substr(0, end) + more + part.text.substr(end);
    }
    return text;
}

}  // namespace relief::grade
