// Lab 19: blends of two normals against exact surfaces, three planes against a displaced solid, and the variance of
// averaged normals.
#include <glm/gtc/constants.hpp>
#include <random>

#include "framework/core/gl/counters.h"
#include "framework/staff/reference/degrees.h"
#include "labs/19_layered_normals/layers.h"
#include "labs/19_layered_normals/scene.h"
#include "labs/19_layered_normals/staff/exact.h"
#include "tests/labs/shots.h"
#include "tests/support.h"

namespace relief {
namespace {

using namespace layered_normals;

double between(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
}

/// Six sines along the plane. The root mean square of their slope is a third of `steepest`.
class Sines {
public:
    Sines(std::mt19937& random, double frequency, double steepest) {
        for (glm::dvec4& wave : waves_) {
            const double angle = between(random, 0, 2 * glm::pi<double>()), k = frequency * between(random, 0.6, 1.4);
            const double slope = steepest / 3 * std::sqrt(2.0 / double(waves_.size()));
            wave = {k * std::cos(angle), k * std::sin(angle), slope / k, between(random, 0, 2 * glm::pi<double>())};
        }
    }
    Height at(glm::dvec2 uv) const {
        Height sum{0, {0, 0}, {0, 0, 0}};
        for (const glm::dvec4& wave : waves_) {
            const glm::dvec2 k(wave);
            const double angle = glm::dot(k, uv) + wave.w, s = wave.z * std::sin(angle), c = wave.z * std::cos(angle);
            sum.height += s, sum.slope += c * k, sum.bend -= s * glm::dvec3(k.x * k.x, k.x * k.y, k.y * k.y);
        }
        return sum;
    }

private:
    std::array<glm::dvec4, 6> waves_;
};

TEST(LayeredNormals, TheMapsHaveTheLayersAtTheCentresOfTexels) {
    for (const auto& [layer, maps] : {std::pair(&stones, &stone_maps()), std::pair(&grain, &grain_maps())})
        for (int y = 0; y < texels; y += 7)
            for (int x = 0; x < texels; x += 5) {
                const Height at = layer(centre_of_texel(x, y));
                const float *const normal = maps->normals.pixel(x, y), *const slope = maps->slopes.pixel(x, y),
                                   *const bend = maps->bends.pixel(x, y);
                EXPECT_NEAR(normal[3], at.height, 1e-8) << x << ", " << y;
                EXPECT_NEAR(normal[0] / normal[2], -at.slope.x, 1e-6) << x << ", " << y;
                EXPECT_NEAR(slope[1], at.slope.y, 1e-6) << x << ", " << y;
                EXPECT_NEAR(slope[2], at.slope.x * at.slope.x, 1e-6) << x << ", " << y;
                EXPECT_NEAR(bend[0], at.slope.x * at.slope.y, 1e-6) << x << ", " << y;
                EXPECT_NEAR(bend[2], at.bend.y, 1e-4) << x << ", " << y;
            }
}

TEST(LayeredNormals, TheLayersDerivativesAreThoseOfTheirHeights) {
    std::mt19937 random(19);
    constexpr double step = 1e-5;
    int compared = 0;
    for (Height (*layer)(glm::dvec2) : {stones, grain})
        for (int i = 0; i < 2000; ++i) {
            const glm::dvec2 uv(between(random, -1, 2), between(random, -1, 2));
            const auto at = [&](double u, double v) { return layer(uv + step * glm::dvec2(u, v)); };
            const Height here = at(0, 0);
            // Stones have kinks of the second derivative, of 2 * 0.024 / 0.03^2 at most.
            const double rough = layer == stones ? 200 * step : 1e-4;
            EXPECT_NEAR(here.slope.x, (at(1, 0).height - at(-1, 0).height) / (2 * step), rough) << i;
            EXPECT_NEAR(here.slope.y, (at(0, 1).height - at(0, -1).height) / (2 * step), rough) << i;
            const glm::dvec2 along_u = (at(1, 0).slope - at(-1, 0).slope) / (2 * step),
                             along_v = (at(0, 1).slope - at(0, -1).slope) / (2 * step);
            const bool is_kink =
                glm::distance(at(-1, 0).bend, at(1, 0).bend) > 5 || glm::distance(at(0, -1).bend, at(0, 1).bend) > 5;
            if (is_kink) continue;
            ++compared;
            EXPECT_NEAR(here.bend.x, along_u.x, 1 + 1e-3 * std::abs(here.bend.x)) << i;
            EXPECT_NEAR(here.bend.y, along_u.y, 1 + 1e-3 * std::abs(here.bend.y)) << i;
            EXPECT_NEAR(here.bend.z, along_v.y, 1 + 1e-3 * std::abs(here.bend.z)) << i;
            EXPECT_LT(glm::length(here.slope), 1.6) << i;
            EXPECT_NEAR(here.height, layer(uv + glm::dvec2(1, -1)).height, 1e-9) << "it repeats";
        }
    EXPECT_GT(compared, 3900) << "kinks are lines, and rare";
}

TEST(LayeredNormals, ThePublishedBlendsHaveTheErrorsOfSixSines) {
    // Six sines each, the detail 13 times finer. The expected means are from a separate program with other random
    // sines; the slope of six sines depends on their phases by about a third.
    struct Row {
        double base, detail;
        Settings::Question question;
        std::array<double, 7> degrees;  ///< in the order of Settings::Blend
    };
    using S = Settings;
    const Row rows[] = {{1, 0.3, S::heights_add, {8.28, 1.45, 0.27, 0.23, 0.00, 0.39, 1.03}},
                        {1, 0.3, S::in_frame, {8.38, 1.68, 0.21, 0.23, 0.40, 0.10, 0.99}},
                        {1, 1, S::along_normal, {11.71, 4.45, 0.88, 1.41, 1.10, 0.49, 3.11}},
                        {2, 1, S::heights_add, {15.00, 6.29, 2.24, 1.71, 0.00, 3.28, 5.56}}};
    for (const Row& row : rows) {
        std::array<double, 7> sums{};
        std::mt19937 random(7);
        constexpr int surfaces = 60, points = 60;
        for (int i = 0; i < surfaces; ++i) {
            const Sines base(random, 1, row.base), detail(random, 13, row.detail);
            for (int j = 0; j < points; ++j) {
                const glm::dvec2 uv(between(random, 0, 100), between(random, 0, 100));
                const Height first = base.at(uv), second = detail.at(uv);
                const glm::dvec3 n1 = with_slope(first.slope), n2 = with_slope(second.slope);
                const glm::dvec3 exact = exact_blend(row.question, n1, n2, second.height, first.bend);
                for (int blend = 0; blend < 7; ++blend)
                    sums[size_t(blend)] += degrees_between(blended(S::Blend(blend), n1, n2), exact);
            }
        }
        for (size_t blend = 0; blend < 7; ++blend) {
            const double mean = sums[blend] / (surfaces * points);
            EXPECT_NEAR(mean, row.degrees[blend], 0.02 + 0.2 * row.degrees[blend])
                << S::blends.names[blend] << " of slopes " << row.base << " and " << row.detail;
        }
    }
}

TEST(LayeredNormals, AlongTheNormalIsTheNormalOfTheDisplacedSurface) {
    std::mt19937 random(5);
    constexpr double step = 1e-6;
    for (int i = 0; i < 300; ++i) {
        const Sines base(random, 1, 1.5), detail(random, 13, 1);
        const glm::dvec2 uv(between(random, 0, 9), between(random, 0, 9));
        const auto displaced = [&](double u, double v) {
            const glm::dvec2 place = uv + glm::dvec2(u, v);
            const Height first = base.at(place);
            return glm::dvec3(place, first.height) + detail.at(place).height * with_slope(first.slope);
        };
        const glm::dvec3 normal =
            glm::cross(displaced(step, 0) - displaced(-step, 0), displaced(0, step) - displaced(0, -step));
        const Height first = base.at(uv), second = detail.at(uv);
        const glm::dvec3 exact = exact_blend(Settings::along_normal, with_slope(first.slope), with_slope(second.slope),
                                             second.height, first.bend);
        EXPECT_LT(degrees_between(normal, exact), 1e-4) << i;
    }
}

TEST(LayeredNormals, AFlatLayerChangesNothingAndARotationTakesZToTheBase) {
    std::mt19937 random(3);
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 base = with_slope({between(random, -3, 3), between(random, -3, 3)}), flat(0, 0, 1);
        for (const Settings::Blend blend : {Settings::whiteout, Settings::pd, Settings::rnm, Settings::swizzle})
            EXPECT_LT(degrees_between(blended(blend, base, flat), base), 1e-6) << blend;
        const glm::dvec3 detail = with_slope({between(random, -3, 3), between(random, -3, 3)});
        const glm::dvec3 turned = blended(Settings::rnm, base, detail);
        EXPECT_NEAR(glm::length(turned), 1, 1e-14);
        EXPECT_NEAR(glm::dot(turned, base), detail.z, 1e-14) << "a rotation keeps angles";
        const glm::dvec3 axis(-base.y, base.x, 0);
        EXPECT_NEAR(glm::dot(turned, axis), glm::dot(detail, axis), 1e-13) << "the axis stays";
    }
}

TEST(LayeredNormals, WithTheGradientOfTheWeightsTheNormalIsThatOfTheDisplacedSphere) {
    std::mt19937 random(11);
    constexpr double step = 1e-5, scale = 1e-3;  // of the heights: the formula is for small ones
    for (int i = 0; i < 300; ++i) {
        const Sines waves(random, 20, 1 * scale);
        const double sharpness = between(random, 1, 16);
        const glm::dvec3 place =
            glm::normalize(glm::dvec3(between(random, -1, 1), between(random, -1, 1), between(random, -1, 1)));
        const auto height = [&](const glm::dvec3& p) {
            const glm::dvec3 weights = plane_weights(p, sharpness);
            double sum = 0;
            for (int axis = 0; axis < 3; ++axis)
                sum += weights[axis] * waves.at(glm::dvec2(p * plane_frame(axis, place[axis] < 0 ? -1 : 1))).height;
            return sum;
        };
        const glm::dvec3 across = glm::normalize(glm::cross(place, glm::dvec3(0.3, 0.5, 0.7))),
                         up = glm::cross(place, across);
        const auto displaced = [&](double u, double v) {
            const glm::dvec3 p = glm::normalize(place + u * across + v * up);
            return p * (1 + height(p));
        };
        const glm::dvec3 normal =
            glm::cross(displaced(step, 0) - displaced(-step, 0), displaced(0, step) - displaced(0, -step));

        const Surface surface = surface_at(place, false);
        glm::dvec3 heights(0);
        glm::dmat3 gradients(0);
        for (int axis = 0; axis < 3; ++axis) {
            const glm::dmat3 frame = plane_frame(axis, place[axis] < 0 ? -1 : 1);
            const Height at = waves.at(glm::dvec2(place * frame));
            heights[axis] = at.height, gradients[axis] = frame[0] * at.slope.x + frame[1] * at.slope.y;
        }
        const glm::dvec3 gradient = gradients * plane_weights(surface.normal, sharpness) +
                                    weight_gradients(surface.normal, surface.turns, sharpness) * heights;
        // Heights of 5e-5 bend the normal by 0.06 degrees; the formula omits their squares.
        EXPECT_LT(degrees_between(normal, bumped(surface.normal, gradient)), 2e-4) << i;
    }
}

TEST(LayeredNormals, TheRocksNormalTurnsAsItsDifferencesSay) {
    std::mt19937 random(13);
    constexpr double step = 1e-6;
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 place(between(random, -1, 1), between(random, -1, 1), between(random, -1, 1));
        if (glm::length(place) < 0.5) continue;
        const Surface surface = surface_at(place, true);
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 along(0);
            along[axis] = 1;
            // Along the surface only: the gradients of `turns` have no part along the normal.
            const glm::dvec3 tangent = along - surface.normal[axis] * surface.normal;
            const glm::dvec3 change =
                (surface_at(place + step * tangent, true).normal - surface_at(place - step * tangent, true).normal) /
                (2 * step);
            EXPECT_LT(glm::distance(glm::transpose(surface.turns) * tangent, change), 1e-6) << i;
        }
    }
}

