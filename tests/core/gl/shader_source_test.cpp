// Shader text from files, and the mapping from a compiler's line to a source line.
#include "framework/core/gl/shader_source.h"

#include <algorithm>
#include <sstream>

#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
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
        const Place& place = source.lines[i - 1];
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

TEST_F(Shaders, MayHaveAByteOrderMarkSpacedIncludesAndTheLineEndsOfAnySystem) {
    for (const char* end : {"\n", "\r\n", "\r"}) {
        const auto ended = [&](const std::string& text) { return join(split(text, '\n'), end); };
        folder_.write("a.glsl", ended("// a comment\nfloat a;\n"));
        const ShaderSource source =
            load(ended("\xef\xbb\xbf#version 410 core\n#  include \"a.glsl\" // why\n#include \"a.glsl\"\nfloat b;\n"));
        EXPECT_TRUE(contains(source.text, "// a comment\nfloat a;\nfloat b;\n")) << source.text;
        EXPECT_EQ(source.lines.back().line, 4);
    }
}

TEST_F(Shaders, NameTheFileWhoseTextTheCompilerWouldBlameOnAnother) {
    for (const auto& [text, line] : std::vector<std::pair<std::string, std::string>>{
             {"float a;\n#if 1\n", ":2: this #if has no #endif"},
             {"float a; // \\", ":1: the last line ends in a backslash"},
             {"float a;\n/*\n", ":2: this comment is never closed"},
             {"float a;\nfloat\xc2\xa0"
              "b;\n",
              ":2: column 6 is a no-break space"},
             {std::string("\xff\xfe/\0/\0\n\0", 8), ": this is text in UTF-16"}}) {
        folder_.write("a.glsl", text);
        const std::string message =
            message_of([&] { load("#version 410 core\n#if 1\n#include \"a.glsl\"\n#endif\n/* */\n"); });
        EXPECT_TRUE(contains(message, "a.glsl" + line)) << message;
    }
}

TEST_F(Shaders, KnowTheUniformsTheyName) {
    folder_.write("a.glsl", "uniform sampler2D s_albedo;\n");
    const ShaderSource source =
        load("#version 410 core\n#include \"a.glsl\"\nuniform float u_scale, menu_size; // u_old\n");
    EXPECT_EQ(source.names, (std::set<std::string>{"s_albedo", "u_old", "u_scale"}));
}

TEST_F(Shaders, HaveAReachedPartWithoutOtherFunctionsCommentsAndEmptyLines) {
    const ShaderSource reached =
        reached_source(load("#version 410 core\n"
                            "// A comment.\n"
                            "\n"
                            "float half_of(float x) { return x / 2.0; } /* of two\n"
                            "lines */ float unused(float x) {\n"
                            "#ifdef MORE\n"
                            "    x = half_of(x);\n"
                            "#endif\n"
                            "    return x;\n"
                            "}\n"
                            "float quarter_of(float x) { return half_of(half_of(x)); }\n"
                            "void main() { quarter_of(1.0); }\n",
                            {"NAME 1"}));
    EXPECT_EQ(reached.text,
              "#version 410 core\n#define NAME 1\n"
              "float half_of(float x) { return x / 2.0; }\n"
              "float quarter_of(float x) { return half_of(half_of(x)); }\n"
              "void main() { quarter_of(1.0); }\n");
    std::vector<int> lines;
    for (const Place& place : reached.lines) lines.push_back(place.line);
    EXPECT_EQ(lines, (std::vector<int>{1, 0, 4, 11, 12}));
}

