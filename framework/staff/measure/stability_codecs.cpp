// Normal formats near poles, seams and zeros, and angles near 0.
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <random>

#include "framework/staff/measure/stability.h"
#include "framework/staff/measure/usual.h"
#include "framework/staff/reference/degrees.h"

namespace relief::measure {
namespace {

constexpr unsigned codec_seed = 3;

/// Returns directions at `angle` from the seams of formats. These are the ends of the axes (poles), the planes between
/// the axes, and the edges of an octahedron's faces. At angle 0 they lie on the seams, with components 0 and -0.
std::vector<glm::dvec3> near_seams(double angle, size_t count) {
    std::mt19937 random(codec_seed);
    std::uniform_real_distribution<> turn(0, 2 * glm::pi<double>());
    std::vector<glm::dvec3> normals;
    for (size_t i = 0; i < count; ++i)
        for (int axis = 0; axis < 3; ++axis)
            for (const double sign : {1.0, -1.0}) {
                const double a = turn(random), s = std::sin(angle), c = std::cos(angle);
                glm::dvec3 pole, plane;
                pole[axis] = sign * c, pole[(axis + 1) % 3] = s * std::cos(a), pole[(axis + 2) % 3] = s * std::sin(a);
                plane[axis] = sign * s, plane[(axis + 1) % 3] = c * std::cos(a),
                plane[(axis + 2) % 3] = c * std::sin(a);
                normals.push_back(pole), normals.push_back(plane);
            }
    return normals;
}

using RoundTrip = std::function<glm::dvec3(const glm::dvec3&)>;

/// An octahedral map in two bytes with GLSL's sign(), which is 0 at 0: a commonly copied version.
glm::dvec3 octahedral_by_sign(const glm::dvec3& normal) {
    const auto sign = [](glm::dvec2 v) { return glm::dvec2((v.x > 0) - (v.x < 0), (v.y > 0) - (v.y < 0)); };
    const auto fold = [&](glm::dvec2 p) { return (1.0 - glm::dvec2(std::abs(p.y), std::abs(p.x))) * sign(p); };
    glm::dvec2 p = glm::dvec2(normal) / (std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z));
    if (normal.z < 0) p = fold(p);
    p = glm::round(p * 127.0) / 127.0;
    const double z = 1 - std::abs(p.x) - std::abs(p.y);
    return glm::normalize(glm::dvec3(z < 0 ? fold(p) : p, z));
}

/// Two bytes, and z by Pythagoras without a check for a negative radicand.
glm::dvec3 two_bytes_bare(const glm::dvec3& normal) {
    const glm::dvec2 xy = glm::round((0.5 * glm::dvec2(normal) + 0.5) * 255.0) / 255.0 * 2.0 - 1.0;
    return glm::dvec3(xy, std::sqrt(1 - glm::dot(xy, xy)));
}

SweptMethod codec(const std::string& name, double stated, const char* why, size_t count, bool upper, RoundTrip trip,
                  bool peer = false) {
    return {name, stated, why,
            [=](double hard) {
                Tally tally;
                // Angles below a double's resolution would round to 0, so use 0.
                for (const glm::dvec3& normal : near_seams(hard > 1e17 ? 0 : 1 / hard, count))
                    if (!upper || normal.z >= 0) tally.add(degrees_between(trip(normal), normal));
                return tally.largest(hard);
            },
            peer};
}

BenchScene seam_scene(const BenchSettings& settings) {
    const size_t count = settings.quick ? 50 : 1000;
    // Largest errors as tests/staff/reference/normal_codec_test.cpp finds them at the corners of each code's
    // directions. Those of the precise formats are Cigolle et al.'s (2014, table 2) plus 1.5 %: sampled maxima are
    // lower bounds.
    const std::pair<NormalFormat, double> formats[] = {
        {NormalFormat::unorm8, 0.389},        {NormalFormat::snorm8, 0.3904},
        {NormalFormat::paired8, 0.3904},      {NormalFormat::rg8, 5.96},
        {NormalFormat::rg16, 0.376},          {NormalFormat::oct8, 0.957},
        {NormalFormat::oct8_precise, 0.6454}, {NormalFormat::oct12, 0.0594},
        {NormalFormat::oct16, 0.00371},       {NormalFormat::oct16_precise, 0.0025},
        {NormalFormat::half, 0.0238}};
    std::vector<SweptMethod> methods;
    for (const auto& [format, largest] : formats) {
        const bool upper = format == NormalFormat::rg8 || format == NormalFormat::rg16;
        methods.push_back(codec(std::string(info_of(format).name), largest,
                                upper ? "Upper half only; the root's argument is held at 0." : "Its sign of 0 is 1.",
                                count, upper, [format = format](const glm::dvec3& normal) {
                                    return decode_normal(format, encode_normal(format, normal));
                                }));
    }
    methods.push_back(codec(
        "usual-three-bytes", 0.778, "Truncated: twice the error everywhere.", count, false,
        [](const glm::dvec3& normal) { return usual_normal(usual_code(normal)); }, true));
    methods.push_back(codec("usual-octahedral", 0.957,
                            "sign(0) is 0: the fold of the lower half puts (x, 0) into the middle, which is the pole.",
                            count, false, octahedral_by_sign, true));
    methods.push_back(codec("usual-two-bytes", 5.96,
                            "Rounding makes (x, y) longer than 1 at the rim: the root of a negative number.", count,
                            true, two_bytes_bare, true));
    std::vector<double> hardness = decades(0.5, 16, settings.quick ? 5 : 1);
    hardness.push_back(1e18);
    return sweep_scene("codecs-seams", "1 / angle to a pole or a seam (1e18: on it, with 0 and -0)", "degree", hardness,
                       methods);
}

/// The angle between two unit vectors, as computed in single precision.
BenchScene angle_scene(const BenchSettings& settings) {
    const size_t count = settings.quick ? 100 : 2000;
    const auto method = [count](const std::string& name, double stated, const char* why, auto angle, bool peer) {
        return SweptMethod{name, stated, why,
                           [=](double hard) {
                               std::mt19937 random(codec_seed);
                               std::uniform_real_distribution<> around(-1, 1);
                               Tally tally;
                               for (size_t i = 0; i < count; ++i) {
                                   const glm::dvec3 a =
                                       glm::normalize(glm::dvec3(around(random), around(random), around(random) + 2));
                                   const glm::dvec3 side = glm::normalize(glm::cross(a, glm::dvec3(1, 0, 0)));
                                   // The method gets the rounded vectors, so their angle is the exact value.
                                   const glm::vec3 one(a), two(std::cos(1 / hard) * a + std::sin(1 / hard) * side);
                                   const double truth = degrees_between(one, two);
                                   if (truth > 0)
                                       tally.add(std::abs(glm::degrees(double(angle(one, two))) / truth - 1));
                               }
                               return tally.largest(hard);
                           },
                           peer};
    };
    return sweep_scene(
        "angle-of-two-vectors", "1 / angle, radians", "share", decades(0, 7, settings.quick ? 1 : 0.5),
        {method(
             "atan2-of-cross-and-dot", 0.1,
             "The sine of a small angle has all its digits; what cancels in the cross product is the floats' own.",
             [](glm::vec3 a, glm::vec3 b) {
                 const glm::dvec3 da(a), db(b);
                 return std::atan2(glm::length(glm::cross(da, db)), glm::dot(da, db));
             },
             false),
         method(
             "asin-of-half-chord", 0.1, "A difference of near floats is exact.",
             [](glm::vec3 a, glm::vec3 b) {
                 const glm::vec3 difference = glm::normalize(a) - glm::normalize(b);
                 return 2 * std::asin(std::min(1.0f, glm::length(difference) / 2));
             },
             true),
         method(
             "acos-of-dot-held-at-1", 0.1,
             "The cosine of 0.0003 is 1 - 4e-8, which a float rounds to 1: the angle is 0, or 0.00035.",
             [](glm::vec3 a, glm::vec3 b) { return std::acos(std::clamp(glm::dot(a, b), -1.0f, 1.0f)); }, true),
         method(
             "acos-of-dot", 0.1, "Rounding makes the dot product larger than 1, and acos of that is not a number.",
             [](glm::vec3 a, glm::vec3 b) { return std::acos(glm::dot(a, b)); }, true)});
}

}  // namespace

std::vector<BenchScene> codec_sweeps(const BenchSettings& settings) {
    return {seam_scene(settings), angle_scene(settings)};
}

}  // namespace relief::measure
