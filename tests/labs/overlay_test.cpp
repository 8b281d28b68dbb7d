// A course with replaced files, and handouts that must be refused.
#include "framework/staff/grade/overlay.h"

#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/staff/handout/handout.h"
#include "tests/support.h"

namespace relief {
namespace {

constexpr const char* task = "shaders/02_normal_map_storage/task.glsl";

TEST(CourseOverlay, ReplacesItsFilesAndKeepsTheOthersWhileItLives) {
    const std::filesystem::path root = course_root().string();  // while the overlay lives, it is another one
    const std::string before = read_file(root / task);
    {
        const grade::CourseOverlay overlay({{task, "// mine"}, {"labs/99_x/new.txt", "new"}});
        EXPECT_NE(course_root(), root);
        EXPECT_EQ(read_file(course_root() / task), "// mine");
        EXPECT_EQ(read_file(course_root() / "labs/99_x/new.txt"), "new");
        for (const char* other : {"shaders/02_normal_map_storage/sphere.frag", "shaders/common/heat.glsl",
                                  "labs/01_specular_highlights/lab.toml", "README.md"})
            EXPECT_EQ(read_file(course_root() / other), read_file(root / other)) << other;
    }
    EXPECT_EQ(course_root(), root);
    EXPECT_EQ(read_file(root / task), before);
    EXPECT_FALSE(std::filesystem::exists(root / "labs/99_x"));
}

TEST(CourseOverlay, EditsReplaceATextThatOccursExactlyOnce) {
    const grade::CourseFiles files =
        grade::edited({{task, "encode_paired8(vec3 normal)", "X"}, {task, "encode_unorm8(vec3 normal)", "Y"}});
    ASSERT_EQ(files.size(), 1u);
    EXPECT_TRUE(contains(files.at(task), "vec3 X {") && contains(files.at(task), "vec3 Y {"));
    for (const char* find : {"nowhere to be found", "vec3", ""})
        EXPECT_TRUE(contains(message_of([&] {
                                 grade::edited({{task, find, "x"}});
                             }),
                             "must occur exactly once"))
            << find;
    EXPECT_TRUE(contains(message_of([&] { grade::edited({{"no/file", "a", "b"}}); }), "no/file: cannot read"));
}

TEST(Handout, IsRefusedWhenALabIncludesAStaffFile) {
    const char* const surface = "shaders/06_tangent_space/surface.frag";
    grade::CourseFiles files =
        grade::edited({{surface, "#include \"common/light.glsl\"", "#include \"common/staff/x.glsl\""}});
    files["shaders/common/staff/x.glsl"] = "\n";
    const grade::CourseOverlay overlay(files);
    const TemporaryFolder folder;
    const std::string message = message_of([&] { handout::write_handout(folder.path() / "handout"); });
    EXPECT_TRUE(contains(message, "includes shaders/common/staff/x.glsl, which students do not get")) << message;
}

TEST(Handout, IsRefusedWhenALabIncludesAShaderOfAnother) {
    const char* const surface = "shaders/06_tangent_space/surface.frag";
    const grade::CourseOverlay overlay(
        grade::edited({{surface, "#include \"common/light.glsl\"", "#include \"05_tangent_basis/task.glsl\""}}));
    const TemporaryFolder folder;
    const std::string message = message_of([&] { handout::write_handout(folder.path() / "handout"); });
    EXPECT_TRUE(contains(message, "includes shaders/05_tangent_basis/task.glsl of another lab")) << message;
}

TEST(Handout, IsRefusedWhenMarksDoNotPair) {
    const grade::CourseOverlay overlay(grade::edited({{task, "// TASK 2.4", "//[solution\n// TASK 2.4"}}));
    const TemporaryFolder folder;
    EXPECT_TRUE(contains(message_of([&] { handout::write_handout(folder.path() / "handout"); }), "task.glsl:"));
}

}  // namespace
}  // namespace relief
