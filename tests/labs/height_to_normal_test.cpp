// Lab 03: the shader and the CPU compute the same filters. Also tests which filter is better in which case.
#include "tests/labs/shots.h"

namespace relief {
namespace {

constexpr const char* filters[] = {"forward", "central", "sobel", "scharr", "fourth-order", "spline"};

double mean_error(const char* filter, std::vector<Knob> knobs) {
    knobs.insert(knobs.end(), {{"view", "one"}, {"filter", filter}});
    return error_of("03", shot_of("03", knobs, "normal")).mean;
}

TEST(HeightToNormal, TheShaderAndTheCpuMakeTheSameMap) {
    for (const char* filter : filters)
        for (const char* wrap : {"on", "off"})
            for (const char* bits : {"float", "8"}) {
                std::vector<Knob> knobs = {{"view", "one"},    {"filter", filter}, {"wrap", wrap},  {"bits", bits},
                                           {"stretch", "1.6"}, {"repeat", "1"},    {"where", "gpu"}};
                const Image by_shader = drawn("03", shot_of("03", knobs, "normal"));
                knobs.back().second = "cpu";
                const Image by_cpu = drawn("03", shot_of("03", knobs, "normal"));
                const ErrorSummary off = summarize(error_image(by_shader, by_cpu, ErrorMetric::angle));
                // One side uses single precision, and sums in another order.
                EXPECT_LT(off.largest, 2e-4) << filter << ", wrap " << wrap << ", bits " << bits;
            }
}

TEST(HeightToNormal, SobelLosesOnCleanHeightsAndWinsOnEightBits) {
    EXPECT_GT(mean_error("sobel", {}), 1.3 * mean_error("central", {}));
    EXPECT_GT(mean_error("central", {}), 5 * mean_error("fourth-order", {}));
    const std::vector<Knob> noisy = {{"bits", "8"}, {"size", "128"}, {"depth", "40"}};
    EXPECT_LT(mean_error("sobel", noisy), 0.75 * mean_error("central", noisy));
    EXPECT_LT(mean_error("central", noisy), mean_error("fourth-order", noisy));
}

TEST(HeightToNormal, ABorderThatDoesNotWrapKeepsTheOrderOfTheFilter) {
    // The border is a thirtieth of the map. Halved slopes there would add degrees to the mean.
    for (const char* filter : {"central", "sobel", "scharr"})
        EXPECT_LT(mean_error(filter, {{"wrap", "off"}}), 1.15 * mean_error(filter, {})) << filter;
}

TEST(HeightToNormal, WithoutDepthTheMapIsFlat) {
    for (const char* filter : filters) {
        const Image normals =
            drawn("03", shot_of("03", {{"view", "one"}, {"filter", filter}, {"depth", "0"}}, "normal"));
        for (size_t i = 0; i < normals.pixel_count(); ++i)
            if (normals.values[i * 4] != no_surface) {
                ASSERT_EQ(normals.values[i * 4], 0) << filter;
                ASSERT_EQ(normals.values[i * 4 + 2], 1) << filter;
            }
    }
}

TEST(HeightToNormal, LevelStrengthsOfZeroSmoothTheNormals) {
    const std::vector<Knob> plain = {{"view", "one"}, {"filter", "central"}, {"source", "bricks"}};
    const Image whole = drawn("03", shot_of("03", plain, "normal"));
    std::vector<Knob> smooth = plain;
    smooth.insert(smooth.end(), {{"fine", "0"}, {"middle", "0"}, {"coarse", "0"}});
    const Image soft = drawn("03", shot_of("03", smooth, "normal"));
    double upright_whole = 0, upright_soft = 0;
    for (size_t i = 0; i < whole.pixel_count(); ++i)
        if (whole.values[i * 4] != no_surface)
            upright_whole += 1 - whole.values[i * 4 + 2], upright_soft += 1 - soft.values[i * 4 + 2];
    EXPECT_LT(upright_soft, 0.5 * upright_whole);
    EXPECT_GT(upright_soft, 0);
}

}  // namespace
}  // namespace relief
