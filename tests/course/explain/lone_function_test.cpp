// Functions of a shader by themselves: which ones a person can follow, and how numbers are shown.
#include "framework/course/explain/lone_function.h"

#include <limits>

#include "tests/support.h"

namespace relief::check {
namespace {

const std::string stage = R"(#version 410 core
uniform float u_depth;
in vec2 v_uv;
const float least = 0.002;
struct Ray { vec3 origin; float t; };
float halved(float x) { return x / 2.0; }
float other(float x) { return x * u_depth; }
float direction() { return u_depth; }
float crossing(float before, float after) { return halved(before) / max(before - after, least); }
float along(Ray ray, mat2 m, bool up) { return up ? ray.t : m[1][0]; }
vec3 turned(vec3 direction) { return direction.zxy; }
float summed(float x) { for (int i = 0; i < 3; ++i) x += x; return x; }
float changing(float x) { return dFdx(x); }
float of_array(float h[9]) { return h[0]; }
float also(float x, out float y) { y = x; return x; }
mat3 matrix_of(vec3 x) { return mat3(x, x, x); }
void main() {}
)";

TEST(LoneFunction, HasItsCalleesAndConstantsOnly) {
    const std::string text = lone_function(stage, "crossing(float,float)");
    for (const char* part :
         {"float halved(", "const float least = 0.002;", "float crossing(", "struct Ray",
          "relief_result.x = float(crossing(float(u_relief_numbers[0]), float(u_relief_numbers[1])))"})
        EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
    for (const char* part : {"u_depth", "v_uv", "other(", "summed("})
        EXPECT_EQ(text.find(part), std::string::npos) << part << "\n" << text;
}

TEST(LoneFunction, TakesStructsMatricesAndTruths) {
    const std::string text = lone_function(stage, "along(Ray,mat2,bool)");
    EXPECT_NE(
        text.find("along(Ray(vec3(u_relief_numbers[0], u_relief_numbers[1], u_relief_numbers[2]), "
                  "float(u_relief_numbers[3])), mat2(u_relief_numbers[4], u_relief_numbers[5], u_relief_numbers[6], "
                  "u_relief_numbers[7]), u_relief_numbers[8] > 0.5)"),
        std::string::npos)
        << text;
}

TEST(LoneFunction, AVariableWithTheNameOfAFunctionCallsNothing) {
    EXPECT_EQ(lone_function(stage, "turned(vec3)").find("u_depth"), std::string::npos);
}

TEST(LoneFunction, OmitsWhatNobodyComputesByHand) {
    for (const char* signature : {"summed(float)", "changing(float)", "of_array(float[9])", "also(float,float)",
                                  "matrix_of(vec3)", "direction()", "missing(float)"})
        EXPECT_EQ(lone_function(stage, signature), "") << signature;
}

std::string shown(const ValueShape& shape, const std::vector<float>& numbers, int digits = 4) {
    const float* at = numbers.data();
    return shown_value(shape, at, digits).text;
}
const ValueShape pair{.name = {}, .kind = ValueShape::group, .parts = {{}, {}}};

TEST(ShownValue, IsRoundedToDigitsOfItsLargestNumber) {
    EXPECT_EQ(shown({}, {0.0312345F}), "0.03123");
    EXPECT_EQ(shown(pair, {0.57735F, -4.37e-8F}), "(0.5774, 0)");
    EXPECT_EQ(shown(pair, {231, 0.25F}), "(231, 0.2)");
    EXPECT_EQ(shown(pair, {12345.6F, -0.3F}), "(12346, 0)");
    EXPECT_EQ(shown({.kind = ValueShape::whole}, {12}), "12");
    EXPECT_EQ(shown({.kind = ValueShape::truth}, {1}), "true");
    EXPECT_EQ(shown({}, {0}), "0");
}

TEST(ShownValue, HoldsTheNumbersOfItsText) {
    const std::vector<float> numbers = {0.57735F, 0.1F};
    const float* at = numbers.data();
    EXPECT_EQ(shown_value(pair, at, 4).numbers, (std::vector<float>{0.5774F, 0.1F}));
    EXPECT_EQ(at, numbers.data() + 2);
}

TEST(ShownValue, IsEmptyForNumbersThatNobodyWritesDown) {
    EXPECT_EQ(shown({}, {std::numeric_limits<float>::infinity()}), "");
    EXPECT_EQ(shown(pair, {1, std::numeric_limits<float>::quiet_NaN()}), "");
    EXPECT_EQ(shown({}, {1e-9F}), "");
    EXPECT_EQ(shown({}, {1e9F}), "");
    EXPECT_EQ(shown({.kind = ValueShape::texture}, {}), "");
}

}  // namespace
}  // namespace relief::check
