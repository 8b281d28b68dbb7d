// Lab 19's formulas for normals, weights and variances, and lab 12's guesses of a shadow, near the ends of their
// inputs. All run in single precision, like their shaders. The exact values are for the same rounded inputs.
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <random>

#include "framework/staff/measure/stability.h"
#include "framework/staff/reference/degrees.h"
#include "framework/staff/reference/terminator.h"

namespace relief::measure {
namespace {

constexpr unsigned layer_seed = 19;

glm::vec3 with_slope(double slope, double towards) {
    return glm::vec3(glm::normalize(glm::dvec3(-slope * std::cos(towards), -slope * std::sin(towards), 1)));
}

/// Returns the exact sum of heights, by slopes.
glm::dvec3 exact_sum(const glm::dvec3& base, const glm::dvec3& detail) {
    return glm::normalize(glm::dvec3(glm::dvec2(base) / base.z + glm::dvec2(detail) / detail.z, 1));
}
/// Returns the exact rotation of the detail with the base, by Rodrigues' formula.
glm::dvec3 exact_rotation(const glm::dvec3& base, const glm::dvec3& detail) {
    const glm::dvec3 axis = glm::cross(glm::dvec3(0, 0, 1), base);
    return base.z * detail + glm::cross(axis, detail) + glm::dot(axis, detail) / (1 + base.z) * axis;
}

/// PD: the sum of heights by products.
glm::vec3 sum_by_products(glm::vec3 base, glm::vec3 detail) {
    return glm::normalize(glm::vec3(glm::vec2(base) * detail.z + glm::vec2(detail) * base.z, base.z * detail.z));
}
/// RNM by two reflections.
glm::vec3 rotation_by_reflections(glm::vec3 base, glm::vec3 detail) {
    const glm::vec3 across = base + glm::vec3(0, 0, 1), mirrored = detail * glm::vec3(1, 1, -1);
    return mirrored - across * (2 * glm::dot(across, mirrored) / glm::dot(across, across));
}
/// A normal map in two channels, with z by Pythagoras.
glm::vec3 rebuilt(glm::vec3 normal) {
    return {normal.x, normal.y, std::sqrt(std::max(0.0f, 1 - normal.x * normal.x - normal.y * normal.y))};
}

BenchScene steep_blends(const BenchSettings& settings) {
    using Blend = glm::vec3 (*)(glm::vec3, glm::vec3);
    using Exact = glm::dvec3 (*)(const glm::dvec3&, const glm::dvec3&);
    const size_t count = settings.quick ? 100 : 2000;
    const auto method = [count](const char* name, const char* why, Blend blend, Exact exact, bool peer) {
        return SweptMethod{name, 1e-4, why,
                           [=](double hard) {
                               std::mt19937 random(layer_seed);
                               // At most 143 degrees apart: of opposite slopes, the sum is mostly rounding.
                               std::uniform_real_distribution<> turn(0, glm::two_pi<double>()), apart(-2.5, 2.5);
                               Tally tally;
                               for (size_t i = 0; i < count; ++i) {
                                   const double towards = turn(random);
                                   const glm::vec3 base = with_slope(hard, towards),
                                                   detail = with_slope(hard, towards + apart(random));
                                   tally.add(degrees_between(glm::dvec3(blend(base, detail)), exact(base, detail)));
                               }
                               return tally.largest(hard);
                           },
                           peer};
    };
    return sweep_scene(
        "blend-slope", "slope of both normals", "degree", decades(0, 6, settings.quick ? 2 : 1),
        {method("pd", "Products of z do not divide; a float has small z with all its digits.", sum_by_products,
                exact_sum, false),
         method("rnm", "The divisor is at least 1.", rotation_by_reflections, exact_rotation, false),
         method(
             "pd-with-rebuilt-z",
             "z by Pythagoras loses its digits. From a slope of 4000 on it is 0, and the sum has no direction.",
             [](glm::vec3 base, glm::vec3 detail) { return sum_by_products(rebuilt(base), rebuilt(detail)); },
             exact_sum, true)});
}

BenchScene plane_weights(const BenchSettings& settings) {
    // Axes, edges and corners, with components of 0, -0 and next to 0, and random normals.
    std::vector<glm::vec3> normals;
    for (const float x : {-1.0f, -0.0f, 0.0f, 1e-20f, 1.0f})
        for (const float y : {-1.0f, -0.0f, 0.0f, 1e-20f, 1.0f})
            for (const float z : {-1.0f, -0.0f, 0.0f, 1e-20f, 1.0f})
                if (std::abs(x) == 1 || std::abs(y) == 1 || std::abs(z) == 1)
                    normals.push_back(glm::normalize(glm::vec3(x, y, z)));
    std::mt19937 random(layer_seed);
    std::normal_distribution<float> one;
    for (int i = 0; i < (settings.quick ? 100 : 2000); ++i)
        normals.push_back(glm::normalize(glm::vec3(one(random), one(random), one(random))));
    // A GPU computes a power by logarithms.
    const auto power = [](float base, float exponent) { return std::exp2(exponent * std::log2(base)); };
    const auto method = [&](const char* name, const char* why, bool absolute, bool peer) {
        return SweptMethod{name, 1e-5, why,
                           [=](double hard) {
                               Tally tally;
                               for (const glm::vec3& normal : normals) {
                                   glm::vec3 weights;
                                   glm::dvec3 exact;
                                   for (int i = 0; i < 3; ++i) {
                                       weights[i] = power(absolute ? std::abs(normal[i]) : normal[i], float(hard));
                                       exact[i] = std::pow(std::abs(double(normal[i])), hard);
                                   }
                                   weights /= weights.x + weights.y + weights.z;
                                   exact /= exact.x + exact.y + exact.z;
                                   // Its sum counts, too. The comparison keeps NaN.
                                   const double sum = double(weights.x) + double(weights.y) + double(weights.z) - 1;
                                   tally.add(glm::length(glm::dvec3(weights) - exact) + std::abs(sum));
                               }
                               return tally.largest(hard);
                           },
                           peer};
    };
    return sweep_scene("triplanar-weights", "power of the weights, 1 to 64", "share",
                       settings.quick ? std::vector<double>{1, 8, 64} : std::vector<double>{1, 2, 4, 8, 16, 32, 64},
                       {method("absolute-first", "The logarithm of 0 is -infinity, and its power is 0.", true, false),
                        method("power-first", "A negative component has no logarithm.", false, true)});
}

/// Toksvig's variance of slopes for mean normals of decreasing length. Relative error of its sum with 1/400, the
/// variance of a texel.
BenchScene short_means(const BenchSettings& settings) {
    const auto at = [](double hard) {
        std::mt19937 random(layer_seed);
        std::normal_distribution<> one;
        Tally tally;
        for (int i = 0; i < 500; ++i) {
            const glm::vec3 mean(glm::normalize(glm::dvec3(one(random), one(random), one(random))) / hard);
            const float length = glm::length(mean), variance = (1 - length) / length;
            const double exact = 1.0 / 400 + 1 / glm::length(glm::dvec3(mean)) - 1;
            tally.add(std::abs((1.0 / 400 + double(variance)) / exact - 1));
        }
        return tally.largest(hard);
    };
    return sweep_scene(
        "toksvig-length", "1 / length of the mean normal", "share", decades(0, 6, settings.quick ? 2 : 1),
        {{"toksvig", 1e-4, "The length is a float with all its digits; that of a unit normal lacks a rounding.", at}});
}

/// The variance that a normal's change to the next pixels suggests, for ever smaller changes. Relative error of its sum
/// with 1/400.
BenchScene small_turns(const BenchSettings& settings) {
    const auto at = [](double hard) {
        std::mt19937 random(layer_seed);
        std::normal_distribution<> one;
        const auto unit = [&] { return glm::normalize(glm::dvec3(one(random), one(random), one(random))); };
        Tally tally;
        for (int i = 0; i < 500; ++i) {
            const glm::dvec3 normal = unit();
            const auto turned = [&] { return glm::vec3(glm::normalize(normal + unit() / hard)); };
            const glm::vec3 here(normal), next = turned(), above = turned();
            const glm::vec3 across = next - here, up = above - here;
            const float variance = std::min(0.25f * (glm::dot(across, across) + glm::dot(up, up)), 0.09f);
            const glm::dvec3 exact_across = glm::dvec3(next) - glm::dvec3(here),
                             exact_up = glm::dvec3(above) - glm::dvec3(here);
            const double exact =
                std::min(0.25 * (glm::dot(exact_across, exact_across) + glm::dot(exact_up, exact_up)), 0.09);
            tally.add(std::abs((double(variance) + 1.0 / 400) / (exact + 1.0 / 400) - 1));
        }
        return tally.largest(hard);
    };
    return sweep_scene(
        "derivatives-turn", "1 / turn to the next pixel", "share", decades(-1, 7, settings.quick ? 2 : 1),
        {{"derivatives", 1e-5, "Differences of near floats are exact, and large ones are clamped.", at}});
}

/// A normal of the base, a normal of the map and a direction to the light.
struct Corner {
    glm::vec3 surface, mapped, to_light;
};

/// Returns corners at `angle` from the ends of the factors, on both sides: n . L = 0, Ng . L = 0, Ng . n = 0, and all
/// three at once. Half of them are aligned with the axes, so that cosines at angle 0 are 0.
std::vector<Corner> near_ends(double angle, size_t count) {
    std::mt19937 random(layer_seed);
    std::uniform_real_distribution<> lean(0.1, 1.4);
    std::normal_distribution<> one;
    const auto at = [](double elevation) { return glm::dvec3(std::cos(elevation), 0, std::sin(elevation)); };
    const double right = glm::half_pi<double>();
    std::vector<Corner> corners;
    for (size_t i = 0; i < count; ++i) {
        glm::dmat3 turn(1);
        if (i % 2) {
            turn[2] = glm::normalize(glm::dvec3(one(random), one(random), one(random)));
            turn[0] = glm::normalize(glm::cross(turn[2], glm::dvec3(0.6, 0.8, 0)));
            turn[1] = glm::cross(turn[2], turn[0]);
        }
        const auto add = [&](const glm::dvec3& mapped, const glm::dvec3& to_light) {
            corners.push_back({glm::vec3(turn[2]), glm::vec3(turn * mapped), glm::vec3(turn * to_light)});
        };
        const double up = lean(random), other = lean(random);
        for (const double off : {angle, -angle}) {
            add(at(up + right + off), at(up));                // n . L, above the base
            add(at(other), at(off));                          // Ng . L
            add(at(off), at(up));                             // Ng . n
            add(at(right + off), at(off));                    // the map is flat, and the light at the horizon
            add({0, std::cos(off), std::sin(off)}, at(off));  // all three
        }
    }
    // Cosines of a right angle are 0, not 6e-17.
    for (Corner& corner : corners)
        if (angle == 0)
            for (glm::vec3* v : {&corner.surface, &corner.mapped, &corner.to_light})
                for (int i = 0; i < 3; ++i)
                    if (std::abs((*v)[i]) < 1e-12f) (*v)[i] = 0;
    return corners;
}

/// Guesses of a shadow on the light of a normal map, in single precision against double.
BenchScene guessed_shadows(const BenchSettings& settings) {
    using Guess = float (*)(float upright, float low, float facing);  // Ng . n, Ng . L, n . L
    using Exact = double (*)(const glm::dvec3&, const glm::dvec3&, const glm::dvec3&);
    const size_t count = settings.quick ? 40 : 400;
    const auto method = [count](const char* name, const char* why, Guess guess, Exact exact, bool peer) {
        return SweptMethod{
            name, 1e-5, why,
            [=](double hard) {
                Tally tally;
                for (const auto& [surface, mapped, light] : near_ends(hard > 1e17 ? 0 : 1 / hard, count)) {
                    const float low = glm::dot(surface, light), facing = glm::dot(mapped, light);
                    const float lit = guess(glm::dot(surface, mapped), low, facing);
                    const double truth =
                        std::max(glm::dot(glm::dvec3(mapped), glm::dvec3(light)), 0.0) * exact(surface, mapped, light);
                    // Not max(): it would drop a factor that is not a number.
                    tally.add(std::abs(double(lit * (facing > 0 ? facing : 0)) - truth));
                }
                return tally.largest(hard);
            },
            peer};
    };
    std::vector<double> hardness = decades(0.5, 8, settings.quick ? 3.5 : 0.5);
    hardness.push_back(1e18);
    return sweep_scene(
        "terminator-ends", "1 / angle to n . L = 0, Ng . L = 0 or Ng . n = 0 (1e18: 0)", "share", hardness,
        {method(
             "estevez", "Cosines are at least 1e-6.",
             [](float upright, float low, float) {
                 if (low <= 0) return 0.0f;
                 const float c = std::max(std::abs(upright), 1e-6f), l = std::max(low, 1e-6f);
                 const float a = std::min((1 - c * c) / (8 * c * c), 1.0f), t = (1 - l * l) / (l * l);
                 return 2 / (1 + std::sqrt(1 + std::max(a, 0.0f) * std::max(t, 0.0f)));
             },
             estevez_shadow, false),
         method(
             "chiang", "The product of cosines is at least 1e-6.",
             [](float upright, float low, float facing) {
                 const float g = std::clamp(low / std::max(facing * upright, 1e-6f), 0.0f, 1.0f);
                 return g * (1 + g * (1 - g));
             },
             chiang_shadow, false),
         method(
             "estevez-divided",
             "A light below the base counts as one above it. 0 times infinity for a flat map and a light at the "
             "horizon.",
             [](float upright, float low, float) {
                 const float a = std::min((1 - upright * upright) / (8 * upright * upright), 1.0f);
                 return 2 / (1 + std::sqrt(1 + a * ((1 - low * low) / (low * low))));
             },
             estevez_shadow, true),
         method(
             "chiang-divided",
             "A mapped normal below the base gets no light. 0 / 0 for a light at the horizon of both normals.",
             [](float upright, float low, float facing) {
                 const float g = low / (facing * upright), clamped = g < 0 ? 0 : g > 1 ? 1 : g;
                 return clamped * (1 + clamped * (1 - clamped));
             },
             chiang_shadow, true)});
}

}  // namespace

std::vector<BenchScene> layer_sweeps(const BenchSettings& settings) {
    return {steep_blends(settings), plane_weights(settings), short_means(settings), small_turns(settings),
            guessed_shadows(settings)};
}

}  // namespace relief::measure
