#include "framework/course/task/starter.h"

#include <algorithm>

#include "framework/core/base/error.h"
#include "framework/core/base/text.h"

namespace relief::check {
namespace {

namespace fs = std::filesystem;

enum class TextPart { shared, solution, starter };

std::string_view without_blanks(std::string_view line) {
    const size_t begin = line.find_first_not_of(" \t\r"), end = line.find_last_not_of(" \t\r");
    return begin == std::string_view::npos ? std::string_view() : line.substr(begin, end + 1 - begin);
}

/// Calls take(part, line, region) for each line that is not a mark; the region's name is empty outside of any.
template <class Take>
void walk(const std::string& text, const fs::path& file, Take take) {
    TextPart part = TextPart::shared;
    int number = 0, opened = 0, region_opened = 0;
    std::string region;
    const auto expect = [&](bool good, const char* message) {
        if (!good) throw Error({file, number}, message);
    };
    for (const std::string& line : split(text, '\n')) {
        ++number;
        const std::string_view word = without_blanks(line);
        if (word == "//[solution") {
            expect(part == TextPart::shared, "a //[solution inside another: close that with //] first");
            part = TextPart::solution;
            opened = number;
        } else if (word == "//]starter") {
            expect(part == TextPart::solution, "a //]starter without its //[solution");
            part = TextPart::starter;
        } else if (word == "//]") {
            expect(part != TextPart::shared, "a //] without its //[solution");
            part = TextPart::shared;
        } else if (word.starts_with("//(")) {
            expect(word.size() > 3, "a region has a name: //(name");
            expect(region.empty(), "a //( inside another: close that with //) first");
            expect(part == TextPart::shared, "a region begins and ends outside of solutions");
            region = word.substr(3);
            region_opened = number;
        } else if (word == "//)") {
            expect(!region.empty(), "a //) without its //(name");
            expect(part == TextPart::shared, "a region begins and ends outside of solutions");
            region.clear();
        } else {
            expect(part != TextPart::starter || word.starts_with("//|"), "a line of a starter begins with //|");
            take(part, line, region);
        }
    }
    if (!region.empty()) throw Error({file, region_opened}, "this //( is never closed by //)");
    if (part != TextPart::shared) throw Error({file, opened}, "this //[solution is never closed by //]");
}

}  // namespace

std::string starter_of(const std::string& text, const fs::path& file) {
    std::string result;
    walk(text, file, [&](TextPart part, const std::string& line, const std::string&) {
        if (part == TextPart::solution) return;
        const size_t bar = part == TextPart::starter ? line.find("//|") : std::string::npos;
        if (bar == std::string::npos) {
            result += line + '\n';
            return;
        }
        std::string rest = line.substr(bar + 3);
        if (rest.starts_with(" ")) rest.erase(0, 1);
        result += without_blanks(rest).empty() ? "\n" : line.substr(0, bar) + rest + '\n';
    });
    result.pop_back();  // split() sees one line more than there are line ends
    return result;
}

std::string solution_of(const std::string& text, const fs::path& file) {
    std::string result;
    walk(text, file, [&](TextPart part, const std::string& line, const std::string&) {
        if (part != TextPart::starter) result += line + '\n';
    });
    result.pop_back();
    return result;
}

std::vector<std::string> solution_lines(const std::string& text, const fs::path& file) {
    std::vector<std::string> result;
    walk(text, file, [&](TextPart part, const std::string& line, const std::string&) {
        if (part == TextPart::solution && !without_blanks(line).empty()) result.emplace_back(without_blanks(line));
    });
    return result;
}

Region region_of(const std::string& text, const fs::path& file, const std::string& name) {
    Region found;
    std::vector<std::string> lines, names;
    size_t margin = std::string::npos;
    walk(text, file, [&](TextPart part, const std::string& line, const std::string& region) {
        if (!region.empty() && (names.empty() || names.back() != region)) names.push_back(region);
        if (region != name || part == TextPart::starter) return;
        found.has_solution |= part == TextPart::solution;
        lines.push_back(line);
        margin = std::min(margin, line.find_first_not_of(' '));
    });
    if (name.empty() || lines.empty()) throw Error({file}, unknown("region", name, names));
    for (const std::string& line : lines) found.text += line.substr(std::min(margin, line.size())) + '\n';
    return found;
}

std::vector<TaskPart> task_parts(const std::string& text) {
    std::vector<TaskPart> parts = {{"", ""}};
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
                    std::none_of(parts.begin(), parts.end(), [&](const TaskPart& one) { return one.task == id; }))
                    parts.push_back({id, ""});
            }
        }
        parts.back().text += line;
        begin = end;
    }
    return parts;
}

}  // namespace relief::check
