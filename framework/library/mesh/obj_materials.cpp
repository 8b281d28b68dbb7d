// Materials of an MTL text.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "framework/core/base/text.h"
#include "framework/library/mesh/obj_parts.h"

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

/// Options of a map, with their first arguments.
using Options = std::vector<std::pair<std::string_view, std::string_view>>;

/// The name of a map without quotes, the options before and after it, and its bump multiplier. Of several options of
/// one name, one before the map's name counts.
struct MapWords {
    std::string name = {};
    std::vector<std::string_view> options = {};
    float bump_scale = 1;
};

/// Takes options with their arguments off the front. `-o`, `-s` and `-t` have one to three numbers. `is_end` means that
/// no name follows; then the result is empty if an option lacks its arguments.
Options take_options(std::string_view& rest, bool is_end) {
    Options options;
    while (true) {
        std::string_view after = rest;
        const std::string_view option = take_name(after);
        const auto found = arguments_of_options().find(option);
        if (found == arguments_of_options().end()) return options;
        options.emplace_back(option, std::string_view());
        for (int i = 0; i < found->second; ++i) {
            std::string_view beyond = after;
            const std::string_view word = take_name(beyond);
            if (is_end && word.empty() && (found->second < 3 || i == 0)) return {};
            const bool is_there =
                found->second < 3 ? !word.empty() : number_of(word) && (is_end || !trimmed(beyond).empty());
            if (!is_there) continue;
            if (i == 0) options.back().second = word;
            after = beyond;
        }
        rest = after;
    }
}

MapWords map_words(std::string_view rest) {
    MapWords map;
    const Options before = take_options(rest, false);
    Options after;
    std::string_view name = trimmed(rest), end;
    if (const size_t quote = name.find('"', 1); name.starts_with('"') && quote != std::string_view::npos) {
        end = name.substr(quote + 1), name = name.substr(1, quote - 1);
        after = take_options(end, true);
    } else {
        // A word like an option may be part of the name. It is an option only if nothing but options follows it.
        for (size_t dash = name.find(" -"); dash != std::string_view::npos; dash = name.find(" -", dash + 1)) {
            end = name.substr(dash + 1);
            after = take_options(end, true);
            if (!after.empty() && trimmed(end).empty()) {
                name = trimmed(name.substr(0, dash));
                break;
            }
            after.clear();
        }
    }
    map.name = name;
    for (const Options* options : {&std::as_const(after), &before})
        for (const auto& [option, argument] : *options) {
            map.options.push_back(option);
            if (option == "-bm") map.bump_scale = float(number_of(argument).value_or(1));
        }
    return map;
}

/// Reads the statements of one material.
class MaterialReader {
public:
    MaterialReader(Material& material, const std::filesystem::path& folder, Notes& notes)
        : material_(material), folder_(folder), notes_(notes) {}

    void read(const Statements& statement) {
        add_word(statement.keyword());
        static const std::map<std::string_view, std::filesystem::path Material::*> maps = {
            {"map_Kd", &Material::diffuse_map}, {"map_Ks", &Material::specular_map}, {"map_d", &Material::opacity_map},
            {"norm", &Material::normal_map},    {"bump", &Material::bump_map},       {"map_bump", &Material::bump_map},
            {"map_Bump", &Material::bump_map}};
        if (const auto map = maps.find(statement.keyword()); map != maps.end())
            read_map(statement, map->second);
        else
            read_numbers(statement);
    }

private:
    void add_word(std::string_view word) {
        std::vector<std::string>& words = material_.words;
        if (words.size() < most_words && std::find(words.begin(), words.end(), word) == words.end())
            words.push_back(excerpt(word));
    }

    void read_map(const Statements& statement, std::filesystem::path Material::*map) {
        const MapWords words = map_words(statement.rest());
        for (const std::string_view option : words.options) add_word(option);
        if (words.name.empty()) return;
        material_.*map = path_in(folder_, words.name);
        if (map == &Material::bump_map) material_.bump_scale = words.bump_scale;
    }

    void read_numbers(const Statements& statement) {
        const std::string_view keyword = statement.keyword();
        static const std::map<std::string_view, glm::vec3 Material::*> colors = {
            {"Kd", &Material::diffuse}, {"Ks", &Material::specular}, {"Ke", &Material::emission}};
        std::string_view rest = statement.rest();
        if (const auto color = colors.find(keyword); color != colors.end()) {
            glm::vec3 rgb;
            for (int i = 0; i < 3; ++i)
                if (!read_number(statement, rest, rgb[i])) return;
            material_.*color->second = rgb;
            return;
        }
        float number = 0;
        if (keyword != "d" && keyword != "Tr" && keyword != "Ns") return;
        if (!read_number(statement, rest, number)) return;
        if (keyword == "Ns") material_.shininess = number;
        if (keyword == "d" || (keyword == "Tr" && !has_d_))
            material_.opacity = std::clamp(keyword == "d" ? number : 1 - number, 0.0f, 1.0f);
        has_d_ |= keyword == "d";
    }

    bool read_number(const Statements& statement, std::string_view& rest, float& number) {
        const std::string_view word = take_word(rest);
        if (const std::optional<double> read = number_of(word)) {
            number = float(*read);
            return true;
        }
        notes_.add({statement.file(), statement.line()},
                   fmt::format("'{}' is left out: '{}' is not a finite number", statement.keyword(), excerpt(word)));
        return false;
    }

    Material& material_;
    const std::filesystem::path& folder_;
    Notes& notes_;
    bool has_d_ = false;  ///< then `Tr`, its opposite, does not count
};

}  // namespace

std::vector<Material> read_materials(std::string_view text, const std::filesystem::path& file,
                                     const std::filesystem::path& folder, Notes& notes) {
    std::vector<Material> materials;
    std::optional<MaterialReader> reader;
    Statements statements(text, file.filename());  // what it throws becomes a note
    try {
        while (statements.next()) {
            if (statements.keyword() == "newmtl") {
                if (statements.rest().empty()) statements.fail("a material without a name; the rest is not read");
                if (materials.size() == most_materials) statements.fail("too many materials; the rest is not read");
                materials.push_back({.name = std::string(statements.rest()), .file = file, .line = statements.line()});
                reader.emplace(materials.back(), folder, notes);
            } else if (reader) {
                reader->read(statements);
            }
        }
    } catch (const Error& error) {
        notes.add(error.what());
    }
    return materials;
}

}  // namespace relief::obj
