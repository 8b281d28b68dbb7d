// Shader text from files, and the mapping from a compiler's line to a source line.
#include "framework/core/gl/shader_source.h"

#include <algorithm>
#include <sstream>

#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "tests/support.h"

namespace relief {
namespace {

namespace fs = std::filesystem;

int count(const std::string& text, const std::string& part) {
    int found = 0;
    for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

/// Returns the lines of a text, indexed from 1.
std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines = {""};
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

class Shaders : public testing::Test {
protected:
    ShaderSource load(const std::string& text, const std::vector<std::string>& defines = {}) const {
        return load_shader(folder_.write("stage.frag", text), defines);
    }
    /// Returns the files of a source, in the order of their first lines.
    std::vector<std::string> files_of(const ShaderSource& source) const {
        std::vector<std::string> files;
        for (const Place& place : source.lines) {
            if (place.file.empty()) continue;
            const fs::path near = place.file.lexically_proximate(folder_.path());
            const std::string name = near.begin()->string() == ".." ? shown(place.file) : near.string();
            if (std::find(files.begin(), files.end(), name) == files.end()) files.push_back(name);
        }
        return files;
    }
    TemporaryFolder folder_;
};

TEST_F(Shaders, DefinesFollowTheVersion) {
    const ShaderSource source = load("#version 410 core\nvoid main() {}\n", {"PROBE_uv", "STEPS 32"});
    EXPECT_EQ(source.text, "#version 410 core\n#define PROBE_uv\n#define STEPS 32\nvoid main() {}\n");
}

TEST_F(Shaders, IncludesAreLookedForBesideTheFileThenInShaders) {
    folder_.write("common/light.glsl", "float beside;\n");
    folder_.write("part/a.glsl", "#include \"b.glsl\"\nfloat a;\n");
    folder_.write("part/b.glsl", "float b;\n");
    const ShaderSource source = load(
        "#version 410 core\n"
        "#include \"common/light.glsl\"\n"
        "#include \"part/a.glsl\"\n"
        "#include \"common/srgb.glsl\"\n");
    EXPECT_EQ(files_of(source), (std::vector<std::string>{"stage.frag", "common/light.glsl", "part/b.glsl",
                                                          "part/a.glsl", "shaders/common/srgb.glsl"}));
    EXPECT_LT(source.text.find("float b;"), source.text.find("float a;")) << "in the include's place";
    EXPECT_TRUE(contains(source.text, "float beside;"));
}

TEST_F(Shaders, IncludeAFileOnceEvenInACycleOrUnderAnotherSpelling) {
    folder_.write("a.glsl", "#include \"b.glsl\"\nfloat a;\n");
    folder_.write("b.glsl", "#include \"a.glsl\"\n#include \"stage.frag\"\nfloat b;\n");
    const ShaderSource source = load(
        "#version 410 core\n"
        "#include \"a.glsl\"\n"
        "#include \"./a.glsl\"\n"
        "#include \"part/../b.glsl\"\n"
        "void main() {}\n");
    for (const char* part : {"float a;", "float b;", "#version", "void main"})
        EXPECT_EQ(count(source.text, part), 1) << part;
}

TEST_F(Shaders, MapEveryLineBackToItsSourceLine) {
    folder_.write("a.glsl", "float a_first;\n\nfloat a_third;");
    folder_.write("b.glsl", "// comment\n#include \"a.glsl\"\n#include \"c.glsl\"\nfloat b_fourth;\n");
    folder_.write("c.glsl", "float c_first;\n");
    folder_.write("empty.glsl", "");
    const ShaderSource source = load(
        "#version 410 core\n"
        "float second;\n"
        "#include \"a.glsl\"\n"
        "float fourth;\n"
        "  #include \"b.glsl\" // why\n"
        "float sixth;\n"
        "#include \"a.glsl\"\n"
        "#include \"empty.glsl\"\n"
        "float ninth;",
        {"A", "B 1"});
    const std::vector<std::string> lines = lines_of(source.text);
    ASSERT_EQ(lines.size(), source.lines.size() + 1);
    std::string places;
    for (size_t i = 1; i < lines.size(); ++i) {
        // Like a compiler's error about this line of the text.
        const Place place = explain_log("0:" + std::to_string(i) + "(5): error: x", source.lines).first;
        if (place.file.empty()) {
            EXPECT_TRUE(lines[i].starts_with("#define ")) << lines[i];
            continue;
        }
        EXPECT_EQ(lines[i], lines_of(read_file(place.file)).at(size_t(place.line))) << place.file << ":" << place.line;
        places += place.file.stem().string() + std::to_string(place.line) + " ";
    }
    EXPECT_EQ(places, "stage1 stage2 a1 a2 a3 stage4 b1 c1 b4 stage6 stage9 ");
}

TEST_F(Shaders, IgnoreIncludesInComments) {
    const ShaderSource source = load(
        "#version 410 core\n"
        "/* one line */\n"
        "/*\n"
        "#include \"no.glsl\"\n"
        "*/ /*/\n"
        "#include \"no.glsl\"\n"
        "*/ // /*\n"
        "// #include \"no.glsl\"\n"
        "#include \"common/srgb.glsl\"\n");
    EXPECT_EQ(files_of(source), (std::vector<std::string>{"stage.frag", "shaders/common/srgb.glsl"}));
    EXPECT_EQ(count(source.text, "no.glsl"), 3);
}

TEST_F(Shaders, AMissingIncludeNamesItsLineAndTheNearestFile) {
    folder_.write("a.glsl", "\n#include \"common/lihgt.glsl\"\n");
    const std::string message = message_of([&] { load("#version 410 core\n#include \"a.glsl\"\n"); });
    EXPECT_EQ(message,
              (folder_.path() / "a.glsl").string() +
                  ":2: cannot find the included file \"common/lihgt.glsl\": did you mean \"common/light.glsl\"?");
    EXPECT_TRUE(contains(message_of([&] { load("#version 410 core\n#include \"\"\n"); }), "stage.frag:2: "));
    EXPECT_TRUE(contains(message_of([&] { load("#version 410 core\n#include \".\"\n"); }), "stage.frag:2: "))
        << "a folder";
}

TEST_F(Shaders, AMisspelledIncludeErrorShowsTheSyntax) {
    for (const char* line : {"#include <a.glsl>", "#include a.glsl", "#include", "#include \"a.glsl\" x"}) {
        const std::string message = message_of([&] { load(std::string("#version 410 core\n\n") + line + "\n"); });
        EXPECT_TRUE(contains(message, "stage.frag:3: write #include \"folder/file.glsl\"")) << line << ": " << message;
    }
}

TEST_F(Shaders, AStageMustBeginWithItsVersion) {
    for (const char* text : {"void main() {}\n", "\n#version 410 core\n", "// c\n#version 410 core\n", "\n", "",
                             "#version 450 core\n", "#version 330 core\n", "#version 410\n"})
        EXPECT_TRUE(contains(message_of([&] { load(text); }), "stage.frag:1: a stage must begin with #version"))
            << "'" << text << "'";
    EXPECT_TRUE(contains(message_of([&] { load_shader(folder_.path() / "no.vert", {}); }), "no.vert: cannot read"));
}

TEST_F(Shaders, AByteOrderMarkAndASpacedIncludeWork) {
    folder_.write("a.glsl", "float a;\n");
    EXPECT_TRUE(contains(load("\xef\xbb\xbf#version 410 core\n#  include \"a.glsl\"\n").text, "float a;"));
}

TEST_F(Shaders, FilesFromWindowsWork) {
    folder_.write("a.glsl", "float a;\r\n");
    const ShaderSource source =
        load("#version 410 core\r\n#include \"a.glsl\" // why\r\n#include \"a.glsl\"\r\nfloat b;\r\n");
    EXPECT_EQ(source.lines.back().line, 4);
}

TEST_F(Shaders, KnowTheUniformsTheyName) {
    folder_.write("a.glsl", "uniform sampler2D s_albedo;\n");
    const ShaderSource source =
        load("#version 410 core\n#include \"a.glsl\"\nuniform float u_scale, menu_size; // u_old\n");
    EXPECT_EQ(source.names, (std::set<std::string>{"s_albedo", "u_old", "u_scale"}));
}

TEST_F(Shaders, SurviveVeryLongNamesAndLines) {
    const std::string name = "u_" + std::string(1 << 20, 'x');
    EXPECT_EQ(load("#version 410 core\nuniform float " + name + ";\n").names.count(name), 1u);
    EXPECT_THROW(load("#version 410 core\n#include \"" + name + "\n"), Error);
    EXPECT_EQ(explain_log("0:1(1): error: " + name, {{"a.frag", 3}}).first.line, 3);
}

/// A stage of ten lines whose fourth to sixth come from an include, with one #define.
const std::vector<Place> ten_lines = {{"a.frag", 1},     {},
                                      {"a.frag", 2},     {"light.glsl", 1},
                                      {"light.glsl", 2}, {"light.glsl", 3},
                                      {"a.frag", 4},     {"a.frag", 5},
                                      {"a.frag", 6},     {"a.frag", 7}};

TEST(ShaderLogs, AreParsedForMesaNvidiaAppleAndAmd) {
    for (const char* line : {"0:5(12): error: 'x' undeclared", "0(5) : error C1008: 'x' undeclared",
                             "ERROR: 0:5: 'x' undeclared", "0:5: error: 'x' undeclared"}) {
        const ShaderLog log = explain_log(line, ten_lines);
        EXPECT_EQ(log.first.file, "light.glsl") << line;
        EXPECT_EQ(log.first.line, 2) << line;
        EXPECT_TRUE(contains(log.first_message, "'x' undeclared")) << line;
        EXPECT_EQ(log.text, "light.glsl:2: " + log.first_message + "\n") << line;
    }
}

TEST(ShaderLogs, QuoteTheSourceLineOnceWithACaretBelowTheColumn) {
    const std::string source = "1\n2\n3\n4\n\tx = y;\n6\n7\n8\n9\n10\n";
    EXPECT_EQ(
        explain_log("0:5(6): error: 'y' undeclared\n0:5(6): error: type mismatch\n0(6) : error: x\n", ten_lines, source)
            .text,
        "light.glsl:2: error: 'y' undeclared\n    \tx = y;\n    \t    ^\nlight.glsl:2: error: type mismatch\n"
        "light.glsl:3: error: x\n    6\n");
    for (const char* nowhere : {"0:5(99): error: x", "0:5(0): error: x"})
        EXPECT_EQ(explain_log(nowhere, ten_lines, source).text, "light.glsl:2: error: x\n    \tx = y;\n") << nowhere;
    EXPECT_EQ(explain_log("0:5(6): error: x", ten_lines, "1\n2\n3\n4\n    x  = y;\n").text,
              "light.glsl:2: error: x\n        x  = y;\n             ^\n")
        << "Mesa counts blanks that follow each other as one";
    EXPECT_EQ(explain_log("0:11(1): error: x", ten_lines, source).text, "error: x\n");
}

TEST(ShaderLogs, TheFirstErrorIsNotAWarning) {
    for (const char* warning :
         {"0:3(1): warning: 'a' unused", "0(3) : warning C7050: 'a' unused", "WARNING: 0:3: 'a' unused"}) {
        const ShaderLog log =
            explain_log(std::string(warning) + "\nERROR: 0:4: no such type\nERROR: 0:9: more\n", ten_lines);
        EXPECT_EQ(log.first.file, "light.glsl") << warning;
        EXPECT_EQ(log.first.line, 1) << warning;
        EXPECT_EQ(log.first_message, "no such type") << warning;
        EXPECT_EQ(count(log.text, "\n"), 3) << "all lines are kept: " << log.text;
        EXPECT_TRUE(log.text.starts_with("a.frag:2: ")) << log.text;
    }
}

TEST(ShaderLogs, AHeadingDoesNotHideTheFirstPlace) {
    const ShaderLog log = explain_log("Fragment info\n-------------\n0(5) : error C1008: x\n", ten_lines);
    EXPECT_EQ(log.first.file, "light.glsl");
    EXPECT_EQ(log.first_message, "error C1008: x");
    EXPECT_EQ(log.text, "Fragment info\n-------------\nlight.glsl:2: error C1008: x\n");
}

TEST(ShaderLogs, LinesWithoutAKnownPlaceAreKept) {
    const ShaderLog link = explain_log("error: no fragment output\r\n\n", {});
    EXPECT_EQ(link.text, "error: no fragment output\n");
    EXPECT_EQ(link.first_message, "error: no fragment output");
    EXPECT_TRUE(link.first.file.empty());
    for (const char* line :
         {"0:0(0): error: x", "0:11(5): error: x", "0:99999999999(1): error: x", "0:2(1): error: x"}) {
        const ShaderLog log = explain_log(line, ten_lines);
        EXPECT_TRUE(contains(log.text, "error: x")) << line;
        EXPECT_EQ(log.first_message, "error: x") << line;
        EXPECT_TRUE(log.first.file.empty()) << line;
    }
    EXPECT_EQ(explain_log("", ten_lines).text, "");
    EXPECT_EQ(explain_log(std::string("0:1(1): error: x\n\0", 18), ten_lines).text, "a.frag:1: error: x\n")
        << "a driver's closing zero";
}

}  // namespace
}  // namespace relief
