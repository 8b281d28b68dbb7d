// relief synctest from the command line. Lab 07's cube, drawn on the graphics card, is the renderer under test.
#include <nlohmann/json.hpp>

#include "tests/course/app/course_copy.h"

namespace relief::app {
namespace {

class SynctestCommand : public testing::Test {
protected:
    TemporaryFolder folder_;
    Result relief(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), relief_program());
        return run(arguments, {folder_.path(), {}});
    }
};

TEST_F(SynctestCommand, WritesAFolderWhoseExpectedPictureIsFlat) {
    EXPECT_EQ(relief({"synctest", "-o", "cube"}).out, "cube/README.md\n");
    for (const char* name : {"cube.gltf", "cube.bin", "cube.obj", "cube.mtl", "cube_normal.png"})
        EXPECT_TRUE(std::filesystem::exists(folder_.path() / "cube" / name)) << name;
    EXPECT_TRUE(contains(read_all(folder_.path() / "cube/README.md"), "`./relief synctest --judge PICTURE`"));
    const Result judged = relief({"synctest", "--judge", "cube/expected.png"});
    EXPECT_EQ(judged.code, 0) << judged.out << judged.err;
    EXPECT_TRUE(contains(judged.out, "expected.png: flat, 0.318 degrees on average")) << judged.out;
    EXPECT_TRUE(contains(judged.out, "\nframe: as interpolated, in sync with the map\n")) << judged.out;
    const auto said = nlohmann::json::parse(relief({"synctest", "--judge", "cube/expected.png", "--json"}).out);
    EXPECT_EQ(said["frame"], "as interpolated");
    EXPECT_TRUE(said["in_sync"] && said["flat"]);
    EXPECT_NEAR(said["degrees"]["mean"].get<double>(), 0.318, 0.001);
    EXPECT_GT(said["likenesses"].size(), 10u);
}

TEST_F(SynctestCommand, NamesTheFramesOfLab07) {
    for (const auto& [knob, frame] : std::map<std::string, std::string>{
             {"frame=interpolated", "as interpolated, in sync with the map"},
             {"frame=each-unit", "each column made unit"},
             {"frame=gram-schmidt", "Gram-Schmidt at each pixel"},
             {"frame=vertex-bitangent", "the bitangent interpolated from the vertices"},
             {"diagonal=other", "as interpolated, quads cut along the other diagonal"}}) {
        // The lab's cube has a side of 1.05 m and another position.
        const Result drawn =
            relief({"shot", "07", "--set", "view=one", "--set", "shape=cube", "--set", knob, "--probe", "normal",
                    "--camera", "30,25,4.2,0.17,0,0,20", "--size", "192x192", "-o", "cube.png"});
        ASSERT_EQ(drawn.code, 0) << drawn.err;
        const Result judged = relief({"synctest", "--judge", "cube.png"});
        EXPECT_EQ(judged.code, knob == "frame=interpolated" ? 0 : 1) << judged.out;
        EXPECT_TRUE(contains(judged.out, "\nframe: " + frame + "\n")) << knob << "\n" << judged.out;
    }
}

TEST_F(SynctestCommand, WrongUseAndOtherPicturesAreOneLine) {
    folder_.write("text.png", "not a picture");
    const std::string albedo = std::string(source_folder) + "/assets/bricks_albedo.png";
    expect_refused([&](const auto& words) { return relief(words); },
                   {{{"synctest"}, "synctest takes -o FOLDER or --judge PICTURE"},
                    {{"synctest", "-o", "a", "--json"}, "--json goes with --judge PICTURE"},
                    {{"synctest", "-o", "a", "--judge", "b"}, "synctest takes -o FOLDER or --judge PICTURE"},
                    {{"synctest", "--judge", "text.png"}, "text.png: ", 1},
                    {{"synctest", "--judge", "missing.png"}, "missing.png: cannot read", 1},
                    {{"synctest", "--judge", albedo}, "bricks_albedo.png: shows no normals", 1},
                    {{"synctest", "-o", "/proc/cube"}, "/proc/cube", 1}});
}

}  // namespace
}  // namespace relief::app
