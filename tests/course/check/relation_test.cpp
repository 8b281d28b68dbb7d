// Sentences about wrong pictures, on pictures whose relation is known.
#include "framework/course/check/relation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace relief::check {
namespace {

constexpr int width = 96, height = 72;
const Quantity normal{.name = "normal", .error = ErrorMetric::angle},
    depth{.name = "depth", .error = ErrorMetric::absolute}, uv{.name = "uv"}, slope{.name = "slope"}, unnamed{};

/// Draws a picture from coordinates in [-1, 1].
Image painted(int channels, const std::function<std::vector<double>(double x, double y)>& color) {
    Image image(width, height, channels);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto values = color(2 * (x + 0.5) / width - 1, 2 * (y + 0.5) / height - 1);
            for (int c = 0; c < channels; ++c) image.pixel(x, y)[c] = float(values[size_t(c)]);
        }
    return image;
}

/// Normals of an uneven surface, seen from the front, with all signs of x and y.
Image normals() {
    return painted(3, [](double x, double y) {
        const double a = std::sin(5 * x + 2 * y), b = 0.8 * std::cos(4 * y - x) + 0.3 * x;
        const double length = std::sqrt(a * a + b * b + 1);
        return std::vector{a / length, b / length, 1 / length};
    });
}
/// Depths from 0.4 to 2.6.
Image depths() {
    return painted(1, [](double x, double y) { return std::vector{1.5 + 0.7 * std::sin(3 * x) + 0.4 * y}; });
}
/// Two different numbers of both signs, and two unused channels, as probes have them.
Image pairs() {
    return painted(4, [](double x, double y) {
        return std::vector{std::sin(3 * x + y), 0.7 * y * y - 0.5 * x, 0.0, 0.0};
    });
}

/// Applies a function to every pixel.
Image changed(Image image, const std::function<void(float* value)>& change) {
    for (size_t i = 0; i < image.pixel_count(); ++i) change(image.values.data() + i * size_t(image.channels));
    return image;
}

std::string said(const Image& drawn, const Image& expected, const Quantity& quantity) {
    const auto relation = relation_between(drawn, expected, quantity);
    return relation ? relation->sentence : "";
}

TEST(Relation, NamesNegatedSwappedAndMissingComponentsOfADirection) {
    const Image right = normals();
    const auto with = [&](const std::function<void(float*)>& change) {
        return said(changed(right, change), right, normal);
    };
    EXPECT_EQ(with([](float* n) { n[0] = -n[0]; }), "yours is the expected direction with x negated");
    EXPECT_EQ(with([](float* n) { n[0] = -n[0], n[1] = -n[1]; }),
              "yours is the expected direction with x and y negated");
    EXPECT_EQ(with([](float* n) { n[0] = -n[0], n[1] = -n[1], n[2] = -n[2]; }),
              "yours is the expected direction negated");
    EXPECT_EQ(with([](float* n) { std::swap(n[0], n[1]); }), "yours is the expected direction with x and y swapped");
    EXPECT_EQ(with([](float* n) { n[0] = 0; }), "yours is the expected direction with 0 for x");
    EXPECT_EQ(with([](float* n) { n[2] *= 2; }), "yours is the expected direction with twice z");
    EXPECT_EQ(with([](float* n) { n[2] = 1; }), "yours is the expected direction with 1 for z");
    EXPECT_EQ(with([](float* n) { n[0] = n[1] = 0, n[2] = 1; }), "yours is the direction (0, 0, 1) everywhere");
    EXPECT_EQ(with([](float* n) { n[0] = std::abs(n[0]); }),
              "yours is the expected direction with the absolute value of x in place of x");
    EXPECT_EQ(with([](float* n) {
                  for (int c = 0; c < 3; ++c) n[c] = n[c] / 2 + 0.5f;
              }),
              "yours is the expected direction / 2 + 1/2");
}

