// Materials of an MTL text, read by tinyobjloader.
//
// tinyobjloader gets only the statements that this course needs, checked and normalised one line at a time. It expects
// three numbers after -o, -s and -t, where the format also allows one or two, and would swallow the map's name.
#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "framework/core/base/text.h"
#include "framework/core/mesh/obj_parts.h"

namespace relief::obj {
namespace {

constexpr size_t most_materials = 4096, most_words = 32;  // words of a material

/// The options of a map, with the numbers of their arguments.
const std::map<std::string_view, int>& arguments_of_options() {
    static const std::map<std::string_view, int> arguments_of = {
        {"-blendu", 1},  {"-blendv", 1}, {"-boost", 1},      {"-clamp", 1}, {"-bm", 1}, {"-texres", 1}, {"-type", 1},
        {"-imfchan", 1}, {"-mm", 2},     {"-colorspace", 1}, {"-o", 3},     {"-s", 3},  {"-t", 3}};
    return arguments_of;
}

/// Takes options off the front, and returns them with all their numbers. `is_end` means that no name follows; then the
/// result is empty if an option lacks its arguments.
std::string take_options(std::string_view& rest, bool is_end) {
    const auto& arguments_of = arguments_of_options();
    std::string whole;
    while (true) {
        std::string_view after = rest;
        const std::string_view option = take_name(after);
        const auto found = arguments_of.find(option);
        if (found == arguments_of.end()) break;
        whole.append(option).append(" ");
        for (int i = 0; i < found->second; ++i) {
            std::string_view beyond = after;
            const std::string_view word = take_name(beyond);
            if (is_end && word.empty() && (found->second < 3 || i == 0)) return {};
            const bool is_there =
                found->second < 3 ? !word.empty() : is_number(word) && (is_end || !trimmed(beyond).empty());
            whole.append(is_there ? word : option == "-s" ? "1" : "0").append(" ");
            if (is_there) after = beyond;
        }
        rest = after;
    }
    return whole;
}

/// The options of a map with all their numbers, from before and after its name, and its name without quotes. Each of
/// these may be empty.
struct MapWords {
    std::string options, name;
};

MapWords map_words(std::string_view rest) {
    std::string whole = take_options(rest, false);
    std::string_view name = trimmed(rest), end;
    if (const size_t quote = name.find('"', 1); name.starts_with('"') && quote != std::string_view::npos) {
        end = name.substr(quote + 1), name = name.substr(1, quote - 1);
        return {take_options(end, true) + whole, std::string(name)};
    }
    // A word like an option may be part of the name. It is an option only if nothing but options follows it.
    for (size_t dash = name.find(" -"); dash != std::string_view::npos; dash = name.find(" -", dash + 1)) {
        end = name.substr(dash + 1);
        std::string options = take_options(end, true);
        if (!options.empty() && trimmed(end).empty())
            return {options + whole, std::string(trimmed(name.substr(0, dash)))};
    }
    return {whole, std::string(name)};
}

/// Returns the line of a statement for tinyobjloader, or an empty string to skip it. Adds its keyword and its options
/// to `words`, unless they are there.
std::string checked(const Statements& statement, std::vector<std::string>& words, Notes& notes) {
    const auto add = [&](std::string_view word) {
        if (words.size() < most_words && std::find(words.begin(), words.end(), word) == words.end())
            words.push_back(excerpt(word));
    };
    add(statement.keyword());

    static const std::set<std::string_view> maps = {"map_Ka",   "map_Kd",   "map_Ks",  "map_Ke", "map_Ns",
                                                    "map_d",    "norm",     "bump",    "disp",   "map_bump",
                                                    "map_Bump", "map_disp", "map_Disp"};
    const std::string keyword(statement.keyword());
    if (maps.contains(keyword)) {
        const auto [options, name] = map_words(statement.rest());
        for (const std::string& word : split(options, ' '))
            if (arguments_of_options().contains(word)) add(word);
        return fmt::format("{} {}{}\n", keyword, options, name);
    }

    static const std::map<std::string_view, int> numbers_of = {{"Ka", 3}, {"Kd", 3}, {"Ks", 3}, {"Ke", 3},
                                                               {"d", 1},  {"Tr", 1}, {"Ns", 1}, {"illum", 1}};
    const auto found = numbers_of.find(keyword);
    if (found == numbers_of.end()) return {};
    std::string line = keyword;
    std::string_view rest = statement.rest();
    for (int i = 0; i < found->second; ++i) {
        const std::string_view word = take_word(rest);
        if (!is_number(word)) {
            notes.add(statement.file(), statement.line(),
                      fmt::format("'{}' is left out: '{}' is not a finite number", keyword, excerpt(word)));
            return {};
        }
        line.append(" ").append(word);
    }
    return line + "\n";
}

float finite_or(float value, float otherwise) { return std::isfinite(value) ? value : otherwise; }

glm::vec3 color(const float (&rgb)[3], float otherwise) {
    return {finite_or(rgb[0], otherwise), finite_or(rgb[1], otherwise), finite_or(rgb[2], otherwise)};
}

/// Returns a map's path for this system. Backslashes become slashes. A path with a drive letter loses its folders, so
/// that the file is looked for beside the model.
std::filesystem::path map_path(std::string name, const std::filesystem::path& folder) {
    std::replace(name.begin(), name.end(), '\\', '/');
    if (name.size() > 2 && name[1] == ':' && name[2] == '/') name.erase(0, name.rfind('/') + 1);
    return name.empty() ? std::filesystem::path() : (folder / name).lexically_normal();
}

}  // namespace

std::vector<Material> read_materials(std::string_view text, const std::filesystem::path& file,
                                     const std::filesystem::path& folder, Notes& notes) {
    std::string shown;
    std::vector<std::string> names;
    std::vector<int> lines;  // of the names
    std::vector<std::vector<std::string>> words;
    Statements statements(text, file);
    try {
        while (statements.next()) {
            if (statements.keyword() == "newmtl") {
                if (statements.rest().empty()) statements.fail("a material without a name; the rest is not read");
                if (names.size() == most_materials) statements.fail("too many materials; the rest is not read");
                // The number replaces the name, because newer releases of tinyobjloader end a name at its first blank.
                // The diffuse colour is set, because its default depends on the previous materials.
                shown += fmt::format("newmtl {}\nKd 1 1 1\n", names.size());
                names.emplace_back(statements.rest());
                lines.push_back(statements.line());
                words.emplace_back();
            } else if (!names.empty()) {
                shown += checked(statements, words.back(), notes);
            }
        }
    } catch (const Error& error) {
        notes.add(error);
    }
    std::istringstream stream(shown);
    std::map<std::string, int> indices;
    std::vector<tinyobj::material_t> read;
    tinyobj::LoadMtl(&indices, &read, &stream, nullptr, nullptr);

    std::vector<Material> materials;
    for (const tinyobj::material_t& material : read) {
        if (material.name.empty()) continue;  // tinyobjloader adds one without a name
        materials.push_back({.name = names[materials.size()],
                             .diffuse = color(material.diffuse, 1),
                             .specular = color(material.specular, 0),
                             .ambient = color(material.ambient, 0),
                             .emission = color(material.emission, 0),
                             .illumination = material.illum,
                             .shininess = finite_or(material.shininess, 1),
                             .opacity = std::clamp(finite_or(material.dissolve, 1), 0.0f, 1.0f),
                             .bump_scale = finite_or(material.bump_texopt.bump_multiplier, 1),
                             .diffuse_map = map_path(material.diffuse_texname, folder),
                             .specular_map = map_path(material.specular_texname, folder),
                             .shininess_map = map_path(material.specular_highlight_texname, folder),
                             .opacity_map = map_path(material.alpha_texname, folder),
                             .ambient_map = map_path(material.ambient_texname, folder),
                             .emission_map = map_path(material.emissive_texname, folder),
                             .bump_map = map_path(material.bump_texname, folder),
                             .normal_map = map_path(material.normal_texname, folder),
                             .displacement_map = map_path(material.displacement_texname, folder),
                             .words = words[materials.size()],
                             .file = file,
                             .line = lines[materials.size()]});
    }
    return materials;
}

}  // namespace relief::obj
