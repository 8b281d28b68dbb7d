#include "wall.h"

#include <algorithm>
#include <cmath>

#include "clip.h"
#include "framework/core/image/mips.h"
#include "levels.h"

namespace relief::budget {
namespace {

constexpr float flat_lean = 0.05f;  // length of the xy of a normal that counts as flat: 3 degrees

/// Returns the x of the borders between patches, rising. Patches are a metre wide at the eye's foot (`foot`). Farther
/// away their width is two fifths of their distance from it. Borders are at whole metres, so that they stay in place
/// while the eye moves.
std::vector<double> lines(double foot) {
    const double low = wall_low.x, high = wall_high.x, begin = std::floor(std::clamp(foot, low, high));
    std::vector<double> all{low, high};
    for (double up = begin; up < high; up += std::max(1.0, std::floor(0.4 * (up - begin))))
        if (up > low) all.push_back(up);
    for (double down = begin; down > low; down -= std::max(1.0, std::floor(0.4 * (begin - down))))
        if (down < high) all.push_back(down);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

/// The camera of a frame.
struct Projection {
    explicit Projection(const Frame& frame)
        : eye(frame.camera.eye()),
          clip_from_world(frame.camera.clip_from_world()),
          along(clip_from_world * glm::dvec4(0, 0, 1, 0)),
          half_size(glm::dvec2(frame.size) / 2.0) {}

    /// Returns the speed of a point's pixel when the point moves along the normal, in pixels, times the distance ahead.
    glm::dvec2 run(const glm::dvec4& clip) const {
        return half_size * (glm::dvec2(along) - glm::dvec2(clip) / clip.w * along.w);
    }

    glm::dvec3 eye;
    glm::dmat4 clip_from_world;
    glm::dvec4 along;  ///< a metre along the wall's normal, in clip space
    glm::dvec2 half_size;
};

/// Returns the polygon of a patch that is in the picture, empty if there is none. The picture is grown by a pixel on
/// each side, for samples that are not at the centres of pixels.
std::vector<ClipCorner> seen_of(const Patch& patch, const FrameBudget& budget) {
    const glm::dmat4 clip_from_world = budget.frame.camera.clip_from_world();
    std::vector<ClipCorner> polygon;
    for (const glm::dvec2 place : {patch.low, {patch.high.x, patch.low.y}, patch.high, {patch.low.x, patch.high.y}})
        polygon.push_back({place, clip_from_world * glm::dvec4(place, 0, 1)});
    return clipped(std::move(polygon), 1.0 + 2.0 / glm::dvec2(glm::max(budget.frame.size, 1)));
}

struct Interval {
    double min, max;
};

/// Bounds of the pixels of a patch.
struct Bounds {
    Interval pixels_per_metre;  ///< along the normal
    Interval reach;             ///< of a view ray in the relief: metres along the wall per metre of depth
    Interval ahead;             ///< distances along the line of sight, metres
    bool may_leave;             ///< a ray may leave the wall
};

/// Returns the bounds of the pixels in the polygon `seen`, which is not empty. When a place moves along the normal, its
/// pixel moves by the length of a vector (a run) times the inverse distance ahead. The inverse distance and the run are
/// linear on the screen. So the inverse distance and the length of the run have their maxima at corners.
Bounds bounds_of(const std::vector<ClipCorner>& seen, const FrameBudget& budget) {
    const Projection projection(budget.frame);
    const glm::dvec3 eye = projection.eye;
    Bounds bounds{{0, 0}, {0, 0}, {INFINITY, 0}, false};
    std::vector<glm::dvec2> runs;
    glm::dvec2 sum(0), low(INFINITY), high(-INFINITY);
    for (const auto& [place, clip] : seen) {
        bounds.ahead = {std::min(bounds.ahead.min, clip.w), std::max(bounds.ahead.max, clip.w)};
        bounds.reach.max = std::max(bounds.reach.max, glm::distance(place, glm::dvec2(eye)) / eye.z);
        runs.push_back(projection.run(clip));
        sum += runs.back();
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
    bounds.reach.min = glm::distance(glm::clamp(glm::dvec2(eye), low, high), glm::dvec2(eye)) / eye.z;
    const double reach = bounds.reach.max * budget.scale;
    bounds.may_leave =
        glm::any(glm::lessThan(low - reach, wall_low)) || glm::any(glm::greaterThan(high + reach, wall_high));
    // A run is at least as long as its projection on their mean direction, which has its minimum at a corner.
    const glm::dvec2 mean = glm::length(sum) > 0 ? glm::normalize(sum) : glm::dvec2(1, 0);
    Interval run{INFINITY, 0};
    for (const glm::dvec2& one : runs)
        run = {std::min(run.min, std::max(0.0, glm::dot(one, mean))), std::max(run.max, glm::length(one))};
    bounds.pixels_per_metre = {run.min / bounds.ahead.max, run.max / bounds.ahead.min};
    return bounds;
}

/// Returns the last level whose error is at most `max_error`, or -1 if there is none. Errors are non-decreasing.
double whole_level(const std::vector<float>& errors, double max_error) {
    return double(std::upper_bound(errors.begin(), errors.end(), float(max_error)) - errors.begin()) - 1;
}

/// Returns all methods that pixels of the patch may choose. The result is conservative: `slack` allows shaders a
/// rounding error of a thousandth.
Methods methods_of(const Bounds& bounds, const FrameBudget& budget, const MapErrors& maps) {
    const double range = double(maps.range.y - maps.range.x), slack = 1.001;
    const auto tolerance = [&](double pixels) { return budget.pixels / std::max(pixels * budget.scale, 1e-30); };
    const Interval tolerated{tolerance(bounds.pixels_per_metre.max), tolerance(bounds.pixels_per_metre.min)};
    Methods methods = 0;
    if (2 * budget.thinning * tolerated.max * slack >= range) {
        const auto level = [&](double ahead) {
            return std::max(0.0, first_level(budget, maps) + 1.5 * std::log2(ahead)) + std::log2(budget.pixels);
        };
        if (level(bounds.ahead.min) < double(maps.flat_level) + 1e-3) methods |= bit(normal_map);
        if (level(bounds.ahead.max) > double(maps.flat_level) - 1e-3) methods |= bit(plain);
    }
    if (2 * budget.thinning * tolerated.min > range * slack) return methods;
    const auto taps = [&](double reach, double max_error, double rounding) {
        const double off = budget.precision * max_error;
        if (off * rounding < double(maps.levels[0])) return 1e30;
        const double left = std::max(0.0, range - 2 * budget.thinning * max_error);
        return std::max(
            1.0, left * reach * budget.scale * maps.texels / std::exp2(whole_level(maps.levels, off * rounding)));
    };
    if (taps(bounds.reach.min, tolerated.max, slack) <= budget.exact_taps * slack) methods |= bit(parallax);
    if (taps(bounds.reach.max, tolerated.min, 1 / slack) * slack >= budget.exact_taps) methods |= bit(exact);
    return methods;
}

/// Returns whether triangles for the patch take less time than the search in its pixels.
bool is_better_displaced(const Patch& patch, const std::vector<ClipCorner>& seen, const Bounds& bounds,
                         const FrameBudget& budget, const MapErrors& maps) {
    if (!(patch.methods & (bit(parallax) | bit(exact)))) return false;
    const glm::dvec2 size = patch.high - patch.low;
    double pixels = 0;  // twice the visible area in clip coordinates, then the area in pixels
    for (size_t i = 0; i < seen.size(); ++i) {
        const glm::dvec4 &a = seen[i].clip, &b = seen[(i + 1) % seen.size()].clip;
        pixels += glm::determinant(glm::dmat2(glm::dvec2(a) / a.w, glm::dvec2(b) / b.w));
    }
    pixels = std::abs(pixels) / 2 * budget.frame.size.x * budget.frame.size.y / 4;
    const auto pays = [&](double side) {  // `side` is that of a square of two triangles
        return 2 * size.x * size.y / (side * side) * budget.triangle_taps < pixels * budget.exact_taps;
    };
    if (!pays(cell_metres)) return false;
    const double off = budget.precision * budget.pixels / (bounds.pixels_per_metre.max * budget.scale);
    const double side = std::exp2(whole_level(maps.pieces(), off)) / maps.texels;
    return side * 64 >= cell_metres && pays(std::min(side, cell_metres));  // the tessellator's limit is 64
}

/// A displaced cell: the highest level of its edges, and its distance from the eye in metres.
struct Cell {
    double level, away;
};

/// Returns the cell whose lower corner is `low`. Its level is the one that shaders/17_time_and_error/wall.tesc chooses
/// at the corner that needs the highest.
Cell cell_at(const glm::dvec2& low, const Projection& projection, const FrameBudget& budget, const MapErrors& maps) {
    Cell cell{1, INFINITY};
    double pixels = 0;
    bool is_before = false, is_behind = false;
    for (const glm::dvec2 corner : {glm::dvec2(0, 0), {cell_metres, 0}, {cell_metres, cell_metres}, {0, cell_metres}}) {
        const glm::dvec3 place(low + corner, 0);
        const glm::dvec4 clip = projection.clip_from_world * glm::dvec4(place, 1);
        cell.away = std::min(cell.away, glm::distance(projection.eye, place));
        (clip.w > 0 ? is_before : is_behind) = true;
        if (clip.w > 0) pixels = std::max(pixels, glm::length(projection.run(clip)) / clip.w);
    }
    if (is_before) cell.level = 64;
    if (!is_before || is_behind) return cell;
    const double tolerance = budget.pixels / std::max(pixels * budget.scale, 1e-30);
    const double side = std::exp2(whole_level(maps.pieces(), budget.precision * tolerance)) / maps.texels;
    cell.level = 2 * budget.thinning * tolerance >= double(maps.range.y - maps.range.x)
                     ? 1
                     : std::exp2(std::ceil(std::log2(std::clamp(cell_metres / side, 1.0, 64.0))));
    return cell;
}

}  // namespace

MapErrors::MapErrors(const Image& heights, const Image& normals)
    : texels(heights.width), normal_texels(normals.width), heights_(heights) {
    const auto [low, high] = std::minmax_element(heights.values.begin(), heights.values.end());
    range = {*low, *high};
    levels = level_errors(heights, (*high - *low) / 2);
    levels.resize(std::min(levels.size(), most_levels));
    const std::vector<Image> mips = mip_chain(normals, ColorSpace::linear);
    const auto normal = [](const float* stored) { return glm::vec3(stored[0], stored[1], stored[2]) * 2.0f - 1.0f; };
    for (size_t level = mips.size(); level-- > 0;) {
        float lean = 0;
        for (size_t i = 0; i < mips[level].pixel_count(); ++i)
            lean = std::max(lean, glm::length(glm::vec2(normal(&mips[level].values[i * 3]))));
        if (lean > flat_lean) break;
        flat_level = float(level);
    }
    flat_normal = normal(mips.back().values.data());
}

const std::vector<float>& MapErrors::pieces() const {
    if (pieces_.empty()) {
        pieces_ = piece_errors(heights_, (range.y - range.x) / 2);
        pieces_.resize(std::min(pieces_.size(), most_levels));
    }
    return pieces_;
}

double first_level(const FrameBudget& budget, const MapErrors& maps) {
    const Frame& frame = budget.frame;
    const double pixels = frame.size.y / (2 * std::tan(glm::radians(frame.camera.orbit().field_of_view) / 2));
    return std::log2(maps.normal_texels / pixels / std::sqrt(std::max(frame.camera.eye().z, 1e-6)));
}

std::vector<Patch> patches_for(const FrameBudget& budget, const MapErrors& maps) {
    const glm::dvec3 eye = budget.frame.camera.eye();
    std::vector<Patch> patches, displaced;
    if (eye.z <= 0) return patches;  // the wall has no back
    const std::vector<double> columns = lines(eye.x);
    for (size_t i = 0; i + 1 < columns.size(); ++i) {
        Patch patch{{columns[i], wall_low.y}, {columns[i + 1], wall_high.y}, 0, false};
        if (const std::vector<ClipCorner> seen = seen_of(patch, budget); !seen.empty()) {
            const Bounds bounds = bounds_of(seen, budget);
            patch.methods = methods_of(bounds, budget, maps), patch.may_leave = bounds.may_leave;
            if (is_better_displaced(patch, seen, bounds, budget, maps)) {
                patch.methods = bit(displacement);
                const double reach = bounds.reach.max * budget.scale;
                displaced.push_back({patch.low - reach, patch.high + reach, 0, false});
            }
        }
        patches.push_back(patch);
    }
    for (Patch& patch : patches)
        for (const Patch& other : displaced)
            patch.behind |=
                patch.methods != bit(displacement) && patch.low.x < other.high.x && other.low.x < patch.high.x;
    return patches;
}

double finest_reach(const FrameBudget& budget, const MapErrors& maps, const std::vector<glm::vec2>& cells) {
    if (2 * 64.0 * 64.0 * double(cells.size() / 4) <= most_triangles) return INFINITY;
    const Projection projection(budget.frame);
    std::vector<Cell> all;
    for (size_t i = 0; i < cells.size(); i += 4) all.push_back(cell_at(glm::dvec2(cells[i]), projection, budget, maps));
    const auto triangles = [&](double reach) {
        double sum = 0;
        for (const auto& [level, away] : all) {
            const double cut = std::min(level, std::max(1.0, 64 * reach / std::max(away, 1e-9)));
            sum += 2 * cut * cut;
        }
        return sum;
    };
    if (triangles(INFINITY) <= most_triangles) return INFINITY;
    double reach = 1024;  // longer than the wall
    while (reach > 1e-3 && triangles(reach) > most_triangles) reach /= 1.25;
    return reach;
}

std::vector<Patch> joined(const std::vector<Patch>& patches) {
    std::vector<Patch> joined;
    for (const Patch& patch : patches) {
        if (patch.methods == 0 && !patch.behind) continue;
        if (!joined.empty() && joined.back().high.x == patch.low.x && joined.back().methods == patch.methods &&
            joined.back().behind == patch.behind) {
            joined.back().high.x = patch.high.x;
            joined.back().may_leave |= patch.may_leave;
        } else {
            joined.push_back(patch);
        }
    }
    return joined;
}

std::map<Group, std::vector<glm::vec2>> groups_of(const std::vector<Patch>& patches, bool with_behind) {
    std::map<Group, std::vector<glm::vec2>> groups;
    for (const Patch& patch : patches) {
        const glm::vec2 low(patch.low), high(patch.high), lower_right(high.x, low.y), upper_left(low.x, high.y);
        const bool is_displaced = patch.methods == bit(displacement);
        if (patch.methods != 0 && !is_displaced) {
            std::vector<glm::vec2>& corners = groups[{patch.methods, patch.may_leave}];
            corners.insert(corners.end(), {low, lower_right, high, low, high, upper_left});
        }
        if (!is_displaced && !(patch.behind && with_behind)) continue;
        std::vector<glm::vec2>& corners = groups[{bit(displacement), false}];
        for (double x = patch.low.x; x < patch.high.x; x += cell_metres)
            for (double y = patch.low.y; y < patch.high.y; y += cell_metres)
                for (const glm::dvec2 corner :
                     {glm::dvec2(0, 0), {cell_metres, 0}, {cell_metres, cell_metres}, {0, cell_metres}})
                    corners.push_back(glm::dvec2(x, y) + corner);
    }
    return groups;
}

}  // namespace relief::budget
