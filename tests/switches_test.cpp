// The switches of shaders: names in their #if lines, which C++ defines. One that nothing sets leaves a path that is
// never taken; a definition that no shader reads compiles an equal program again.
#include <map>
#include <regex>
#include <set>
#include <string>

#include "framework/core/base/file.h"
#include "tests/support.h"

namespace relief {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

/// Calls `take` with each file below a folder of the course whose name ends in one of `endings`, and its text.
template <class Take>
void each_file(const char* folder, const Names& endings, Take take) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(source_folder) / folder))
        if (entry.is_regular_file() && endings.contains(entry.path().extension().string()))
            take(entry.path(), read_file(entry.path()));
}

const Names glsl = {".glsl", ".vert", ".tesc", ".tese", ".geom", ".frag"};
const Names cpp = {".cpp", ".h"};

std::string without_comments(const std::string& text) {
    static const std::regex comment("//[^\n]*");
    return std::regex_replace(text, comment, "");
}

void add_words(const std::string& text, Names& words) {
    static const std::regex word("[A-Za-z_][A-Za-z_0-9]*");
    for (auto at = std::sregex_iterator(text.begin(), text.end(), word); at != std::sregex_iterator(); ++at)
        words.insert(at->str());
}

/// Returns the string literals of a C++ text.
std::vector<std::string> literals_of(const std::string& text) {
    static const std::regex literal("\"((?:[^\"\\\\\n]|\\\\.)*)\"");
    std::vector<std::string> found;
    for (auto at = std::sregex_iterator(text.begin(), text.end(), literal); at != std::sregex_iterator(); ++at)
        found.push_back((*at)[1]);
    return found;
}

/// What the shaders read and define themselves. `asked` has the names in #if lines, by folder, with a file that has
/// one.
struct Shaders {
    std::map<std::string, std::map<std::string, std::string>> asked;
    Names read, defined;
};

Shaders read_shaders() {
    static const std::regex condition("(^|\n)[ \t]*#[ \t]*(?:ifdef|ifndef|if|elif)\\b([^\n]*)");
    static const std::regex definition("(^|\n)[ \t]*#[ \t]*define[ \t]+([A-Za-z_0-9]+)");
    Shaders shaders;
    each_file("shaders", glsl, [&](const fs::path& file, const std::string& whole) {
        const std::string text = without_comments(whole);
        for (auto at = std::sregex_iterator(text.begin(), text.end(), condition); at != std::sregex_iterator(); ++at) {
            Names names;
            add_words((*at)[2], names);
            const std::string folder = file.lexically_relative(fs::path(source_folder) / "shaders").begin()->string();
            for (const std::string& name : names)
                if (name != "defined") shaders.asked[folder].emplace(name, file.string());
        }
        for (auto at = std::sregex_iterator(text.begin(), text.end(), definition); at != std::sregex_iterator(); ++at)
            shaders.defined.insert((*at)[2]);
        add_words(std::regex_replace(text, definition, "\n"), shaders.read);
    });
    return shaders;
}

/// Returns the names of all probes, from the labs' manifests.
Names probes() {
    static const std::regex probe("\\[\\[probe\\]\\]\\s*name\\s*=\\s*\"([^\"]+)\"");
    Names names;
    each_file("labs", {".toml"}, [&](const fs::path&, const std::string& text) {
        for (auto at = std::sregex_iterator(text.begin(), text.end(), probe); at != std::sregex_iterator(); ++at)
            names.insert((*at)[1]);
    });
    return names;
}

/// Adds the words of all string literals in the C++ of a folder.
void add_literals(const std::string& folder, Names& words) {
    each_file(folder.c_str(), cpp, [&](const fs::path&, const std::string& text) {
        for (const std::string& literal : literals_of(without_comments(text))) add_words(literal, words);
    });
}

TEST(Switches, AreEachSetByTheLabOrTheFramework) {
    Names everywhere = probes(), of_all_labs;
    add_literals("framework", everywhere);
    add_literals("labs", of_all_labs);
    const Shaders shaders = read_shaders();
    size_t count = 0;
    for (const auto& [folder, names] : shaders.asked) {
        Names set = everywhere;
        if (fs::exists(fs::path(source_folder) / "labs" / folder))
            add_literals("labs/" + folder, set);
        else
            set.merge(Names(of_all_labs));  // shaders that labs share
        for (const auto& [name, file] : names) {
            const bool is_the_drivers = name.starts_with("GL_");
            const std::string word = name.starts_with("PROBE_") ? name.substr(6) : name;
            EXPECT_TRUE(set.contains(word) || shaders.defined.contains(name) || is_the_drivers)
                << name << " in " << file << " is defined by no C++";
            ++count;
        }
    }
    EXPECT_GT(count, 200u);
}

TEST(Switches, AreEachReadByAShader) {
    // Words in capitals that are shown or stored, and define nothing.
    const Names others = {"BC1", "BC5", "BRDF", "PCF"};
    static const std::regex form("([A-Z][A-Z0-9_]*[A-Z0-9])( [A-Za-z0-9_.-]+)?");
    const Names read = read_shaders().read;
    int count = 0;
    for (const char* const folder : {"labs", "framework/library/kit"})
        each_file(folder, cpp, [&](const fs::path& file, const std::string& text) {
            for (const std::string& literal : literals_of(without_comments(text))) {
                std::smatch match;
                if (!std::regex_match(literal, match, form) || others.contains(match[1])) continue;
                ++count;
                EXPECT_TRUE(read.contains(match[1])) << literal << " in " << file << " is read by no shader";
            }
        });
    EXPECT_GT(count, 150);
}

}  // namespace
}  // namespace relief
