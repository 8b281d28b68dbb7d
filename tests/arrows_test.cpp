// The arrows of the house: which part may include which; and what is done in one place only.
#include <map>
#include <regex>

#include "tests/support.h"

namespace relief {
namespace {

namespace fs = std::filesystem;
using Lines = std::vector<std::string>;

// From the ground up. Parts on one floor do not include each other.
const std::map<std::string, int> floors = {{"base", 0},    {"image", 1}, {"mesh", 1},  {"reference", 2}, {"gl", 3},
                                           {"context", 4}, {"lab", 5},   {"grade", 6}, {"measure", 7},   {"app", 8}};

/// What a file includes, by "" or <>.
Lines includes_of(const std::string& text) {
    static const std::regex form("(^|\n)[ \t]*#[ \t]*include[ \t]*[<\"]([^>\"\n]+)");
    Lines found;
    for (auto match = std::sregex_iterator(text.begin(), text.end(), form); match != std::sregex_iterator(); ++match)
        found.push_back((*match)[2]);
    return found;
}

std::string part_of(const std::string& path) {
    if (!path.starts_with("framework/")) return path.substr(0, path.find('/'));
    return path.substr(10, path.find('/', 10) - 10);
}

/// What is wrong with an include; "" when nothing is.
std::string mistake(const std::string& file, const std::string& include) {
    if (include.starts_with("..") || include.find("/../") != std::string::npos) return "climbs out of its folder";
    for (const std::string folder : {"labs/", "assets/", "tests/"})
        if (include.starts_with(folder) && (folder != "assets/" || !file.starts_with(folder)))
            return "nothing is built upon that folder";
    if (!include.starts_with("framework/")) return "";
    const std::string from = part_of(file), to = part_of(include);
    if (!floors.contains(to)) return "names no part of the framework";
    if (from == "labs") {
        if (to == "lab")
            return include == "framework/lab/lab.h" || include == "framework/lab/labels.h" ||
                           include == "framework/lab/tiles.h" || include == "framework/lab/relief_surface.h" ||
                           include == "framework/lab/displaced_surface.h" ||
                           include == "framework/lab/relief_material.h"
                       ? ""
                       : "a lab includes lab.h, labels.h, tiles.h, relief_surface.h, relief_material.h or "
                         "displaced_surface.h, and what lies below";
        return floors.at(to) < floors.at("context") ? "" : "a lab does not know of contexts or what is above labs";
    }
    if (from == "assets") return floors.at(to) < floors.at("gl") ? "" : "the textures are made without GL";
    if (!floors.contains(from)) return "is in no part of the framework";
    if (to == from || floors.at(to) < floors.at(from)) return "";
    return "points up, or across";
}

/// The arrows of one file that point up, "file includes X: why".
Lines wrong_arrows(const std::string& file, const std::string& text) {
    Lines wrong;
    for (const std::string& include : includes_of(text))
        if (const std::string why = mistake(file, include); !why.empty())
            wrong.push_back(file + " includes " + include + ": " + why);
    return wrong;
}

/// The libraries that one file alone may know; where `file` is not that file.
Lines wrong_libraries(const std::string& file, const std::string& text) {
    static const std::regex window_file("framework/(context/[a-z]+_window|app/menu[a-z_]*)\\.(cpp|h)");
    const bool cpu =
        part_of(file) == "assets" || (floors.contains(part_of(file)) && floors.at(part_of(file)) < floors.at("gl"));
    Lines wrong;
    for (const std::string& include : includes_of(text)) {
        const bool image = include.starts_with("OpenImageIO/"),
                   gl = include.starts_with("glad/") || include.starts_with("GL/");
        const bool archive = include == "archive.h" || include == "archive_entry.h";
        const bool window =
            include.starts_with("GLFW/") || include.starts_with("imgui") || include.starts_with("backends/imgui");
        if ((image && file != "framework/image/openimageio.cpp" && file != "framework/measure/peers_module.cpp") ||
            (archive && file != "framework/grade/libarchive.cpp") ||
            (include == "md4c.h" && file != "framework/base/markdown.cpp") ||
            (window && !std::regex_match(file, window_file)) || (gl && cpu))
            wrong.push_back(file + " includes " + include);
    }
    return wrong;
}

/// Calls `check` with every source file of the course, its path relative to the top folder.
template <class Check>
int each_source(Check check) {
    const fs::path root = RELIEF_SOURCE_FOLDER;
    int count = 0;
    for (const char* folder : {"framework", "labs", "assets"})
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
            std::ifstream stream(entry.path());
            const std::string text{std::istreambuf_iterator<char>(stream), {}};
            check(entry.path().lexically_relative(root).string(), text);
            ++count;
        }
    return count;
}

TEST(Arrows, PointDown) {
    const int count = each_source([](const std::string& file, const std::string& text) {
        for (const std::string& line : wrong_arrows(file, text)) ADD_FAILURE() << line;
    });
    EXPECT_GT(count, 50) << "the course has more source files than that";
}

TEST(Arrows, AForeignLibraryIsKnownWhereItBelongs) {
    int images = 0, windows = 0;
    each_source([&](const std::string& file, const std::string& text) {
        for (const std::string& line : wrong_libraries(file, text)) ADD_FAILURE() << line;
        for (const std::string& include : includes_of(text))
            images += include.starts_with("OpenImageIO/"), windows += include.starts_with("GLFW/");
    });
    EXPECT_GT(images, 0) << "the claim is empty when nothing includes it";
    EXPECT_GT(windows, 0);
}

TEST(Sources, RoundNumbersForPeopleInOnePlace) {
    // g writes 1000 as 1e+03 when asked for three digits: rounded() in framework/base/text.h does not.
    const std::regex general("[:0-9}]g\\}");
    EXPECT_TRUE(std::regex_search(R"(fmt::format("{:>{}.4g}", 1000, 9))", general));
    int places = 0;
    each_source([&](const std::string& file, const std::string& text) {
        if (!std::regex_search(text, general)) return;
        EXPECT_EQ(file, "framework/base/text.cpp");
        ++places;
    });
    EXPECT_EQ(places, 1);
}

TEST(Arrows, APlantedOneIsFound) {
    const struct {
        const char *file, *include;
        bool right;
    } cases[] = {
        {"framework/base/text.h", "framework/image/image.h", false},
        {"framework/image/mips.cpp", "framework/base/error.h", true},
        {"framework/image/mips.cpp", "framework/mesh/mesh.h", false},
        {"framework/mesh/shapes.cpp", "framework/image/image.h", false},
        {"framework/reference/march.h", "framework/image/image.h", true},
        {"framework/gl/texture.cpp", "framework/context/context.h", false},
        {"framework/lab/lab.h", "framework/app/menu.h", false},
        {"framework/lab/lab.h", "framework/gl/program.h", true},
        {"framework/app/bench.cpp", "framework/measure/bench.h", true},
        {"framework/measure/bench.h", "framework/app/menu.h", false},
        {"framework/grade/results.cpp", "framework/measure/sweep.h", false},
        {"framework/grade/results.cpp", "framework/app/page.h", false},
        {"framework/app/menu.cpp", "framework/context/context.h", true},
        {"framework/app/menu.cpp", "framework/unheard_of/x.h", false},
        {"framework/app/menu.cpp", "../lab/lab.h", false},
        {"framework/lab/shot.cpp", "labs/07_baking/bake.h", false},
        {"labs/07_baking/lab.cpp", "framework/lab/lab.h", true},
        {"labs/07_baking/lab.cpp", "framework/reference/march.h", true},
        {"labs/07_baking/lab.cpp", "framework/lab/manifest.h", false},
        {"labs/07_baking/lab.cpp", "framework/context/context.h", false},
        {"labs/07_baking/lab.cpp", "framework/app/menu.h", false},
        {"labs/07_baking/lab.cpp", "bake.h", true},
        {"labs/07_baking/lab.cpp", "labs/08_torus/torus.h", false},
        {"assets/make.cpp", "framework/image/file.h", true},
        {"assets/make.cpp", "assets/noise.h", true},
        {"framework/gl/texture.cpp", "assets/noise.h", false},
        {"assets/make.cpp", "framework/gl/texture.h", false},
    };
    for (const auto& [file, include, right] : cases)
        for (const auto& [open, close] : {std::pair("#include \"", "\"\n"), {"int x;\n  # include <", ">"}})
            EXPECT_EQ(wrong_arrows(file, std::string(open) + include + close).empty(), right)
                << file << " includes " << include;
    EXPECT_TRUE(wrong_arrows("framework/base/a.h", "// #include \"framework/app/menu.h\"\n").empty()) << "a comment";
}

TEST(Arrows, APlantedLibraryIsFound) {
    EXPECT_FALSE(wrong_libraries("framework/image/file.cpp", "#include <OpenImageIO/imageio.h>\n").empty());
    EXPECT_FALSE(wrong_libraries("framework/lab/shot.cpp", "#include <GLFW/glfw3.h>\n").empty());
    EXPECT_FALSE(wrong_libraries("framework/context/window.cpp", "#include <GLFW/glfw3.h>\n").empty());
    EXPECT_FALSE(wrong_libraries("labs/07_baking/lab.cpp", "#include <imgui.h>\n").empty());
    EXPECT_FALSE(wrong_libraries("framework/mesh/shapes.cpp", "#include <glad/gl.h>\n").empty());
    EXPECT_TRUE(wrong_libraries("framework/context/glfw_window.cpp", "#include <GLFW/glfw3.h>\n").empty());
    EXPECT_TRUE(wrong_libraries("framework/app/menu_panel.cpp", "#include <imgui.h>\n").empty());
    EXPECT_TRUE(wrong_libraries("framework/gl/gl.h", "#include <glad/gl.h>\n").empty());
}

}  // namespace
}  // namespace relief
