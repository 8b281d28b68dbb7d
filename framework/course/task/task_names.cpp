#include "framework/course/task/task_names.h"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "framework/core/base/text.h"

namespace relief::check {
namespace {

namespace fs = std::filesystem;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

std::string lower(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    return text;
}

std::string with_slashes(std::string name) {
    std::replace(name.begin(), name.end(), '\\', '/');
    return name;
}

bool leads_outside(const std::string& name) {
    const std::vector<std::string> parts = split(name, '/');
    return name.starts_with("/") || std::find(parts.begin(), parts.end(), "..") != parts.end();
}

/// Returns the name without the endings that editors and file managers append to a whole name, in lower case.
std::string without_appended(std::string name) {
    name = lower(std::move(name));
    for (bool again = true; again;) {
        again = false;
        for (const std::string ending : {".txt", ".bak", ".orig", ".old", "~"})
            if (name.size() > ending.size() && name.ends_with(ending)) {
                name.resize(name.size() - ending.size());
                again = true;
            }
    }
    return name;
}

/// Returns the number that begins at `at`, and the position behind it. Nothing for more than four digits.
std::optional<std::pair<int, size_t>> number_at(const std::string& text, size_t at) {
    size_t end = at;
    while (end < text.size() && is_digit(text[end])) ++end;
    if (end == at || end - at > 4) return {};
    return std::pair(std::stoi(text.substr(at, end - at)), end);
}

/// The lab of a task file: "shaders/03_height_to_normal/task.glsl" has the folder "03_height_to_normal".
std::string lab_of(const std::string& file) { return fs::path(file).parent_path().filename().string(); }
int lab_number(const std::string& file) {
    const auto number = number_at(lab_of(file), 0);
    return number ? number->first : -1;
}

/// Returns whether a folder's or a file's name, in lower case, names a lab: "lab03", "Lab 3", "03_height_to_normal",
/// "task03", "height_to_normal".
bool names_lab(const std::string& part, const std::string& file) {
    const std::string folder = lower(lab_of(file));
    const size_t bar = folder.find('_');
    if (part == folder || (bar != std::string::npos && part == folder.substr(bar + 1))) return true;
    const int number = lab_number(file);
    const auto is_it = [&](size_t at, size_t digits) {
        const auto found = number_at(part, at);
        return found && found->first == number && found->second - at >= digits;
    };
    if (is_it(0, 2)) return true;
    for (const auto& [word, digits] : {std::pair<std::string, size_t>("lab", 1), {"task", 2}})
        for (size_t at = part.find(word); at != std::string::npos; at = part.find(word, at + 1)) {
            if (at > 0 && is_letter(part[at - 1])) continue;
            size_t behind = at + word.size();
            while (behind < part.size() && (part[behind] == ' ' || part[behind] == '_' || part[behind] == '-'))
                ++behind;
            if (is_it(behind, digits)) return true;
        }
    return false;
}

/// Returns the numbers of the labs in lines such as `// TASK 3.1`.
std::set<int> labs_in_text(const std::string& text) {
    std::set<int> labs;
    const std::string word = "TASK ";
    for (size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
        if (const auto number = number_at(text, at + word.size()); number && number->second + 1 < text.size() &&
                                                                   text[number->second] == '.' &&
                                                                   is_digit(text[number->second + 1]))
            labs.insert(number->first);
    return labs;
}

/// Returns the only file, or nothing.
std::optional<std::string> only(const std::vector<std::string>& files) {
    return files.size() == 1 ? std::optional(files.front()) : std::nullopt;
}

}  // namespace

std::optional<std::string> task_file_of(const std::string& name, const std::set<std::string>& wanted) {
    const std::string path = with_slashes(name);
    if (leads_outside(path)) return {};
    for (const std::string& file : wanted)
        if (path == file || path.ends_with("/" + file)) return file;
    return {};
}

bool is_near_task_file(const std::string& name, const std::set<std::string>& wanted) {
    const std::string path = with_slashes(name);
    if (leads_outside(path) || task_file_of(path, wanted)) return false;
    if (("/" + path).find("/framework/") != std::string::npos) return false;  // files of the course itself
    const std::string last = without_appended(path.substr(path.rfind('/') + 1));
    const std::string stem = fs::path(last).stem().string(), ending = fs::path(last).extension().string();
    if (stem.starts_with(".")) return false;  // macOS writes it beside a file: ._task.glsl
    const auto has_ending = [&](const std::string& file) { return fs::path(file).extension() == ending; };
    if (std::none_of(wanted.begin(), wanted.end(), has_ending)) return false;
    if (const size_t at = stem.find("task"); at != std::string::npos && (at == 0 || !is_letter(stem[at - 1]))) {
        // "tasks" and "task2" are near, "tasking" is not.
        const size_t behind = at + 4 + (at + 4 < stem.size() && stem[at + 4] == 's');
        return behind >= stem.size() || !is_letter(stem[behind]);
    }
    return std::any_of(wanted.begin(), wanted.end(), [&](const std::string& file) { return names_lab(stem, file); });
}

std::optional<std::string> task_file_meant(const std::string& name, const std::string& text,
                                           const std::set<std::string>& wanted) {
    const std::string path = with_slashes(name);
    const size_t slash = path.rfind('/');
    const std::string last = without_appended(path.substr(slash + 1));
    const std::string ending = fs::path(last).extension().string();
    std::vector<std::string> alike;
    for (const std::string& file : wanted)
        if (fs::path(file).extension() == ending) alike.push_back(file);
    const auto those = [&](const auto& hold) {
        std::vector<std::string> files;
        std::copy_if(alike.begin(), alike.end(), std::back_inserter(files), hold);
        return files;
    };
    if (const std::set<int> labs = labs_in_text(text); labs.size() == 1)
        return only(those([&](const std::string& file) { return labs.contains(lab_number(file)); }));
    std::vector<std::string> parts =
        slash == std::string::npos ? std::vector<std::string>() : split(lower(path.substr(0, slash)), '/');
    parts.push_back(fs::path(last).stem().string());
    const std::vector<std::string> named = those([&](const std::string& file) {
        return std::any_of(parts.begin(), parts.end(), [&](const std::string& part) { return names_lab(part, file); });
    });
    return only(named.empty() ? alike : named);
}

CopyName copy_name(const std::string& name) {
    CopyName copy{name};
    const auto cut = [&](size_t length) {
        copy.original.resize(length);
        while (!copy.original.empty() && (copy.original.back() == ' ' || copy.original.back() == '_'))
            copy.original.pop_back();
    };
    std::string& rest = copy.original;
    const auto is_marked = [&](size_t digits, bool bracketed) {
        if (digits == 0) return false;
        const char before = rest[digits - 1];
        return bracketed ? before == '(' : before == '-';
    };
    {  // "(2)" and "-2"
        const bool bracketed = rest.ends_with(")");
        const size_t end = rest.size() - bracketed;
        size_t begin = end;
        while (begin > 0 && is_digit(rest[begin - 1])) --begin;
        if (begin < end && end - begin <= 4 && begin > 1 && is_marked(begin, bracketed)) {
            copy.number = std::stoi(rest.substr(begin, end - begin));
            cut(begin - 1);
        }
    }
    // "- Copy", which may stand before a number, and "copy 2"
    const std::string small = lower(rest);
    const size_t at = small.rfind("copy");
    if (at == std::string::npos || at < 2 || is_letter(small[at - 1])) return copy;
    size_t behind = at + 4;
    while (behind < small.size() && small[behind] == ' ') ++behind;
    const auto number = number_at(small, behind);
    if (behind < small.size() && (!number || number->second < small.size())) return copy;
    copy.number = number ? number->first : std::max(copy.number, 1);
    size_t length = at;
    while (length > 0 && (rest[length - 1] == ' ' || rest[length - 1] == '-' || rest[length - 1] == '_')) --length;
    if (length == 0) return {name};
    cut(length);
    return copy;
}

int copy_number(const std::string& path) {
    int number = 0;
    for (const std::string& part : split(with_slashes(path), '/')) {
        const size_t dot = part.find('.', 1);
        number = std::max(number, copy_name(part.substr(0, dot)).number);
    }
    return number;
}

}  // namespace relief::check
