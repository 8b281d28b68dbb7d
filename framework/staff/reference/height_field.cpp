#include "framework/staff/reference/height_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "framework/base/error.h"
#include "framework/base/text.h"

namespace relief {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool is_finite(glm::dvec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Where a ray crosses the lines between the cells along one axis.
struct Crossings {
    double origin, inverse;
    int step;
    int64_t next;  ///< the line to be crossed

    Crossings(double from, double along, double now)
        : origin(from), inverse(along == 0 ? infinity : 1 / along), step(along < 0 ? -1 : 1) {
        const double place = std::floor(now);
        next = static_cast<int64_t>(place) + (step > 0);
    }
    // Each from the line itself, not from the one before: nothing adds up.
    double t() const { return std::isinf(inverse) ? infinity : (static_cast<double>(next) - origin) * inverse; }
};

}  // namespace

HeightField::HeightField(const Image& heights, bool wraps) : size_(heights.width, heights.height), wraps_(wraps) {
    if (heights.pixel_count() == 0 || heights.channels != 1)
        throw Error(fmt::format("a height map has one channel and at least one texel; this is {}x{} with {}",
                                heights.width, heights.height, heights.channels));
    for (size_t i = 0; i < heights.values.size(); ++i)
        if (!std::isfinite(heights.values[i]))
            throw Error(
                fmt::format("the height in column {}, row {} is not finite", i % heights.width, i / heights.width));
    const auto [low, high] = std::minmax_element(heights.values.begin(), heights.values.end());
    lowest_ = *low, highest_ = *high;
    padded_.reserve(size_t(size_.x + 2) * (size_.y + 2));
    for (int row = -1; row <= size_.y; ++row)
        for (int column = -1; column <= size_.x; ++column) {
            const auto inside = [&](int i, int n) { return wraps ? (i + n) % n : std::clamp(i, 0, n - 1); };
            padded_.push_back(*heights.pixel(inside(column, size_.x), size_.y - 1 - inside(row, size_.y)));
        }
    tops_.resize(padded_.size());
    for (int row = -1; row < size_.y; ++row)
        for (int column = -1; column < size_.x; ++column) tops_[place(column, row)] = cell(place(column, row)).top();
}

/// Cells are numbered by their lower left texel. Beyond a border that is clamped they are all like cell -1, or the last
/// one: level across the border.
int64_t HeightField::wrapped(int64_t index, int side) const {
    if (!wraps_) return std::clamp<int64_t>(index, -1, side - 1);
    const int64_t rest = index % side;
    return rest < 0 ? rest + side : rest;
}

HeightCell HeightField::cell(size_t place) const {
    const double* const lower = padded_.data() + place;
    const double* const upper = lower + size_.x + 2;
    return {lower[0], lower[1], upper[0], upper[1]};
}

double HeightField::height(glm::dvec2 texel) const {
    const glm::dvec2 at = texel - 0.5, corner = glm::floor(at);
    return height_in_cell(cell(place(wrapped(int64_t(corner.x), size_.x), wrapped(int64_t(corner.y), size_.y))),
                          at - corner);
}

glm::dvec2 HeightField::slope(glm::dvec2 texel) const {
    const glm::dvec2 at = texel - 0.5, corner = glm::floor(at);
    return slope_in_cell(cell(place(wrapped(int64_t(corner.x), size_.x), wrapped(int64_t(corner.y), size_.y))),
                         at - corner);
}

glm::dvec2 HeightField::central_slope(glm::dvec2 texel) const {
    const glm::dvec2 right(1, 0), up(0, 1);
    return {(height(texel + right) - height(texel - right)) / 2, (height(texel + up) - height(texel - up)) / 2};
}

std::optional<HeightField::Hit> HeightField::first_hit(const Ray& ray, double t_end, double bend) const {
    if (!is_finite(ray.origin) || !is_finite(ray.direction) || !(t_end >= 0)) return {};
    if (!(bend >= 0) || (bend > 0 && std::isinf(t_end))) return {};
    const glm::dvec3 along = ray.direction;

    // Above the highest height nothing can be hit; a little below the lowest one everything has been.
    double t0 = 0, t_stop = t_end;
    const double above = ray.origin.z - highest_;
    if (bend > 0) {
        // It may turn before it is low enough, and rise for ever after: every cell is looked at.
    } else if (along.z < 0) {
        t0 = std::max(0.0, above / -along.z);
        const double slack = 1e-12 * (1 + std::abs(lowest_) + std::abs(ray.origin.z));
        t_stop = std::min(t_stop, std::max(t0, (ray.origin.z - lowest_ + slack) / -along.z));
    } else {
        if (above > 0) return {};
        if (along.z > 0) t_stop = std::min(t_stop, -above / along.z);
    }
    if (along == glm::dvec3(0)) t_stop = t0;
    if (t0 > t_stop) return {};

    // From the tile that the walk begins in: far from it a place would lose its digits. Cells begin at texel centres.
    glm::dvec2 tile(0);
    if (wraps_)
        tile = glm::floor((glm::dvec2(ray.origin) + t0 * glm::dvec2(along)) / glm::dvec2(size_)) * glm::dvec2(size_);
    const glm::dvec3 origin(glm::dvec2(ray.origin) - tile - 0.5, ray.origin.z);
    const auto at = [&](double t) { return origin + t * along + glm::dvec3(0, 0, bend * t * t); };
    const double cells = (std::abs(along.x) + std::abs(along.y)) * (t_stop - t0);
    const glm::dvec3 first = at(t0);
    if (!is_finite(first) || !(std::abs(first.x) + std::abs(first.y) < 1e15)) return {};

    Crossings across_u(origin.x, along.x, first.x), across_v(origin.y, along.y, first.y);
    int64_t column = int64_t(std::floor(first.x)), row = int64_t(std::floor(first.y));
    int64_t stored_column = wrapped(column, size_.x), stored_row = wrapped(row, size_.y);
    const auto enter_next = [&](int64_t& index, int64_t& stored, Crossings& lines, int side) {
        index += lines.step, lines.next += lines.step;
        if (!wraps_)
            stored = wrapped(index, side);
        else if (lines.step > 0)
            stored = stored + 1 == side ? 0 : stored + 1;
        else
            stored = stored == 0 ? side - 1 : stored - 1;
    };

    glm::dvec3 from = first;
    double t_u = across_u.t(), t_v = across_v.t();
    for (int64_t count = 1;; ++count) {
        const double t1 = std::min({std::max(t0, std::min(t_u, t_v)), t_stop});
        const glm::dvec3 to = at(t1);
        const size_t here = place(stored_column, stored_row);
        const double sag =
            bend * (t1 - t0) * (t1 - t0) / 2;  // between its ends a ray that bends is lower by half of it
        if (std::min(from.z, to.z) - sag <= tops_[here]) {
            const glm::dvec3 corner(column, row, 0);
            Gap gap = gap_above_cell(cell(here), from - corner, to - corner);
            gap.middle -= sag;
            if (closes(gap)) {
                const double t = t0 + (t1 - t0) * first_closing(gap);
                return Hit{t, glm::dvec2(at(t)) + 0.5 + tile, count};
            }
        }
        if (t1 >= t_stop) return {};
        if (double(count) > max_cells)
            throw Error(fmt::format("a ray crosses {} cells of a height map; the limit is {}", rounded(cells),
                                    rounded(max_cells)));
        t0 = t1, from = to;
        if (t_u <= t_v) {
            enter_next(column, stored_column, across_u, size_.x);
            t_u = across_u.t();
        } else {
            enter_next(row, stored_row, across_v, size_.y);
            t_v = across_v.t();
        }
    }
}

bool HeightField::is_lit(glm::dvec2 texel, glm::dvec3 direction) const {
    if (!(direction.z > 0)) return false;
    const double lift = 1e-10 * std::max({highest_ - lowest_, std::abs(highest_), 1e-100});
    return !first_hit({{texel, height(texel) + lift}, direction}, infinity);
}

}  // namespace relief
