// Compares every function of shaders/common with its twin in double precision, over thousands of
// inputs. Repeats this with a mistake planted in the shader, which must be detected.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <regex>
#include <set>

#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/image/color.h"
#include "framework/core/image/mips.h"
#include "framework/library/maps/skips.h"
#include "framework/library/maps/test_maps.h"
#include "framework/library/maps/visualize.h"
#include "framework/library/mesh/frame.h"
#include "framework/staff/reference/budget.h"
#include "framework/staff/reference/displaced.h"
#include "framework/staff/reference/height_field.h"
#include "framework/staff/reference/mesh_rays.h"
#include "framework/staff/reference/patch_points.h"
#include "framework/staff/reference/shading.h"
#include "framework/staff/reference/terminator.h"
#include "framework/staff/reference/tessellation.h"
#include "tests/core/gl/glsl_function.h"

namespace relief {
namespace {

/// Random inputs that are exact floats, so that shader and twin start with the same numbers.
struct Dice {
    std::mt19937 random;
    float between(float low, float high) { return std::uniform_real_distribution<float>(low, high)(random); }
    /// Both signs, with magnitudes over several powers of ten.
    float any_size(float lowest, float highest) {
        const float size = std::pow(10.0f, between(lowest, highest));
        return random() % 2 ? size : -size;
    }
    glm::vec2 two(float low, float high) { return {between(low, high), between(low, high)}; }
    glm::vec3 inside(float low, float high) { return {between(low, high), between(low, high), between(low, high)}; }
    glm::vec4 four(float low, float high) { return {inside(low, high), between(low, high)}; }
    glm::vec3 unit() {
        for (;;)
            if (const glm::vec3 v = inside(-1, 1); glm::length(v) > 0.1f && glm::length(v) <= 1)
                return glm::normalize(v);
    }
};

/// The largest accepted error of a twin. An error is the distance between the two results, relative to the larger of
/// the twin's length and `scale`.
struct Tolerance {
    double relative = 1e-5;  ///< a larger one has its reason beside it
    double scale = 1e-6;
};

using In = const GlslInput&;

/// A function and its twin.
struct Twin {
    std::string function, file, call;
    std::function<GlslInput(Dice&)> input;
    std::function<glm::dvec4(In)> twin;
    PlantedMistake mistake;
    Tolerance tolerance;
};

struct Twins {
    std::vector<Twin> all;
    std::string file;  ///< of the functions that are added next

