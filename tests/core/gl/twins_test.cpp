// Compares every function of shaders/common and shaders/staff with its twin in double precision, over thousands of
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
#include "framework/staff/reference/normal_map.h"
#include "framework/staff/reference/patch_points.h"
#include "framework/staff/reference/shading.h"
#include "framework/staff/reference/tangent_space.h"
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
    glm::vec3 inside(float low, float high) { return {between(low, high), between(low, high), between(low, high)}; }
    glm::vec3 unit() {
        for (;;)
            if (const glm::vec3 v = inside(-1, 1); glm::length(v) > 0.1f && glm::length(v) <= 1)
                return glm::normalize(v);
    }
};

/// A function and its twin. The error is the distance between the two results, relative to the larger of the
/// twin's length and `scale`.
struct Twin {
    std::string function, file, expression;
    std::function<GlslInput(Dice&)> input;
    std::function<glm::dvec4(const GlslInput&)> twin;
    PlantedMistake mistake;
    double tolerance = 1e-5;  ///< a larger one has its reason beside it
    double scale = 1e-6;
};

glm::dvec3 xyz(const glm::vec4& v) { return glm::dvec3(v); }
glm::dvec4 scalar(double value) { return {value, 0, 0, 0}; }
HeightCell cell_of(const glm::vec4& gathered) { return {gathered.w, gathered.z, gathered.x, gathered.y}; }

GlslInput random_cell(Dice& dice) {
    return {glm::vec4(dice.inside(0, 1), dice.between(0, 1)), glm::vec4(dice.inside(0, 1), 0),
            glm::vec4(dice.inside(0, 1), 0)};
}

/// A normal and a tangent that are not nearly parallel, with any length, as after interpolation.
GlslInput random_frame(Dice& dice) {
    for (;;) {
        const glm::vec3 normal = dice.between(0.3f, 1) * dice.unit(), tangent = dice.between(0.3f, 1) * dice.unit();
        if (std::abs(glm::dot(glm::normalize(normal), glm::normalize(tangent))) < 0.9f)
            return {glm::vec4(dice.unit(), 0), glm::vec4(normal, 0), glm::vec4(tangent, dice.random() % 2 ? 1 : -1)};
    }
}

glm::dvec4 column_of_cotangent_frame(const GlslInput& in, int column) {
    return {cotangent_frame(xyz(in[0]), xyz(in[1]), xyz(in[2]), {in[3].x, in[3].y}, {in[3].z, in[3].w})[column], 0};
}
GlslInput random_differences(Dice& dice) {
    for (;;) {
        const glm::vec3 n = dice.unit(), p = dice.inside(-1, 1), q = dice.inside(-1, 1);
        const glm::vec2 u(dice.between(-1, 1), dice.between(-1, 1)), v(dice.between(-1, 1), dice.between(-1, 1));
        // Neighbours that see the surface neither edge-on nor with nearly constant uv.
        if (std::abs(glm::dot(n, glm::cross(p, q))) > 0.1f && std::abs(u.x * v.y - u.y * v.x) > 0.1f)
            return {glm::vec4(n, 0), glm::vec4(p, 0), glm::vec4(q, 0), glm::vec4(u, v)};
    }
}

/// A base's normal, a normal of a map that leans by 3 to 75 degrees, and a light at least 3 degrees above the base:
/// near the ends the relative error of a cosine is unbounded. ReliefExact tests the ends.
GlslInput random_terminator(Dice& dice) {
    for (;;) {
        const glm::vec3 base = dice.unit(), mapped = dice.unit(), light = dice.unit();
        const float upright = glm::dot(base, mapped);
        if (upright > 0.26f && upright < 0.9986f && glm::dot(base, light) > 0.05f && glm::dot(mapped, light) > 0.05f)
            return {glm::vec4(base, 0), glm::vec4(mapped, 0), glm::vec4(light, 0), glm::vec4(dice.unit(), 0)};
    }
}

/// See schuessler_light() in terminator.h.
double visible_share(const glm::dvec3& surface, const glm::dvec3& mapped, const glm::dvec3& way) {
    const glm::dvec3 lean = mapped - glm::dot(surface, mapped) * surface;
    const double area = std::max(glm::dot(mapped, way), 0.0) + std::max(glm::dot(-lean, way), 0.0);
    return std::min(glm::dot(surface, way) * glm::dot(surface, mapped) / area, 1.0);
}

std::vector<Twin> terminator() {
    const char* const file = "common/terminator.glsl";
    return {{"chiang_shadow",
             file,
             "vec4(chiang_shadow(a.xyz, b.xyz, c.xyz), 0.0, 0.0, 0.0)",
             random_terminator,
             [](const GlslInput& in) { return scalar(chiang_shadow(xyz(in[0]), xyz(in[1]), xyz(in[2]))); },
             {"g * (1.0 - g)", "g * (1.0 + g)"}},
            {"visible_share",
             file,
             "vec4(visible_share(a.xyz, b.xyz, -normalize(b.xyz - dot(a.xyz, b.xyz) * a.xyz), "
             "length(b.xyz - dot(a.xyz, b.xyz) * a.xyz), c.xyz), 0.0, 0.0, 0.0)",
             random_terminator,
             [](const GlslInput& in) { return scalar(visible_share(xyz(in[0]), xyz(in[1]), xyz(in[2]))); },
             {"* dot(surface, mapped) / area", "/ area"}},
            {"schuessler_light",
             file,
             "vec4(schuessler_light(a.xyz, b.xyz, c.xyz), 0.0, 0.0)",
             random_terminator,
             [](const GlslInput& in) {
                 const FacetLight light = schuessler_light(xyz(in[0]), xyz(in[1]), xyz(in[2]));
                 return glm::dvec4(light.direct, light.mirrored, 0, 0);
             },
             {"1.0 - visible_share", "visible_share"}},
            {"blinn_phong_on_facets",
             file,
             "vec4(blinn_phong_on_facets(vec3(0.5), 0.2, 8.0, a.xyz, b.xyz, c.xyz, d.xyz), 0.0)",
             random_terminator,
             [](const GlslInput& in) {
                 const glm::dvec3 mapped = xyz(in[1]), to_light = xyz(in[2]);
                 const FacetLight light = schuessler_light(xyz(in[0]), mapped, to_light);
                 const double visible = light.direct / glm::dot(mapped, to_light);
                 return glm::dvec4(glm::dvec3(0.5 * light.sum()) +
                                       visible * blinn_phong(glm::dvec3(0), 0.2, 8, mapped, to_light, xyz(in[3])),
                                   0);
             },
             {"light.x + light.y", "light.x"},
             1e-4}};  // the power of a cosine, as in blinn_phong
}

