#include "framework/gl/shader_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <sstream>

#include "framework/base/file.h"
#include "framework/base/paths.h"
#include "framework/base/text.h"

namespace relief {
namespace {

namespace fs = std::filesystem;

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
        if (fs::is_regular_file(candidate)) return candidate;
    }
    const auto guess = nearest(name, names_of_shaders());
    throw Error(from, fmt::format("cannot find the included file \"{}\"{}", name,
                                  guess ? fmt::format(": did you mean \"{}\"?", *guess) : ""));
}

void collect_names(const std::string& text, std::set<std::string>& names) {
    static const std::regex name("\\b[us]_\\w+");
    for (auto found = std::sregex_iterator(text.begin(), text.end(), name); found != std::sregex_iterator();
         ++found)
        names.insert(found->str());
}

class Loader {
public:
    explicit Loader(const std::vector<std::string>& defines) : defines_(defines) {}

    void append(const fs::path& path, bool is_stage) {
        const size_t number = source_.files.size();
        source_.files.push_back(path);
        const std::string text = read_file(path, size_t{1} << 24);
        collect_names(text, source_.names);

        std::istringstream lines(text);
        std::string line;
        bool in_comment = false;
        for (int place = 1; std::getline(lines, line); ++place) {
            const std::string start = without_indent(line);
            if (place == 1 && is_stage) {
                if (!start.starts_with("#version"))
                    throw Error({path, 1}, "a stage must begin with #version 410 core");
                source_.text += line + "\n";
                for (const std::string& define : defines_) source_.text += "#define " + define + "\n";
                source_.text += fmt::format("#line 2 {}\n", number);
                continue;
            }
            if (place == 1) source_.text += fmt::format("#line 1 {}\n", number);
            if (!in_comment && start.starts_with("#include"))
                include(start, {path, place}, number);
            else
                source_.text += line + "\n";
            in_comment = ends_in_comment(line, in_comment);
        }
    }

    ShaderSource take() { return std::move(source_); }

private:
    void include(const std::string& line, const Place& place, size_t number) {
        static const std::regex form("#include\\s+\"([^\"]+)\"\\s*(//.*)?");
        std::smatch parts;
        if (!std::regex_match(line, parts, form)) throw Error(place, "write #include \"folder/file.glsl\"");
        const fs::path file = find_include(parts[1], place);
        const auto& have = source_.files;
        if (std::find(have.begin(), have.end(), file) == have.end()) append(file, false);
        source_.text += fmt::format("#line {} {}\n", place.line + 1, number);
    }

    static bool ends_in_comment(const std::string& line, bool inside) {
        for (size_t i = 0; i + 1 < line.size(); ++i) {
            if (!inside && line[i] == '/' && line[i + 1] == '/') return false;
            if (!inside && line[i] == '/' && line[i + 1] == '*')
                inside = true, ++i;
            else if (inside && line[i] == '*' && line[i + 1] == '/')
                inside = false, ++i;
        }
        return inside;
    }

    const std::vector<std::string>& defines_;
    ShaderSource source_;
};

}  // namespace

ShaderSource load_shader(const fs::path& stage, const std::vector<std::string>& defines) {
    Loader loader(defines);
    loader.append(stage, true);
    return loader.take();
}

ShaderLog explain_log(const std::string& log, const std::vector<fs::path>& files) {
    // Mesa "0:12(5): error: x", Nvidia "0(12) : error C1: x", Apple and AMD "ERROR: 0:12: x".
    static const std::regex form(
        "^(?:ERROR: |WARNING: )?(\\d+)(?::(\\d+)(?:\\(\\d+\\))?|\\((\\d+)\\)) ?: *(.*)$");
    ShaderLog result;
    std::istringstream lines(log);
    for (std::string line; std::getline(lines, line);) {
        std::smatch parts;
        const auto end = line.find_last_not_of(" \r\0", std::string::npos, 3);
        line.resize(end == std::string::npos ? 0 : end + 1);
        if (line.empty()) continue;
        if (!std::regex_match(line, parts, form)) {
            result.text += line + "\n";
            if (result.first_message.empty()) result.first_message = line;
            continue;
        }
        const auto number = parse_int(parts[1].str());
        const auto place = parse_int((parts[2].matched ? parts[2] : parts[3]).str());
        if (!number || !place || *number < 0 || size_t(*number) >= files.size()) {
            result.text += line + "\n";
            continue;
        }
        const Place at{files[*number], *place};
        const std::string message = parts[4];
        result.text += fmt::format("{}:{}: {}\n", shown(at.file), at.line, message);
        const bool is_warning = message.starts_with("warning");
        if (result.first.file.empty() && !is_warning) result.first = at, result.first_message = message;
    }
    return result;
}

}  // namespace relief