    /// Adds the function that `call` begins with, or that stands first in its vector: "vec2(f(a), f(b))".
    void add(const std::string& call, const std::function<GlslInput(Dice&)>& input, const PlantedMistake& mistake,
             const Tolerance& tolerance, auto twin) {
        const size_t name = call.starts_with("vec") ? call.find('(') + 1 : 0;
        all.push_back({call.substr(name, call.find('(', name) - name), file, call, input,
                       [twin](In in) { return padded(twin(in)); }, mistake, tolerance});
    }
    void add(const std::string& call, const std::function<GlslInput(Dice&)>& input, const PlantedMistake& mistake,
             auto twin) {
        add(call, input, mistake, Tolerance(), twin);
    }
};

glm::dvec2 xy(const glm::vec4& v) { return {v.x, v.y}; }
glm::dvec2 zw(const glm::vec4& v) { return {v.z, v.w}; }
glm::dvec3 xyz(const glm::vec4& v) { return glm::dvec3(v); }

/// A base's normal, a normal of a map that leans by 3 to 75 degrees, and a light at least 3 degrees above the base:
/// near the ends the relative error of a cosine is unbounded. ReliefExact tests the ends.
GlslInput random_terminator(Dice& dice) {
    for (;;) {
        const glm::vec3 base = dice.unit(), mapped = dice.unit(), light = dice.unit();
        const float upright = glm::dot(base, mapped);
        if (upright > 0.26f && upright < 0.9986f && glm::dot(base, light) > 0.05f && glm::dot(mapped, light) > 0.05f)
            return {base, mapped, light, dice.unit()};
    }
}

/// See schuessler_light() in terminator.h.
double visible_share(const glm::dvec3& surface, const glm::dvec3& mapped, const glm::dvec3& way) {
    const glm::dvec3 lean = mapped - glm::dot(surface, mapped) * surface;
    const double area = std::max(glm::dot(mapped, way), 0.0) + std::max(glm::dot(-lean, way), 0.0);
    return std::min(glm::dot(surface, way) * glm::dot(surface, mapped) / area, 1.0);
}

void add_terminator(Twins& all) {
    all.file = "common/terminator.glsl";
    all.add("chiang_shadow(a.xyz, b.xyz, c.xyz)", random_terminator, {"g * (1.0 - g)", "g * (1.0 + g)"},
            [](In in) { return chiang_shadow(xyz(in[0]), xyz(in[1]), xyz(in[2])); });
    all.add(
        "visible_share(a.xyz, b.xyz, -normalize(b.xyz - dot(a.xyz, b.xyz) * a.xyz), "
        "length(b.xyz - dot(a.xyz, b.xyz) * a.xyz), c.xyz)",
        random_terminator, {"* dot(surface, mapped) / area", "/ area"},
        [](In in) { return visible_share(xyz(in[0]), xyz(in[1]), xyz(in[2])); });
    all.add("schuessler_light(a.xyz, b.xyz, c.xyz)", random_terminator, {"1.0 - visible_share", "visible_share"},
            [](In in) {
                const FacetLight light = schuessler_light(xyz(in[0]), xyz(in[1]), xyz(in[2]));
                return glm::dvec2(light.direct, light.mirrored);
            });
    // The tolerance: the power of a cosine, as in blinn_phong.
    all.add("blinn_phong_on_facets(vec3(0.5), 0.2, 8.0, a.xyz, b.xyz, c.xyz, d.xyz)", random_terminator,
            {"light.x + light.y", "light.x"}, {1e-4}, [](In in) {
                const glm::dvec3 mapped = xyz(in[1]), to_light = xyz(in[2]);
                const FacetLight light = schuessler_light(xyz(in[0]), mapped, to_light);
                const double visible = light.direct / glm::dot(mapped, to_light);
                return glm::dvec3(0.5 * light.sum()) +
                       visible * blinn_phong(glm::dvec3(0), 0.2, 8, mapped, to_light, xyz(in[3]));
            });
}

void add_light_and_color(Twins& all) {
    all.file = "common/light.glsl";
    const auto light = [](Dice& dice) {
        // Within 60 degrees of the normal: at a right angle the relative error of the cosine is unbounded.
        const glm::vec3 n = dice.unit();
        const auto near = [&] { return glm::normalize(n + 0.8f * dice.unit()); };
        return GlslInput{dice.four(0, 1), glm::vec4(n, std::pow(2.0f, dice.between(0, 8))), near(), near()};
    };
    // The tolerance: a power of 256 multiplies the relative error of its base by 256, and llvmpipe's pow itself is only
    // accurate to about 1e-5.
    all.add("blinn_phong(a.xyz, a.w, b.w, b.xyz, c.xyz, d.xyz)", light, {"albedo + specular", "albedo - specular"},
            {1e-4},
            [](In in) { return blinn_phong(xyz(in[0]), in[0].w, in[1].w, xyz(in[1]), xyz(in[2]), xyz(in[3])); });
    all.file = "common/srgb.glsl";
    const auto color = [](Dice& dice) {
        return GlslInput{glm::vec2(std::abs(dice.any_size(-5, 0)), dice.between(0, 1))};
    };
    all.add("srgb_from_linear(a.xyz)", color, {"- 0.055;", "+ 0.055;"}, [](In in) {
        return glm::dvec3(srgb_from_linear(in[0].x), srgb_from_linear(in[0].y), srgb_from_linear(in[0].z));
    });
    all.file = "common/heat.glsl";
    all.add(
        "heat(a.x)", [](Dice& dice) { return GlslInput{dice.between(-0.2f, 1.2f)}; }, {"0.87, 0.32", "0.32, 0.87"},
        [](In in) { return heat_color(in[0].x); });
    all.add(
        "log_heat(a.x, -3.0, 1.0)", [](Dice& dice) { return GlslInput{std::abs(dice.any_size(-4, 2))}; },
        {"log2(10.0) - low", "log2(10.0) + low"},
        [](In in) { return heat_color((std::log10(double(in[0].x)) + 3) / 4); });
    all.file = "common/perpendicular.glsl";
    all.add(
        "any_perpendicular(a.xyz)", [](Dice& dice) { return GlslInput{dice.unit()}; },
        {"sign_ * unit.x * unit.y", "unit.x * unit.y"}, [](In in) { return any_perpendicular(xyz(in[0])); });
}

/// A cell, the t at which a ray leaves it, a slightly later position, and the direction. Positions stay farther from a
/// line than the rounding of next_cell().
GlslInput random_walk(Dice& dice) {
    const glm::vec2 cell = glm::floor(dice.two(-9, 9)), in_cell = dice.two(0.01f, 0.99f);
    const glm::vec2 skipped = glm::floor(dice.two(-3, 3));
    return {cell, dice.two(0, 1), cell + skipped + in_cell, dice.two(-1, 1)};
}

void add_cell_walks(Twins& all) {
    all.file = "common/cell_walk.glsl";
    all.add("vec4(way_of(d.xy), way_of(vec2(0.0)))", random_walk, {"vec2(-1.0), vec2(1.0)", "vec2(1.0), vec2(-1.0)"},
            [](In in) { return glm::dvec4(in[3].x < 0 ? -1 : 1, in[3].y < 0 ? -1 : 1, 1, 1); });
    all.add("octant_of(d.xy, way_of(d.xy))", random_walk, {"vec3(1.0, 2.0, 4.0)", "vec3(2.0, 1.0, 4.0)"}, [](In in) {
        const double octant = (in[3].x < 0 ? 1 : 0) + (in[3].y < 0 ? 2 : 0);
        return octant + (std::abs(in[3].y) > std::abs(in[3].x) ? 4 : 0);
    });
    all.add("start_along(b.xy, way_of(d.xy))", random_walk, {"1.0 - start, start", "start, 1.0 - start"}, [](In in) {
        const auto along = [&](int i) { return in[3][i] < 0 ? 1 - double(in[1][i]) : double(in[1][i]); };
        return glm::dvec2(along(0), along(1));
    });
    all.add("next_cell(a.xy, b.xy, c.xy)", random_walk, {"lessThanEqual(leaves", "greaterThanEqual(leaves"}, [](In in) {
        glm::dvec2 next;
        for (int i = 0; i < 2; ++i) {
            const double next_one = double(in[0][i]) + (in[1][i] <= in[1][1 - i] ? 1 : 0);
            next[i] = std::max(next_one, std::floor(double(in[2][i])));
        }
        return next;
    });
    // The tolerance: integers, up to tens of thousands.
    all.add("vec2(iterations_between(d.xy * 1000.0, b.x, b.x + b.y), iterations_between(d.xy * 1e6, 0.0, 1e3))",
            random_walk, {"+ abs(along.y)", "+ along.y"}, {1e-4}, [](In in) {
                const double way = 1000 * (std::abs(double(in[3].x)) + std::abs(double(in[3].y)));
                return glm::dvec2(way * double(in[1].y) + 4, 65004);
            });
}

HeightCell cell_of(const glm::vec4& gathered) { return {gathered.w, gathered.z, gathered.x, gathered.y}; }
Gap gap_of(const glm::vec4& v) { return {v.x, v.y, v.z}; }
/// Returns 0 for a gap that touches 0 without crossing it.
double clearance_of(const Gap& gap) { return std::abs(gap.middle * gap.middle - gap.begin * gap.end); }

void add_height_cells(Twins& all) {
    all.file = "common/height_cell.glsl";
    const auto cell = [](Dice& dice) { return GlslInput{dice.four(0, 1), dice.inside(0, 1), dice.inside(0, 1)}; };
    all.add("height_in_cell(a, b.xy)", cell, {"corners.wz, corners.xy", "corners.zw, corners.yx"},
            [](In in) { return height_in_cell(cell_of(in[0]), xy(in[1])); });
    // The scale of these two: a difference of heights is relative to the heights.
    all.add("slope_in_cell(a, b.xy)", cell,
            {"corners.x - corners.w, corners.y - corners.z", "corners.w - corners.x, corners.z - corners.y"},
            {.scale = 1}, [](In in) { return slope_in_cell(cell_of(in[0]), xy(in[1])); });
    all.add("gap_above_cell(a, b.xyz, c.xyz)", cell, {"from.z + to.z - mixed", "from.z + to.z + mixed"}, {.scale = 1},
            [](In in) {
                const Gap gap = gap_above_cell(cell_of(in[0]), xyz(in[1]), xyz(in[2]));
                return glm::dvec3(gap.begin, gap.middle, gap.end);
            });
    const auto clear = [](Dice& dice) {
        for (;;)  // not closer to contact than float precision
            if (const GlslInput in = dice.inside(-1, 1); clearance_of(gap_of(in[0])) > 1e-5) return in;
    };
    all.add("closes(a.xyz)", clear, {"gap.y < 0.0", "gap.y > 0.0"}, [](In in) { return closes(gap_of(in[0])); });
    const auto closing = [](Dice& dice) {
        for (;;)
            if (const GlslInput in = glm::vec3(dice.between(0, 1), dice.two(-1, 1));
                closes(gap_of(in[0])) && clearance_of(gap_of(in[0])) > 0.01)
                return in;
    };
    all.add("first_closing(a.xyz)", closing, {"gap.x - gap.y + root", "gap.x + gap.y + root"},
            [](In in) { return first_closing(gap_of(in[0])); });
}

void add_displacement(Twins& all) {
    all.file = "13_displacement/task.glsl";
    const auto base = [](Dice& dice) {
        return GlslInput{glm::vec4(1, 0.1f * dice.inside(-1, 1)),
                         0.1f * dice.inside(-1, 1),
                         dice.unit(),
                         glm::vec4(dice.inside(-1, 1), dice.between(0, 1)),
                         glm::vec4(dice.inside(-1, 1), dice.between(0, 0.2f)),
                         dice.two(-2, 2)};
    };
    all.add("displaced(a.xyz, 0.7 * c.xyz, d.w, e.w)", base,
            {"* (height - 1.0) * normalize(direction)", "* (1.0 - height) * normalize(direction)"}, [](In in) {
                const SurfacePoint point{
                    .position = xyz(in[0]), .normal = xyz(in[2]), .du = {}, .dv = {}, .normal_du = {}, .normal_dv = {}};
                return displace(point, {in[3].w, {}}, in[4].w).position;
            });
    all.add("displaced_normal(a.xyz, b.xyz + vec3(0.0, 1.0, 0.0), vec3(0.0, 0.0, 1.0), d.xyz, e.xyz, d.w, f.xy, e.w)",
            base, {"scale * slope.x * normal, dv", "scale * slope.y * normal, dv"}, [](In in) {
                const SurfacePoint point{.position = {},
                                         .normal = {0, 0, 1},
                                         .du = xyz(in[0]),
                                         .dv = xyz(in[1]) + glm::dvec3(0, 1, 0),
                                         .normal_du = xyz(in[3]),
                                         .normal_dv = xyz(in[4])};
                return displace(point, {in[3].w, xy(in[5])}, in[4].w).normal;
            });
}

void add_adaptive_displacement(Twins& all) {
    all.file = "14_adaptive_displacement/task.glsl";
    const auto edge = [](Dice& dice) {
        return GlslInput{dice.inside(-1, 1), dice.inside(-1, 1), dice.inside(2, 9),
                         glm::vec2(dice.between(300, 3000), dice.between(4, 64))};
    };
    const auto bounds = [](Dice& dice) {
        const float lowest = dice.between(0, 1);
        return GlslInput{glm::vec4(dice.inside(-1, 1), dice.between(0.1f, 1)),
                         glm::vec4(dice.unit(), dice.between(0, 0.5f)),
                         glm::vec3(lowest, dice.between(lowest, 1), dice.between(0, 1))};
    };
    all.add(
        "possible_level(a.x)", [](Dice& dice) { return GlslInput{dice.any_size(-3, 3)}; },
        {"return level > 1.0", "return level < 1.0"}, [](In in) { return possible_level(in[0].x); });
    const auto distances = [edge](Dice& dice) {
        GlslInput in = edge(dice);
        in[3].z = dice.between(0.1f, 10), in[3].w = in[3].z * dice.between(2, 10);
        in[4] = glm::vec4(dice.between(3, 6), dice.between(0, 3), 0, 0);
        return in;
    };
    all.add("level_by_distance(a.xyz, b.xyz, c.xyz, d.z, d.w, e.x, e.y)", distances,
            {"eye) - nearest", "eye) + nearest"}, [](In in) {
                return level_by_distance(xyz(in[0]), xyz(in[1]), xyz(in[2]), in[3].z, in[3].w, in[4].x, in[4].y);
            });
    all.add("level_by_size(a.xyz, b.xyz, c.xyz, d.x, d.y)", edge,
            {"pixels_per_radian / distance(0.5", "pixels_per_radian / distance(0.7"},
            [](In in) { return level_by_size(xyz(in[0]), xyz(in[1]), xyz(in[2]), in[3].x, in[3].y); });
    const auto scaled = [edge](Dice& dice) {
        GlslInput in = edge(dice);
        in[0].w = dice.between(0.01f, 2);
        return in;
    };
    all.add("tolerated(c.x, d.x, d.y, a.w)", scaled, {"(pixels_per_radian * scale)", "pixels_per_radian * scale"},
            [](In in) { return tolerated(in[2].x, in[3].x, in[3].y, in[0].w); });
    const auto falling = [](Dice& dice) {
        std::array<float, 7> errors;
        for (float& error : errors) error = dice.between(0.001f, 1);
        std::sort(errors.begin(), errors.end(), std::greater<>());
        return GlslInput{glm::vec4(errors[0], errors[1], errors[2], errors[3]),
                         glm::vec4(errors[4], errors[5], errors[6], dice.between(0, 1.2f))};
    };
    // The tolerance: a difference of two errors that may be 1000 times closer to each other than to 0.
    all.add("level_by_error(a, vec4(b.xyz, 0.0), b.w)", falling, {"float(octave - 1) + share", "float(octave) - share"},
            {1e-3}, [](In in) {
                return level_by_error({in[0].x, in[0].y, in[0].z, in[0].w, in[1].x, in[1].y, in[1].z}, in[1].w);
            });
    all.add("outer_levels_of_triangle(a.xyz)", edge, {"edges.yzx", "edges.xyz"},
            [](In in) { return outer_levels_of_triangle(xyz(in[0])); });
    all.add("outer_levels_of_quad(c)", edge, {"edges.wxyz", "edges.yzwx"},
            [](In in) { return outer_levels_of_quad(in[2]); });
    all.add("relief_bounds(a, b.xyz, b.w, c.x, c.y, c.z)", bounds, {"(highest - 1.0)", "(1.0 - highest)"},
            [](In in) { return relief_bounds(in[0], xyz(in[1]), in[1].w, in[2].x, in[2].y, in[2].z); });
    const auto planes_and_sphere = [](Dice& dice) {
        for (;;) {  // not closer to contact than float precision
            GlslInput in;
            for (int i = 0; i < 6; ++i) in[size_t(i)] = glm::vec4(dice.unit(), dice.between(-0.5f, 2));
            in[6] = glm::vec4(dice.inside(-1, 1), dice.between(0, 1));
            bool is_clear = true;
            for (size_t i = 0; i < 6; ++i)
                is_clear = is_clear && std::abs(glm::dot(in[i], {xyz(in[6]), 1}) + in[6].w) > 1e-4;
            if (is_clear) return in;
        }
    };
    all.add("is_outside(vec4[](a, b, c, d, e, f), g)", planes_and_sphere, {"< -sphere.w", "< sphere.w"},
            [](In in) { return is_outside(std::vector<glm::dvec4>(in.begin(), in.begin() + 6), in[6]); });
    const auto facing = [bounds](Dice& dice) {
        for (;;) {  // as above
            GlslInput in = bounds(dice);
            in[2].w = std::abs(dice.any_size(-2, 1)), in[3] = glm::vec4(dice.inside(-3, 3), 0);
            const auto faces = [&](double slope) { return faces_away(xyz(in[1]), in[2].w * slope, in[0], xyz(in[3])); };
            if (faces(0.999) == faces(1.001)) return in;
        }
    };
    all.add("faces_away(b.xyz, c.w, a, d.xyz)", facing, {"atan(slope) + asin", "atan(slope) - asin"},
            [](In in) { return faces_away(xyz(in[1]), in[2].w, in[0], xyz(in[3])); });
    const auto fading = [edge](Dice& dice) {
        GlslInput in = edge(dice);
        in[3].z = dice.between(0, 10), in[3].w = in[3].z + dice.between(1, 10);
        return in;
    };
    // The scale: a difference that may be nearly 0.
    all.add("remaining(c.x, d.z, d.w)", fading, {"(end - distance_)", "(distance_ - begin)"}, {.scale = 0.1},
            [](In in) { return remaining(in[2].x, in[3].z, in[3].w); });
}

void add_budgets(Twins& all) {
    all.file = "17_time_and_error/task.glsl";
    const auto clip = [](Dice& dice) {
        return GlslInput{glm::vec4(dice.inside(-3, 3), dice.between(0.5f, 100)), dice.four(-1, 1), dice.two(64, 2000)};
    };
    all.add("pixels_per_metre(a, b, c.xy)", clip, {"along.xy - ndc", "along.xy + ndc"},
            [](In in) { return pixels_per_metre(in[0], in[1], xy(in[2])); });
    const auto pixels = [](Dice& dice) {
        return GlslInput{dice.any_size(-2, 2), dice.any_size(-1, 4), dice.any_size(-3, 0)};
    };
    all.add("tolerated(a.x, b.x, c.x)", pixels, {"budget / pixels", "budget * pixels"},
            [](In in) { return tolerated(in[0].x, in[1].x, in[2].x); });
    const auto heights = [](Dice& dice) {
        return GlslInput{dice.between(0, 0.5f), dice.between(0.5f, 1), dice.between(0, 0.6f)};
    };
    all.add("thinned(a.x, b.x, c.x)", heights, {"highest - max_error", "highest + max_error"},
            [](In in) { return thinned(in[0].x, in[1].x, in[2].x); });
    const auto rising = [](Dice& dice) {
        GlslInput in;
        float sum = 0;
        for (int i = 0; i < 8; ++i) in[size_t(i / 4)][i % 4] = sum += dice.between(0.02f, 0.1f);
        in[2].x = dice.between(0, 1);
        return in;
    };
    all.add("coarsest_level(float[12](a.x, a.y, a.z, a.w, b.x, b.y, b.z, b.w, 9.0, 9.0, 9.0, 9.0), 8, c.x)", rising,
            {"errors[level + 1] - errors[level]", "errors[level + 1]"}, {.scale = 1},
            [](In in) { return coarsest_level(std::span(&in[0].x, 8), in[2].x); });
    const auto mean = [](Dice& dice) {
        return GlslInput{dice.unit() * dice.between(0.01f, 0.99f), dice.between(1, 100)};
    };
    // The tolerance: rounding of the length, amplified by a sharp highlight.
    all.add("spread_shininess(a.xyz, b.x)", mean, {"shininess * (1.0 - l)", "shininess * l"}, {1e-4},
            [](In in) { return in[1].x * toksvig_factor(glm::length(xyz(in[0])), in[1].x); });
    const auto levels = [](Dice& dice) {
        const float flat = dice.between(2, 10);
        return GlslInput{flat + dice.between(-3, 1), flat, dice.between(0.25f, 4)};
    };
    // The scale: a difference that may be nearly 0.
    all.add("bumps_left(a.x, b.x, c.x)", levels, {"- log2(budget)", "+ log2(budget)"}, {.scale = 0.1},
            [](In in) { return bumps_left(in[0].x, in[1].x, in[2].x); });
}

void add_patches(Twins& all) {
    all.file = "common/patch.glsl";
    // On each edge, at each corner, and inside.
    const auto place = [](Dice& dice) {
        const float x = std::array{0.0f, 1.0f, dice.between(0, 1)}[dice.random() % 3];
        const float y = std::array{0.0f, 1.0f, dice.between(0, 1)}[dice.random() % 3];
        glm::vec3 weights = dice.inside(0.1f, 1);
        if (dice.random() % 2) weights[int(dice.random() % 3)] = 0;
        return GlslInput{glm::vec2(x, y), weights, dice.four(-1, 1), dice.four(-1, 1)};
    };
    const auto five = [](Dice& dice) {
        return GlslInput{dice.four(0, 1), dice.four(0, 1), dice.four(0, 1), dice.four(0, 1), dice.four(0, 1)};
    };
    const auto directions = [](Dice& dice) {
        return GlslInput{dice.between(0.5f, 2) * dice.unit(), dice.inside(-1, 1), dice.four(-0.5f, 0.5f)};
    };
    all.add("quad_weights(a.xy)", place, {"place.x * place.y, rest.x", "place.x * rest.y, rest.x"},
            [](In in) { return quad_weights(xy(in[0])); });
    all.add("blend(a, b, c, d, e)", five, {"weights.z * c", "weights.w * c"}, [](In in) {
        return blend(glm::dvec4(in[0]), glm::dvec4(in[1]), glm::dvec4(in[2]), glm::dvec4(in[3]), glm::dvec4(in[4]));
    });
    all.add("edge_of_triangle(b.xyz)", place, {"weights.x == 0.0 ? 1", "weights.x == 0.0 ? 2"},
            [](In in) { return edge_of_triangle(xyz(in[1])); });
    all.add("edge_of_quad(a.xy)", place, {"place.y == 1.0 ? 2", "place.y == 0.5 ? 2"},
            [](In in) { return edge_of_quad(xy(in[0])); });
    all.add("uv_on_edge(a.x, 1.0 - a.x, c, d.xy, d.zw)", place, {"there == 1.0 ? uv_there", "there == 1.0 ? uv_here"},
            [](In in) { return uv_on_edge(in[0].x, 1 - in[0].x, glm::dvec4(in[2]), xy(in[3]), zw(in[3])); });
    const auto gradients = [](In in) {
        return by_uv(xyz(in[0]), xyz(in[1]), xy(in[2]) + glm::dvec2(2, 0), zw(in[2]) + glm::dvec2(0, 2));
    };
    all.add("by_uv(a.xyz, b.xyz, c.xy + vec2(2.0, 0.0), c.zw + vec2(0.0, 2.0))[0]", directions,
            {"uv_y.y * along_x", "uv_x.x * along_x"}, [gradients](In in) { return gradients(in)[0]; });
    all.add("by_uv(a.xyz, b.xyz, c.xy + vec2(2.0, 0.0), c.zw + vec2(0.0, 2.0))[1]", directions,
            {"uv_y.x * along_x", "uv_x.y * along_x"}, [gradients](In in) { return gradients(in)[1]; });
    all.add("turn_of_unit(a.xyz, b.xyz)", directions, {"change - vector", "change + vector"},
            [](In in) { return turn_of_unit(xyz(in[0]), xyz(in[1])); });
}

Ray ray_of(In in) { return {xyz(in[0]), xyz(in[1])}; }

/// A ray and a triangle, with a hit or a miss by more than float rounding.
GlslInput random_ray_and_triangle(Dice& dice) {
    for (;;) {
        const GlslInput in{dice.inside(-1, 1), dice.inside(-2, 2), dice.inside(-1, 1), dice.inside(-1, 1),
                           dice.inside(-1, 1)};
        const glm::dvec3 across = glm::cross(xyz(in[3]) - xyz(in[2]), xyz(in[4]) - xyz(in[2]));
        const double slant = glm::dot(across, xyz(in[1]));
        if (std::abs(slant) < 0.3) continue;
        const glm::dvec3 at = ray_of(in).at(glm::dot(across, xyz(in[2]) - xyz(in[0])) / slant);
        double least = 1;
        for (size_t i = 0; i < 3; ++i) {
            const glm::dvec3 from = xyz(in[2 + i]), to = xyz(in[2 + (i + 1) % 3]);
            least = std::min(least, std::abs(glm::dot(glm::cross(to - from, at - from), across)));
        }
        if (least > 1e-3) return in;
    }
}

void add_mesh_rays(Twins& all) {
    all.file = "common/mesh_rays.glsl";
    const auto direction = [](Dice& dice) {
        return GlslInput{glm::vec3(dice.any_size(-2, 2), dice.any_size(-2, 2), dice.any_size(-2, 2)),
                         dice.inside(-1, 1)};
    };
    all.add("in_ray_order(b.xyz, a.xyz)", direction, {"v.yzx", "v.zyx"}, [](In in) {
        const RayAxes axes = axes_of(xyz(in[0]));
        return glm::dvec3(in[1][axes.along[0]], in[1][axes.along[1]], in[1][axes.along[2]]);
    });
    all.add("ray_shear(a.xyz)", direction, {"d.x / d.z", "d.x * d.z"}, [](In in) { return axes_of(xyz(in[0])).shear; });
    const auto tiny = [](Dice& dice) {
        return GlslInput{glm::vec3(dice.any_size(-2, 2), dice.any_size(-25, -19), dice.random() % 2)};
    };
    all.add("inverse_direction(a.xyz)", tiny, {"vec3(1e18), vec3(-1e18)", "vec3(-1e18), vec3(1e18)"},
            [](In in) { return inverse_direction(xyz(in[0])); });
    const auto box = [](Dice& dice) {
        const auto grid = [&] { return glm::round(dice.inside(-8, 8)) / 4.0f; };
        // Boxes on a grid; origins and directions off the grid by more than any rounding.
        return GlslInput{grid() + 0.1f, grid() + glm::vec3(0.03f, 0.07f, 0.013f), grid(), grid()};
    };
    all.add("meets_box(a.xyz, inverse_direction(b.xyz), 1.0, min(c.xyz, d.xyz), max(c.xyz, d.xyz))", box,
            {"max(near.z, 0.0)", "near.z"}, [](In in) {
                return meets_box(xyz(in[0]), inverse_direction(xyz(in[1])), 1, glm::min(xyz(in[2]), xyz(in[3])),
                                 glm::max(xyz(in[2]), xyz(in[3])));
            });
    // The tolerance: t is the quotient of lengths up to 4 by a slant of at least 0.3.
    all.add("triangle_hit(a.xyz, b.xyz, ray_shear(b.xyz), c.xyz, d.xyz, e.xyz)", random_ray_and_triangle,
            {"(any_below && any_above)", "any_above"}, {2e-4, 1}, [](In in) {
                const Ray ray = ray_of(in);
                return triangle_hit(ray, axes_of(ray.direction), xyz(in[2]), xyz(in[3]), xyz(in[4]));
            });
}

/// Gaussian slopes within a pixel, an eye for which the facets that face away are at most one in a thousand, and a
/// light. The inputs are: mean of the slopes; their variance along u, along v, covariance, and alpha²; to the eye; to
/// the light.
GlslInput random_slopes(Dice& dice) {
    for (;;) {
        const float u = dice.between(0.1f, 0.4f), v = dice.between(0.1f, 0.4f), wide = std::max(u, v);
        const glm::vec4 variance(u * u, v * v, u * v * dice.between(-0.7f, 0.7f), wide * wide * dice.between(1, 3));
        const GlslInput in = {dice.two(-0.5f, 0.5f), variance, dice.unit(), dice.unit()};
        const glm::vec2 flat(in[2]);
        const bool is_seen = in[2].z - glm::dot(flat, glm::vec2(in[0])) > 3.2f * wide * glm::length(flat);
        if (glm::length(flat) > 0.05f && is_seen && in[2].z > 0.1f && in[3].z > 0.1f) return in;
    }
}

/// Returns the mean over random_slopes() of `value`, by the area that a facet of each slope has on the picture:
/// max(e.z - s.x e.x - s.y e.y, 0) for the direction e to the eye.
glm::dvec2 mean_over_facets(In in, const std::function<glm::dvec2(glm::dvec2 slope)>& value) {
    const double u = std::sqrt(double(in[1].x)), lean = double(in[1].z) / u,
                 v = std::sqrt(double(in[1].y) - lean * lean);
    const glm::dvec3 to_eye = xyz(in[2]);
    double areas = 0;
    glm::dvec2 sum(0);
    constexpr int side = 10;  // with 4.5 deviations each way, such sums of Gaussians are off by 1e-5
    for (int i = -side; i <= side; ++i)
        for (int j = -side; j <= side; ++j) {
            const glm::dvec2 place = 4.5 / side * glm::dvec2(i, j);
            const glm::dvec2 slope = xy(in[0]) + glm::dvec2(u * place.x, lean * place.x + v * place.y);
            const double area =
                std::exp(-glm::dot(place, place) / 2) * std::max(to_eye.z - glm::dot(slope, glm::dvec2(to_eye)), 0.0);
            areas += area, sum += area * value(slope);
        }
    return sum / areas;
}

void add_slopes_of_pixels(Twins& all) {
    all.file = "common/slope_moments.glsl";
    const auto two = [](Dice& dice) { return GlslInput{dice.inside(-1, 1), dice.inside(-1, 1)}; };
    all.add("variance_of_slopes(0.5 * (a.xy + b.xy), 0.5 * vec3(a.xy * a.xy + b.xy * b.xy, a.x * a.y + b.x * b.y))",
            two, {"squares.z - mean.x * mean.y", "squares.z"}, {.scale = 0.1}, [](In in) {
                const glm::dvec2 half =
                    0.5 * (xy(in[0]) - xy(in[1]));  // of two slopes: the product of half of their difference
                return glm::dvec3(half * half, half.x * half.y);
            });
    all.add("covariance_matrix(a.xyz) * b.xy", two, {"variance.z, variance.y)", "variance.y, variance.z)"},
            {.scale = 0.1}, [](In in) {
                const glm::dvec3 of = xyz(in[0]), by = xyz(in[1]);
                return glm::dvec2(of.x * by.x + of.z * by.y, of.z * by.x + of.y * by.y);
            });
    all.file = "14_adaptive_displacement/leadr.glsl";
    // The tolerance: the distribution function of a Gaussian.
    all.add("seen_slope(Slopes(a.xy, b.xyz), c.xyz)", random_slopes,
            {"slopes.mean - covariance_matrix", "slopes.mean + covariance_matrix"}, {5e-4, 0.1},
            [](In in) { return mean_over_facets(in, [](glm::dvec2 slope) { return slope; }); });
    // The tolerance: highlight() counts facets that face away, at most one in a thousand, as negative areas.
    all.add("highlight(Slopes(a.xy, b.xyz), b.w, c.xyz, d.xyz)", random_slopes, {"mat2(0.5 * alpha2)", "mat2(alpha2)"},
            {2e-3, 0.1}, [](In in) {
                const glm::dvec3 halfway = xyz(in[2]) + xyz(in[3]);
                const auto lobe = [&](glm::dvec2 slope) {
                    const glm::dvec2 off = slope + glm::dvec2(halfway) / halfway.z;
                    return glm::dvec2(std::exp(-glm::dot(off, off) / double(in[1].w)));
                };
                return mean_over_facets(in, lobe).x;
            });
}

std::vector<Twin> all_twins() {
    Twins twins;
    for (const auto add : {add_terminator, add_light_and_color, add_cell_walks, add_height_cells, add_displacement,
                           add_adaptive_displacement, add_budgets, add_patches, add_mesh_rays, add_slopes_of_pixels})
        add(twins);
    return twins.all;
}

constexpr unsigned twins_seed = 11;

std::vector<GlslInput> inputs_of(const Twin& twin) {
    Dice dice{std::mt19937(twins_seed)};
    std::vector<GlslInput> inputs(4000);
    for (GlslInput& input : inputs) input = twin.input(dice);
    return inputs;
}

/// Returns the maximum error over all inputs; infinity if a result is NaN.
double largest_error(const Twin& twin, const PlantedMistake& mistake) {
    const std::vector<GlslInput> inputs = inputs_of(twin);
    const std::vector<glm::vec4> results = evaluate_glsl(twin.file, twin.call, inputs, mistake);
    double largest = 0;
    for (size_t i = 0; i < inputs.size(); ++i) {
        const glm::dvec4 truth = twin.twin(inputs[i]);
        const double error =
            glm::length(glm::dvec4(results[i]) - truth) / std::max(glm::length(truth), twin.tolerance.scale);
        largest = std::max(largest, std::isnan(error) ? INFINITY : error);
    }
    return largest;
}

TEST(ShaderFunction, AgreesWithItsTwin) {
    for (const Twin& twin : all_twins())
        EXPECT_LE(largest_error(twin, {}), twin.tolerance.relative) << twin.call << ", seed " << twins_seed;
}

TEST(ShaderFunction, DisagreesWithItsTwinAfterAPlantedMistake) {
    for (const Twin& twin : all_twins())
        EXPECT_GT(largest_error(twin, twin.mistake), 100 * twin.tolerance.relative)
            << twin.call << ", seed " << twins_seed;
}

TEST(ShaderFunction, HasATwinForEveryDefinition) {
    std::set<std::string> tested = {"cell_corners", "exact_hit"};  // tested below, because they sample textures
    for (const Twin& twin : all_twins())
        if (twin.file.starts_with("common/")) tested.insert(twin.function);
    const std::regex definition("(^|\n)(float|bool|int|vec[234]|mat[234]) ([a-z_0-9]+)\\(");
    size_t found = 0;
    for (const auto& file : std::filesystem::directory_iterator(course_root() / "shaders/common")) {
        if (file.path().filename() == "unfinished.glsl") continue;  // placeholders for students, no mathematics
        const std::string text = read_file(file.path());
        for (auto match = std::sregex_iterator(text.begin(), text.end(), definition); match != std::sregex_iterator();
             ++match, ++found)
            EXPECT_TRUE(tested.contains((*match)[3])) << (*match)[3] << " in " << file.path();
    }
    EXPECT_GE(found, tested.size());
}

// Rays at a vertex, at points on the edges around it, and at their rounded positions.
TEST(ShaderFunction, RaysAtAFansVertexAndEdgesHitATriangle) {
    Dice dice{std::mt19937(twins_seed)};
    std::vector<GlslInput> inputs(20000);
    for (GlslInput& in : inputs) {
        const float size = std::pow(10.0f, float(int(dice.random() % 7)) * 2 - 6);
        const glm::vec3 origin = size * dice.inside(-1, 1), axis = dice.unit();
        const glm::vec3 middle = origin + size * dice.between(0.5f, 3) * axis;
        const glm::vec3 x = any_perpendicular(axis), y = glm::cross(axis, x);
        glm::vec3 ring[4];
        for (int i = 0; i < 4; ++i) {
            const float turn = float(i) * 1.5708f + dice.between(-0.5f, 0.5f);
            ring[i] = middle + 0.3f * size * (std::cos(turn) * x + std::sin(turn) * y + dice.between(-1, 1) * axis);
        }
        const glm::vec3 target =
            dice.random() % 2 ? middle : glm::mix(middle, ring[dice.random() % 4], dice.between(0, 0.9f));
        in = {origin, target - origin, middle, ring[0], ring[1], ring[2], ring[3]};
    }
    std::string sum;
    for (const char* pair : {"d.xyz, e.xyz", "e.xyz, f.xyz", "f.xyz, g.xyz", "g.xyz, d.xyz"})
        sum += (sum.empty() ? "" : " + ") +
               fmt::format("abs(triangle_hit(a.xyz, b.xyz, ray_shear(b.xyz), c.xyz, {}))", pair);
    const auto lost = [&](const PlantedMistake& mistake) {
        const auto hits = evaluate_glsl("common/mesh_rays.glsl", sum, inputs, mistake);
        return std::count_if(hits.begin(), hits.end(), [](const glm::vec4& hit) { return !(hit.w >= 1); });
    };
    EXPECT_EQ(lost({}), 0);
    EXPECT_GT(lost({"r.xy = r.xy - shear.xy", "r.xy = r.xy - 1.000001 * shear.xy"}), 100)
        << "a corner that is not where the neighbour has it";
}

TEST(ShaderFunction, CellCornersReturnTheTexelsOfAnyCell) {
    const int columns = 8, rows = 4;
    Image image(columns, rows, 1);
    Dice dice{std::mt19937(twins_seed)};
    for (float& value : image.values) value = dice.between(0, 1);
    const Texture map("heights", [&] { return image; });
    std::vector<GlslInput> inputs;
    for (int row = -1; row < rows; ++row)
        for (int column = -1; column < columns; ++column) inputs.push_back({glm::vec2(column, row)});
    const auto corners = evaluate_glsl("common/height_cell.glsl", "cell_corners(s_map, ivec2(a.xy))", inputs, {}, &map);
    const auto texel = [&](float column, float row) {
        return *image.pixel((int(column) + columns) % columns, rows - 1 - (int(row) + rows) % rows);
    };
    for (size_t i = 0; i < inputs.size(); ++i) {
        const float x = inputs[i][0].x, y = inputs[i][0].y;
        EXPECT_EQ(corners[i], glm::vec4(texel(x, y + 1), texel(x + 1, y + 1), texel(x + 1, y), texel(x, y)))
            << "cell " << x << ", " << y;
    }
}

/// exact_hit() over a map with its windows, and its twin. The inputs of a ray: its start and its way to the ground, in
/// tiles, and the shares of that way at which it begins and ends.
class ExactHits {
public:
    ExactHits(HeightMap kind, int side)
        : image_(make_height_map(kind, side)), windows_(height_windows(image_)), field_(image_, true) {}