std::vector<Twin> light_and_color() {
    return {
        {"blinn_phong",
         "common/light.glsl",
         "vec4(blinn_phong(a.xyz, a.w, b.w, b.xyz, c.xyz, d.xyz), 0.0)",
         [](Dice& dice) {
             // Within 60 degrees of the normal: at a right angle the relative error of the cosine is unbounded.
             const glm::vec3 n = dice.unit();
             const auto near = [&] { return glm::normalize(n + 0.8f * dice.unit()); };
             return GlslInput{glm::vec4(dice.inside(0, 1), dice.between(0, 1)),
                              glm::vec4(n, std::pow(2.0f, dice.between(0, 8))), glm::vec4(near(), 0),
                              glm::vec4(near(), 0)};
         },
         [](const GlslInput& in) {
             return glm::dvec4(blinn_phong(xyz(in[0]), in[0].w, in[1].w, xyz(in[1]), xyz(in[2]), xyz(in[3])), 0);
         },
         {"albedo + specular", "albedo - specular"},
         // A power of 256 multiplies the relative error of its base by 256, and llvmpipe's pow itself is only accurate
         // to about 1e-5.
         1e-4},
        {"srgb_from_linear",
         "common/srgb.glsl",
         "vec4(srgb_from_linear(a.xyz), 0.0)",
         [](Dice& dice) { return GlslInput{glm::vec4(std::abs(dice.any_size(-5, 0)), dice.between(0, 1), 0, 0)}; },
         [](const GlslInput& in) {
             return glm::dvec4(srgb_from_linear(in[0].x), srgb_from_linear(in[0].y), srgb_from_linear(in[0].z), 0);
         },
         {"- 0.055;", "+ 0.055;"}},
        {"heat",
         "common/heat.glsl",
         "vec4(heat(a.x), 0.0)",
         [](Dice& dice) { return GlslInput{glm::vec4(dice.between(-0.2f, 1.2f), 0, 0, 0)}; },
         [](const GlslInput& in) { return glm::dvec4(heat_color(in[0].x), 0); },
         {"0.87, 0.32", "0.32, 0.87"}},
        {"log_heat",
         "common/heat.glsl",
         "vec4(log_heat(a.x, -3.0, 1.0), 0.0)",
         [](Dice& dice) { return GlslInput{glm::vec4(std::abs(dice.any_size(-4, 2)), 0, 0, 0)}; },
         [](const GlslInput& in) { return glm::dvec4(heat_color((std::log10(double(in[0].x)) + 3) / 4), 0); },
         {"log2(10.0) - low", "log2(10.0) + low"}},
    };
}

std::vector<Twin> normals_and_frames() {
    const auto stored = [](Dice& dice) { return GlslInput{glm::vec4(dice.inside(0, 1), 0)}; };
    const auto pair = [](Dice& dice) { return GlslInput{glm::vec4(dice.between(-1, 1), dice.between(-1, 1), 0, 0)}; };
    return {
        {"any_perpendicular",
         "common/perpendicular.glsl",
         "vec4(any_perpendicular(a.xyz), 0.0)",
         [](Dice& dice) { return GlslInput{glm::vec4(dice.unit(), 0)}; },
         [](const GlslInput& in) { return glm::dvec4(any_perpendicular(xyz(in[0])), 0); },
         {"sign_ * unit.x * unit.y", "unit.x * unit.y"}},
        {"decode_normal",
         "staff/normal_map.glsl",
         "vec4(decode_normal(a.xyz), 0.0)",
         stored,
         [](const GlslInput& in) { return glm::dvec4(decode_normal(xyz(in[0])), 0); },
         {"stored * 2.0 - 1.0", "stored * 2.0 + 1.0"}},
        {"decode_normal_128",
         "staff/normal_map.glsl",
         "vec4(decode_normal_128(a.xyz), 0.0)",
         stored,
         [](const GlslInput& in) { return glm::dvec4(decode_normal_128(xyz(in[0])), 0); },
         {"- 128.0", "+ 128.0"}},
        {"decode_normal_xy",
         "staff/normal_map.glsl",
         "vec4(decode_normal_xy(a.xy), 0.0)",
         pair,
         [](const GlslInput& in) {
             return glm::dvec4(decode_normal_xy({in[0].x, in[0].y}), 0);
         },
         {"1.0 - dot(xy, xy)", "1.0 + dot(xy, xy)"},
         // At the horizon z is the root of a small difference from 1, so half of its digits are lost.
         5e-4},
        {"decode_octahedral",
         "staff/normal_map.glsl",
         "vec4(decode_octahedral(a.xy), 0.0)",
         pair,
         [](const GlslInput& in) {
             return glm::dvec4(decode_octahedral({in[0].x, in[0].y}), 0);
         },
         {"n.y >= 0.0 ? -below", "n.y >= 0.0 ? below"}},
        {"tangent_frame",
         "staff/tangent_space.glsl",
         "vec4(tangent_frame(b.xyz, c)[1], 0.0)",
         random_frame,
         [](const GlslInput& in) { return glm::dvec4(tangent_frame(xyz(in[1]), in[2])[1], 0); },
         {"cross(n, t)", "cross(t, n)"}},
        {"from_tangent_space",
         "staff/tangent_space.glsl",
         "vec4(from_tangent_space(a.xyz, b.xyz, c), 0.0)",
         random_frame,
         [](const GlslInput& in) { return glm::dvec4(from_tangent_space(xyz(in[0]), xyz(in[1]), in[2]), 0); },
         {"tangent.xyz - dot", "tangent.xyz + dot"}},
        {"to_tangent_space",
         "staff/tangent_space.glsl",
         "vec4(to_tangent_space(a.xyz, b.xyz, c), 0.0)",
         random_frame,
         [](const GlslInput& in) { return glm::dvec4(to_tangent_space(xyz(in[0]), xyz(in[1]), in[2]), 0); },
         {"direction * tangent_frame", "-direction * tangent_frame"}},
        {"interpolated_frame",
         "staff/tangent_space.glsl",
         "vec4(interpolated_frame(b.xyz, c)[1], 0.0)",
         random_frame,
         [](const GlslInput& in) { return glm::dvec4(interpolated_frame(xyz(in[1]), in[2])[1], 0); },
         {"tangent.w * cross(normal, tangent.xyz), normal", "cross(normal, tangent.xyz), normal"}},
        {"from_interpolated_frame",
         "staff/tangent_space.glsl",
         "vec4(from_interpolated_frame(a.xyz, b.xyz, c), 0.0)",
         random_frame,
         [](const GlslInput& in) { return glm::dvec4(from_interpolated_frame(xyz(in[0]), xyz(in[1]), in[2]), 0); },
         {"interpolated_frame(normal, tangent) * direction", "direction * interpolated_frame(normal, tangent)"}},
        {"to_interpolated_frame",
         "staff/tangent_space.glsl",
         "vec4(to_interpolated_frame(a.xyz, b.xyz, c), 0.0)",
         random_frame,
         [](const GlslInput& in) { return glm::dvec4(to_interpolated_frame(xyz(in[0]), xyz(in[1]), in[2]), 0); },
         {"sign(tangent.w) * (direction", "(direction"}},
        {"cotangent_frame",
         "staff/tangent_space.glsl",
         "vec4(cotangent_frame(a.xyz, b.xyz, c.xyz, d.xy, d.zw)[0], 0.0)",
         random_differences,
         [](const GlslInput& in) { return column_of_cotangent_frame(in, 0); },
         {"? -1.0 : 1.0", "? 1.0 : 1.0"},
         // Sums of two products may nearly cancel, because the longer of the two columns sets the scale.
         1e-5,
         1},
        {"cotangent_frame",
         "staff/tangent_space.glsl",
         "vec4(cotangent_frame(a.xyz, b.xyz, c.xyz, d.xy, d.zw)[1], 0.0)",
         random_differences,
         [](const GlslInput& in) { return column_of_cotangent_frame(in, 1); },
         {"across_x * uv_dx.y + across_y", "across_x * uv_dx.y - across_y"},
         1e-5,
         1},
    };
}

