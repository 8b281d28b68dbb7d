// relief explain from the command line.
#include <nlohmann/json.hpp>

#include "tests/course/app/course_copy.h"

namespace relief::app {
namespace {

using Json = nlohmann::json;

Result explain(std::vector<std::string> more) {
    std::vector<std::string> command = {relief_program(), "explain"};
    command.insert(command.end(), more.begin(), more.end());
    return run(command);
}

const std::vector<std::string> stairs = {"10", "--check", "eight layers", "--pixel", "65,80"};
Result with(std::vector<std::string> more) {
    more.insert(more.begin(), stairs.begin(), stairs.end());
    return explain(more);
}

/// Returns the functions of a report by name.
std::map<std::string, Json> functions_of(const Json& report) {
    std::map<std::string, Json> functions;
    for (const Json& one : report["functions"]) functions[one["name"]] = one;
    return functions;
}

TEST(ExplainCommand, FollowsAPixelThroughTheFunctionsOfTheTask) {
    const Result result = with({"--json"});
    ASSERT_EQ(result.code, 0) << result.err;
    const Json report = Json::parse(result.out);
    EXPECT_TRUE(report["first"].is_null());
    const auto functions = functions_of(report);
    ASSERT_TRUE(functions.contains("ray_in_relief") && functions.contains("steep_t") && functions.contains("on_ray"));
    // The picture's value must match the functions' values: uv + t along, in texels of the map.
    const Json call = functions.at("steep_t")["calls"][0], inputs = call["inputs"];
    const double t = call["results"]["returns"];
    for (size_t i = 0; i < 2; ++i) {
        const double uv = double(inputs["uv"][i]) + t * double(inputs["along"][i]);
        EXPECT_NEAR(double(report["value"][i]), uv * 1024, 0.01);
    }
    // Eight layers: t is a multiple of 1/8. Each layer before it is one call, and so is the coordinate at the end.
    EXPECT_EQ(t * 8, std::round(t * 8));
    EXPECT_EQ(functions.at("on_ray")["call_count"], int(t * 8) + 2);
    EXPECT_EQ(functions.at("on_ray")["calls"].size(), 2U) << "first and last";
}

TEST(ExplainCommand, TheExpectedValueIsShownForACheckGivenByNameOrByItsKnobs) {
    const Result named = with({});
    const Result set = explain({"10", "--set", "view=one", "--set", "steps=8", "--set", "method=steep", "--camera",
                                "45,20,0.2", "--probe", "uv", "--size", "128x128", "--pixel", "65,80"});
    EXPECT_TRUE(contains(named.out, "expected by the check: ")) << named.out << named.err;
    EXPECT_EQ(set.out, named.out);
    EXPECT_TRUE(contains(explain({"10", "--probe", "uv", "--pixel", "9,9", "--size", "64x64"}).out, "the exact value"));
}

TEST(ExplainCommand, TwinsHaveMoreDigits) {
    const auto functions = functions_of(Json::parse(with({"--json"}).out));
    const Json call = functions.at("ray_in_relief")["calls"][0], in = call["inputs"];
    const auto dot = [&](const char* axis) {
        double sum = 0;
        for (size_t i = 0; i < 3; ++i) sum += double(in["to_eye"][i]) * double(in[axis][i]);
        return sum;
    };
    const double exact = -dot("tangent") / dot("normal") * double(in["depth"][0]);
    EXPECT_NEAR(double(call["twin"]["returns"][0]), exact, 1e-13);
    EXPECT_NEAR(double(call["results"]["returns"][0]), exact, 1e-8);
}

TEST(ExplainCommand, NamesTheWrongFunctionButNotItsCallers) {
    // All three tasks of this picture differ from the solution; steep_t() calls on_ray().
    const Result result = with({"--mistake", "against-the-ray"});
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_TRUE(contains(result.out,
                         "the first that differs by more than rounding: on_ray (shaders/10_parallax_offset/task.glsl:"))
        << result.out;
    EXPECT_TRUE(contains(result.out, "> on_ray")) << result.out;
}

TEST(ExplainCommand, ShowsOneOfTwoCallsWithTheSameValues) {
    // Where the relief is as high as its top, the first layer is the hit: the search and the picture both want t = 0.
    const Result result = explain({"10", "--set", "view=one", "--set", "map=high", "--set", "method=steep", "--size",
                                   "64x64", "--camera", "0,0,1", "--probe", "uv", "--pixel", "32,32", "--json"});
    ASSERT_EQ(result.code, 0) << result.err;
    const Json on_ray = functions_of(Json::parse(result.out)).at("on_ray");
    EXPECT_EQ(on_ray["call_count"], 2);
    EXPECT_EQ(on_ray["calls"].size(), 1U);
}

TEST(ExplainCommand, ADirectionHasNoUnit) {
    const Result result = explain({"01", "--probe", "normal", "--size", "64x64", "--pixel", "32,32"});
    EXPECT_TRUE(contains(result.out, "probe normal: ")) << result.out << result.err;
    EXPECT_TRUE(contains(with({}).out, "probe uv (texels): "));
}

TEST(ExplainCommand, SaysWhenNoFunctionIsCalled) {
    const Result result =
        explain({"10", "--set", "view=one", "--size", "64x64", "--camera", "90,0,3", "--pixel", "1,1"});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_TRUE(contains(result.out, "no function of a task is called at this pixel")) << result.out;
}

TEST(ExplainCommand, MarksUnfinishedFunctions) {
    const TemporaryFolder folder;
    const std::string task = read_all(std::filesystem::path(source_folder) / "shaders/10_parallax_offset/task.glsl");
    folder.write("jane/shaders/10_parallax_offset/task.glsl",
                 std::string(task).replace(task.find("return 1.0 - height;"), 20, "return unfinished(0.0);"));
    const Result result = explain({"10", "--check", "bricks by one tap", "--pixel", "60,60", "--json", "--submission",
                                   (folder.path() / "jane").string()});
    ASSERT_EQ(result.code, 0) << result.err;
    const auto functions = functions_of(Json::parse(result.out));
    EXPECT_TRUE(functions.at("offset_t")["unfinished"]);
    EXPECT_FALSE(functions.at("ray_in_relief")["unfinished"]);
}

TEST(ExplainCommand, ReportsThatCppTasksAreNotTraced) {
    const Result result = explain({"05", "--check", "faces of a sheared quad", "--pixel", "40,40"});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_TRUE(contains(result.err, "is in C++: only functions of shaders are followed")) << result.err;
}

TEST(ExplainCommand, RefusesWrongUseInOneLine) {
    expect_refused(
        explain,
        {{{"10", "--pixel", "5"}, "--pixel takes COLUMN,ROW, from the picture's upper left corner, not '5'"},
         {{"10"}, "--pixel takes COLUMN,ROW"},
         {{"10", "--pixel", "1280,0"},
          "the picture is 1280 x 720 pixels: columns 0 to 1279, rows 0 to 719 from the top; there is no 1280,0"},
         {{"10", "--pixel", "1,1", "--mistake", "towards-the-eyes"}, "did you mean 'towards-the-eye'"},
         {{"10", "--pixel", "1,1", "--check", "eight layer"}, "did you mean 'eight layers'"},
         {{"05", "--pixel", "1,1", "--mistake", "determinant-sign-lost"},
          "is a mistake in C++: only shaders are explained"}});
}

}  // namespace
}  // namespace relief::app