    std::vector<glm::vec4> found(const std::vector<GlslInput>& rays, const PlantedMistake& mistake = {}) const {
        const glm::mat4 extents = windows_.extents();
        std::string columns;
        for (int i = 0; i < 16; ++i) columns += fmt::format("{}{:.1f}", i ? ", " : "", extents[i / 4][i % 4]);
        const std::string call = fmt::format("exact_hit(s_map, s_other, mat4({}), a.xy, a.zw, b.xy)", columns);
        return evaluate_glsl("common/exact_hit.glsl", call, rays, mistake, &map_, &clearance_);
    }
    /// Returns the number of rays that differ from the twin by more than `t`, as a share of the way to the ground, or
    /// by more than `texels`.
    size_t off(const std::vector<GlslInput>& rays, double t, double texels) const {
        const std::vector<glm::vec4> hits = found(rays);
        size_t count = 0;
        for (size_t i = 0; i < rays.size(); ++i) {
            const glm::dvec4 ray = glm::dvec4(rays[i][0]) * double(image_.width);
            const double begin = double(rays[i][1].x), end = double(rays[i][1].y);
            const glm::dvec3 along(ray.z, ray.w, -1);
            const auto hit = field_.first_hit({glm::dvec3(ray.x, ray.y, 1) + begin * along, along}, end - begin);
            const double error = std::abs(double(hits[i].x) - (hit ? begin + hit->t : end));
            count += error > t || error * glm::length(along) > texels;
        }
        return count;
    }

private:
    Image image_;
    HeightWindows windows_;
    HeightField field_;
    Texture map_{"heights", [this] { return image_; }};
    Texture clearance_{"windows", [this] { return windows_.clearance; }, {.mips = false, .layers = 8}};
};

TEST(ShaderFunction, ExactHitEqualsTheHeightFieldHit) {
    Dice dice{std::mt19937(twins_seed)};
    std::vector<GlslInput> rays;
    for (int i = 0; i < 4000; ++i) {
        const float reach = i % 50 == 0 ? 0 : dice.between(0, 2), turn = dice.between(0, 6.3f);
        const float begin = i % 2 == 0 ? 0 : dice.between(0, 0.6f), end = i % 2 == 0 ? 1 : dice.between(begin, 1);
        rays.push_back(
            {glm::vec4(dice.two(-2, 2), reach * std::cos(turn), reach * std::sin(turn)), glm::vec2(begin, end)});
    }
    const ExactHits stones(HeightMap::stones, 64);
    EXPECT_LE(stones.off(rays, 1e-4, INFINITY), 4u) << "of 4000 a few graze an edge";
    EXPECT_NE(stones.found(rays, {"next_cell(passed, leaves, ahead + t", "next_cell(passed + 1.0, leaves, ahead + t"}),
              stones.found(rays));
}

/// One kind of rays, in tiles, for exact_hit() and its twin.
struct FarRays {
    float start, reach;  ///< maximum distance of the start from the origin, and length to the ground
    double off;          ///< tolerance in texels
};

TEST(ShaderFunction, ExactHitEqualsTheHeightFieldHitForAnyRayStartAndLength) {
    for (const HeightMap kind : {HeightMap::posts, HeightMap::stones}) {
        const ExactHits hits(kind, 256);
        // A float resolves 6e-8 of its value: at the end of 250 tiles (64,000 texels) that is 0.004 texels.
        for (const FarRays& far : {FarRays{1, 8, 0.01}, FarRays{512, 30, 0.02}, FarRays{4, 250, 0.1}}) {
            Dice dice{std::mt19937(twins_seed)};
            std::vector<GlslInput> rays;
            for (int i = 0; i < 2000; ++i) {
                const float turn = float(i % 4) * 1.5707964f + dice.between(0, 0.2f) * dice.between(0, 1);
                const glm::vec2 along = dice.between(0.9f, 1) * far.reach * glm::vec2(std::cos(turn), std::sin(turn));
                rays.push_back({glm::vec4(dice.two(-far.start, far.start), along), glm::vec2(0, 1)});
            }
            EXPECT_LE(hits.off(rays, INFINITY, far.off), rays.size() / 200)
                << int(kind) << ", " << far.reach << ": a few graze an edge";
        }
    }
}

TEST(ShaderFunction, ATexelWithoutANormalOrAFrameIsBakedFlat) {
    const std::vector<GlslInput> inputs = {{0, glm::vec3(0.6f, 0, 0.8f)}};
    const auto value = [&](const char* unit) {
        const std::string call = fmt::format("finite_or({}, vec3(0.0, 0.0, 1.0))", unit);
        return evaluate_glsl("07_baking/frames.glsl", call, inputs)[0];
    };
    EXPECT_EQ(value("normalize(a.xyz)"), glm::vec4(0, 0, 1, 0));
    EXPECT_EQ(value("normalize(b.xyz / a.x)"), glm::vec4(0, 0, 1, 0));
    EXPECT_EQ(value("b.xyz"), inputs[0][1]);
}

TEST(ShaderFunction, MatchesItsTwinForDegenerateInputs) {
    const std::vector<GlslInput> zero(1);
    const auto value = [&](const char* file, const char* expression) {
        return evaluate_glsl(file, expression, zero)[0];
    };
    EXPECT_EQ(value("13_displacement/task.glsl",
                    "displaced_normal(a.xyz, a.xyz, vec3(0.0, 0.0, 1.0), a.xyz, a.xyz, 0.5, a.xy, 1.0)"),
              glm::vec4(0, 0, 1, 0));
    EXPECT_EQ(value("common/height_cell.glsl", "vec2(first_closing(vec3(1.0, 1.0, -1e30)), closes(vec3(1.0)))").y, 0);
    EXPECT_EQ(value("common/height_cell.glsl", "first_closing(a.xyz)").x, 0);
    EXPECT_EQ(value("14_adaptive_displacement/task.glsl", "level_by_size(a.xyz, a.xyz, a.xyz, 1000.0, 8.0)").x, 1)
        << "0 / 0";
}

}  // namespace
}  // namespace relief
