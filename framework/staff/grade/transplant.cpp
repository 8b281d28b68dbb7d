#include "framework/staff/grade/transplant.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>
#include <vector>

namespace relief {
namespace {

/// The text before the first task, with an empty id, and the tasks' parts. What names a task again belongs to the part
/// that it stands in.
std::vector<std::pair<std::string, std::string>> parts_of(const std::string& text) {
    std::vector<std::pair<std::string, std::string>> parts = {{"", ""}};
    for (size_t begin = 0; begin < text.size();) {
        const size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
        const std::string_view line = std::string_view(text).substr(begin, end - begin);
        size_t at = std::min(line.find_first_not_of(" \t"), line.size());
        if (line.substr(at).starts_with("//")) {
            at = std::min(line.find_first_not_of("/ \t", at), line.size());
            if (line.substr(at).starts_with("TASK ")) {
                at += 5;
                size_t after = at;
                while (after < line.size() &&
                       (std::isdigit(static_cast<unsigned char>(line[after])) || line[after] == '.'))
                    ++after;
                while (after > at && line[after - 1] == '.') --after;  // the end of a sentence
                const std::string id(line.substr(at, after - at));
                if (!id.empty() &&
                    std::none_of(parts.begin(), parts.end(), [&](const auto& one) { return one.first == id; }))
                    parts.emplace_back(id, "");
            }
        }
        parts.back().second += line;
        begin = end;
    }
    return parts;
}

}  // namespace

std::optional<std::string> with_one_task(const std::string& solution, const std::string& submitted,
                                         const std::string& task) {
    const auto own = parts_of(submitted);
    const auto part = std::find_if(own.begin() + 1, own.end(), [&](const auto& one) { return one.first == task; });
    if (part == own.end()) return {};
    std::string text;
    for (const auto& [id, lines] : parts_of(solution))
        text += id.empty() ? own.front().second : id == task ? part->second : lines;
    return text;
}

}  // namespace relief
