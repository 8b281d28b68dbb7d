// The lab made by `relief new-lab` builds, runs and passes without changes.
#include "framework/core/image/file.h"
#include "tests/course/app/course_with_new_lab.h"

namespace relief::app {
namespace {

class NewLab : public testing::Test {
protected:
    void SetUp() override { ASSERT_EQ(course_.failure, ""); }
    const CourseWithNewLab& course_ = CourseWithNewLab::get();
};

TEST_F(NewLab, SaysWhatItMadeAndTakesTheFirstNumberAboveTheCourses) {
    EXPECT_EQ(course_.made.code, 0) << course_.made.err;
    for (const char* file :
         {"labs/20_test_wall/lab.cpp", "labs/20_test_wall/staff/truth.cpp", "labs/20_test_wall/lab.toml",
          "labs/20_test_wall/README.md", "shaders/20_test_wall/surface.vert", "shaders/20_test_wall/surface.frag",
          "slides/20_test_wall.md"})
        EXPECT_TRUE(contains(course_.made.out, std::string(file) + "\n")) << course_.made.out;
    EXPECT_TRUE(contains(course_.made.out, "./relief run 20")) << course_.made.out;
}

TEST_F(NewLab, IsListedByItsFolderAlone) {
    const Result list = run({course_.program("relief"), "list"});
    EXPECT_EQ(list.code, 0) << list.err;
    EXPECT_TRUE(contains(list.out, "\n20  test_wall              Test wall ")) << list.out;
}

TEST_F(NewLab, KeepsItsTruthWithTheStaff) {
    const std::filesystem::path lab = course_.course.path() / "labs/20_test_wall";
    EXPECT_TRUE(contains(read_all(lab / "staff/truth.cpp"), "ray.direction"));
    for (const char* file : {"lab.cpp", "truth.h"})
        EXPECT_FALSE(contains(read_all(lab / file), "ray.direction")) << file;
}

TEST_F(NewLab, PassesTheTestsOfEveryLab) {
    const Result result = run({course_.program("labs_tests"), "--context", "auto"});
    EXPECT_EQ(result.code, 0) << result.out << result.err;
    EXPECT_TRUE(contains(result.out, "EachProbeIsFiniteAgreesWithItsTruthAndRepeatsNoColour/Lab20_test_wall"))
        << result.out;
}

TEST_F(NewLab, HasAnExecutableOfItsOwnAndItsErrorMap) {
    const Result result =
        run({course_.program("lab-20"), "shot", "--error", "position", "-o", "e.exr", "--size", "64x48"},
            {course_.course.path(), {}});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_TRUE(contains(result.out, "mean ")) << result.out;
    EXPECT_EQ(read_image(course_.course.path() / "e.exr").channels, 1);
}

TEST_F(NewLab, HasADeckOfSlidesWithItsPictures) {
    // The slide tool is installed in the build's folder; this course has its own build folder.
    std::filesystem::create_directory_symlink(std::string(build_folder) + "/marp",
                                              course_.course.path() / "build/marp");
    const Result result = run({course_.program("relief"), "slides", "test_wall", "--no-pdf"});
    EXPECT_EQ(result.code, 0) << result.err;
    const std::string deck = read_all(course_.course.path() / "build/slides/20_test_wall.html");
    for (const char* part : {"Test wall", "20_test_wall/01.png", "facing", "mjx-container"})
        EXPECT_TRUE(contains(deck, part)) << part;
    EXPECT_GT(read_image(course_.course.path() / "build/slides/20_test_wall/02.png").width, 800);
    // The gallery may be published and includes build/slides.
    const Result solved = run({course_.program("relief"), "slides", "test_wall", "--no-pdf", "--solutions"});
    EXPECT_TRUE(contains(solved.out, "build/slides-with-solutions/20_test_wall.html")) << solved.out << solved.err;
}

TEST_F(NewLab, ReportsThatItHasNoGoldenPictures) {
    const Result none = run({course_.program("relief"), "golden", "20"});
    EXPECT_EQ(none.code, 1);
    EXPECT_TRUE(contains(none.err, "there is no [[golden]] in labs/20_test_wall/lab.toml")) << none.err;
}

TEST_F(NewLab, RefusesTakenOrInvalidNamesAndNumbers) {
    const auto new_lab = [&](std::vector<std::string> words) {
        words.insert(words.begin(), {course_.program("relief"), "new-lab"});
        return run(words);
    };
    expect_refused(new_lab, {{{"test_wall"}, "a lab of that name exists: 20_test_wall"},
                             {{"01_other"}, "number 01 is taken by 01_specular_highlights"},
                             {{"Wet Stone"}, "lower case with underscores"},
                             {{"../x"}, "lower case with underscores"},
                             {{"100_x"}, "lab numbers go from 01 to 99"},
                             {{""}, "must not be empty"}});
}

}  // namespace
}  // namespace relief::app
