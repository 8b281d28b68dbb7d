#include "framework/staff/reference/height_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "framework/core/base/error.h"
#include "framework/core/base/text.h"

namespace relief {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool is_finite(glm::dvec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Cells are numbered by their lower left texel. With clamping, all cells beyond a border equal cell -1 or the last
/// cell: they are level across the border.
int64_t wrapped(int64_t index, int side, bool wraps) {
    if (!wraps) return std::clamp<int64_t>(index, -1, side - 1);
    const int64_t rest = index % side;
    return rest < 0 ? rest + side : rest;
}

/// The path of a ray through the cells along one axis.
class AxisWalk {
public:
    AxisWalk(double origin, double along, double now, int side, bool wraps)
        : origin_(origin),
          inverse_(along == 0 ? infinity : 1 / along),
          step_(along < 0 ? -1 : 1),
          side_(side),
          wraps_(wraps),
          cell_(int64_t(std::floor(now))),
          stored_(wrapped(cell_, side, wraps)) {}

    int64_t cell() const { return cell_; }
    int64_t stored() const { return stored_; }  ///< index of the cell in the map
    /// t at which the ray leaves the cell. Computed from the line itself, not from the previous t, so errors do not
    /// accumulate.
    double t() const { return std::isinf(inverse_) ? infinity : (double(cell_ + (step_ > 0)) - origin_) * inverse_; }
    void enter_next() {
        cell_ += step_;
        if (!wraps_)
            stored_ = wrapped(cell_, side_, false);
        else if (step_ > 0)
            stored_ = stored_ + 1 == side_ ? 0 : stored_ + 1;
        else
            stored_ = stored_ == 0 ? side_ - 1 : stored_ - 1;
    }

private:
    double origin_, inverse_;
    int step_, side_;
    bool wraps_;
    int64_t cell_, stored_;
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

size_t HeightField::place_of(glm::dvec2 corner) const {
    return place(wrapped(int64_t(corner.x), size_.x, wraps_), wrapped(int64_t(corner.y), size_.y, wraps_));
}

HeightCell HeightField::cell(size_t place) const {
    const double* const lower = padded_.data() + place;
    const double* const upper = lower + size_.x + 2;
    return {lower[0], lower[1], upper[0], upper[1]};
}

double HeightField::height(glm::dvec2 texel) const {
    const glm::dvec2 at = texel - 0.5, corner = glm::floor(at);
    return height_in_cell(cell(place_of(corner)), at - corner);
}

glm::dvec2 HeightField::slope(glm::dvec2 texel) const {
    const glm::dvec2 at = texel - 0.5, corner = glm::floor(at);
    return slope_in_cell(cell(place_of(corner)), at - corner);
}

glm::dvec2 HeightField::central_slope(glm::dvec2 texel) const {
    const glm::dvec2 right(1, 0), up(0, 1);
    return {(height(texel + right) - height(texel - right)) / 2, (height(texel + up) - height(texel - up)) / 2};
}

std::optional<HeightField::Stretch> HeightField::stretch_of(const Ray& ray, double t_end, double bend) const {
    if (!is_finite(ray.origin) || !is_finite(ray.direction) || !(t_end >= 0)) return {};
    if (!(bend >= 0) || (bend > 0 && std::isinf(t_end))) return {};
    const glm::dvec3 along = ray.direction;
    Stretch stretch{0, t_end};
    const double above = ray.origin.z - highest_;
    if (bend > 0) {
        // The ray may turn before it is low enough and rise from then on, so its whole range is walked.
    } else if (along.z < 0) {
        stretch.begin = std::max(0.0, above / -along.z);
        const double slack = 1e-12 * (1 + std::abs(lowest_) + std::abs(ray.origin.z));
        stretch.end = std::min(t_end, std::max(stretch.begin, (ray.origin.z - lowest_ + slack) / -along.z));
    } else {
        if (above > 0) return {};
        if (along.z > 0) stretch.end = std::min(t_end, -above / along.z);
    }
    if (along == glm::dvec3(0)) stretch.end = stretch.begin;
    if (stretch.begin > stretch.end) return {};
    return stretch;
}

std::optional<HeightField::Hit> HeightField::first_hit(const Ray& ray, double t_end, double bend) const {
    const auto stretch = stretch_of(ray, t_end, bend);
    if (!stretch) return {};
    const glm::dvec3 along = ray.direction;
    double t0 = stretch->begin;

    // Use coordinates relative to the tile in which the walk starts, to keep precision far from the origin. Cells begin
    // at texel centres.
    glm::dvec2 tile(0);
    if (wraps_)
        tile = glm::floor((glm::dvec2(ray.origin) + t0 * glm::dvec2(along)) / glm::dvec2(size_)) * glm::dvec2(size_);
    const glm::dvec3 origin(glm::dvec2(ray.origin) - tile - 0.5, ray.origin.z);
    const auto at = [&](double t) { return origin + t * along + glm::dvec3(0, 0, bend * t * t); };
    glm::dvec3 from = at(t0);
    if (!is_finite(from) || !(std::abs(from.x) + std::abs(from.y) < 1e15)) return {};

    AxisWalk across_u(origin.x, along.x, from.x, size_.x, wraps_), across_v(origin.y, along.y, from.y, size_.y, wraps_);
    double t_u = across_u.t(), t_v = across_v.t();
    for (int64_t count = 1;; ++count) {
        const double t1 = std::min({std::max(t0, std::min(t_u, t_v)), stretch->end});
        const glm::dvec3 to = at(t1);
        const size_t here = place(across_u.stored(), across_v.stored());
        const double sag =
            bend * (t1 - t0) * (t1 - t0) / 2;  // the bent ray sags by at most half of this below its chord
        if (std::min(from.z, to.z) - sag <= tops_[here]) {
            const glm::dvec3 corner(across_u.cell(), across_v.cell(), 0);
            Gap gap = gap_above_cell(cell(here), from - corner, to - corner);
            gap.middle -= sag;
            if (closes(gap)) {
                const double t = t0 + (t1 - t0) * first_closing(gap);
                return Hit{t, glm::dvec2(at(t)) + 0.5 + tile, count};
            }
        }
        if (t1 >= stretch->end) return {};
        if (double(count) > max_cells) {
            const double cells = (std::abs(along.x) + std::abs(along.y)) * (stretch->end - stretch->begin);
            throw Error(fmt::format("a ray crosses {} cells of a height map; the limit is {}", rounded(cells),
                                    rounded(max_cells)));
        }
        t0 = t1;
        from = to;
        if (t_u <= t_v) {
            across_u.enter_next();
            t_u = across_u.t();
        } else {
            across_v.enter_next();
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