TEST(Relation, NamesFactorsOffsetsBoundsAndFunctionsOfAValue) {
    const Image right = depths();
    const auto with = [&](float (*of)(float)) {
        return said(changed(right, [of](float* d) { *d = of(*d); }), right, depth);
    };
    EXPECT_EQ(with([](float d) { return 2 * d; }), "yours is twice the expected value");
    EXPECT_EQ(with([](float d) { return d * float(std::numbers::pi / 180); }),
              "yours is pi / 180 times the expected value");
    EXPECT_EQ(with([](float d) { return 1.37f * d; }), "yours is 1.37 times the expected value");
    EXPECT_EQ(with([](float d) { return d - 0.25f; }), "yours is the expected value minus 0.25");
    EXPECT_EQ(with([](float d) { return 1 - d; }), "yours is 1 - the expected value");
    EXPECT_EQ(with([](float d) { return d * d; }), "yours is the square of the expected value");
    EXPECT_EQ(with([](float d) { return 1 / d; }), "yours is 1 / the expected value");
    EXPECT_EQ(with([](float d) { return std::min(d, 1.75f); }), "yours is the expected value, but never above 1.75");
    EXPECT_EQ(with([](float) { return 0.5f; }), "yours is 0.5 everywhere");
    EXPECT_EQ(with([](float d) { return 0.5f * d + 0.1f; }), "yours is half the expected value plus 0.1");
}

TEST(Relation, NamesWhereItHolds) {
    const Image right = pairs();
    EXPECT_EQ(said(changed(right, [](float* s) { s[1] = s[0] < 0 ? -s[1] : s[1]; }), right, slope),
              "where the expected x is negative, yours is the expected value with y negated; elsewhere it is right or "
              "nearly so");
    int count = 0;
    const std::string half = said(changed(right, [&](float* s) { s[1] = count++ % 2 ? s[1] : -s[1]; }), right, slope);
    EXPECT_TRUE(half.ends_with(
        "% of the pixels, yours is the expected value with y negated; on the others it is right or nearly so"))
        << half;
    Image left = right;
    std::minstd_rand random;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width / 2; ++x) left.pixel(x, y)[0] += 1 + float(random() % 1000) / 500;
    EXPECT_EQ(said(left, right, slope), "yours is right except in the left half of the picture");
}

TEST(Relation, CallsTheComponentsOfTextureCoordinatesUAndV) {
    const Image right = pairs();
    EXPECT_EQ(said(changed(right, [](float* p) { p[1] = -p[1]; }), right, uv),
              "yours is the expected value with v negated");
    EXPECT_EQ(said(changed(right, [](float* p) { std::swap(p[0], p[1]); }), right, uv),
              "yours is the expected value with u and v swapped");
    EXPECT_EQ(said(changed(right, [](float* p) { p[0] += 3e-4f, p[1] += 2e-4f; }), right, uv),
              "yours is the expected value plus (0.0003, 0.0002)");
    EXPECT_EQ(said(changed(right, [](float* p) { p[0] *= 1.003f, p[1] *= 1.003f; }), right, uv), "") << "too near to 1";
}

TEST(Relation, SaysThatPixelsAreMissing) {
    const Image right = depths();
    Image drawn = changed(right, [](float* d) { *d *= 2; });
    for (int x = 0; x < width / 2; ++x)
        for (int y = 0; y < height; ++y) *drawn.pixel(x, y) = no_surface;
    EXPECT_EQ(said(drawn, right, depth), "yours is twice the expected value, where both pictures have a surface");
}

// In a dark edge that is wider, most values are those of the opposite side.
TEST(Relation, NamesNoOtherPlaceForAPartOfThePicture) {
    const auto step = [](double end) {
        return painted(1, [=](double x, double y) { return std::vector{x > end ? 1.5 + 0.3 * y : 0.5 + 0.3 * y}; });
    };
    const std::string sentence = said(step(-0.4), step(-0.2), depth);
    EXPECT_FALSE(sentence.find("mirrored") != std::string::npos) << sentence;
}

TEST(Relation, NamesAPictureAtAnotherPlace) {
    const Image right = pairs();
    Image turned = right, moved = right;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 2; ++c) {
                turned.pixel(x, y)[c] = right.pixel(x, height - 1 - y)[c];
                moved.pixel(x, y)[c] = right.pixel(std::max(x - 1, 0), y)[c];
            }
    EXPECT_EQ(said(turned, right, uv), "yours is the expected value upside down");
    EXPECT_EQ(said(moved, right, uv).substr(0, 51), "yours is the expected value moved right by 1 pixel,");
}

TEST(Relation, NamesTheBaseThatTheReliefShouldChange) {
    const Image right = pairs(), base = painted(4, [](double x, double y) { return std::vector{x, y, 0.0, 0.0}; });
    const Quantity moved{.name = "uv", .base = &base, .base_knob = "depth = 0"};
    const auto from_base = [&](double k) {
        Image drawn = right;
        for (size_t i = 0; i < drawn.values.size(); ++i)
            drawn.values[i] = float(base.values[i] + k * (right.values[i] - base.values[i]));
        return said(drawn, right, moved);
    };
    EXPECT_EQ(from_base(0), "yours is the value for depth = 0");
    EXPECT_EQ(from_base(-1), "yours is the expected value moved to the opposite side of the value for depth = 0");
    EXPECT_EQ(from_base(2), "yours is twice as far from the value for depth = 0 as the expected value");
}