TEST_F(Shaders, KeepInTheirReachedPartWhatAPreprocessorLineMayUse) {
    const std::string text =
        "#version 410 core\n"
        "#define TWICE(x) \\\n"
        "\\\n"
        "    by_macro(by_macro(x))\n"
        "float by_macro(float x) { return x; }\n"
        "float by_definition(float x) { return x; }\n"
        "float over(float x) { return x; }\n"
        "float over(vec2 x) { return x.x; }\n"
        "#ifdef FLAT\n"
        "float either(float x)\n"
        "#else\n"
        "float either(vec2 x)\n"
        "#endif\n"
        "{ return 1.0; }\n"
        "float with_macro(float x) {\n"
        "#define INSIDE 1.0\n"
        "return x;\n"
        "}\n"
        "void main() { over(INSIDE); }\n";
    ShaderSource source = load(text, {"CALL by_definition"});
    std::string expected = source.text;
    const std::string left_out = "float either(float x)\n";
    expected.erase(expected.find(left_out), left_out.size());
    EXPECT_EQ(reached_source(source).text, expected);
    EXPECT_EQ(reached_source(load(text)).text.find("by_definition"), std::string::npos);
    const ShaderSource open = load("#version 410 core\nfloat f() { return 1.0; }\nvoid main() {\nfloat g() { {\n");
    EXPECT_EQ(count(reached_source(open).text, "main"), 1) << "brackets that do not match";
}

TEST_F(Shaders, HaveAReachedPartWithoutWhatTheirDefinitionsLeaveOut) {
    const std::string text =
        "#version 410 core\n"
        "float near_of(float x) { return x; }\n"
        "float far_of(float x) { return -x; }\n"
        "void main() {\n"
        "#ifdef FAR\n"
        "    far_of(1.0);\n"
        "#else\n"
        "    near_of(1.0);\n"
        "#endif\n"
        "}\n";
    const std::string far_text = reached_source(load(text, {"FAR"})).text, near_text = reached_source(load(text)).text;
    EXPECT_EQ(far_text.find("near_of"), std::string::npos) << far_text;
    EXPECT_EQ(count(far_text, "far_of"), 2) << far_text;
    EXPECT_EQ(near_text.find("far_of"), std::string::npos) << near_text;
    EXPECT_EQ(count(near_text, "near_of"), 2) << near_text;
}

TEST_F(Shaders, KeepAllFunctionsInTheirReachedPartWhereTheirEndsAreNotKnown) {
    const std::string needed = "float needed(float x) { return x; }\n", main = "void main() { needed(1.0); }\n";
    for (const char* strange :
         {"float h(float x) {\n#ifdef A\n if (x > 0.0) {\n#else\n {\n#endif\n x += 1.0; } return x; }\nNEEDED"
          "float k(float x) { if (x > 0.0) {\n#ifdef B\n x = 1.0; }\n#else\n x = 2.0; }\n#endif\n return x; }\n",
          "#define LOOP for (int i = 0; i < 4; ++i) {\nfloat f(float x) { LOOP x += 1.0; } return x; }\nNEEDED",
          "#define NAME(n) need##n\nNEEDED"}) {
        std::string text = std::string("#version 410 core\n") + strange + main;
        text.replace(text.find("NEEDED"), 6, needed);
        const std::string reached = reached_source(load(text)).text;
        EXPECT_TRUE(contains(reached, "float needed(float x) { return x; }")) << text << reached;
        EXPECT_EQ(count(reached, "{"), count(reached, "}")) << reached;
    }
    const std::string marked = "#version 410 core\n#define P highp\nP float f(float x) { return x; }\n" + needed + main;
    EXPECT_TRUE(contains(reached_source(load(marked)).text, "P float f(float x)")) << "what is before it belongs to it";
    const std::string blank = "#version 410 core\n#define A 1 \\ \n#define B 2\n" + needed + main;
    EXPECT_TRUE(contains(reached_source(load(blank)).text, "\\ \n")) << "it does not join lines";
}

TEST_F(Shaders, SurviveVeryLongNamesAndLines) {
    const std::string name = "u_" + std::string(1 << 20, 'x');
    EXPECT_EQ(load("#version 410 core\nuniform float " + name + ";\n").names.count(name), 1u);
    EXPECT_THROW(load("#version 410 core\n#include \"" + name + "\n"), Error);
}

}  // namespace
}  // namespace relief
