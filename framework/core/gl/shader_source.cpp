#include "framework/core/gl/shader_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>

#include "framework/core/base/code_text.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/source_text.h"
#include "framework/core/base/text.h"

namespace relief {
namespace {

namespace fs = std::filesystem;

constexpr const char* must_begin = "a stage must begin with #version 410 core";

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

// No std::regex: it recurses once per character and would overflow the stack on a long line.
void collect_names(const std::string& text, std::set<std::string>& names) {
    for (size_t begin = 0; begin < text.size();) {
        size_t end = begin;
        while (end < text.size() && is_word_character(text[end])) ++end;
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

/// Returns the name in each `#include "name"` by its line, counted from 1. Nothing for a malformed line.
std::map<int, std::optional<std::string>> includes_of(const std::string& text) {
    std::map<int, std::optional<std::string>> includes;
    int line = 1;
    size_t counted = 0;
    for (const CodeToken& token : all_tokens(text)) {
        if (token.kind != CodeToken::directive) continue;
        const std::vector<CodeToken> words = tokens_of_directive(token);
        if (words.size() < 2 || words[1].text != "include") continue;
        line += int(std::count(text.begin() + long(counted), text.begin() + long(token.begin), '\n'));
        counted = token.begin;
        const std::string name = words.size() == 3 ? words[2].text : "";
        const bool is_well_formed = name.size() > 1 && name.starts_with('"') && name.ends_with('"') &&
                                    token.end - token.begin == token.text.size();  // on one line
        includes[line] = is_well_formed ? std::optional(name.substr(1, name.size() - 2)) : std::nullopt;
    }
    return includes;
}

/// Calls `take` with each line of a plain_source().
template <class Take>
void each_line(const std::string& text, Take take) {
    std::istringstream lines(text);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        take(line, number);
    }
}

class Loader {
public:
    explicit Loader(const std::vector<std::string>& defines) : defines_(defines) {}

    void append(const fs::path& path, bool is_stage) { append(read_source(path), path, is_stage); }

    void append(const std::string& text, const fs::path& path, bool is_stage) {
        refuse_faulty_source(text, path);
        taken_.push_back(path);
        if (is_stage && text.empty()) throw Error({path, 1}, must_begin);
        collect_names(text, source_.names);

        const auto includes = includes_of(text);
        each_line(text, [&](const std::string& line, int number) {
            const Place place{path, number};
            if (number == 1 && is_stage) {
                if (!is_version_410(line)) throw Error(place, must_begin);
                put(line, place);
                for (const std::string& define : defines_) put("#define " + define, {});
            } else if (const auto found = includes.find(number); found != includes.end()) {
                include(found->second, place);
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

    void include(const std::optional<std::string>& name, const Place& place) {
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
    for (const auto& [line, name] : includes_of(text))
        if (name) names.insert(*name);
    return names;
}

}  // namespace relief