TEST(Relation, NamesComponentsInTangentSpace) {
    // Bumps on a column around y, whose tangent is horizontal.
    const Image local = normals(), base = painted(3, [](double x, double) {
                                       return std::vector{std::sin(1.4 * x), 0.0, std::cos(1.4 * x)};
                                   });
    const auto on_the_column = [&](const std::function<void(float*)>& change) {
        Image world = changed(local, change);
        for (size_t i = 0; i < world.pixel_count(); ++i) {
            float* const v = &world.values[3 * i];
            const float *const n = &base.values[3 * i], x = v[0];
            v[0] = n[2] * x + n[0] * v[2], v[2] = n[2] * v[2] - n[0] * x;
        }
        return world;
    };
    const Image right = on_the_column([](float*) {});
    const Quantity bumped{.name = "normal", .error = ErrorMetric::angle, .base = &base, .base_knob = "strength = 0"};
    EXPECT_EQ(said(on_the_column([](float* n) { n[0] = -n[0]; }), right, bumped),
              "in tangent space, yours is the expected direction with x negated");
    EXPECT_EQ(said(on_the_column([](float* n) { n[2] *= 2; }), right, bumped),
              "in tangent space, yours is the expected direction with twice z");
    EXPECT_EQ(said(local, right, bumped), "yours is the expected direction left in tangent space");
    EXPECT_EQ(said(base, right, bumped), "yours is the direction for strength = 0");
}

TEST(Relation, SaysWhetherAllValuesAreTooLargeIfNothingElseIsKnown) {
    const Image right = depths();
    std::minstd_rand random;
    const Image drawn = changed(right, [&](float* d) { *d += 0.1f + float(random() % 1000) / 1000; });
    const auto relation = relation_between(drawn, right, depth);
    ASSERT_TRUE(relation);
    EXPECT_EQ(relation->sentence.substr(0, 58), "yours is larger than expected wherever they differ, by 0.5");
    EXPECT_TRUE(relation->predicted.values.empty());
}

TEST(Relation, PredictsTheDrawnPicture) {
    const Image right = normals();
    const Image drawn = changed(right, [](float* n) {
        std::swap(n[0], n[2]);
        for (int c = 0; c < 3; ++c) n[c] *= 3;  // a direction's length is that of the drawn one
    });
    const auto relation = relation_between(drawn, right, normal);
    ASSERT_TRUE(relation);
    EXPECT_LT(difference(relation->predicted, drawn, 0).largest, 1e-5);
}

TEST(Relation, SaysNothingThatItDoesNotKnow) {
    const Image right = normals();
    std::minstd_rand random;
    const auto noise = [&] { return float(random() % 2000) / 1000 - 1; };
    EXPECT_EQ(said(changed(right, [&](float* n) { n[0] = noise(), n[1] = noise(), n[2] = noise(); }), right, normal),
              "")
        << "noise";
    EXPECT_EQ(said(right, right, normal), "") << "no difference";
    EXPECT_EQ(said(changed(right, [](float* n) { n[0] += 1e-7f; }), right, normal), "") << "rounding";
    EXPECT_EQ(said(changed(depths(), [&](float* d) { *d += noise(); }), depths(), depth), "") << "noise on a value";
}

TEST(Relation, AcceptsAnyValuesAndShapes) {
    const Image right = depths();
    for (const float bad : {NAN, INFINITY, -INFINITY, 3e38f, -3e38f, 1e-40f, 0.0f}) {
        int count = 0;
        (void)said(changed(right, [&](float* d) { *d = bad; }), right, depth);
        (void)said(changed(right, [&](float* d) { *d = count++ % 2 ? bad : *d; }), right, depth);
        (void)said(right, changed(right, [&](float* d) { *d = bad; }), depth);
        (void)said(changed(normals(), [&](float* n) { n[0] = bad; }), normals(), normal);
        (void)said(normals(), changed(normals(), [&](float* n) { n[0] = n[1] = n[2] = bad; }), normal);
    }
    EXPECT_EQ(said(Image(3, 3, 3), right, depth), "") << "another shape";
    EXPECT_EQ(said(Image(), Image(), unnamed), "");
}

}  // namespace
}  // namespace relief::check
