#include "framework/core/gl/program.h"

#include <gtest/gtest.h>

#include "framework/core/base/error.h"
#include "framework/core/gl/counters.h"
#include "framework/core/gl/texture.h"
#include "tests/support.h"

namespace relief {
namespace {

constexpr const char* good_vertex = "#version 410 core\nvoid main() { gl_Position = vec4(0.0); }\n";

class ProgramTest : public testing::Test {
protected:
    TemporaryFolder folder_;

    Program program(const std::string& vertex, const std::string& fragment,
                    const std::vector<std::string>& defines = {}) {
        folder_.write("a.vert", vertex), folder_.write("a.frag", fragment);
        return Program({folder_.path() / "a.vert", folder_.path() / "a.frag"}, defines);
    }
    Error error_of(const std::string& vertex, const std::string& fragment) {
        try {
            program(vertex, fragment);
        } catch (const Error& error) {
            return error;
        }
        ADD_FAILURE() << "it compiled";
        return Error("");
    }
};

TEST_F(ProgramTest, ACompileErrorNamesTheSourceFileAndLine) {
    const Error error =
        error_of(good_vertex, "#version 410 core\nout vec4 o_color;\nvoid main() { o_color = colour; }\n");
    EXPECT_EQ(error.place().file, folder_.path() / "a.frag");
    EXPECT_EQ(error.place().line, 3);
    EXPECT_NE(std::string(error.what()).find("colour"), std::string::npos) << error.what();
}

TEST_F(ProgramTest, MismatchedStagesAreALinkError) {
    const Error error =
        error_of("#version 410 core\nout vec2 v_uv;\nvoid main() { v_uv = vec2(0.0); gl_Position = vec4(0.0); }\n",
                 "#version 410 core\nin vec3 v_uv;\nout vec4 o_color;\n"
                 "void main() { o_color = vec4(v_uv, 1.0); }\n");
    EXPECT_NE(std::string(error.what()).find("does not link"), std::string::npos) << error.what();
}

TEST_F(ProgramTest, AFailedProgramLeavesNoObjectBehind) {
    const Counters before = counters();
    error_of(good_vertex, "#version 410 core\nnonsense\n");
    EXPECT_EQ(counters().live, before.live);
}

constexpr const char* uniforms =
    "#version 410 core\nuniform float u_strength;\nuniform float u_unused;\nuniform sampler2D s_map;\n"
    "out vec4 o_color;\nvoid main() {\n#ifdef MAP\n o_color = texture(s_map, vec2(0.0));\n#else\n"
    " o_color = vec4(u_strength);\n#endif\n}\n";

TEST_F(ProgramTest, AnUndeclaredUniformIsAnErrorWithASuggestion) {
    const Program shader = program(good_vertex, uniforms);
    glUseProgram(shader);
    EXPECT_NO_THROW(shader.set("u_strength", 1.0f));
    EXPECT_NO_THROW(shader.set("u_unused", 1.0f)) << "declared, but not in use: a permutation may drop it";
    try {
        shader.set("u_stregnth", 1.0f);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("did you mean 'u_strength'"), std::string::npos) << error.what();
    }
}

TEST_F(ProgramTest, AnUnusedSamplerLoadsNoTexture) {
    int loads = 0;
    const Texture map("map", [&] { return ++loads, Image(1, 1, 3, 8); });
    const Program without = program(good_vertex, uniforms);
    glUseProgram(without);
    without.set("s_map", 0, map);
    EXPECT_EQ(loads, 0);
    const Program with = program(good_vertex, uniforms, {"MAP"});
    glUseProgram(with);
    with.set("s_map", 0, map);
    EXPECT_EQ(loads, 1);
}

TEST(Programs, CompileEachPermutationOnceAndOnlyWhenAsked) {
    const Programs surface{"01_specular_highlights/surface.vert", "01_specular_highlights/surface.frag"};
    const int64_t before = counters().links;
    const Program& plain = surface.with();
    EXPECT_EQ(&plain, &surface.with({""}));
    EXPECT_EQ(counters().links, before + 1);
    const Program& mapped = surface.with({"NORMAL_MAP"});
    EXPECT_NE(&plain, &mapped);
    EXPECT_EQ(&mapped, &surface.with({"", "NORMAL_MAP"}));
    EXPECT_EQ(counters().links, before + 2);
}

}  // namespace
}  // namespace relief
