// Lab 07: a baked map is right only with the renderer that it was baked for. A bake runs only when an input changes.
#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/gl/program.h"
#include "framework/staff/grade/overlay.h"
#include "tests/labs/shots.h"

namespace relief {
namespace {

std::vector<Knob> one(std::vector<Knob> knobs) {
    knobs.insert(knobs.begin(), {"view", "one"});
    return knobs;
}

/// Returns the mean error in degrees over one face of the cube, without the cube's edges and other faces.
double degrees_on_the_cube(std::vector<Knob> knobs) {
    knobs.insert(knobs.end(), {{"shape", "cube"}, {"level", "0"}});
    Shot shot = shot_of("07", one(std::move(knobs)), "normal", {96, 96});
    shot.camera = {.yaw = 0, .pitch = 0, .distance = 1.9, .target = {0.17, 0, 0}};
    return error_of("07", shot).mean;
}

TEST(Baking, ACubeIsFlatOnlyInTheFrameOfTheBake) {
    EXPECT_LT(degrees_on_the_cube({}), 0.04);
    EXPECT_LT(degrees_on_the_cube({{"bits", "8"}}), 0.35);  // half a step of 255 tilts z by 0.22 degrees, and F by more
    EXPECT_LT(degrees_on_the_cube({{"bake_frame", "gram-schmidt"}, {"frame", "gram-schmidt"}}), 0.04);
    EXPECT_LT(degrees_on_the_cube({{"bake_frame", "each-unit"}, {"frame", "each-unit"}}), 0.04);
    // Measured by a separate program in double precision, over all faces: 5.0, 4.5, 6.2, 7.6.
    EXPECT_NEAR(degrees_on_the_cube({{"frame", "gram-schmidt"}}), 5.0, 0.2);
    EXPECT_NEAR(degrees_on_the_cube({{"frame", "each-unit"}}), 4.5, 0.2);
    EXPECT_NEAR(degrees_on_the_cube({{"frame", "vertex-bitangent"}}), 6.2, 0.3);
    EXPECT_NEAR(degrees_on_the_cube({{"diagonal", "other"}}), 7.6, 0.9);
}

TEST(Baking, HitsMatchDoublePrecisionAndNoRayIsLost) {
    for (const std::vector<Knob>& knobs : {std::vector<Knob>{{"gap", "0.05"}},
                                           {{"shape", "mirrored"}, {"low", "2000"}},
                                           {{"cord", "true"}, {"reach", "0.6"}},
                                           {{"reach", "0.2"}},
                                           {{"ribs", "0.3"}, {"bulge", "0.3"}, {"dents", "0.2"}, {"reach", "0.6"}},
                                           {{"shape", "cube"}}}) {
        std::vector<Knob> small = knobs;
        small.emplace_back("map_size", "128");
        const Shot shot = shot_of("07", small, "hit");
        const auto lab = make_lab(find_lab("07"), shot);
        const Image found = render_shot(*lab, shot), truth = truth_of(*lab, shot);
        size_t covered = 0, outline = 0;
        for (size_t i = 0; i < found.values.size(); i += 4) {
            const bool is_found = std::isfinite(found.values[i]), is_there = std::isfinite(truth.values[i]);
            covered += is_there, outline += is_found != is_there;
        }
        EXPECT_GT(covered, 3000u) << knobs[0].first;
        // At the very end of a ray, rounding decides.
        EXPECT_LE(outline, 2u) << knobs[0].first;
        EXPECT_LT(summarize(error_image(found, truth, ErrorMetric::absolute)).mean, 1e-6) << knobs[0].first;
    }
}

/// Counts the covered texels of the map whose ray hits nothing.
size_t missed(const std::vector<Knob>& knobs) {
    std::vector<Knob> small = knobs;
    small.emplace_back("map_size", "128");
    const auto probe = [&](const char* name) {
        const Shot shot = shot_of("07", small, name);
        return render_shot(*make_lab(find_lab("07"), shot), shot);
    };
    const Image hits = probe("hit"), cover = probe("cover");
    size_t count = 0;
    for (size_t i = 0; i < hits.values.size(); i += 4) count += cover.values[i] > 0 && std::isinf(hits.values[i]);
    return count;
}

// 504 triangles: the relief is 0.162, the sagittas are 0.105 along and 0.134 around. 2016 triangles: sagittas 0.026 and
// 0.034.
TEST(Baking, AReachOfTheReliefPlusBothSagittasMissesNoTexel) {
    EXPECT_EQ(missed({{"reach", "0.402"}}), 0u);
    EXPECT_EQ(missed({{"reach", "0.223"}, {"low", "2000"}}), 0u);
    EXPECT_GT(missed({{"reach", "0.2"}}), 500u);
}

TEST(Baking, ABulgeNeedsAsMuchMoreReachAsItIsHigh) {
    const auto missed_with = [](const char* bulge, const char* reach) {
        return missed({{"ribs", "0"}, {"bulge", bulge}, {"reach", reach}});
    };
    // The growth lines' 0.012 and the sagittas of 504 triangles, and 0.25 more.
    EXPECT_EQ(missed_with("0", "0.252"), 0u);
    EXPECT_EQ(missed_with("0.25", "0.502"), 0u);
    EXPECT_GT(missed_with("0.25", "0.252"), 100u);
}

TEST(Baking, SculptingChangesTheFineModelAndTheMapOnly) {
    const auto normals = [](const char* wears, const char* dents) {
        return drawn("07", shot_of("07", one({{"wears", wears}, {"dents", dents}}), "normal"));
    };
    EXPECT_EQ(normals("nothing", "0").values, normals("nothing", "0.2").values);
    for (const char* wears : {"map", "high"}) {
        const Image error = error_image(normals(wears, "0"), normals(wears, "0.2"), ErrorMetric::angle);
        EXPECT_GT(summarize(error).mean, 2) << wears;
    }
    const Shot sculpted = shot_of("07", one({{"dents", "0.2"}, {"map_size", "512"}, {"level", "0"}}), "normal");
    EXPECT_LT(error_of("07", sculpted).mean, 0.5) << "the map is that of the dents";
}

TEST(Baking, ALargerMapIsNearerToTheFineModel) {
    double last = 100;
    for (const char* size : {"64", "128", "256", "512"}) {
        const double error = error_of("07", shot_of("07", one({{"map_size", size}, {"level", "0"}}), "normal")).mean;
        EXPECT_LT(error, 0.7 * last) << size;
        last = error;
    }
    EXPECT_LT(last, 0.5);
    EXPECT_GT(error_of("07", shot_of("07", one({{"wears", "nothing"}}), "normal")).mean, 8);
}

TEST(Baking, PaddingKeepsSeamsOutOfSmallLevels) {
    const auto seams = [](const char* texels) {
        return error_of("07", shot_of("07", one({{"padding", texels}, {"level", "3"}}), "normal")).p99;
    };
    EXPECT_LT(seams("8"), 20);
    EXPECT_GT(seams("0"), 60);
}

TEST(Baking, RunsAgainOnlyWhenAnInputChanges) {
    Shot shot = shot_of("07", {}, "", {96, 64});
    const auto lab = make_lab(find_lab("07"), shot);
    const auto draw_calls = [&] { return work_of(*lab, shot).draws; };
    const int64_t first = draw_calls(), still = draw_calls();
    EXPECT_EQ(first - still, 2 * (1 + 8 + 1)) << "a bake, eight steps of padding and the picture, of shell and cube";
    for (const auto& [knob, value] : {std::pair("light_yaw", "20"), {"level", "2"}, {"frame", "each-unit"}}) {
        set_knob(*lab, knob, value);
        EXPECT_EQ(draw_calls(), still) << knob;
    }
    for (const auto& [knob, value] : {std::pair("low", "2000"), {"bulge", "0.2"}}) {
        set_knob(*lab, knob, value);
        EXPECT_EQ(draw_calls(), still + 10) << "the shell's alone: " << knob;
        EXPECT_EQ(draw_calls(), still);
    }
}

TEST(Baking, AMapInObjectSpaceReadsNoTangent) {
    const Programs programs{"07_baking/surface.vert", "07_baking/surface.frag"};
    EXPECT_GE(glGetAttribLocation(programs.with("MAP"), "a_tangent"), 0);
    EXPECT_EQ(glGetAttribLocation(programs.with({"MAP", "OBJECT_SPACE"}), "a_tangent"), -1);
    EXPECT_EQ(glGetAttribLocation(programs.with(), "a_uv"), -1) << "no map";
}

TEST(Baking, TheCoverProbeCountsOverlappingIslands) {
    const auto most = [](const char* islands) {
        const Shot shot = shot_of("07", {{"islands", islands}}, "cover", {64, 64});
        EXPECT_EQ(error_of("07", shot).largest, 0) << islands;
        const Image cover = drawn("07", shot);
        float largest = 0;
        for (size_t i = 0; i < cover.values.size(); i += 4) largest = std::max(largest, cover.values[i]);
        return largest;
    };
    EXPECT_EQ(most("apart"), 1);
    EXPECT_EQ(most("overlapping"), 2);
}

TEST(Baking, WithoutReachEveryTexelHoldsTheCoarseModelsNormal) {
    for (const char* shape : {"ammonite", "mirrored", "cube"}) {
        const Shot shot =
            shot_of("07", one({{"reach", "0"}, {"shape", shape}, {"map_size", "64"}}), "normal", {64, 64});
        const Image normals = drawn("07", shot);  // throws if a pixel is not finite
        if (shape == std::string("cube")) continue;
        Shot bare = shot;
        bare.set.emplace_back("wears", "nothing");
        EXPECT_LT(summarize(error_image(normals, drawn("07", bare), ErrorMetric::angle)).mean, 1) << shape;
    }
}

TEST(Baking, RaysOfAnUnwrittenTaskAreNotShownAsMisses) {
    const std::string file = "shaders/07_baking/task.glsl";
    std::string task = read_file(course_root() / file);
    const std::string solution = "return is_front && abs(height) < abs(best);";
    const Shot shot = shot_of("07", {{"view", "rays"}}, "", {320, 240});
    const auto count = [&](glm::vec3 color) {
        const Image picture = drawn("07", shot);
        size_t pixels = 0;
        for (size_t i = 0; i < picture.values.size(); i += 3)
            pixels += glm::distance(glm::vec3(picture.values[i], picture.values[i + 1], picture.values[i + 2]), color) <
                      0.05f;
        return pixels;
    };
    const glm::vec3 miss(0.93f, 0.28f, 0.20f), unwritten(0.85f, 0, 0.85f);
    EXPECT_EQ(count(unwritten), 0u);
    ASSERT_NE(task.find(solution), std::string::npos);
    task.replace(task.find(solution), solution.size(), "return unfinished(0.0) > 0.5;");
    const grade::CourseOverlay overlay(grade::CourseFiles{{file, task}});
    EXPECT_EQ(count(miss), 0u);
    EXPECT_GT(count(unwritten), 500u);
}

}  // namespace
}  // namespace relief
