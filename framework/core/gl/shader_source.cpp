#include "framework/core/gl/shader_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <sstream>

#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"

namespace relief {
namespace {

namespace fs = std::filesystem;

constexpr const char* must_begin = "a stage must begin with #version 410 core";

std::string without_indent(const std::string& line) {
    const size_t begin = line.find_first_not_of(" \t");
    return begin == std::string::npos ? "" : line.substr(begin);
}

std::vector<std::string> names_of_shaders() {
    const fs::path shaders = course_root() / "shaders";
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(shaders))
        if (entry.is_regular_file()) names.push_back(entry.path().lexically_relative(shaders).string());
    std::sort(names.begin(), names.end());
    return names;
}

fs::path find_include(const std::string& name, const Place& from) {
    for (const fs::path& folder : {from.file.parent_path(), course_root() / "shaders"}) {
        const fs::path candidate = (folder / name).lexically_normal();
        std::error_code ignored;
        if (fs::is_regular_file(candidate, ignored)) return candidate;
    }
    const auto guess = nearest(name, names_of_shaders());
    throw Error(from, fmt::format("cannot find the included file \"{}\"{}", name,
                                  guess ? fmt::format(": did you mean \"{}\"?", *guess) : ""));
}

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

// No std::regex: it recurses once per character and would overflow the stack on a long line.
void collect_names(const std::string& text, std::set<std::string>& names) {
    for (size_t begin = 0; begin < text.size();) {
        size_t end = begin;
        while (end < text.size() && is_word(text[end])) ++end;
        const std::string_view word(text.data() + begin, end - begin);
        if (word.size() > 2 && (word.starts_with("u_") || word.starts_with("s_"))) names.emplace(word);
        begin = end + 1;
    }
}

/// Accepts `#version 410 core` with any spacing. A newer version would not run on every student's machine.
bool is_version_410(const std::string& line) {
    std::istringstream words(line);
    std::string directive, number, profile;
    words >> directive >> number >> profile;
    return directive == "#version" && number == "410" && profile == "core";
}

/// Accepts `#include` and `# include`: the language allows blanks after the # of any directive.
bool is_include(const std::string& line) {
    return line.starts_with("#") && without_indent(line.substr(1)).starts_with("include");
}

/// Returns the name in `#include "name"`. Only a comment may follow it.
std::optional<std::string> included_name(const std::string& line) {
    const size_t open = line.find_first_not_of(" \t", line.find("include") + std::string_view("include").size());
    if (open == std::string::npos || line[open] != '"') return {};
    const size_t close = line.find('"', open + 1);
    if (close == std::string::npos) return {};
    const std::string rest = without_indent(line.substr(close + 1));
    if (!rest.empty() && !rest.starts_with("//")) return {};
    return line.substr(open + 1, close - open - 1);
}

/// A compiler's message: Mesa's "0:12(5): error: x", Nvidia's "0(12) : error C1: x", Apple's "ERROR: 0:12: x".
struct LogLine {
    std::optional<int> line;  ///< in the compiled text
    int column = 0;           ///< from 1; 0 if the compiler reports none
    std::string message;
    bool is_warning = false;
};

LogLine parse_log_line(const std::string& whole) {
    std::string_view rest(whole);
    const auto skip = [&](std::string_view text) {
        const bool found = rest.starts_with(text);
        if (found) rest.remove_prefix(text.size());
        return found;
    };
    const auto number = [&]() -> std::optional<int> {
        const size_t end = std::min(rest.find_first_not_of("0123456789"), rest.size());
        const auto value = parse_int(rest.substr(0, end));
        const bool digits = end > 0;
        rest.remove_prefix(end);
        return digits ? value.value_or(0) : std::optional<int>();
    };
    LogLine result{.line = {}, .message = whole, .is_warning = whole.starts_with("WARNING")};
    skip("ERROR: ") || skip("WARNING: ");
    if (!number()) return result;
    std::optional<int> line;
    if (skip(":")) {
        line = number();
        if (line && skip("(")) {
            const auto column = number();
            if (!column || !skip(")")) return result;
            result.column = *column;
        }
    } else if (skip("(")) {
        line = number();
        if (!skip(")")) return result;
    }
    skip(" ");
    if (!line || !skip(":")) return result;
    result.line = line;
    result.message = without_indent(std::string(rest));
    result.is_warning |= result.message.starts_with("warning");
    return result;
}

bool ends_in_comment(const std::string& line, bool inside) {
    for (size_t i = 0; i + 1 < line.size(); ++i) {
        if (!inside && line[i] == '/' && line[i + 1] == '/') return false;
        if (!inside && line[i] == '/' && line[i + 1] == '*')
            inside = true, ++i;
        else if (inside && line[i] == '*' && line[i + 1] == '/')
            inside = false, ++i;
    }
    return inside;
}

/// Calls `take` with each line, without a carriage return and without a UTF-8 byte order mark.
template <class Take>
void each_line(const std::string& text, Take take) {
    std::istringstream lines(text);
    std::string line;
    bool in_comment = false;
    for (int number = 1; std::getline(lines, line); ++number) {
        if (line.ends_with('\r')) line.pop_back();  // written on Windows
        if (number == 1 && line.starts_with("\xef\xbb\xbf")) line.erase(0, 3);
        take(line, number, in_comment);
        in_comment = ends_in_comment(line, in_comment);
    }
}

class Loader {
public:
    explicit Loader(const std::vector<std::string>& defines) : defines_(defines) {}

