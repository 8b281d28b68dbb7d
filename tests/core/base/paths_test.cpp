// The course's place on disk, and how its paths are shown.
#include "framework/core/base/paths.h"

#include "tests/support.h"

namespace relief {
namespace {

namespace fs = std::filesystem;

TEST(Paths, TheCourseHasLabsAndShaders) {
    EXPECT_TRUE(course_root().is_absolute()) << course_root();
    EXPECT_TRUE(fs::is_directory(course_root() / "labs"));
    EXPECT_TRUE(fs::is_directory(course_root() / "shaders"));
}

TEST(Paths, TheExecutableFolderContainsTheExecutable) {
    const fs::path executable = fs::read_symlink("/proc/self/exe");
    EXPECT_TRUE(fs::equivalent(executable_folder() / executable.filename(), executable));
}

TEST(Paths, AreShownRelativeToTheCourseRoot) {
    EXPECT_EQ(shown(course_root() / "shaders" / "common" / "light.glsl"), "shaders/common/light.glsl");
}

TEST(Paths, OutsideTheCourseAreShownAsTheyAre) {
    EXPECT_EQ(shown("labs/lab.toml"), "labs/lab.toml") << "relative to the working directory";
    EXPECT_EQ(shown("/nowhere/a.png"), "/nowhere/a.png");
    const std::string neighbour = course_root().string() + "2/a.png";
    EXPECT_EQ(shown(neighbour), neighbour) << "a folder whose name only begins like the course's";
    EXPECT_EQ(shown(course_root().parent_path()), course_root().parent_path().string());
}

}  // namespace
}  // namespace relief
