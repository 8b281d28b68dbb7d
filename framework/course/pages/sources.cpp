#include "framework/course/pages/sources.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/course/manifest/toml_table.h"

namespace relief::pages {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Returns whether a byte can be part of a name. Bytes of UTF-8 above 127 count as letters.
bool is_letter(char c) { return static_cast<signed char>(c) < 0 || std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_name(char c) { return is_letter(c) || c == '-' || c == '\''; }

bool starts_year(std::string_view text, size_t at) {
    if (at + 4 > text.size() || (at > 0 && (is_letter(text[at - 1]) || is_digit(text[at - 1]) || text[at - 1] == '-')))
        return false;
    if (text.substr(at, 2) != "19" && text.substr(at, 2) != "20") return false;
    if (!is_digit(text[at + 2]) || !is_digit(text[at + 3])) return false;
    return at + 4 == text.size() || (!is_digit(text[at + 4]) && !is_letter(text[at + 4]));
}

/// Returns a list such as "A, B and C".
std::string list_of(std::span<const std::string> names) {
    if (names.size() < 2) return names.empty() ? "" : names[0];
    return join(names.first(names.size() - 1), ", ") + " and " + names.back();
}

/// Returns the ways to write the authors of a source in a text.
std::vector<std::string> ways_to_name(const Source& source) {
    const std::string& first = source.authors.front();
    std::vector<std::string> ways = {first};
    if (source.authors.size() > 1) ways.push_back(list_of(source.authors));
    if (source.authors.size() > 2) ways.insert(ways.end(), {first + " et al.", first + " and others"});
    return ways;
}

/// Returns the source of a year whose longest name ends at the end of `before`, and the length of that name.
std::pair<const Source*, size_t> named(std::string_view before, std::string_view year,
                                       std::span<const Source> sources) {
    std::pair<const Source*, size_t> best;
    for (const Source& source : sources) {
        if (source.year != year) continue;
        for (const std::string& way : ways_to_name(source)) {
            const bool is_whole = before.ends_with(way) &&
                                  (before.size() == way.size() || !is_name(before[before.size() - way.size() - 1]));
            if (is_whole && way.size() > best.second) best = {&source, way.size()};
        }
    }
    return best;
}

/// Returns the length of the capitalised word at the end of a text, with "et al." or "and others" after it; 0 if
/// there is none.
size_t length_of_name(std::string_view before) {
    size_t end = before.size();
    for (const std::string_view more : {" et al.", " and others"})
        if (before.ends_with(more)) end -= more.size();
    size_t begin = end;
    while (begin > 0 && is_name(before[begin - 1])) --begin;
    const bool is_capitalised = begin < end && (std::isupper(static_cast<unsigned char>(before[begin])) != 0 ||
                                                static_cast<signed char>(before[begin]) < 0);
    return is_capitalised && end - begin > 1 ? before.size() - begin : 0;
}

}  // namespace

std::vector<Source> parse_sources(const std::string& text, const std::filesystem::path& file) {
    std::vector<Source> sources;
    const toml::table parsed = parse_toml(text, file);
    for (const auto& [key, node] : parsed) {
        const int line = int(key.source().begin.line);
        if (!node.is_table()) throw Error({file, line}, fmt::format("{} is no entry", key.str()));
        Table table(file, *node.as_table(), fmt::format("[\"{}\"]", key.str()));
        Source& source = sources.emplace_back();
        source.key = key.str();
        table.read("authors", source.authors);
        source.title = table.text("title");
        source.in = table.text("in");
        table.read("doi", source.doi);
        table.finish();
        const std::string first = source.authors.empty() ? "" : source.authors.front() + " ";
        source.year = source.key.substr(std::min(first.size(), source.key.size()));
        if (first.empty() || !source.key.starts_with(first) || source.year.size() != 4 || !starts_year(source.year, 0))
            throw Error({file, line}, fmt::format("the key '{}' is not its first author and a year", source.key));
    }
    return sources;
}

std::vector<Source> load_sources() {
    const std::filesystem::path file = course_root() / "labs/sources.toml";
    return parse_sources(read_file(file), file);
}

std::string source_text(const Source& source) {
    return fmt::format("{}, \"{}\", {}, {}", list_of(source.authors), source.title, source.in, source.year);
}

std::vector<Citation> citations_in(std::string_view text, std::span<const Source> sources) {
    std::vector<Citation> citations;
    for (size_t at = 0; at < text.size(); ++at) {
        if (!starts_year(text, at)) continue;
        std::string_view before = text.substr(0, at);
        if (before.ends_with('(')) before.remove_suffix(1);
        if (!before.ends_with(' ')) continue;
        before.remove_suffix(1);
        if (before.ends_with(',')) before.remove_suffix(1);
        auto [source, length] = named(before, text.substr(at, 4), sources);
        if (!source) length = length_of_name(before);
        if (length > 0) citations.push_back({before.size() - length, at + 4, source});
    }
    return citations;
}

std::string with_sources(const std::string& handout, std::span<const Source> sources,
                         const std::filesystem::path& file) {
    std::vector<std::string> lines = split(handout, '\n');
    bool is_inside = false;
    for (size_t i = 0; i < lines.size(); ++i) {
        if (lines[i].starts_with("## ")) is_inside = lines[i] == "## Sources";
        if (!is_inside || !lines[i].starts_with("- ")) continue;
        const std::string item = lines[i].substr(2), key = item.substr(0, item.find(':'));
        const auto source =
            std::find_if(sources.begin(), sources.end(), [&](const Source& one) { return one.key == key; });
        if (source == sources.end()) {
            std::vector<std::string> keys;
            for (const Source& one : sources) keys.push_back(one.key);
            const auto near = nearest(key, keys);
            throw Error({file, int(i) + 1}, fmt::format("labs/sources.toml has no entry '{}'{}", key,
                                                        near ? fmt::format(": did you mean '{}'?", *near) : ""));
        }
        lines[i] = "- " + source_text(*source);
        if (!source->doi.empty()) lines[i] += fmt::format(", [doi:{0}](https://doi.org/{0})", source->doi);
        lines[i] += item.substr(key.size());
    }
    return join(lines, "\n");
}

}  // namespace relief::pages