TEST(LayeredNormals, PlanesAreRightHandedAndTextOnThemIsNotMirrored) {
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {1.0, -1.0}) {
            const glm::dmat3 frame = plane_frame(axis, side);
            EXPECT_EQ(glm::determinant(frame), 1);
            EXPECT_EQ(frame[2][axis], side);
            EXPECT_EQ(axis == 1 ? frame[0].x : frame[1].y, 1) << "up is +y; on the y planes, right is +x";
        }
}

TEST(LayeredNormals, ToksvigsLengthIsTheVarianceOfAGaussianOfSmallSlopes) {
    // For slopes of variance v on each axis, the mean normal's length is about 1 - v, and (1 - l) / l is v to first
    // order.
    std::mt19937 random(17);
    for (const double variance : {0.001, 0.01}) {
        std::normal_distribution slope(0.0, std::sqrt(variance));
        glm::dvec3 sum(0);
        constexpr int samples = 400000;
        for (int i = 0; i < samples; ++i) sum += with_slope({slope(random), slope(random)});
        EXPECT_NEAR(lost_variance(sum / double(samples)) / variance, 1, 0.03);
    }
}

TEST(LayeredNormals, TheLobeOfGgxIsTheDistributionOfWalterAndOthers) {
    // D(h) of their equation 33, by angle. Slopes have the density D cos^4: cos dw is cos^4 of an area of slopes.
    for (const double shininess : {10.0, 400.0})
        for (const double degrees : {0.0, 1.0, 5.0, 20.0, 60.0, 85.0}) {
            const double a2 = 2 / (shininess + 2), c = std::cos(glm::radians(degrees)), t2 = 1 / (c * c) - 1;
            const double d = a2 / (glm::pi<double>() * std::pow(c, 4) * std::pow(a2 + t2, 2));
            EXPECT_NEAR(falls(Settings::ggx, t2 * (shininess + 2)) / (d * std::pow(c, 4) * glm::pi<double>() * a2), 1,
                        1e-9)
                << shininess << ' ' << degrees;
        }
}

