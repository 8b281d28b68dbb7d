// relief inspect from the command line.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "framework/core/image/file.h"
#include "framework/library/maps/test_maps.h"
#include "framework/staff/reference/normals.h"
#include "tests/course/app/course_copy.h"

namespace relief::app {
namespace {

const std::string assets = std::string(source_folder) + "/assets/";

class InspectCommand : public testing::Test {
protected:
    TemporaryFolder folder_;

    Result inspect(std::vector<std::string> more) const {
        more.insert(more.begin(), {relief_program(), "inspect"});
        return run(more, {folder_.path(), {}});
    }
    void write(const char* name, const Image& image) const { write_image(folder_.path() / name, image); }
};

Image stones(int bits, bool green_down = false) {
    NormalOptions options;
    options.texels_u = options.texels_v = 16;
    Image map = normals_from_heights(make_height_map(HeightMap::stones, 128), options);
    map.bits = bits;
    if (green_down)
        for (size_t i = 1; i < map.values.size(); i += 3) map.values[i] = 1 - map.values[i];
    return map;
}

TEST_F(InspectCommand, FindsNoFaultInTheCoursesMapsAndTheirHeights) {
    const Result result = inspect({assets + "paving_normal.png", assets + "paving_height.png"});
    EXPECT_EQ(result.code, 0) << result.out << result.err;
    EXPECT_EQ(result.err, "");
    for (const char* part :
         {"paving_normal.png: 1024 x 1024 texels, 3 channels of 8 bits\n", "tangent space",
          "linear: ", "unit: ", "127.5: ", "up: ", "none: ", "agree: ", "a height of 1 is 12 texels", "\nno faults\n"})
        EXPECT_TRUE(contains(result.out, part)) << part << "\n" << result.out;
}

TEST_F(InspectCommand, AFaultIsNamedAndIsTheExitCode) {
    for (const char* name : {"down.png", "down.exr"}) {
        write(name, stones(std::string(name) == "down.png" ? 16 : 32, true));
        const Result result = inspect({name});
        EXPECT_EQ(result.code, 1);
        EXPECT_TRUE(contains(result.out, "  fault  green      down: ")) << result.out;
        EXPECT_TRUE(contains(result.out, "\n1 fault\n")) << result.out;
        EXPECT_EQ(result.err, "");
    }
}

TEST_F(InspectCommand, ScriptsReadJson) {
    write("down.png", stones(8, true));
    const Result result = inspect({"down.png", "--json"});
    EXPECT_EQ(result.code, 1);
    const auto said = nlohmann::json::parse(result.out);
    EXPECT_EQ(said["file"], "down.png");
    EXPECT_EQ(said["width"], 128);
    EXPECT_EQ(said["bits"], 8);
    EXPECT_EQ(said["faults"], 1);
    for (const auto& finding : said["findings"])
        if (finding["name"] == "green") {
            EXPECT_EQ(finding["outcome"], "fault");
            EXPECT_EQ(finding["verdict"], "down");
            EXPECT_LT(finding["numbers"]["up"], -0.9);
            return;
        }
    FAIL() << result.out;
}

TEST_F(InspectCommand, DrawsWhereTheFaultsAre) {
    Image map = stones(8);
    std::fill_n(map.pixel(30, 40), 3, 0.5f);
    write("hole.png", map);
    const Result result = inspect({"hole.png", "-o", "where.png"});
    EXPECT_EQ(result.code, 1);
    EXPECT_TRUE(contains(result.out, "where.png\n  red      length off by more than 0.1: 1 texel\n")) << result.out;
    const Image picture = read_image(folder_.path() / "where.png");
    EXPECT_EQ(picture.width, 128);
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 128; ++x) {
            const float* const color = picture.pixel(x, y);
            EXPECT_EQ(color[0] == color[1] && color[1] == color[2], x != 30 || y != 40) << x << ", " << y;
        }
    EXPECT_EQ(nlohmann::json::parse(inspect({"hole.png", "-o", "again.png", "--json"}).out)["faults"], 1);
    EXPECT_TRUE(std::filesystem::exists(folder_.path() / "again.png"));
}

TEST_F(InspectCommand, BadInputIsOneLine) {
    folder_.write("text.png", "this is not a picture\n");
    folder_.write("empty.png", "");
    const std::string whole = read_all(assets + "paving_normal.png");
    folder_.write("half.png", whole.substr(0, whole.size() / 2));
    expect_refused([&](const auto& words) { return inspect(words); },
                   {{{"text.png"}, "text.png: ", 1},
                    {{"empty.png"}, "empty.png: ", 1},
                    {{"half.png"}, "half.png: damaged", 1},
                    {{"missing.png"}, "missing.png: cannot read: No such file", 1},
                    {{assets + "paving_normal.png", "text.png"}, "text.png: ", 1},
                    {{assets + "paving_normal.png", "-o", "/proc/where.png"}, "/proc/where.png", 1},
                    {{assets + "paving_normal.png", "-o", "where.jpg"}, "must end in .png"},
                    {{}, "MAP is required; --help shows the options"},
                    {{""}, "must not be empty"},
                    {{"a.png", "b.png", "c.png"}, "inspect takes MAP and one file of HEIGHTS"}});
}

TEST_F(InspectCommand, ItsHelpDocumentsTheExitCodes) {
    const Result result = inspect({"--help"});
    EXPECT_EQ(result.code, 0);
    EXPECT_TRUE(contains(result.out, "Exit code: 0 no fault, 1 a fault or a file that cannot be read, 2 wrong use."));
}

}  // namespace
}  // namespace relief::app
