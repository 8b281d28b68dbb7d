#include "layers.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/gtc/constants.hpp>

#include "framework/core/base/parallel.h"
#include "framework/library/maps/slope_moments.h"

namespace relief::layered_normals {
namespace {

constexpr double turn_rad = 2 * glm::pi<double>();

/// Returns a number in [0, 1) that depends on the integers alone.
double random_of(uint32_t a, uint32_t b, uint32_t c) {
    uint32_t x = a * 0x9e3779b9u + b * 0x85ebca6bu + c * 0xc2b2ae35u + 1;
    for (const uint32_t factor : {0x7feb352du, 0x846ca68bu}) x = (x ^ (x >> 15)) * factor;
    return double(x ^ (x >> 16)) / 4294967296.0;
}

Height operator+(const Height& a, const Height& b) { return {a.height + b.height, a.slope + b.slope, a.bend + b.bend}; }
Height operator*(const Height& a, const Height& b) {
    const glm::dvec2 &s = a.slope, &t = b.slope;
    return {a.height * b.height, a.height * t + b.height * s,
            a.height * b.bend + b.height * a.bend + glm::dvec3(2 * s.x * t.x, s.x * t.y + s.y * t.x, 2 * s.y * t.y)};
}
Height constant(double height) { return {height, {0, 0}, {0, 0, 0}}; }

/// A linear function of u and v.
Height linear(double height, glm::dvec2 slope) { return {height, slope, {0, 0, 0}}; }

/// A wave where its angle has the sine s and the cosine c, both times its amplitude.
Height wave_of(double s, double c, glm::dvec2 periods) {
    const glm::dvec2 k = turn_rad * periods;
    return {s, c * k, -s * glm::dvec3(k.x * k.x, k.x * k.y, k.y * k.y)};
}

Height wave(glm::dvec2 uv, glm::dvec2 periods, double amplitude, double phase_rad) {
    const double angle = glm::dot(turn_rad * periods, uv) + phase_rad;
    return wave_of(amplitude * std::sin(angle), amplitude * std::cos(angle), periods);
}

/// Returns the smooth rise from 0 to 1 of the first argument, which is linear, between 0 and 1.
Height rise(const Height& t) {
    if (t.height <= 0) return constant(0);
    if (t.height >= 1) return constant(1);
    return t * t * linear(3 - 2 * t.height, -2.0 * t.slope);
}

/// Returns the rounded profile between two joints at `low` and `high` along an axis, of which `place` is the
/// coordinate.
Height between_joints(double place, double low, double high, glm::dvec2 axis) {
    constexpr double joint = 0.004, rounding = 0.03;  // half of a joint's width, and of an edge's rounding; tiles
    const bool is_low = place - low < high - place;
    const double edge = is_low ? place - low : high - place, side = is_low ? 1 : -1;
    return rise(linear((edge - joint) / rounding, axis * (side / rounding)));
}

struct Wave {
    glm::dvec2 periods;  ///< integers
    double amplitude, phase_rad;
};

const std::array<Wave, 32>& waves_of_grain() {
    static const auto waves = [] {
        std::array<Wave, 32> all;
        for (uint32_t i = 0; i < all.size(); ++i) {
            // Logarithmic between 4 and 28 periods, so that every octave has as many waves.
            const double length = 4 * std::pow(7.0, (i + random_of(i, 1, 1)) / double(all.size()));
            const double angle = turn_rad / 2 * (0.6180339887 * i - std::floor(0.6180339887 * i));  // evenly
            const glm::dvec2 periods(std::round(length * std::cos(angle)), std::round(length * std::sin(angle)));
            all[i] = {periods, 0.1 / (turn_rad * glm::length(periods)), turn_rad * random_of(i, 3, 1)};
        }
        return all;
    }();
    return waves;
}

/// The grain at the centres of texels. There, a wave has one of a few angles: their sines are kept.
class GrainOfTexels {
public:
    GrainOfTexels() {
        for (const Wave& each : waves_of_grain())
            for (int angle = 0; angle < angles; ++angle) {
                const double radians = turn_rad * angle / angles + each.phase_rad;
                kept_.push_back(each.amplitude * glm::dvec2(std::sin(radians), std::cos(radians)));
            }
    }
    Height operator()(int x, int y) const {
        Height sum = constant(0);
        const glm::dvec2* kept = kept_.data();
        for (const Wave& each : waves_of_grain()) {
            const glm::ivec2 periods(each.periods);
            const int angle = periods.x * (2 * x + 1) + periods.y * (angles - 2 * y - 1);
            const glm::dvec2 at = kept[angle & (angles - 1)];
            sum = sum + wave_of(at.x, at.y, each.periods);
            kept += angles;
        }
        return sum;
    }

private:
    static constexpr int angles = 2 * texels;  ///< a power of two
    std::vector<glm::dvec2> kept_;             ///< sine and cosine, times the amplitude
};

template <class Layer>
LayerMaps layer_maps(const Layer& layer) {
    LayerMaps maps;
    maps.normals = maps.slopes = maps.bends = Image(texels, texels, 4);
    parallel_pieces(size_t(texels), 8, 0, [&](size_t begin, size_t end) {
        for (int y = int(begin); y < int(end); ++y)
            for (int x = 0; x < texels; ++x) {
                const Height at = layer(x, y);
                const glm::dvec2 slope = at.slope;
                const glm::dvec3 squares = squares_of(slope);
                const glm::dvec3 normal = glm::normalize(glm::dvec3(-slope, 1));
                const auto put = [&](Image& image, const glm::dvec4& value) {
                    for (int c = 0; c < 4; ++c) image.pixel(x, y)[c] = float(value[c]);
                };
                put(maps.normals, {normal, at.height});
                put(maps.slopes, {slope, squares.x, squares.y});
                put(maps.bends, {squares.z, at.bend});
            }
    });
    return maps;
}

}  // namespace

Height stones(glm::dvec2 uv) {
    constexpr int courses = 4, stones_per_course = 3;
    const double v = (uv.y - std::floor(uv.y)) * courses, u = uv.x - std::floor(uv.x);
    const auto course = uint32_t(std::min(int(v), courses - 1));
    const auto joint = [&](int i) {
        const int wrapped = (i + stones_per_course) % stones_per_course, around = (i - wrapped) / stones_per_course;
        const double offset = 0.5 * double(course % 2) + 0.5 * random_of(course, uint32_t(wrapped), 7);
        return (wrapped + offset) / stones_per_course + around;
    };
    int stone = -1;
    while (joint(stone + 1) <= u) ++stone;
    const double low = joint(stone), high = joint(stone + 1);
    const auto id = uint32_t((stone + stones_per_course) % stones_per_course);
    const auto signed_random = [&](uint32_t which) { return 2 * random_of(course, id, which) - 1; };

    const Height profile =
        between_joints(u, low, high, {1, 0}) *
        between_joints(v / courses, course / double(courses), (course + 1) / double(courses), {0, 1});
    const glm::dvec2 tilt = 0.7 * glm::dvec2(signed_random(1), signed_random(2));
    const glm::dvec2 off(u - (low + high) / 2, (v - course - 0.5) / courses);
    const Height face = linear(0.85 + 0.15 * signed_random(3) + glm::dot(tilt, off), tilt);
    Height dents = constant(0);
    for (uint32_t i = 0; i < 6; ++i) {
        const glm::dvec2 periods(std::round(4 + 6 * random_of(i, 1, 9)), std::round(12 * random_of(i, 2, 9) - 6));
        dents = dents + wave(uv, periods, 0.15 / glm::length(periods), turn_rad * (random_of(i, 3, 9) + 0.37 * id));
    }
    return constant(0.024) * profile * (face + dents);
}

Height grain(glm::dvec2 uv) {
    Height sum = constant(0);
    for (const Wave& each : waves_of_grain()) sum = sum + wave(uv, each.periods, each.amplitude, each.phase_rad);
    return sum;
}

const LayerMaps& stone_maps() {
    static const LayerMaps maps = layer_maps([](int x, int y) { return stones(centre_of_texel(x, y)); });
    return maps;
}

const LayerMaps& grain_maps() {
    static const LayerMaps maps = layer_maps(GrainOfTexels());
    return maps;
}

}  // namespace relief::layered_normals