TEST(LayeredNormals, ALobeKeepsItsLightWhenAVarianceWidensIt) {
    // The highlight is falls(off² / v) / (precision v). Its integral over all slopes is the same for each v >= 1 /
    // precision: 2 pi / precision for both lobes. Slopes at r = tan(u) reach infinity, where GGX still has light.
    for (const Settings::Brdf brdf : {Settings::blinn_phong, Settings::ggx})
        for (const double variance : {0.0025, 0.01, 0.3}) {
            double sum = 0;
            constexpr int steps = 200000;
            for (int i = 0; i < steps; ++i) {
                const double u = (i + 0.5) / steps * glm::half_pi<double>(), r = std::tan(u);
                sum += falls(brdf, r * r / variance) * r * (1 + r * r);
            }
            const double whole = sum * glm::half_pi<double>() / steps * 2 * glm::pi<double>() / variance;
            EXPECT_NEAR(whole, 2 * glm::pi<double>(), 2e-3) << brdf << ' ' << variance;
        }
}

TEST(LayeredNormals, SamplesOfBothLobesAgreeWithTheExactHighlight) {
    const auto off = [](const char* brdf, const char* filter) {
        return error_of("19",
                        shot_of("19", {{"view", "far"}, {"brdf", brdf}, {"filter", filter}}, "highlight", {64, 64}));
    };
    for (const char* brdf : {"blinn-phong", "ggx"}) {
        EXPECT_LT(off(brdf, "samples").largest, 1e-3) << brdf;
        EXPECT_LT(off(brdf, "lean").mean, off(brdf, "plain").mean / 2) << brdf;
    }
}

