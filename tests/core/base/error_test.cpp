// The place in an error's message.
#include "framework/core/base/error.h"

#include "framework/core/base/paths.h"
#include "tests/support.h"

namespace relief {
namespace {

TEST(Errors, AreOneLine) {
    EXPECT_STREQ(Error("first\nsecond\n\n").what(), "first second");
    EXPECT_STREQ(Error({"a.glsl", 3}, "first\nsecond\n").what(), "a.glsl:3: first second");
}

TEST(Errors, ShowCourseFilesRelativeToTheCourseRoot) {
    const auto file = course_root() / "labs" / "07_baking" / "lab.toml";
    EXPECT_STREQ(Error({file, 12}, "no title").what(), "labs/07_baking/lab.toml:12: no title");
    EXPECT_STREQ(Error({file}, "missing").what(), "labs/07_baking/lab.toml: missing") << "line 0 is the whole file";
}

TEST(Errors, ShowOtherFilesAsTheyAre) {
    EXPECT_STREQ(Error({"/nowhere/a.png"}, "missing").what(), "/nowhere/a.png: missing");
    EXPECT_STREQ(Error({"relative/a.png", 1}, "missing").what(), "relative/a.png:1: missing");
    EXPECT_STREQ(Error(Place{}, "no place").what(), "no place");
}

TEST(Errors, KeepTheirPlaceAndTheWholeLog) {
    const Error error({"a.frag", 5}, "x", "line 1\nline 2\n");
    EXPECT_EQ(error.place().file, "a.frag");
    EXPECT_EQ(error.place().line, 5);
    EXPECT_EQ(error.details(), "line 1\nline 2\n");
    EXPECT_EQ(Error("x").place().line, 0);
    EXPECT_EQ(Error("x").details(), "");
}

TEST(Errors, IncludeUsageErrors) { EXPECT_THROW(throw UsageError("no such lab"), Error); }

}  // namespace
}  // namespace relief
