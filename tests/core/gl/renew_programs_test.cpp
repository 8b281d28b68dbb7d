// Programs that follow changes of their files while in use.
#include <gtest/gtest.h>

#include "framework/core/base/error.h"
#include "framework/core/gl/counters.h"
#include "framework/core/gl/program.h"
#include "tests/support.h"

namespace relief {
namespace {

constexpr const char* renewed_vertex = "#version 410 core\nvoid main() { gl_Position = vec4(0.0); }\n";
constexpr const char* renewed_fragment =
    "#version 410 core\n#include \"light.glsl\"\nuniform float u_a;\nout vec4 o_color;\n"
    "void main() {\n#ifdef MORE\no_color = vec4(u_a);\n#else\no_color = vec4(light());\n#endif\n}\n";

class RenewPrograms : public testing::Test {
protected:
    TemporaryFolder folder_;
    const std::filesystem::path vert_ = folder_.write("a.vert", renewed_vertex),
                                frag_ = folder_.write("a.frag", renewed_fragment);
    const std::filesystem::path light_ = light("1.0");
    Programs programs_ = programs();

    std::filesystem::path light(const std::string& value) const {
        return folder_.write("light.glsl", "float light() { return " + value + "; }\n");
    }
    Programs programs() const { return Programs(vert_.c_str(), frag_.c_str()); }
    /// Returns the result of the second of two looks: the first sees a new text, the second sees that it has settled.
    static ShaderNews look_twice() {
        EXPECT_FALSE(renew_programs().changed);
        return renew_programs();
    }
    static bool knows(const Program& program, const char* uniform) {
        glUseProgram(program);
        try {
            program.set(uniform, 1.0f);
        } catch (const Error&) {
            return false;
        }
        return true;
    }
};

TEST_F(RenewPrograms, UnchangedFilesRenewNothing) {
    const GLuint before = programs_.with();
    for (int i = 0; i < 3; ++i) {
        EXPECT_FALSE(renew_programs().changed);
        light("1.0");  // saved without a change
    }
    EXPECT_EQ(GLuint(programs_.with()), before);
}

TEST_F(RenewPrograms, ASavedStageIsRelinkedInPlaceAfterTwoEqualReads) {
    const Program& program = programs_.with();
    const GLuint before = program;
    folder_.write("a.frag", std::string(renewed_fragment) + "uniform float u_new;\n");
    EXPECT_FALSE(knows(program, "u_new"));
    EXPECT_FALSE(renew_programs().changed) << "it may be half written";
    const ShaderNews news = renew_programs();
    EXPECT_TRUE(news.changed);
    EXPECT_FALSE(news.error) << news.error->what();
    EXPECT_EQ(&program, &programs_.with());
    EXPECT_NE(GLuint(program), before);
    EXPECT_TRUE(knows(program, "u_new"));
    EXPECT_FALSE(renew_programs().changed) << "once";
}

TEST_F(RenewPrograms, AnIncludedFileRenewsOnlyItsIncluders) {
    folder_.write("b.frag", "#version 410 core\nout vec4 o_color;\nvoid main() { o_color = vec4(1.0); }\n");
    const Programs other(vert_.c_str(), (folder_.path() / "b.frag").c_str());
    const GLuint first = programs_.with(), second = programs_.with("MORE"), third = other.with();
    light("2.0");
    EXPECT_TRUE(look_twice().changed);
    EXPECT_NE(GLuint(programs_.with()), first);
    EXPECT_NE(GLuint(programs_.with("MORE")), second);
    EXPECT_EQ(GLuint(other.with()), third);
}

TEST_F(RenewPrograms, ACompileErrorKeepsTheLastProgramAndNamesItsLine) {
    const Program& program = programs_.with();
    const GLuint before = program;
    light("brightness");
    ShaderNews news = look_twice();
    EXPECT_TRUE(news.changed);
    ASSERT_TRUE(news.error);
    EXPECT_EQ(news.error->place().file, light_);
    EXPECT_EQ(news.error->place().line, 1);
    EXPECT_NE(news.error->details(), "");
    EXPECT_EQ(GLuint(program), before);
    news = renew_programs();
    EXPECT_FALSE(news.changed) << "it is not tried again";
    EXPECT_TRUE(news.error) << "and stays wrong";

    light("3.0");
    news = look_twice();
    EXPECT_TRUE(news.changed);
    EXPECT_FALSE(news.error);
    EXPECT_NE(GLuint(program), before);
}

// A program is compiled without the functions that it does not use. A person who edits one sees its errors all the
// same.
TEST_F(RenewPrograms, AnErrorInAFunctionOutOfReachLeavesTheProgramAndIsFound) {
    folder_.write("light.glsl", "float light() { return 1.0; }\nfloat other() { return brightness; }\n");
    const Program& program = programs_.with();
    const GLuint before = program;
    const ShaderNews first = look_twice();
    EXPECT_FALSE(first.changed) << "the file is as the program was made of";
    ASSERT_TRUE(first.error);
    EXPECT_EQ(first.error->place().file, light_);
    EXPECT_EQ(first.error->place().line, 2);
    light("1.0");
    const ShaderNews news = look_twice();
    EXPECT_TRUE(news.changed);
    EXPECT_FALSE(news.error);
    EXPECT_NE(GLuint(program), before);
}

TEST_F(RenewPrograms, UndoingAMistakeCompilesNothing) {
    const GLuint before = programs_.with();
    light("brightness");
    EXPECT_TRUE(look_twice().error);
    light("1.0");
    const ShaderNews news = look_twice();
    EXPECT_TRUE(news.changed);
    EXPECT_FALSE(news.error);
    EXPECT_EQ(GLuint(programs_.with()), before);
}

TEST_F(RenewPrograms, ABrieflyMissingFileRenewsNothing) {
    programs_.with();
    for (const auto& file : {frag_, light_}) {
        rename(file, folder_.path() / "away");
        EXPECT_FALSE(renew_programs().error);
        rename(folder_.path() / "away", file);
        EXPECT_FALSE(renew_programs().changed);
        EXPECT_FALSE(renew_programs().changed);
    }
}

TEST_F(RenewPrograms, AMissingFileIsAnErrorUntilItReturns) {
    const GLuint before = programs_.with();
    for (const auto& file : {frag_, light_}) {
        rename(file, folder_.path() / "away");
        EXPECT_TRUE(look_twice().error);
        EXPECT_EQ(GLuint(programs_.with()), before);
        rename(folder_.path() / "away", file);
        EXPECT_FALSE(look_twice().error);
        EXPECT_EQ(GLuint(programs_.with()), before);
    }
}

TEST_F(RenewPrograms, AFileReplacedByRenamingIsReloaded) {
    programs_.with();
    rename(folder_.write("light.glsl.new", "float light() { return brightness; }\n"), light_);
    EXPECT_TRUE(look_twice().error);
}

TEST_F(RenewPrograms, AProgramThatFailedAtFirstUseCanBeRetriedAfterAChange) {
    light("brightness");
    EXPECT_THROW(programs_.with(), Error);
    EXPECT_FALSE(renew_programs().changed);
    EXPECT_FALSE(renew_programs().error) << "it was thrown already";
    light("1.0");
    EXPECT_TRUE(look_twice().changed);
    EXPECT_NO_THROW(programs_.with());
}

TEST_F(RenewPrograms, MovedProgramsAreStillWatchedButDestroyedOnesAreNot) {
    programs_.with();
    Programs moved = std::move(programs_);
    const GLuint before = moved.with();
    light("2.0");
    EXPECT_TRUE(look_twice().changed);
    EXPECT_NE(GLuint(moved.with()), before);
    moved = programs();
    light("brightness");
    EXPECT_FALSE(renew_programs().changed);
    EXPECT_FALSE(renew_programs().error);
}

TEST_F(RenewPrograms, RenewalsLeakNoObjectEvenIfTheyFail) {
    programs_.with();
    const Counters before = counters();
    for (const char* value : {"2.0", "brightness", "3.0", "nonsense(", "1.0"}) {
        light(value);
        EXPECT_TRUE(look_twice().changed) << value;
        EXPECT_EQ(counters().live, before.live) << value;
    }
}

}  // namespace
}  // namespace relief