TEST(LayeredNormals, ALayerOfStrength0AndAPlaneOfWeight0AreNotRead) {
    const auto reads = [](std::vector<Knob> knobs) {
        const Image image = drawn("19", shot_of("19", std::move(knobs), "reads", {64, 64}));
        std::map<float, int> counts;
        for (size_t i = 0; i < image.values.size(); i += 4)
            if (image.values[i] != no_surface) ++counts[image.values[i]];
        return counts;
    };
    EXPECT_EQ(reads({{"grain", "0"}}).count(2), 0u);
    EXPECT_EQ(reads({{"grain", "1"}}).count(1), 0u);
    const auto fading = reads({{"fade", "2.6"}});
    EXPECT_GT(fading.at(1), 100) << "beyond the fade";
    EXPECT_GT(fading.at(2), 100) << "before it";
    const auto cube = reads({{"view", "solid"}, {"shape", "cube"}});
    EXPECT_EQ(cube.size(), 1u);
    EXPECT_GT(cube.at(1), 500);
    EXPECT_GT(reads({{"view", "solid"}, {"shape", "sphere"}, {"sharpness", "1"}}).at(3), 500);
}

TEST(LayeredNormals, AFadedGrainGivesTheStonesToTheBit) {
    const auto normals = [](const char* grain, const char* fade) {
        return drawn("19", shot_of("19", {{"grain", grain}, {"fade", fade}}, "normal", {64, 64})).values;
    };
    EXPECT_EQ(normals("0", "30"), normals("4", "0.1"));
    EXPECT_NE(normals("0", "30"), normals("1", "30"));
}