/// A cell, the t at which a ray leaves it, a slightly later position, and the direction. Positions stay farther from a
/// line than the rounding of next_cell().
GlslInput random_walk(Dice& dice) {
    const glm::vec2 cell(std::floor(dice.between(-9, 9)), std::floor(dice.between(-9, 9)));
    const glm::vec2 in_cell(dice.between(0.01f, 0.99f), dice.between(0.01f, 0.99f));
    const glm::vec2 skipped(std::floor(dice.between(-3, 3)), std::floor(dice.between(-3, 3)));
    return {glm::vec4(cell, 0, 0), glm::vec4(dice.between(0, 1), dice.between(0, 1), 0, 0),
            glm::vec4(cell + skipped + in_cell, 0, 0), glm::vec4(dice.between(-1, 1), dice.between(-1, 1), 0, 0)};
}

std::vector<Twin> cell_walks() {
    return {
        {"way_of",
         "common/cell_walk.glsl",
         "vec4(way_of(d.xy), way_of(vec2(0.0)))",
         random_walk,
         [](const GlslInput& in) { return glm::dvec4(in[3].x < 0 ? -1 : 1, in[3].y < 0 ? -1 : 1, 1, 1); },
         {"vec2(-1.0), vec2(1.0)", "vec2(1.0), vec2(-1.0)"}},
        {"octant_of",
         "common/cell_walk.glsl",
         "vec4(octant_of(d.xy, way_of(d.xy)))",
         random_walk,
         [](const GlslInput& in) {
             const double octant = (in[3].x < 0 ? 1 : 0) + (in[3].y < 0 ? 2 : 0);
             return glm::dvec4(octant + (std::abs(in[3].y) > std::abs(in[3].x) ? 4 : 0));
         },
         {"vec3(1.0, 2.0, 4.0)", "vec3(2.0, 1.0, 4.0)"}},
        {"start_along",
         "common/cell_walk.glsl",
         "vec4(start_along(b.xy, way_of(d.xy)), 0.0, 0.0)",
         random_walk,
         [](const GlslInput& in) {
             const auto along = [&](int i) { return in[3][i] < 0 ? 1 - double(in[1][i]) : double(in[1][i]); };
             return glm::dvec4(along(0), along(1), 0, 0);
         },
         {"1.0 - start, start", "start, 1.0 - start"}},
        {"next_cell",
         "common/cell_walk.glsl",
         "vec4(next_cell(a.xy, b.xy, c.xy), 0.0, 0.0)",
         random_walk,
         [](const GlslInput& in) {
             glm::dvec4 next(0);
             for (int i = 0; i < 2; ++i) {
                 const double next_one = double(in[0][i]) + (in[1][i] <= in[1][1 - i] ? 1 : 0);
                 next[i] = std::max(next_one, std::floor(double(in[2][i])));
             }
             return next;
         },
         {"lessThanEqual(leaves", "greaterThanEqual(leaves"}},
        {"iterations_between",
         "common/cell_walk.glsl",
         "vec4(iterations_between(d.xy * 1000.0, b.x, b.x + b.y), iterations_between(d.xy * 1e6, 0.0, 1e3), 0.0, 0.0)",
         random_walk,
         [](const GlslInput& in) {
             const double way = 1000 * (std::abs(double(in[3].x)) + std::abs(double(in[3].y)));
             return glm::dvec4(way * double(in[1].y) + 4, 65004, 0, 0);
         },
         {"+ abs(along.y)", "+ along.y"},
         1e-4},  // integers, up to tens of thousands
    };
}

std::vector<Twin> height_cells() {
    return {
        {"height_in_cell",
         "common/height_cell.glsl",
         "vec4(height_in_cell(a, b.xy), vec3(0.0))",
         random_cell,
         [](const GlslInput& in) {
             return scalar(height_in_cell(cell_of(in[0]), {in[1].x, in[1].y}));
         },
         {"corners.wz, corners.xy", "corners.zw, corners.yx"}},
        {"slope_in_cell",
         "common/height_cell.glsl",
         "vec4(slope_in_cell(a, b.xy), 0.0, 0.0)",
         random_cell,
         [](const GlslInput& in) {
             return glm::dvec4(slope_in_cell(cell_of(in[0]), {in[1].x, in[1].y}), 0, 0);
         },
         {"corners.x - corners.w, corners.y - corners.z", "corners.w - corners.x, corners.z - corners.y"},
         1e-5,
         1},  // a difference of heights: relative to the heights
        {"gap_above_cell",
         "common/height_cell.glsl",
         "vec4(gap_above_cell(a, b.xyz, c.xyz), 0.0)",
         random_cell,
         [](const GlslInput& in) {
             const Gap gap = gap_above_cell(cell_of(in[0]), xyz(in[1]), xyz(in[2]));
             return glm::dvec4(gap.begin, gap.middle, gap.end, 0);
         },
         {"from.z + to.z - mixed", "from.z + to.z + mixed"},
         1e-5,
         1},  // as above
        {"closes",
         "common/height_cell.glsl",
         "vec4(closes(a.xyz), vec3(0.0))",
         [](Dice& dice) {
             for (;;) {  // not closer to contact than float precision
                 const glm::dvec3 gap = dice.inside(-1, 1);
                 if (std::abs(gap.y * gap.y - gap.x * gap.z) > 1e-5) return GlslInput{glm::vec4(gap, 0)};
             }
         },
         [](const GlslInput& in) {
             return scalar(closes({in[0].x, in[0].y, in[0].z}));
         },
         {"gap.y < 0.0", "gap.y > 0.0"}},
        {"first_closing",
         "common/height_cell.glsl",
         "vec4(first_closing(a.xyz), vec3(0.0))",
         [](Dice& dice) {
             for (;;) {
                 const glm::dvec3 gap(dice.between(0, 1), dice.between(-1, 1), dice.between(-1, 1));
                 if (closes({gap.x, gap.y, gap.z}) && std::abs(gap.y * gap.y - gap.x * gap.z) > 0.01)
                     return GlslInput{glm::vec4(gap, 0)};
             }
         },
         [](const GlslInput& in) {
             return scalar(first_closing({in[0].x, in[0].y, in[0].z}));
         },
         {"gap.x - gap.y + root", "gap.x + gap.y + root"}},
    };
}

