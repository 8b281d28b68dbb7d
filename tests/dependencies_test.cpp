// The arrows of the house: which room may include which, which code labs may share, and which calls and libraries only
// one file may use. `core` hosts a lab, `library` has what labs share, `course` the tools around the labs, and `staff`
// the code that students never get.
#include <fmt/format.h>

#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "tests/support.h"

namespace relief {
namespace {

namespace fs = std::filesystem;
using Lines = std::vector<std::string>;

// The floors, from the ground up. Rooms on one floor do not include each other.
const std::map<std::string, int> floors = {
    {"core/base", 0},       {"core/image", 1},      {"library/mesh", 2},     {"library/maps", 2},
    {"staff/reference", 3}, {"core/gl", 4},         {"core/context", 5},     {"core/lab", 6},
    {"library/kit", 7},     {"course/manifest", 8}, {"course/inspect", 9},   {"course/task", 9},
    {"course/explain", 10}, {"course/check", 11},   {"course/web", 12},      {"staff/grade", 12},
    {"course/pages", 13},   {"staff/class", 13},    {"staff/proof", 13},     {"staff/handout", 14},
    {"staff/measure", 14},  {"staff/synctest", 14}, {"staff/questions", 14}, {"staff/originality", 14},
    {"staff/cluster", 14},  {"course/window", 14},  {"staff/pages", 15},     {"staff/web", 15},
    {"staff/slides", 15},   {"course/app", 15},     {"staff/app", 16}};

/// Returns the files and headers that a text includes, by "" or <>.
Lines includes_of(const std::string& text) {
    static const std::regex form("(^|\n)[ \t]*#[ \t]*include[ \t]*[<\"]([^>\"\n]+)");
    Lines found;
    for (auto match = std::sregex_iterator(text.begin(), text.end(), form); match != std::sregex_iterator(); ++match)
        found.push_back((*match)[2]);
    return found;
}

/// Returns the room of a file: "core/gl", "staff/grade", or "labs", "labs/staff", "assets", "assets/staff".
std::string part_of(const std::string& path) {
    static const std::regex room(
        "(?:framework/([^/]+/[^/]+)/.*|(labs)/[^/]+/(?:(staff)/)?.*|(assets)/(?:(staff)/)?.*)");
    std::smatch match;
    if (!std::regex_match(path, match, room)) return path;
    if (match[1].matched) return match[1];
    const std::string top = match[2].matched ? match[2] : match[4];
    return top + (match[3].matched || match[5].matched ? "/staff" : "");
}

bool is_the_staffs(const std::string& part) { return part.starts_with("staff/") || part.ends_with("/staff"); }

/// Returns the fault of an include, or "".
std::string mistake(const std::string& file, const std::string& include) {
    if (include.starts_with("..") || include.find("/../") != std::string::npos) return "climbs out of its folder";
    for (const std::string folder : {"labs/", "assets/", "tests/"})
        if (include.starts_with(folder) && (folder != "assets/" || !file.starts_with(folder)))
            return "nothing is built upon that folder";
    const std::string from = part_of(file), to = part_of(include);
    if (include.starts_with("assets/staff/") && !is_the_staffs(from))
        return "everybody's files know nothing of the staff's";
    if (!include.starts_with("framework/")) return "";
    if (!floors.contains(to)) return "names no room of the framework";
    if (from.starts_with("core/") && !to.starts_with("core/")) return "the core includes nothing else";
    if (from.starts_with("library/") && !to.starts_with("core/") && !to.starts_with("library/"))
        return "the library includes the core alone";
    if (is_the_staffs(to) && !is_the_staffs(from)) return "everybody's files know nothing of the staff's";
    if (from.starts_with("labs")) {
        if (to == "core/lab" && include != "framework/core/lab/lab.h" && !file.ends_with("/staff/bench.cpp"))
            return "of that room a lab includes lab.h alone";
        const bool shared = (to.starts_with("core/") && to != "core/context") || to.starts_with("library/");
        if (shared || (from == "labs/staff" && to == "staff/reference")) return "";
        if (!file.ends_with("/staff/bench.cpp")) return "a lab includes the core without contexts, and the library";
        return to == "staff/measure" || floors.at(to) < floors.at("staff/measure")
                   ? ""
                   : "a topic includes what its room may";
    }
    if (from.starts_with("assets"))
        return floors.at(to) < floors.at("core/gl") ? "" : "the textures are made without GL";
    if (!floors.contains(from)) return "is in no room of the framework";
    if (to == from || floors.at(to) < floors.at(from)) return "";
    return "points up, or across";
}

/// Returns the faulty includes of a file, as "file includes X: why".
Lines wrong_includes(const std::string& file, const std::string& text) {
    Lines wrong;
    for (const std::string& include : includes_of(text))
        if (const std::string why = mistake(file, include); !why.empty())
            wrong.push_back(file + " includes " + include + ": " + why);
    return wrong;
}

/// Returns the includes of libraries that only one other file may include.
Lines wrong_libraries(const std::string& file, const std::string& text) {
    static const std::regex window_file("framework/(core/context/[a-z]+_window|course/window/menu[a-z_]*)\\.(cpp|h)");
    const bool cpu = part_of(file).starts_with("assets") ||
                     (floors.contains(part_of(file)) && floors.at(part_of(file)) < floors.at("core/gl"));
    Lines wrong;
    for (const std::string& include : includes_of(text)) {
        const bool image = include.starts_with("OpenImageIO/"),
                   gl = include.starts_with("glad/") || include.starts_with("GL/");
        const bool archive = include == "archive.h" || include == "archive_entry.h";
        const bool window =
            include.starts_with("GLFW/") || include.starts_with("imgui") || include.starts_with("backends/imgui");
        if ((image && file != "framework/core/image/openimageio.cpp" &&
             file != "framework/staff/measure/peers_module.cpp") ||
            ((include.starts_with("librsvg/") || include.starts_with("cairo")) &&
             file != "framework/course/pages/librsvg.cpp") ||
            (archive && file != "framework/staff/grade/libarchive.cpp") ||
            (include == "glib.h" && file != "framework/staff/grade/glib.cpp") ||
            (include == "seccomp.h" && file != "framework/staff/grade/system_calls.cpp") ||
            (include == "md4c.h" && file != "framework/course/pages/markdown.cpp") ||
            (include.starts_with("kainjow/") && file != "framework/course/pages/template.cpp") ||
            (window && !std::regex_match(file, window_file)) || (gl && cpu))
            wrong.push_back(file + " includes " + include);
    }
    return wrong;
}

/// Calls `check` with the path, relative to the top folder, and the text of every file below `folders` with one of the
/// extensions.
template <class Check>
int each_file(const std::set<std::string>& folders, const std::set<std::string>& extensions, Check check) {
    const fs::path root = source_folder;
    int count = 0;
    for (const std::string& folder : folders)
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            if (!extensions.contains(entry.path().extension().string())) continue;
            std::ifstream stream(entry.path());
            const std::string text{std::istreambuf_iterator<char>(stream), {}};
            check(entry.path().lexically_relative(root).string(), text);
            ++count;
        }
    return count;
}

/// Calls `check` with the path and the text of every C++ file of the course.
template <class Check>
int each_source(Check check) {
    return each_file({"framework", "labs", "assets"}, {".cpp", ".h"}, check);
}

/// Returns what stands in quotes after `before`, with `before`: "framework/core/gl/gl.h".
Lines quoted_names(const std::string& text, const std::string& before) {
    Lines names;
    for (size_t at = 0; (at = text.find('"' + before, at)) != std::string::npos;) {
        const size_t end = text.find('"', ++at);
        names.push_back(text.substr(at, end - at));
        at = end;
    }
    return names;
}

/// Returns the common name of a header and its source, or the path of another file.
std::string unit_of(const std::string& path) {
    const size_t dot = path.rfind('.');
    return path.ends_with(".h") || path.ends_with(".cpp") ? path.substr(0, dot) : path;
}

using Users = std::map<std::string, std::set<std::string>>;

/// Returns the labs and the rooms that use each header of the core or library and each shader in shaders/common,
/// directly or through others of them. `texts` are C++ files and shaders by their paths. A bench does not count as a
/// user: what it measures belongs to a lab.
Users users_of_shared_code(const std::map<std::string, std::string>& texts) {
    Users users, direct;
    for (const auto& [path, text] : texts) {
        if (((path.starts_with("framework/core/") || path.starts_with("framework/library/")) && path.ends_with(".h")) ||
            path.starts_with("shaders/common/"))
            users[unit_of(path)];
        for (const char* part : {"framework/core/", "framework/library/"})
            for (const std::string& name : quoted_names(text, part)) direct[unit_of(name)].insert(path);
        for (const std::string& name : quoted_names(text, "shaders/common/")) direct[name].insert(path);
        for (const std::string& name : quoted_names(text, "common/")) direct["shaders/" + name].insert(path);
    }
    static const std::regex lab("(?:labs|shaders)/([0-9][0-9]_[a-z0-9_]+)/.*");
    for (bool is_growing = true; is_growing;) {
        is_growing = false;
        for (auto& [unit, all] : users) {
            const size_t before = all.size();
            for (const std::string& path : direct[unit]) {
                std::smatch match;
                if (const auto through = users.find(unit_of(path)); through != users.end())
                    all.insert(through->second.begin(), through->second.end());
                else if (std::regex_match(path, match, lab))
                    all.insert("labs/" + match[1].str());
                else if (part_of(path) != "staff/measure")
                    all.insert(part_of(path));
            }
            is_growing = is_growing || all.size() > before;
        }
    }
    return users;
}

/// Returns the shared code that one lab alone uses, or nobody, with this user: "framework/library/mesh/clip:
/// labs/17_x".
Lines lonely(const Users& users) {
    Lines found;
    for (const auto& [unit, all] : users)
        if (all.empty() || (all.size() == 1 && all.begin()->starts_with("labs/")))
            found.push_back(unit + ": " + (all.empty() ? "nobody" : *all.begin()));
    return found;
}

TEST(SharedCode, IsUsedByTwoLabsOrByAnotherRoom) {
    const Lines exceptions = {
        // The bench of lab 02 measures it, from framework/staff/measure.
        "framework/library/maps/bc1: labs/02_normal_map_storage",
        // The twin of framework/staff/reference/mesh_rays.h, with which other labs compute exact values.
        "shaders/common/mesh_rays.glsl: labs/07_baking",
    };
    std::map<std::string, std::string> texts;
    each_file({"framework", "labs", "assets", "shaders"}, {".cpp", ".h", ".glsl", ".vert", ".frag", ".tesc", ".tese"},
              [&](const std::string& file, const std::string& text) { texts[file] = text; });
    const Users users = users_of_shared_code(texts);
    EXPECT_GT(users.size(), 50u) << "the course shares more than that";
    EXPECT_EQ(lonely(users), exceptions) << "a lab's own code is at home in its folder";
}

TEST(SharedCode, FindsAPlantedHeaderOfOneLab) {
    std::map<std::string, std::string> texts = {
        {"framework/library/mesh/polygon.h", ""},
        {"framework/library/mesh/polygon.cpp", "#include \"framework/library/mesh/polygon.h\"\n"},
        {"framework/library/mesh/clip.h", "#include \"framework/library/mesh/polygon.h\"\n"},
        {"framework/staff/measure/clips.cpp", "#include \"framework/library/mesh/clip.h\"\n"},
        {"labs/07_baking/staff/truth.cpp", "#include \"framework/library/mesh/clip.h\"\n"},
        {"labs/07_baking/lab.cpp", "#include \"framework/library/mesh/clip.h\"\n"},
        {"shaders/common/ray.glsl", ""},
        {"shaders/07_baking/walk.glsl", "#include \"common/ray.glsl\"\n"},
    };
    EXPECT_EQ(lonely(users_of_shared_code(texts)),
              (Lines{"framework/library/mesh/clip: labs/07_baking", "framework/library/mesh/polygon: labs/07_baking",
                     "shaders/common/ray.glsl: labs/07_baking"}));
    texts["labs/08_torus/torus.cpp"] = "#include \"framework/library/mesh/polygon.h\"\n";
    texts["framework/core/gl/rays.h"] = "Programs rays{\"common/ray.glsl\"};\n";
    EXPECT_EQ(lonely(users_of_shared_code(texts)),
              (Lines{"framework/core/gl/rays: nobody", "framework/library/mesh/clip: labs/07_baking",
                     "shaders/common/ray.glsl: labs/07_baking"}));
    texts["framework/course/window/menu.cpp"] =
        "#include \"framework/library/mesh/clip.h\"\n#include \"framework/core/gl/rays.h\"\n";
    EXPECT_EQ(lonely(users_of_shared_code(texts)), Lines());
}

TEST(Dependencies, PointDown) {
    const int count = each_source([](const std::string& file, const std::string& text) {
        for (const std::string& line : wrong_includes(file, text)) ADD_FAILURE() << line;
    });
    EXPECT_GT(count, 50) << "the course has more source files than that";
}

TEST(Rooms, AreListedInContributing) {
    std::ifstream stream(fs::path(source_folder) / "CONTRIBUTING.md");
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    for (const auto& [room, floor] : floors) {
        const size_t slash = room.find('/');
        const size_t table = text.find("| room of `framework/" + room.substr(0, slash) + "`");
        ASSERT_NE(table, std::string::npos) << room;
        const std::string rows = text.substr(table, text.find("\n\n", table) - table);
        EXPECT_TRUE(std::regex_search(rows, std::regex("\n\\|[^|]*`" + room.substr(slash + 1) + "`"))) << room;
    }
    for (const auto& part : fs::directory_iterator(fs::path(source_folder) / "framework"))
        for (const auto& room : fs::directory_iterator(part)) {
            if (!room.is_directory()) continue;
            EXPECT_TRUE(floors.contains(room.path().lexically_relative(part.path().parent_path()).string()))
                << room.path() << " is no room";
        }
}

// CONTRIBUTING prints these lines as the list of a room's files.
TEST(Rooms, HaveHeadersWhoseFirstLineSaysWhatTheyHave) {
    const int count = each_file({"framework", "labs"}, {".h"}, [](const std::string& file, const std::string& text) {
        EXPECT_TRUE(text.starts_with("// ")) << file << ": " << text.substr(0, text.find('\n'));
    });
    EXPECT_GT(count, 200) << "the course has more headers than that";
}

TEST(Dependencies, KeepForeignLibrariesInTheirOwnFiles) {
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
    // The format g writes 1000 as 1e+03 when asked for three digits. rounded() in framework/core/base/text.h does not.
    const std::regex general("[:0-9}]g\\}");
    EXPECT_TRUE(std::regex_search(R"(fmt::format("{:>{}.4g}", 1000, 9))", general));
    int places = 0;
    each_source([&](const std::string& file, const std::string& text) {
        if (!std::regex_search(text, general)) return;
        EXPECT_EQ(file, "framework/core/base/text.cpp");
        ++places;
    });
    EXPECT_EQ(places, 1);
}

/// Returns whether code starts processes, limits them or waits for them. Ignores comments and strings.
bool handles_processes(const std::string& text) {
    static const std::regex dropped("//[^\n]*|\"(\\\\.|[^\"\\\\\n])*\"");
    static const std::regex call(
        "\\b(v?fork|f?exec(l|le|lp|v|ve|vp|vpe)|execveat|posix_spawnp?|popen|system|waitpid|waitid|wait[34]|"
        "setrlimit|prlimit)\\s*\\(");
    return std::regex_search(std::regex_replace(text, dropped, ""), call);
}

TEST(Sources, StartProcessesInOneFileForEachSystem) {
    for (const char* planted : {"const pid_t child = fork();", "execvp (a, b);", "std::system(\"ls\");",
                                "::waitpid(child, &status, 0);", "posix_spawnp(&child, a, b, c, d, e);", "popen(a, b);",
                                "setrlimit(RLIMIT_CPU, &both);", "say(\"fork()\"); vfork();"})
        EXPECT_TRUE(handles_processes(planted)) << planted;
    for (const char* other : {"// fork() copies\n", "say(\"a \\\"fork() call\");", "utsname system{};", "wait();"})
        EXPECT_FALSE(handles_processes(other)) << other;
    Lines places;
    each_source([&](const std::string& file, const std::string& text) {
        if (handles_processes(text)) places.push_back(file);
    });
    std::sort(places.begin(), places.end());
    EXPECT_EQ(places, (Lines{"framework/core/base/process_darwin.cpp", "framework/core/base/process_linux.cpp"}));
}

/// Returns the uses of the operating system's own functions, and of parts of the standard library that are missing on
/// some systems, outside of the files for them.
Lines uses_of_the_system(const std::string& file, const std::string& text) {
    static const std::regex own(
        "framework/core/base/(system|process)_[a-z]+\\.cpp|"
        "framework/course/web/compiled_task\\.cpp");  // only for a browser: the heap of compiled tasks
    if (std::regex_match(file, own) || is_the_staffs(part_of(file))) return {};
    // The headers of POSIX.1-2017 that are not C's, and Linux's.
    static const std::regex header(
        "(aio|cpio|dirent|dlfcn|fcntl|fmtmsg|fnmatch|ftw|glob|grp|iconv|langinfo|libgen|malloc|monetary|mqueue|ndbm|"
        "netdb|nl_types|poll|pthread|pwd|regex|sched|search|semaphore|signal|spawn|strings|stropts|syslog|tar|termios|"
        "time|ulimit|unistd|utime|utmpx|wordexp)\\.h|csignal|(arpa|linux|net|netinet|sys)/.*");
    static const std::regex dropped("//[^\n]*|\"(\\\\.|[^\"\\\\\n])*\"");
    static const std::regex call(
        "\\b(jthread|stop_token)\\b|"
        "\\b(setenv|unsetenv|isatty|getpid|aligned_alloc|fsync|dup[23]?|_exit|clock_gettime|strto[df]_l|mmap|dlopen|"
        "unlink|usleep)\\s*\\(");
    Lines uses;
    for (const std::string& include : includes_of(text))
        // Only GCC's library has conversions of floating-point numbers there. text.cpp converts integers.
        if (std::regex_match(include, header) || (include == "charconv" && file != "framework/core/base/text.cpp"))
            uses.push_back(file + " includes " + include);
    const std::string code = std::regex_replace(text, dropped, "");
    if (std::smatch found; std::regex_search(code, found, call)) uses.push_back(file + " uses " + found.str());
    return uses;
}

TEST(Sources, UseTheSystemInTwoFilesOnly) {
    for (const char* planted :
         {"#include <unistd.h>\n", "#include <sys/mman.h>\n", "#include <csignal>\n", "#include <charconv>\n",
          "std::vector<std::jthread> all;", "setenv(a, b, 1);", "std::aligned_alloc(64, size);", "if (isatty (2))",
          "fsync(file);", "::dup2(a, b);", "_exit(1);"}) {
        EXPECT_FALSE(uses_of_the_system("framework/core/image/file.cpp", planted).empty()) << planted;
        EXPECT_FALSE(uses_of_the_system("labs/07_baking/lab.cpp", planted).empty()) << planted;
        EXPECT_TRUE(uses_of_the_system("framework/core/base/system_linux.cpp", planted).empty()) << planted;
        EXPECT_TRUE(uses_of_the_system("framework/staff/grade/stage.cpp", planted).empty()) << planted;
    }
    for (const char* other : {"#include <regex>\n", "// dup(1) copies\n", "say(\"setenv()\");", "std::_Exit(1);",
                              "os::set_environment(a, b);", "#include <ctime>\n"})
        EXPECT_TRUE(uses_of_the_system("framework/core/image/file.cpp", other).empty()) << other;
    each_source([](const std::string& file, const std::string& text) {
        for (const std::string& use : uses_of_the_system(file, text)) ADD_FAILURE() << use;
    });
}

TEST(Dependencies, FindAPlantedUpwardInclude) {
    const struct {
        const char *file, *include;
        bool right;
    } cases[] = {
        {"framework/core/base/text.h", "framework/core/image/image.h", false},
        {"framework/core/image/mips.cpp", "framework/core/base/error.h", true},
        {"framework/core/image/mips.cpp", "framework/library/mesh/polygon.h", false},
        {"framework/library/mesh/shapes.cpp", "framework/core/image/image.h", true},
        {"framework/library/mesh/shapes.cpp", "framework/library/maps/bounds.h", false},
        {"framework/library/mesh/shapes.cpp", "framework/staff/reference/march.h", false},
        {"framework/core/gl/gpu_mesh.h", "framework/library/mesh/shapes.h", false},
        {"framework/library/maps/test_maps.h", "framework/core/image/image.h", true},
        {"framework/staff/reference/march.h", "framework/core/image/image.h", true},
        {"framework/core/gl/texture.cpp", "framework/core/context/context.h", false},
        {"framework/core/lab/lab.h", "framework/course/window/menu.h", false},
        {"framework/core/lab/lab.h", "framework/core/gl/program.h", true},
        {"framework/core/lab/lab.h", "framework/library/kit/labels.h", false},
        {"framework/library/kit/labels.h", "framework/course/check/check.h", false},
        {"framework/course/check/check.h", "framework/library/kit/labels.h", true},
        {"framework/course/inspect/inspect.h", "framework/staff/reference/march.h", false},
        {"labs/07_baking/lab.cpp", "framework/course/inspect/inspect.h", false},
        {"framework/course/app/shot.cpp", "framework/staff/grade/mistake_pictures.h", false},
        {"framework/library/mesh/obj.cpp", "framework/staff/reference/bake.h", false},
        {"framework/staff/app/bench.cpp", "framework/staff/measure/bench.h", true},
        {"framework/staff/app/bench.cpp", "framework/course/app/command.h", true},
        {"framework/staff/measure/bench.h", "framework/course/window/menu.h", false},
        {"framework/staff/grade/results.cpp", "framework/staff/measure/sweep.h", false},
        {"framework/staff/grade/results.cpp", "framework/course/pages/page.h", false},
        {"framework/course/window/menu.cpp", "framework/core/context/context.h", true},
        {"framework/course/window/menu.cpp", "framework/unheard_of/x.h", false},
        {"framework/course/window/menu.cpp", "../lab/lab.h", false},
        {"framework/core/lab/shot.cpp", "labs/07_baking/bake.h", false},
        {"labs/07_baking/lab.cpp", "framework/core/lab/lab.h", true},
        {"labs/07_baking/lab.cpp", "framework/library/kit/tiles.h", true},
        {"labs/07_baking/lab.cpp", "framework/staff/reference/march.h", false},
        {"labs/07_baking/staff/truth.cpp", "framework/staff/reference/march.h", true},
        {"labs/07_baking/staff/truth.cpp", "framework/staff/grade/marks.h", false},
        {"labs/07_baking/staff/truth.cpp", "framework/staff/measure/bench.h", false},
        {"labs/07_baking/staff/bench.cpp", "framework/staff/measure/bench.h", true},
        {"labs/07_baking/staff/bench.cpp", "framework/staff/app/bench.h", false},
        {"labs/07_baking/staff/bench.cpp", "framework/course/window/menu.h", false},
        {"labs/07_baking/lab.cpp", "framework/course/manifest/manifest.h", false},
        {"labs/07_baking/lab.cpp", "framework/core/context/context.h", false},
        {"labs/07_baking/lab.cpp", "framework/course/window/menu.h", false},
        {"labs/07_baking/lab.cpp", "bake.h", true},
        {"labs/07_baking/lab.cpp", "labs/08_torus/torus.h", false},
        {"assets/staff/make.cpp", "framework/core/image/file.h", true},
        {"assets/staff/make.cpp", "assets/noise.h", true},
        {"assets/bricks.cpp", "assets/staff/quilt.h", false},
        {"framework/core/gl/texture.cpp", "assets/noise.h", false},
        {"assets/staff/make.cpp", "framework/core/gl/texture.h", false},
    };
    for (const auto& [file, include, right] : cases)
        for (const auto& [open, close] : {std::pair("#include \"", "\"\n"), {"int x;\n  # include <", ">"}})
            EXPECT_EQ(wrong_includes(file, std::string(open) + include + close).empty(), right)
                << file << " includes " << include;
    EXPECT_TRUE(wrong_includes("framework/core/base/a.h", "// #include \"framework/course/window/menu.h\"\n").empty())
        << "a comment";
}

TEST(Dependencies, FindAPlantedForeignLibrary) {
    EXPECT_FALSE(wrong_libraries("framework/core/image/file.cpp", "#include <OpenImageIO/imageio.h>\n").empty());
    EXPECT_FALSE(wrong_libraries("framework/course/pages/svg.cpp", "#include <librsvg/rsvg.h>\n").empty());
    EXPECT_FALSE(wrong_libraries("framework/core/lab/shot.cpp", "#include <GLFW/glfw3.h>\n").empty());
    EXPECT_FALSE(wrong_libraries("framework/core/context/window.cpp", "#include <GLFW/glfw3.h>\n").empty());
    EXPECT_FALSE(wrong_libraries("labs/07_baking/lab.cpp", "#include <imgui.h>\n").empty());
    EXPECT_FALSE(wrong_libraries("framework/library/mesh/shapes.cpp", "#include <glad/gl.h>\n").empty());
    EXPECT_FALSE(wrong_libraries("framework/course/pages/page.cpp", "#include <kainjow/mustache.hpp>\n").empty());
    EXPECT_FALSE(wrong_libraries("framework/staff/grade/submission.cpp", "#include <glib.h>\n").empty());
    EXPECT_TRUE(wrong_libraries("framework/course/pages/librsvg.cpp", "#include <librsvg/rsvg.h>\n").empty());
    EXPECT_TRUE(wrong_libraries("framework/core/context/glfw_window.cpp", "#include <GLFW/glfw3.h>\n").empty());
    EXPECT_TRUE(wrong_libraries("framework/course/window/menu_panel.cpp", "#include <imgui.h>\n").empty());
    EXPECT_TRUE(wrong_libraries("framework/core/gl/gl.h", "#include <glad/gl.h>\n").empty());
}

// GCC 16 takes no precompiled header that was compiled at another level of optimisation.
TEST(PrecompiledHeaders, AreUsedAtTheirOwnOptimisationLevel) {
    std::ifstream commands(std::string(build_folder) + "/compile_commands.json");
    ASSERT_TRUE(commands);
    std::map<std::string, std::set<std::string>> levels;
    for (std::string line; std::getline(commands, line);) {
        std::smatch header;
        if (!std::regex_search(line, header, std::regex(" -include (\\S+cmake_pch\\.hxx) "))) continue;
        const size_t last = line.rfind(" -O");  // the last one counts
        levels[header[1]].insert(last == std::string::npos ? "none" : line.substr(last + 1, 3));
    }
    for (const auto& [header, found] : levels) EXPECT_EQ(found.size(), 1u) << header;
}

}  // namespace
}  // namespace relief