    void append(const fs::path& path, bool is_stage) { append(read_file(path, size_t{1} << 24), path, is_stage); }

    void append(const std::string& text, const fs::path& path, bool is_stage) {
        taken_.push_back(path);
        if (is_stage && text.empty()) throw Error({path, 1}, must_begin);
        collect_names(text, source_.names);

        each_line(text, [&](const std::string& line, int number, bool in_comment) {
            const Place place{path, number};
            const std::string start = without_indent(line);
            if (number == 1 && is_stage) {
                if (!is_version_410(start)) throw Error(place, must_begin);
                put(line, place);
                for (const std::string& define : defines_) put("#define " + define, {});
            } else if (!in_comment && is_include(start)) {
                include(start, place);
            } else {
                put(line, place);
            }
        });
    }

    ShaderSource take() { return std::move(source_); }

private:
    void put(const std::string& line, const Place& place) {
        source_.text += line + "\n";
        source_.lines.push_back(place);
    }

    void include(const std::string& line, const Place& place) {
        const auto name = included_name(line);
        if (!name) throw Error(place, "write #include \"folder/file.glsl\"");
        const fs::path file = find_include(*name, place);
        if (std::find(taken_.begin(), taken_.end(), file) == taken_.end()) append(file, false);
    }

    const std::vector<std::string>& defines_;
    std::vector<fs::path> taken_;
    ShaderSource source_;
};

}  // namespace

ShaderSource load_shader(const fs::path& stage, const std::vector<std::string>& defines) {
    Loader loader(defines);
    loader.append(stage, true);
    ShaderSource source = loader.take();
    source.stage = stage;
    return source;
}

ShaderSource load_shader_text(const std::string& text, const fs::path& stage, const std::vector<std::string>& defines) {
    Loader loader(defines);
    loader.append(text, stage, true);
    ShaderSource source = loader.take();
    source.stage = stage;
    return source;
}

std::set<std::string> included_by(const std::string& text) {
    std::set<std::string> names;
    each_line(text, [&](const std::string& line, int, bool in_comment) {
        const std::string start = without_indent(line);
        if (in_comment || !is_include(start)) return;
        if (const auto name = included_name(start)) names.insert(*name);
    });
    return names;
}

namespace {

/// Converts a compiler's column to an offset in the line, from 0. Returns the line's length if there is no such column.
/// Only Mesa reports columns, and it counts a run of blanks as one.
size_t place_of(const std::string& line, int column) {
    const auto is_blank = [&](size_t i) { return line[i] == ' ' || line[i] == '\t'; };
    for (size_t i = 0; i < line.size(); ++i)
        if ((i == 0 || !is_blank(i) || !is_blank(i - 1)) && --column == 0) return i;
    return line.size();
}

/// Returns a line of the compiled text with a mark below the column. Empty if there is no such line.
std::string quoted(const std::vector<std::string>& source, const LogLine& at) {
    if (!at.line || *at.line < 1 || size_t(*at.line) >= source.size()) return {};
    const std::string& line = source[size_t(*at.line) - 1];
    std::string text = "    " + line + '\n';
    const size_t place = place_of(line, at.column);
    if (place >= line.size()) return text;
    std::string before = line.substr(0, place);
    for (char& c : before) c = c == '\t' ? '\t' : ' ';
    return text + "    " + before + "^\n";
}

}  // namespace

ShaderLog explain_log(const std::string& log, const std::vector<Place>& lines, const std::string& source) {
    ShaderLog result;
    const std::vector<std::string> source_lines = split(source, '\n');
    std::string last_quoted;
    std::istringstream stream(log);
    for (std::string line; std::getline(stream, line);) {
        const auto end = line.find_last_not_of(" \r\0", std::string::npos, 3);
        line.resize(end == std::string::npos ? 0 : end + 1);
        if (line.empty()) continue;
        const LogLine parsed = parse_log_line(line);
        const bool known = parsed.line && *parsed.line >= 1 && size_t(*parsed.line) <= lines.size();
        const Place place = known ? lines[size_t(*parsed.line) - 1] : Place{};
        if (place.file.empty())
            result.text += parsed.message + "\n";
        else
            result.text += fmt::format("{}:{}: {}\n", shown(place.file), place.line, parsed.message);
        const std::string quote = place.file.empty() ? "" : quoted(source_lines, parsed);
        if (quote != last_quoted) result.text += quote;
        last_quoted = quote;
        // A message with a place is more useful than a heading without one.
        const bool better = result.first_message.empty() || (result.first.file.empty() && !place.file.empty());
        if (better && !parsed.is_warning) {
            result.first = place;
            result.first_message = parsed.message;
        }
    }
    return result;
}

}  // namespace relief