std::vector<Twin> displacement_and_levels() {
    const auto edge = [](Dice& dice) {
        return GlslInput{glm::vec4(dice.inside(-1, 1), 0), glm::vec4(dice.inside(-1, 1), 0),
                         glm::vec4(dice.inside(2, 9), 0),
                         glm::vec4(dice.between(300, 3000), dice.between(4, 64), 0, 0)};
    };
    const auto bounds = [](Dice& dice) {
        const float lowest = dice.between(0, 1);
        return GlslInput{glm::vec4(dice.inside(-1, 1), dice.between(0.1f, 1)),
                         glm::vec4(dice.unit(), dice.between(0, 0.5f)),
                         glm::vec4(lowest, dice.between(lowest, 1), dice.between(0, 1), 0)};
    };
    const auto base = [](Dice& dice) {
        return GlslInput{glm::vec4(1, 0.1f * dice.inside(-1, 1)),
                         glm::vec4(0.1f * dice.inside(-1, 1), 0),
                         glm::vec4(dice.unit(), 0),
                         glm::vec4(dice.inside(-1, 1), dice.between(0, 1)),
                         glm::vec4(dice.inside(-1, 1), dice.between(0, 0.2f)),
                         glm::vec4(dice.between(-2, 2), dice.between(-2, 2), 0, 0)};
    };
    // On each edge, at each corner, and inside.
    const auto place = [](Dice& dice) {
        const float x = std::array{0.0f, 1.0f, dice.between(0, 1)}[dice.random() % 3];
        const float y = std::array{0.0f, 1.0f, dice.between(0, 1)}[dice.random() % 3];
        glm::vec3 weights = dice.inside(0.1f, 1);
        if (dice.random() % 2) weights[int(dice.random() % 3)] = 0;
        return GlslInput{glm::vec4(x, y, 0, 0), glm::vec4(weights, 0),
                         glm::vec4(dice.inside(-1, 1), dice.between(-1, 1)),
                         glm::vec4(dice.inside(-1, 1), dice.between(-1, 1))};
    };
    const auto directions = [](Dice& dice) {
        return GlslInput{glm::vec4(dice.between(0.5f, 2) * dice.unit(), 0), glm::vec4(dice.inside(-1, 1), 0),
                         0.5f * glm::vec4(dice.inside(-1, 1), dice.between(-1, 1))};
    };
    return {
        {"displaced",
         "13_displacement/task.glsl",
         "vec4(displaced(a.xyz, 0.7 * c.xyz, d.w, e.w), 0.0)",
         base,
         [](const GlslInput& in) {
             const SurfacePoint point{
                 .position = xyz(in[0]), .normal = xyz(in[2]), .du = {}, .dv = {}, .normal_du = {}, .normal_dv = {}};
             return glm::dvec4(displace(point, {in[3].w, {}}, in[4].w).position, 0);
         },
         {"* (height - 1.0) * normalize(direction)", "* (1.0 - height) * normalize(direction)"}},
        {"displaced_normal",
         "13_displacement/task.glsl",
         "vec4(displaced_normal(a.xyz, b.xyz + vec3(0.0, 1.0, 0.0), vec3(0.0, 0.0, 1.0), d.xyz, e.xyz, d.w, f.xy, "
         "e.w), 0.0)",
         base,
         [](const GlslInput& in) {
             const SurfacePoint point{.position = {},
                                      .normal = {0, 0, 1},
                                      .du = xyz(in[0]),
                                      .dv = xyz(in[1]) + glm::dvec3(0, 1, 0),
                                      .normal_du = xyz(in[3]),
                                      .normal_dv = xyz(in[4])};
             return glm::dvec4(displace(point, {in[3].w, {in[5].x, in[5].y}}, in[4].w).normal, 0);
         },
         {"scale * slope.x * normal, dv", "scale * slope.y * normal, dv"}},
        {"possible_level",
         "14_adaptive_displacement/task.glsl",
         "vec4(possible_level(a.x), vec3(0.0))",
         [](Dice& dice) { return GlslInput{glm::vec4(dice.any_size(-3, 3), 0, 0, 0)}; },
         [](const GlslInput& in) { return scalar(possible_level(in[0].x)); },
         {"return level > 1.0", "return level < 1.0"}},
        {"level_by_distance",
         "14_adaptive_displacement/task.glsl",
         "vec4(level_by_distance(a.xyz, b.xyz, c.xyz, d.z, d.w, e.x, e.y), vec3(0.0))",
         [edge](Dice& dice) {
             GlslInput in = edge(dice);
             in[3].z = dice.between(0.1f, 10), in[3].w = in[3].z * dice.between(2, 10);
             in[4] = glm::vec4(dice.between(3, 6), dice.between(0, 3), 0, 0);
             return in;
         },
         [](const GlslInput& in) {
             return scalar(level_by_distance(xyz(in[0]), xyz(in[1]), xyz(in[2]), in[3].z, in[3].w, in[4].x, in[4].y));
         },
         {"eye) - nearest", "eye) + nearest"}},
        {"level_by_size",
         "14_adaptive_displacement/task.glsl",
         "vec4(level_by_size(a.xyz, b.xyz, c.xyz, d.x, d.y), vec3(0.0))",
         edge,
         [](const GlslInput& in) {
             return scalar(level_by_size(xyz(in[0]), xyz(in[1]), xyz(in[2]), in[3].x, in[3].y));
         },
         {"pixels_per_radian / distance(0.5", "pixels_per_radian / distance(0.7"}},
        {"tolerated",
         "14_adaptive_displacement/task.glsl",
         "vec4(tolerated(c.x, d.x, d.y, a.w), vec3(0.0))",
         [edge](Dice& dice) {
             GlslInput in = edge(dice);
             in[0].w = dice.between(0.01f, 2);
             return in;
         },
         [](const GlslInput& in) { return scalar(tolerated(in[2].x, in[3].x, in[3].y, in[0].w)); },
         {"(pixels_per_radian * scale)", "pixels_per_radian * scale"}},
        {"level_by_error",
         "14_adaptive_displacement/task.glsl",
         "vec4(level_by_error(a, vec4(b.xyz, 0.0), b.w), vec3(0.0))",
         [](Dice& dice) {
             std::array<float, 7> errors;
             for (float& error : errors) error = dice.between(0.001f, 1);
             std::sort(errors.begin(), errors.end(), std::greater<>());
             return GlslInput{glm::vec4(errors[0], errors[1], errors[2], errors[3]),
                              glm::vec4(errors[4], errors[5], errors[6], dice.between(0, 1.2f))};
         },
         [](const GlslInput& in) {
             return scalar(level_by_error({in[0].x, in[0].y, in[0].z, in[0].w, in[1].x, in[1].y, in[1].z}, in[1].w));
         },
         {"float(octave - 1) + share", "float(octave) - share"},
         // A difference of two errors that may be 1000 times closer to each other than to 0.
         1e-3},
        {"outer_levels_of_triangle",
         "14_adaptive_displacement/task.glsl",
         "outer_levels_of_triangle(a.xyz)",
         edge,
         [](const GlslInput& in) { return outer_levels_of_triangle(xyz(in[0])); },
         {"edges.yzx", "edges.xyz"}},
        {"outer_levels_of_quad",
         "14_adaptive_displacement/task.glsl",
         "outer_levels_of_quad(c)",
         edge,
         [](const GlslInput& in) { return outer_levels_of_quad(in[2]); },
         {"edges.wxyz", "edges.yzwx"}},
        {"relief_bounds",
         "14_adaptive_displacement/task.glsl",
         "relief_bounds(a, b.xyz, b.w, c.x, c.y, c.z)",
         bounds,
         [](const GlslInput& in) { return relief_bounds(in[0], xyz(in[1]), in[1].w, in[2].x, in[2].y, in[2].z); },
         {"(highest - 1.0)", "(1.0 - highest)"}},
        {"is_outside",
         "14_adaptive_displacement/task.glsl",
         "vec4(is_outside(vec4[](a, b, c, d, e, f), g), vec3(0.0))",
         [](Dice& dice) {
             for (;;) {  // not closer to contact than float precision
                 GlslInput in;
                 for (int i = 0; i < 6; ++i) in[size_t(i)] = glm::vec4(dice.unit(), dice.between(-0.5f, 2));
                 in[6] = glm::vec4(dice.inside(-1, 1), dice.between(0, 1));
                 bool is_clear = true;
                 for (size_t i = 0; i < 6; ++i)
                     is_clear = is_clear && std::abs(glm::dot(in[i], {xyz(in[6]), 1}) + in[6].w) > 1e-4;
                 if (is_clear) return in;
             }
         },
         [](const GlslInput& in) {
             const std::vector<glm::dvec4> planes(in.begin(), in.begin() + 6);
             return scalar(is_outside(planes, in[6]));
         },
         {"< -sphere.w", "< sphere.w"}},
        {"faces_away",
         "14_adaptive_displacement/task.glsl",
         "vec4(faces_away(b.xyz, c.w, a, d.xyz), vec3(0.0))",
         [bounds](Dice& dice) {
             for (;;) {  // as above
                 GlslInput in = bounds(dice);
                 in[2].w = std::abs(dice.any_size(-2, 1)), in[3] = glm::vec4(dice.inside(-3, 3), 0);
                 const auto faces = [&](double slope) {
                     return faces_away(xyz(in[1]), in[2].w * slope, in[0], xyz(in[3]));
                 };
                 if (faces(0.999) == faces(1.001)) return in;
             }
         },
         [](const GlslInput& in) { return scalar(faces_away(xyz(in[1]), in[2].w, in[0], xyz(in[3]))); },
         {"atan(slope) + asin", "atan(slope) - asin"}},
        {"remaining",
         "14_adaptive_displacement/task.glsl",
         "vec4(remaining(c.x, d.z, d.w), vec3(0.0))",
         [edge](Dice& dice) {
             GlslInput in = edge(dice);
             in[3].z = dice.between(0, 10), in[3].w = in[3].z + dice.between(1, 10);
             return in;
         },
         [](const GlslInput& in) { return scalar(remaining(in[2].x, in[3].z, in[3].w)); },
         {"(end - distance_)", "(distance_ - begin)"},
         1e-5,
         0.1},  // a difference that may be nearly 0
        {"pixels_per_metre",
         "17_time_and_error/task.glsl",
         "vec4(pixels_per_metre(a, b, c.xy), vec3(0.0))",
         [](Dice& dice) {
             return GlslInput{glm::vec4(dice.inside(-3, 3), dice.between(0.5f, 100)),
                              glm::vec4(dice.inside(-1, 1), dice.between(-1, 1)),
                              glm::vec4(dice.between(64, 2000), dice.between(64, 2000), 0, 0)};
         },
         [](const GlslInput& in) {
             return scalar(pixels_per_metre(in[0], in[1], {in[2].x, in[2].y}));
         },
         {"along.xy - ndc", "along.xy + ndc"}},
        {"tolerated",
         "17_time_and_error/task.glsl",
         "vec4(tolerated(a.x, a.y, a.z), vec3(0.0))",
         [](Dice& dice) {
             return GlslInput{glm::vec4(dice.any_size(-2, 2), dice.any_size(-1, 4), dice.any_size(-3, 0), 0)};
         },
         [](const GlslInput& in) { return scalar(tolerated(in[0].x, in[0].y, in[0].z)); },
         {"budget / pixels", "budget * pixels"}},
        {"thinned",
         "17_time_and_error/task.glsl",
         "vec4(thinned(a.x, a.y, a.z), vec2(0.0))",
         [](Dice& dice) {
             return GlslInput{glm::vec4(dice.between(0, 0.5f), dice.between(0.5f, 1), dice.between(0, 0.6f), 0)};
         },
         [](const GlslInput& in) { return glm::dvec4(thinned(in[0].x, in[0].y, in[0].z), 0, 0); },
         {"highest - max_error", "highest + max_error"}},
        {"coarsest_level",
         "17_time_and_error/task.glsl",
         "vec4(coarsest_level(float[12](a.x, a.y, a.z, a.w, b.x, b.y, b.z, b.w, 9.0, 9.0, 9.0, 9.0), 8, c.x), "
         "vec3(0.0))",
         [](Dice& dice) {
             GlslInput in;
             float sum = 0;
             for (int i = 0; i < 8; ++i) in[size_t(i / 4)][i % 4] = sum += dice.between(0.02f, 0.1f);
             in[2].x = dice.between(0, 1);
             return in;
         },
         [](const GlslInput& in) { return scalar(coarsest_level(std::span(&in[0].x, 8), in[2].x)); },
         {"errors[level + 1] - errors[level]", "errors[level + 1]"},
         1e-5,
         1},
        {"spread_shininess",
         "17_time_and_error/task.glsl",
         "vec4(spread_shininess(a.xyz, b.x), vec3(0.0))",
         [](Dice& dice) {
             return GlslInput{glm::vec4(dice.unit() * dice.between(0.01f, 0.99f), 0),
                              glm::vec4(dice.between(1, 100), 0, 0, 0)};
         },
         [](const GlslInput& in) { return scalar(in[1].x * toksvig_factor(glm::length(xyz(in[0])), in[1].x)); },
         {"shininess * (1.0 - l)", "shininess * l"},
         1e-4},  // rounding of the length, amplified by a sharp highlight
        {"bumps_left",
         "17_time_and_error/task.glsl",
         "vec4(bumps_left(a.x, a.y, a.z), vec3(0.0))",
         [](Dice& dice) {
             const float flat = dice.between(2, 10);
             return GlslInput{glm::vec4(flat + dice.between(-3, 1), flat, dice.between(0.25f, 4), 0)};
         },
         [](const GlslInput& in) { return scalar(bumps_left(in[0].x, in[0].y, in[0].z)); },
         {"- log2(budget)", "+ log2(budget)"},
         1e-5,
         0.1},  // a difference that may be nearly 0
        {"quad_weights",
         "common/patch.glsl",
         "quad_weights(a.xy)",
         place,
         [](const GlslInput& in) {
             return quad_weights({in[0].x, in[0].y});
         },
         {"place.x * place.y, rest.x", "place.x * rest.y, rest.x"}},
        {"blend",
         "common/patch.glsl",
         "blend(a, b, c, d, e)",
         [](Dice& dice) {
             GlslInput input;
             for (glm::vec4& value : input) value = glm::vec4(dice.inside(0, 1), dice.between(0, 1));
             return input;
         },
         [](const GlslInput& in) {
             return blend(glm::dvec4(in[0]), glm::dvec4(in[1]), glm::dvec4(in[2]), glm::dvec4(in[3]),
                          glm::dvec4(in[4]));
         },
         {"weights.z * c", "weights.w * c"}},
        {"edge_of_triangle",
         "common/patch.glsl",
         "vec4(edge_of_triangle(b.xyz), vec3(0.0))",
         place,
         [](const GlslInput& in) { return scalar(edge_of_triangle(xyz(in[1]))); },
         {"weights.x == 0.0 ? 1", "weights.x == 0.0 ? 2"}},
        {"edge_of_quad",
         "common/patch.glsl",
         "vec4(edge_of_quad(a.xy), vec3(0.0))",
         place,
         [](const GlslInput& in) {
             return scalar(edge_of_quad({in[0].x, in[0].y}));
         },
         {"place.y == 1.0 ? 2", "place.y == 0.5 ? 2"}},
        {"uv_on_edge",
         "common/patch.glsl",
         "vec4(uv_on_edge(a.x, 1.0 - a.x, c, d.xy, d.zw), 0.0, 0.0)",
         place,
         [](const GlslInput& in) {
             return glm::dvec4(
                 uv_on_edge(in[0].x, 1 - in[0].x, glm::dvec4(in[2]), {in[3].x, in[3].y}, {in[3].z, in[3].w}), 0, 0);
         },
         {"there == 1.0 ? uv_there", "there == 1.0 ? uv_here"}},
        {"by_uv",
         "common/patch.glsl",
         "vec4(by_uv(a.xyz, b.xyz, c.xy + vec2(2.0, 0.0), c.zw + vec2(0.0, 2.0))[0], 0.0)",
         directions,
         [](const GlslInput& in) {
             return glm::dvec4(by_uv(xyz(in[0]), xyz(in[1]), {in[2].x + 2, in[2].y}, {in[2].z, in[2].w + 2})[0], 0);
         },
         {"uv_y.y * along_x", "uv_x.x * along_x"}},
        {"by_uv",
         "common/patch.glsl",
         "vec4(by_uv(a.xyz, b.xyz, c.xy + vec2(2.0, 0.0), c.zw + vec2(0.0, 2.0))[1], 0.0)",
         directions,
         [](const GlslInput& in) {
             return glm::dvec4(by_uv(xyz(in[0]), xyz(in[1]), {in[2].x + 2, in[2].y}, {in[2].z, in[2].w + 2})[1], 0);
         },
         {"uv_y.x * along_x", "uv_x.y * along_x"}},
        {"turn_of_unit",
         "common/patch.glsl",
         "vec4(turn_of_unit(a.xyz, b.xyz), 0.0)",
         directions,
         [](const GlslInput& in) { return glm::dvec4(turn_of_unit(xyz(in[0]), xyz(in[1])), 0); },
         {"change - vector", "change + vector"}},
    };
}