TEST(LayeredNormals, ShadersAgreeWithTheExactValuesAtTheEndsOfTheirKnobs) {
    // Slopes up to 6, sharpness 1 and 64: a float's rounding of normals with a z of 0.1.
    for (const char* stones : {"0", "4"})
        for (const char* grain : {"0.01", "4"}) {
            const std::vector<Knob> layers = {{"stones", stones}, {"grain", grain}, {"fade", "1000"}};
            const auto off = [&](std::vector<Knob> more, const char* probe) {
                more.insert(more.end(), layers.begin(), layers.end());
                return error_of("19", shot_of("19", more, probe, {48, 48}));
            };
            EXPECT_LT(off({}, "normal").largest, 0.05) << stones << ' ' << grain;
            EXPECT_LT(off({{"blend", "rnm"}, {"question", "shortest-arc"}}, "normal").largest, 0.05);
            for (const char* filter : {"toksvig", "derivatives"})
                EXPECT_LT(off({{"filter", filter}, {"blend", "udn"}}, "variance").mean, 1e-4) << filter;
            for (const char* sharpness : {"1", "64"})
                EXPECT_LT(off({{"view", "solid"}, {"sharpness", sharpness}}, "gradient").mean, 2e-3) << sharpness;
        }
}

TEST(LayeredNormals, BlendsOfSteepSlopesAreFiniteAndOfUnitLength) {
    std::mt19937 random(23);
    for (int i = 0; i < 300; ++i) {
        const auto steep = [&] {
            const double size = std::pow(10.0, between(random, -6, 6)), angle = between(random, 0, 6.3);
            return with_slope(size * glm::dvec2(std::cos(angle), std::sin(angle)));
        };
        const glm::dvec3 base = steep(), detail = steep();
        for (int blend = 0; blend < 7; ++blend)
            EXPECT_NEAR(glm::length(blended(Settings::Blend(blend), base, detail)), 1, 1e-9) << blend;
        for (int question = 0; question < 4; ++question)
            EXPECT_NEAR(glm::length(exact_blend(Settings::Question(question), base, detail, 0.01, {1, 1, 1})), 1, 1e-9);
    }
}

}  // namespace
}  // namespace relief
