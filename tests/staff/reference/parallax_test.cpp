// The searches of the shaders against the exact hit.
#include "framework/staff/reference/parallax.h"

#include <gtest/gtest.h>

#include <random>

#include "framework/library/maps/test_maps.h"

namespace relief {
namespace {

/// Returns rays at an angle from the normal, with random origins and directions, for a map of 256² texels that is 20
/// deep.
std::vector<ReliefRay> rays_at(double degrees, int count) {
    std::mt19937 random(unsigned(degrees) + 1);
    std::uniform_real_distribution<> share(0, 1);
    std::vector<ReliefRay> rays;
    for (int i = 0; i < count; ++i) {
        const double turn = 2 * M_PI * share(random), reach = 20 * std::tan(degrees * M_PI / 180);
        rays.push_back({{256 * share(random), 256 * share(random)},
                        {reach * std::cos(turn), reach * std::sin(turn)},
                        std::cos(degrees * M_PI / 180)});
    }
    return rays;
}

struct Figures {
    double taps = 0, mean = 0, wrong = 0;  ///< wrong: share off by more than one texel
};

template <class Search>
Figures figures(const HeightField& field, const Search& search,
                std::initializer_list<double> angles = {30, 60, 75, 85}) {
    constexpr int count = 4000;
    Figures sum;
    for (const double angle : angles)
        for (const ReliefRay& ray : rays_at(angle, count)) {
            const auto exact = field.first_hit(ray.in_texels(), 1);
            const ParallaxHit found = search(ray);
            const double error = exact ? glm::distance(found.texel, exact->texel) : INFINITY;
            sum.taps += found.taps, sum.mean += error, sum.wrong += error > 1;
        }
    const double n = count * double(angles.size());
    return {sum.taps / n, sum.mean / n, sum.wrong / n};
}

const HeightField& fbm() {
    static const HeightField field(make_height_map(HeightMap::fbm, 256), true);
    return field;
}

TEST(Parallax, LinearStepsHaveTheErrorRateOfHandout11) {
    // Per cent, rounded as in the handout.
    struct Row {
        int steps;
        double wrong, rounding;
    };
    for (const Row& row :
         {Row{8, 26, .5}, {16, 15, .5}, {32, 7, .5}, {64, 1.4, .05}, {128, 0.2, .05}, {256, 0.07, .005}})
        EXPECT_NEAR(
            100 * figures(fbm(),
                          [&](const ReliefRay& ray) { return march(fbm(), ray, row.steps, Refinement::linear, 0); })
                      .wrong,
            row.wrong, row.rounding)
            << row.steps;
}

/// Returns the hit of a march whose samples after the first one are shifted by a share of a step, with a linear
/// crossing. A share of 0 is march().
glm::dvec2 shifted_march(const HeightField& field, const ReliefRay& ray, int steps, double shift) {
    const auto gap = [&](double t) { return 1 - t - field.height(ray.texel + t * ray.march); };
    double before = 0, after = 0, gap_before = gap(0), gap_after = gap_before;
    for (int i = 1; gap_after > 0 && after < 1; ++i) {
        before = after, gap_before = gap_after;
        after = std::min(1.0, (i - shift) / steps);
        gap_after = gap(after);
    }
    const double t = gap_before <= 0 ? before : before + (after - before) * gap_before / (gap_before - gap_after);
    return ray.texel + t * ray.march;
}

// The numbers of deck 11: 8 steps, in one frame, and as the mean of 16 frames with shifted samples.
TEST(Parallax, SixteenFramesOfShiftedStepsHaveTheErrorOfDeck11) {
    constexpr int steps = 8, frames = 16;
    const auto with = [&](auto texel_of) {
        return figures(fbm(), [&](const ReliefRay& ray) { return ParallaxHit{0, texel_of(ray), 0}; });
    };
    const Figures still = with([&](const ReliefRay& ray) { return shifted_march(fbm(), ray, steps, 0); });
    const Figures many = with([&](const ReliefRay& ray) {
        glm::dvec2 sum(0);
        for (int i = 0; i < frames; ++i) sum += shifted_march(fbm(), ray, steps, (i + 0.5) / frames);
        return sum / double(frames);
    });
    const Figures fine =
        with([&](const ReliefRay& ray) { return march(fbm(), ray, steps * frames, Refinement::linear, 0).texel; });
    EXPECT_NEAR(still.mean, 2.3, 0.05);
    EXPECT_NEAR(100 * still.wrong, 26, 0.5) << "as LinearStepsHaveTheErrorRateOfHandout11 says";
    EXPECT_NEAR(many.mean, 2.2, 0.05);
    EXPECT_NEAR(100 * many.wrong, 25, 0.5);
    EXPECT_NEAR(fine.mean, 0.052, 0.0005) << "the same number of samples, in one frame";
    EXPECT_NEAR(100 * fine.wrong, 0.2, 0.05);
}

TEST(Parallax, OneTapMissesMostRays) {
    const Figures found = figures(fbm(), [&](const ReliefRay& ray) { return parallax_offset(fbm(), ray); });
    EXPECT_NEAR(found.wrong, 0.68, 0.15);
    EXPECT_EQ(found.taps, 1);
}

TEST(Parallax, EachRefinementIsBetterThanTheLineAlone) {
    const auto wrong = [&](Refinement refinement, int rounds) {
        return figures(fbm(), [&](const ReliefRay& ray) { return march(fbm(), ray, 32, refinement, rounds); }).wrong;
    };
    const double line = wrong(Refinement::linear, 0);
    EXPECT_GT(wrong(Refinement::none, 0), 3 * line);
    EXPECT_LT(wrong(Refinement::bisection, 5), line / 2);
    EXPECT_LT(wrong(Refinement::secant, 2), line / 2);
    // An end of the bracket that never moves keeps the secant away from the root. Illinois halves its weight.
    const auto mean = [&](Refinement refinement) {
        return figures(fbm(), [&](const ReliefRay& ray) { return march(fbm(), ray, 8, refinement, 4); }).mean;
    };
    EXPECT_LT(mean(Refinement::illinois), 0.99 * mean(Refinement::secant));
}

TEST(Parallax, MoreStepsAreNeverWorse) {
    for (const HeightMap map :
         {HeightMap::smooth, HeightMap::fbm, HeightMap::bricks, HeightMap::stones, HeightMap::posts}) {
        const HeightField field(make_height_map(map, 256), true);
        double before = 1;
        for (const int steps : {8, 16, 32, 64, 128}) {
            const double wrong = figures(field, [&](const ReliefRay& ray) {
                                     return march(field, ray, steps, Refinement::linear, 0);
                                 }).wrong;
            // A handful of the 16,000 rays may hit correctly by chance.
            EXPECT_LE(wrong, before + 0.001) << height_map_names[size_t(map)] << ", " << steps;
            before = wrong;
        }
    }
}

TEST(Parallax, AFlatMapIsExactForEverySearch) {
    for (const auto& [map, t] : {std::pair(HeightMap::high, 0.0), {HeightMap::plateau, 0.5}, {HeightMap::low, 1.0}}) {
        const HeightField field(make_height_map(map, 4), true);
        for (const ReliefRay& ray : rays_at(60, 20)) {
            EXPECT_EQ(parallax_offset(field, ray).t, t);
            EXPECT_EQ(march(field, ray, 8, Refinement::linear, 0).taps, 1 + 8 * t) << "up to the surface";
            for (const Refinement refinement :
                 {Refinement::linear, Refinement::bisection, Refinement::secant, Refinement::illinois})
                for (const double steps : {1.0, 3.5, 7.0, 8.0})
                    EXPECT_NEAR(march(field, ray, steps, refinement, 3).t, t, 1e-12)
                        << int(refinement) << ", " << steps;
        }
    }
}

TEST(Parallax, StraightDownIsExactForEverySearchButSteep) {
    for (ReliefRay ray : rays_at(0, 50)) {
        ray.march = {};
        const double t = 1 - fbm().height(ray.texel);
        EXPECT_EQ(parallax_offset(fbm(), ray).t, t);
        EXPECT_NEAR(march(fbm(), ray, 8, Refinement::linear, 0).t, t, 1e-12);
        EXPECT_NEAR(march(fbm(), ray, 8, Refinement::bisection, 3).t, t, 1e-12);
        EXPECT_NEAR(steep_parallax(fbm(), ray, 8).t, t, 1.0 / 8);
    }
}

}  // namespace
}  // namespace relief