Ray ray_of(const GlslInput& in) { return {xyz(in[0]), xyz(in[1])}; }

/// A ray and a triangle, with a hit or a miss by more than float rounding.
GlslInput random_ray_and_triangle(Dice& dice) {
    for (;;) {
        const GlslInput in{glm::vec4(dice.inside(-1, 1), 0), glm::vec4(dice.inside(-2, 2), 0),
                           glm::vec4(dice.inside(-1, 1), 0), glm::vec4(dice.inside(-1, 1), 0),
                           glm::vec4(dice.inside(-1, 1), 0)};
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

std::vector<Twin> mesh_rays() {
    const auto direction = [](Dice& dice) {
        return GlslInput{glm::vec4(dice.any_size(-2, 2), dice.any_size(-2, 2), dice.any_size(-2, 2), 0),
                         glm::vec4(dice.inside(-1, 1), 0)};
    };
    const std::string call = "triangle_hit(a.xyz, b.xyz, ray_shear(b.xyz), c.xyz, d.xyz, e.xyz)";
    return {
        {"in_ray_order",
         "common/mesh_rays.glsl",
         "vec4(in_ray_order(b.xyz, a.xyz), 0.0)",
         direction,
         [](const GlslInput& in) {
             const RayAxes axes = axes_of(xyz(in[0]));
             return glm::dvec4(in[1][axes.along[0]], in[1][axes.along[1]], in[1][axes.along[2]], 0);
         },
         {"v.yzx", "v.zyx"}},
        {"ray_shear",
         "common/mesh_rays.glsl",
         "vec4(ray_shear(a.xyz), 0.0)",
         direction,
         [](const GlslInput& in) { return glm::dvec4(axes_of(xyz(in[0])).shear, 0); },
         {"d.x / d.z", "d.x * d.z"}},
        {"inverse_direction",
         "common/mesh_rays.glsl",
         "vec4(inverse_direction(a.xyz), 0.0)",
         [](Dice& dice) {
             return GlslInput{glm::vec4(dice.any_size(-2, 2), dice.any_size(-25, -19), dice.random() % 2, 0)};
         },
         [](const GlslInput& in) { return glm::dvec4(inverse_direction(xyz(in[0])), 0); },
         {"vec3(1e18), vec3(-1e18)", "vec3(-1e18), vec3(1e18)"}},
        {"meets_box",
         "common/mesh_rays.glsl",
         "vec4(meets_box(a.xyz, inverse_direction(b.xyz), 1.0, min(c.xyz, d.xyz), max(c.xyz, d.xyz)))",
         [](Dice& dice) {
             const auto grid = [&] { return glm::vec4(glm::round(dice.inside(-8, 8)) / 4.0f, 0); };
             // Boxes on a grid; origins and directions off the grid by more than any rounding.
             return GlslInput{grid() + 0.1f, grid() + glm::vec4(0.03f, 0.07f, 0.013f, 0), grid(), grid()};
         },
         [](const GlslInput& in) {
             return glm::dvec4(meets_box(xyz(in[0]), inverse_direction(xyz(in[1])), 1, glm::min(xyz(in[2]), xyz(in[3])),
                                         glm::max(xyz(in[2]), xyz(in[3]))));
         },
         {"max(near.z, 0.0)", "near.z"}},
        {"triangle_hit",
         "common/mesh_rays.glsl",
         call,
         random_ray_and_triangle,
         [](const GlslInput& in) {
             const Ray ray = ray_of(in);
             return triangle_hit(ray, axes_of(ray.direction), xyz(in[2]), xyz(in[3]), xyz(in[4]));
         },
         {"(any_below && any_above)", "any_above"},
         // t is the quotient of lengths up to 4 by a slant of at least 0.3.
         2e-4,
         1},
    };
}

/// Gaussian slopes within a pixel, an eye for which the facets that face away are at most one in a thousand, and a
/// light. The inputs are: mean of the slopes; their variance along u, along v, covariance, and alpha²; to the eye; to
/// the light.
GlslInput random_slopes(Dice& dice) {
    for (;;) {
        const float u = dice.between(0.1f, 0.4f), v = dice.between(0.1f, 0.4f), wide = std::max(u, v);
        const glm::vec4 variance(u * u, v * v, u * v * dice.between(-0.7f, 0.7f), wide * wide * dice.between(1, 3));
        const GlslInput in = {glm::vec4(dice.between(-0.5f, 0.5f), dice.between(-0.5f, 0.5f), 0, 0), variance,
                              glm::vec4(dice.unit(), 0), glm::vec4(dice.unit(), 0)};
        const glm::vec2 flat(in[2]);
        const bool is_seen = in[2].z - glm::dot(flat, glm::vec2(in[0])) > 3.2f * wide * glm::length(flat);
        if (glm::length(flat) > 0.05f && is_seen && in[2].z > 0.1f && in[3].z > 0.1f) return in;
    }
}

/// Returns the mean over random_slopes() of `value`, by the area that a facet of each slope has on the picture:
/// max(e.z - s.x e.x - s.y e.y, 0) for the direction e to the eye.
glm::dvec2 mean_over_facets(const GlslInput& in, const std::function<glm::dvec2(glm::dvec2 slope)>& value) {
    const double u = std::sqrt(double(in[1].x)), lean = double(in[1].z) / u,
                 v = std::sqrt(double(in[1].y) - lean * lean);
    const glm::dvec3 to_eye = xyz(in[2]);
    double areas = 0;
    glm::dvec2 sum(0);
    constexpr int side = 10;  // with 4.5 deviations each way, such sums of Gaussians are off by 1e-5
    for (int i = -side; i <= side; ++i)
        for (int j = -side; j <= side; ++j) {
            const glm::dvec2 place = 4.5 / side * glm::dvec2(i, j);
            const glm::dvec2 slope = glm::dvec2(in[0]) + glm::dvec2(u * place.x, lean * place.x + v * place.y);
            const double area =
                std::exp(-glm::dot(place, place) / 2) * std::max(to_eye.z - glm::dot(slope, glm::dvec2(to_eye)), 0.0);
            areas += area, sum += area * value(slope);
        }
    return sum / areas;
}

std::vector<Twin> slopes_of_pixels() {
    const char* const file = "14_adaptive_displacement/leadr.glsl";
    const auto lobe = [](const GlslInput& in) {
        const glm::dvec3 halfway = xyz(in[2]) + xyz(in[3]);
        return scalar(mean_over_facets(in, [&](glm::dvec2 slope) {
                          const glm::dvec2 off = slope + glm::dvec2(halfway) / halfway.z;
                          return glm::dvec2(std::exp(-glm::dot(off, off) / double(in[1].w)));
                      }).x);
    };
    return {
        {"variance_of_slopes",
         "common/slope_moments.glsl",
         "vec4(variance_of_slopes(0.5 * (a.xy + b.xy), 0.5 * vec3(a.xy * a.xy + b.xy * b.xy, a.x * a.y + b.x * b.y)), "
         "0.0)",
         [](Dice& dice) {
             return GlslInput{glm::vec4(dice.inside(-1, 1), 0), glm::vec4(dice.inside(-1, 1), 0)};
         },
         [](const GlslInput& in) {  // of two slopes: the product of half of their difference
             const glm::dvec2 half = 0.5 * (glm::dvec2(in[0]) - glm::dvec2(in[1]));
             return glm::dvec4(half * half, half.x * half.y, 0);
         },
         {"squares.z - mean.x * mean.y", "squares.z"},
         1e-5,
         0.1},
        {"covariance_matrix",
         "common/slope_moments.glsl",
         "vec4(covariance_matrix(a.xyz) * b.xy, 0.0, 0.0)",
         [](Dice& dice) {
             return GlslInput{glm::vec4(dice.inside(-1, 1), 0), glm::vec4(dice.inside(-1, 1), 0)};
         },
         [](const GlslInput& in) {
             const glm::dvec3 of = xyz(in[0]), by = xyz(in[1]);
             return glm::dvec4(of.x * by.x + of.z * by.y, of.z * by.x + of.y * by.y, 0, 0);
         },
         {"variance.z, variance.y)", "variance.y, variance.z)"},
         1e-5,
         0.1},
        {"seen_slope",
         file,
         "vec4(seen_slope(Slopes(a.xy, b.xyz), c.xyz), 0.0, 0.0)",
         random_slopes,
         [](const GlslInput& in) {
             return glm::dvec4(mean_over_facets(in, [](glm::dvec2 slope) { return slope; }), 0, 0);
         },
         {"slopes.mean - covariance_matrix", "slopes.mean + covariance_matrix"},
         5e-4,  // the distribution function of a Gaussian
         0.1},
        {"highlight",
         file,
         "vec4(highlight(Slopes(a.xy, b.xyz), b.w, c.xyz, d.xyz), 0.0, 0.0, 0.0)",
         random_slopes,
         lobe,
         {"mat2(0.5 * alpha2)", "mat2(alpha2)"},
         2e-3,  // it counts facets that face away, at most one in a thousand, as negative areas
         0.1}};
}

std::vector<Twin> all_twins() {
    std::vector<Twin> all;
    for (const auto& some : {light_and_color(), terminator(), normals_and_frames(), height_cells(), cell_walks(),
                             displacement_and_levels(), slopes_of_pixels(), mesh_rays()})
        all.insert(all.end(), some.begin(), some.end());
    return all;
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
    const std::vector<glm::vec4> results = evaluate_glsl(twin.file, twin.expression, inputs, mistake);
    double largest = 0;
    for (size_t i = 0; i < inputs.size(); ++i) {
        const glm::dvec4 truth = twin.twin(inputs[i]);
        const double error = glm::length(glm::dvec4(results[i]) - truth) / std::max(glm::length(truth), twin.scale);
        largest = std::max(largest, std::isnan(error) ? INFINITY : error);
    }
    return largest;
}

TEST(ShaderFunction, AgreesWithItsTwin) {
    for (const Twin& twin : all_twins())
        EXPECT_LE(largest_error(twin, {}), twin.tolerance) << twin.expression << ", seed " << twins_seed;
}

TEST(ShaderFunction, DisagreesWithItsTwinAfterAPlantedMistake) {
    for (const Twin& twin : all_twins())
        EXPECT_GT(largest_error(twin, twin.mistake), 100 * twin.tolerance)
            << twin.expression << ", seed " << twins_seed;
}

TEST(ShaderFunction, HasATwinForEveryDefinition) {
    std::set<std::string> tested = {"cell_corners", "exact_hit"};  // tested below, because they sample textures
    for (const Twin& twin : all_twins())
        if (twin.file.starts_with("common/") || twin.file.starts_with("staff/")) tested.insert(twin.function);
    const std::regex definition("(^|\n)(float|bool|int|vec[234]|mat[234]) ([a-z_0-9]+)\\(");
    size_t found = 0;
    for (const char* folder : {"shaders/common", "shaders/staff"})
        for (const auto& file : std::filesystem::directory_iterator(course_root() / folder)) {
            if (file.path().filename() == "unfinished.glsl") continue;  // placeholders for students, no mathematics
            const std::string text = read_file(file.path());
            for (auto match = std::sregex_iterator(text.begin(), text.end(), definition);
                 match != std::sregex_iterator(); ++match, ++found)
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
        in = {glm::vec4(origin, 0), glm::vec4(target - origin, 0), glm::vec4(middle, 0)};
        for (size_t i = 0; i < 4; ++i) in[3 + i] = glm::vec4(ring[i], 0);
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
        for (int column = -1; column < columns; ++column) inputs.push_back({glm::vec4(column, row, 0, 0)});
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

/// Returns a call of exact_hit() with the map and these windows as its textures. `ray` is GLSL: the other arguments.
std::string exact_hit_call(const HeightWindows& windows, const char* ray) {
    const glm::mat4 extents = windows.extents();
    std::string columns;
    for (int i = 0; i < 16; ++i) columns += fmt::format("{}{:.1f}", i ? ", " : "", extents[i / 4][i % 4]);
    return fmt::format("vec4(exact_hit(s_map, s_other, mat4({}), {}))", columns, ray);
}

TEST(ShaderFunction, ExactHitEqualsTheHeightFieldHit) {
    Dice dice{std::mt19937(twins_seed)};
    Image image = make_height_map(HeightMap::stones, 64);
    const Texture map("heights", [&] { return image; });
    const HeightWindows windows = height_windows(image);
    const Texture other("windows", [&] { return windows.clearance; }, {.mips = false, .layers = 8});
    std::vector<GlslInput> inputs;
    for (int i = 0; i < 4000; ++i) {
        const float reach = i % 50 == 0 ? 0 : dice.between(0, 2);
        const float turn = dice.between(0, 6.3f);
        const float begin = i % 2 == 0 ? 0 : dice.between(0, 0.6f);
        inputs.push_back(
            {glm::vec4(dice.between(-2, 2), dice.between(-2, 2), reach * std::cos(turn), reach * std::sin(turn)),
             glm::vec4(begin, i % 2 == 0 ? 1 : dice.between(begin, 1), 0, 0)});
    }
    const std::string hit_of = exact_hit_call(windows, "a.xy, a.zw, b.xy");
    const auto found = evaluate_glsl("common/exact_hit.glsl", hit_of, inputs, {}, &map, &other);
    const HeightField field(image, true);
    int off = 0;
    for (size_t i = 0; i < inputs.size(); ++i) {
        const glm::dvec4 ray = glm::dvec4(inputs[i][0]) * 64.0;
        const double begin = double(inputs[i][1].x), end = double(inputs[i][1].y);
        const glm::dvec3 along(ray.z, ray.w, -1);
        const auto hit = field.first_hit({glm::dvec3(ray.x, ray.y, 1) + begin * along, along}, end - begin);
        off += std::abs(double(found[i].x) - (hit ? begin + hit->t : end)) > 1e-4;
    }
    EXPECT_LE(off, 4) << "of 4000 a few graze an edge";
    const PlantedMistake one_too_far{"next_cell(passed, leaves, ahead + t",
                                     "next_cell(passed + 1.0, leaves, ahead + t"};
    const auto wrong = evaluate_glsl("common/exact_hit.glsl", hit_of, inputs, one_too_far, &map, &other);
    EXPECT_NE(wrong, found);
}

/// One kind of rays, in tiles, for exact_hit() and its twin.
struct FarRays {
    float start, reach;  ///< maximum distance of the start from the origin, and length to the ground
    double off;          ///< tolerance in texels
};

TEST(ShaderFunction, ExactHitEqualsTheHeightFieldHitForAnyRayStartAndLength) {
    for (const HeightMap kind : {HeightMap::posts, HeightMap::stones}) {
        const Image image = make_height_map(kind, 256);
        const HeightField field(image, true);
        const Texture map("heights", [&] { return image; });
        const HeightWindows windows = height_windows(image);
        const Texture other("windows", [&] { return windows.clearance; }, {.mips = false, .layers = 8});
        // A float resolves 6e-8 of its value: at the end of 250 tiles (64,000 texels) that is 0.004 texels.
        for (const FarRays& rays : {FarRays{1, 8, 0.01}, FarRays{512, 30, 0.02}, FarRays{4, 250, 0.1}}) {
            Dice dice{std::mt19937(twins_seed)};
            std::vector<GlslInput> inputs;
            for (int i = 0; i < 2000; ++i) {
                const float turn = float(i % 4) * 1.5707964f + dice.between(0, 0.2f) * dice.between(0, 1);
                const glm::vec2 along = dice.between(0.9f, 1) * rays.reach * glm::vec2(std::cos(turn), std::sin(turn));
                inputs.push_back(
                    {glm::vec4(dice.between(-rays.start, rays.start), dice.between(-rays.start, rays.start), along)});
            }
            const auto found =
                evaluate_glsl("common/exact_hit.glsl", exact_hit_call(windows, "a.xy, a.zw, vec2(0.0, 1.0)"), inputs,
                              {}, &map, &other);
            size_t off = 0;
            for (size_t i = 0; i < inputs.size(); ++i) {
                const glm::dvec4 ray = glm::dvec4(inputs[i][0]) * 256.0;
                const glm::dvec3 along(ray.z, ray.w, -1);
                const auto hit = field.first_hit({glm::dvec3(ray.x, ray.y, 1), along}, 1);
                off += std::abs(double(found[i].x) - (hit ? hit->t : 1)) * glm::length(along) > rays.off;
            }
            EXPECT_LE(off, inputs.size() / 200) << int(kind) << ", " << rays.reach << ": a few graze an edge";
        }
    }
}

TEST(ShaderFunction, ATexelWithoutANormalOrAFrameIsBakedFlat) {
    const std::vector<GlslInput> inputs = {{glm::vec4(0), glm::vec4(0.6f, 0, 0.8f, 0)}};
    const auto value = [&](const char* unit) {
        const std::string expression = "vec4(finite_or(" + std::string(unit) + ", vec3(0.0, 0.0, 1.0)), 0.0)";
        return evaluate_glsl("07_baking/frames.glsl", expression, inputs)[0];
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
    EXPECT_EQ(value("staff/normal_map.glsl", "vec4(decode_octahedral(vec2(1.0, 1.0)), 0.0)"), glm::vec4(0, 0, -1, 0));
    EXPECT_EQ(value("staff/normal_map.glsl", "vec4(decode_octahedral(vec2(1.0, 0.0)), 0.0)"), glm::vec4(1, 0, 0, 0));
    EXPECT_EQ(value("staff/normal_map.glsl", "vec4(decode_normal_xy(vec2(1.0, 0.5)), 0.0)").z, 0) << "too long: no NaN";
    EXPECT_EQ(value("staff/normal_map.glsl", "vec4(decode_normal_128(vec3(128.0, 128.0, 255.0) / 255.0), 0.0)"),
              glm::vec4(0, 0, 1, 0));
    EXPECT_EQ(
        value(
            "staff/tangent_space.glsl",
            "vec4(cotangent_frame(vec3(0.0, 0.0, 1.0), vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0), a.xy, a.xy)[0], 0.0)"),
        glm::vec4(0));
    EXPECT_EQ(value("13_displacement/task.glsl",
                    "vec4(displaced_normal(a.xyz, a.xyz, vec3(0.0, 0.0, 1.0), a.xyz, a.xyz, 0.5, a.xy, 1.0), 0.0)"),
              glm::vec4(0, 0, 1, 0));
    EXPECT_EQ(
        value("common/height_cell.glsl", "vec4(first_closing(vec3(1.0, 1.0, -1e30)), closes(vec3(1.0)), 0.0, 0.0)").y,
        0);
    EXPECT_EQ(value("common/height_cell.glsl", "vec4(first_closing(a.xyz), vec3(0.0))").x, 0);
    EXPECT_EQ(
        value("14_adaptive_displacement/task.glsl", "vec4(level_by_size(a.xyz, a.xyz, a.xyz, 1000.0, 8.0), vec3(0.0))")
            .x,
        1)
        << "0 / 0";
}

}  // namespace
}  // namespace relief
