// The values of calls, as a picture.
#include "framework/course/check/calls.h"

#include <gtest/gtest.h>

#include "framework/course/manifest/manifest.h"
#include "tests/support.h"

namespace relief::check {
namespace {

Shot shot_of(std::vector<std::string> calls) {
    Shot shot;
    shot.probe.name = calls_probe;
    shot.calls = {.file = "shaders/06_tangent_space/task.glsl", .texts = std::move(calls)};
    shot.size = {int(shot.calls.texts.size()), 1};
    return shot;
}

Image drawn(const Shot& shot) { return draw_shot(*make_drawer(LabEntry{}, shot), shot); }

TEST(Calls, AreOnePixelEach) {
    const Image image = drawn(shot_of({"true", "int(7)", "0.25", "vec2(1.0, 2.0)", "vec3(3.0)", "vec4(4.0)",
                                       "to_tangent_space(vec3(1.0, 2.0, 3.0), mat3(2.0))"}));
    const std::vector<float> values = {1, 0, 0, 0, 7, 0, 0, 0, 0.25f, 0, 0, 0, 1, 2,
                                       0, 0, 3, 3, 3, 0, 4, 4, 4,     4, 2, 4, 6, 0};
    EXPECT_EQ(image.values, values);
}

TEST(Calls, KeepValuesThatAreNotFinite) {
    const Image image = drawn(shot_of({"uintBitsToFloat(0x7fc00000u)", "1e30", "uintBitsToFloat(0x7f800000u)"}));
    EXPECT_TRUE(std::isnan(image.values[0]));
    EXPECT_EQ(image.values[4], 1e30f);
    EXPECT_TRUE(std::isinf(image.values[8]));
}

TEST(Calls, HaveTheValuesOfTheirLiteralsWhichUniformsHold) {
    const Image image =
        drawn(shot_of({"exp2(4.5 * log2(abs(to_tangent_space(normalize(vec3(-1.0, 2.0, -3.0)), mat3(1.0)))))",
                       "vec4[2](vec4(1), vec4(2.5))[1]", "true ? vec2(-1e-3, .5) : vec2(0)", "int(0x7u) + 010"}));
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(image.values[size_t(i)], std::pow((i + 1) / std::sqrt(14.0), 4.5), 1e-5);
    EXPECT_EQ(image.values[4], 2.5f);
    EXPECT_EQ(image.values[8], -1e-3f);
    EXPECT_EQ(image.values[9], 0.5f);
    EXPECT_EQ(image.values[12], 15);
}

TEST(Calls, InCppAreThoseOfTheProgram) {
    Shot shot = shot_of({"twice(2)"});
    shot.calls.file = "labs/05_tangent_basis/task.cpp";
    EXPECT_EQ(message_of<Error>([&] { drawn(shot); }), "this program has no call 'twice(2)'");
    using Value = std::optional<glm::dvec4>;
    const ProvidedCalls one([](const std::string& call) -> Value { return call == "f()" ? Value(1) : Value(); });
    const ProvidedCalls other([](const std::string& call) -> Value {
        return call == "twice(2)" ? Value({4, 0, 0, 0}) : Value();
    });
    EXPECT_EQ(drawn(shot).values, (std::vector<float>{4, 0, 0, 0}));
}

}  // namespace
}  // namespace relief::check
