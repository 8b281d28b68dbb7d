#include "framework/course/web/tessellator.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>

namespace relief::web {
namespace {

// Lengths are numbers of 2^-16, and products of two are rounded.
constexpr int64_t one = 1 << 16, half = one / 2;
int64_t product(int64_t a, int64_t b) { return (a * b + half) / one; }

constexpr float smallest_above_one = 1.0f + 1.0f / float(one);

/// The points along one axis of a patch.
class Axis {
public:
    Axis() = default;
    /// `level` is within the range of its spacing, and is an even number of segments or, if `odd`, an odd one. Between
    /// such numbers, two segments are shorter than the rest.
    Axis(float level, bool odd) : odd_(odd) {
        int64_t halves = (std::lrint(level * float(one)) + 1) / 2;
        if (odd || halves == half) halves += half;
        const int64_t fewer = halves / one, more = (halves + one - 1) / one;
        half_count_ = int(more);
        fraction_ = halves % one;
        const auto segment = [&](int64_t count) {
            const int64_t segments = 2 * count - odd;
            return (one + segments / 2) / segments;
        };
        fewer_segment_ = segment(fewer), more_segment_ = segment(more);
        short_segment_ = fewer == more ? half_count_ + 1 : index_of_short_segment(int(fewer));
    }

    bool is_odd() const { return odd_; }
    int count() const { return 2 * half_count_ + !odd_; }  ///< points, with both ends
    int segments_of_half() const { return half_count_ - odd_; }

    int64_t place(int point) const {
        const bool is_second_half = point >= half_count_;
        if (is_second_half) point = 2 * half_count_ - odd_ - point;
        if (point == half_count_) return half;  // the middle
        const int64_t among_fewer = (point > short_segment_ ? point - 1 : point) * fewer_segment_;
        const int64_t among_more = point * more_segment_;
        const int64_t place = (among_fewer * (one - fraction_) + among_more * fraction_ + half) / one;
        return is_second_half ? one - place : place;
    }

private:
    /// Returns which segment of the first half grows from nothing: the bits below the highest one, in steps of two.
    int index_of_short_segment(int fewer) const {
        if (odd_ && fewer == 1) return 0;
        const int number = odd_ ? fewer - 1 : fewer;
        return 2 * (number - int(std::bit_floor(unsigned(number)))) + 1;
    }

    bool odd_ = false;
    int half_count_ = 0;    ///< points of the first half, without the middle
    int64_t fraction_ = 0;  ///< 0: as many segments as the next lower number; 1: as the next higher one
    int64_t fewer_segment_ = 0, more_segment_ = 0;  ///< lengths
    int short_segment_ = 0;
};

/// The points of one side of a ring, in the direction in which all sides run around.
using Side = std::vector<uint32_t>;
using Ring = std::vector<Side>;

class Tessellator {
public:
    Tessellator(int corners, TessellationSpacing spacing) : corners_(corners), spacing_(spacing) {}

    Tessellation divided(const TessellationLevels& levels) {
        const auto outer_end = levels.outer.begin() + corners_,
                   inner_end = levels.inner.begin() + (corners_ == 4 ? 2 : 1);
        if (!std::all_of(levels.outer.begin(), outer_end, [](float level) { return level > 0; })) return {};
        const bool is_even = spacing_ == TessellationSpacing::fractional_even;
        const bool is_odd = spacing_ == TessellationSpacing::fractional_odd;
        const float lowest = is_even ? 2 : 1, highest = is_odd ? 63 : 64;
        const auto clamped = [&](float level, float low) {
            level = level > low ? std::min(level, highest) : low;  // if it is not a number: low
            return is_even || is_odd ? level : std::ceil(level);
        };
        std::vector<float> outer, inner;
        std::transform(levels.outer.begin(), outer_end, std::back_inserter(outer),
                       [&](float level) { return clamped(level, lowest); });
        // If anything is divided, there is a ring of points inside.
        const auto is_divided = [](float level) { return level > 1.0f + 0.5f / float(one); };
        const bool has_ring = std::any_of(outer.begin(), outer.end(), is_divided) ||
                              std::any_of(levels.inner.begin(), inner_end, is_divided);
        const float lowest_inner = is_odd && has_ring ? smallest_above_one : lowest;
        std::transform(levels.inner.begin(), inner_end, std::back_inserter(inner),
                       [&](float level) { return clamped(level, lowest_inner); });
        if (!is_even && !has_ring) {
            add_whole_patch();
            return result_;
        }
        const auto is_axis_odd = [&](float level) { return is_odd || (!is_even && std::fmod(level, 2.0f) == 1); };
        for (const float level : outer) outer_.emplace_back(level, is_axis_odd(level));
        for (const float level : inner) inner_.emplace_back(level, level > 1 && is_axis_odd(level));
        if (corners_ == 4)
            divide_quad();
        else
            divide_triangle();
        return result_;
    }

private:
    uint32_t add(int64_t u, int64_t v) {
        const auto number = [](int64_t length) { return float(length) / float(one); };
        result_.points.emplace_back(number(u), number(v), corners_ == 3 ? number(one - u - v) : 0.0f);
        return uint32_t(result_.points.size() - 1);
    }
    /// Adds a triangle whose points run around as the sides do.
    void add_triangle(uint32_t a, uint32_t b, uint32_t c) { result_.triangles.push_back({a, b, c}); }

    void add_whole_patch() {
        if (corners_ == 4) {
            for (const auto& [u, v] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) add(u * one, v * one);
            add_triangle(0, 1, 3), add_triangle(1, 2, 3);
        } else {
            add(0, one), add(0, 0), add(one, 0);
            add_triangle(0, 1, 2);
        }
    }

    /// Returns the outermost ring. `place` has the coordinates of a point of a side by its distance from the side's
    /// end where the coordinate that varies is 0; the sides with `is_falling` begin at the other end.
    template <class IsFalling, class Place>
    Ring outer_ring(const IsFalling& is_falling, const Place& place) {
        Ring ring(outer_.size());
        for (size_t side = 0; side < ring.size(); ++side) {
            const Axis& axis = outer_[side];
            for (int i = 0; i < axis.count() - 1; ++i) {
                const auto [u, v] = place(side, axis.place(is_falling(side) ? axis.count() - 1 - i : i));
                ring[side].push_back(add(u, v));
            }
        }
        return closed(ring);
    }
    /// Ends each side with the first point of the next one.
    static Ring closed(Ring ring) {
        for (size_t side = 0; side < ring.size(); ++side) ring[side].push_back(ring[(side + 1) % ring.size()].front());
        return ring;
    }

    void join_outermost(const Ring& outer, const Ring& inner) {
        for (size_t side = 0; side < outer.size(); ++side)
            join(outer[side], outer_[side], inner[side], inner_[(side + 1) % inner_.size()]);
    }
    static bool is_falling_in_quad(size_t side) { return side == 0 || side == 3; }

    /// Sides run along u = 0, v = 0, u = 1 and v = 1, beginning at (0, 1).
    void divide_quad() {
        const Axis &along_u = inner_[0], &along_v = inner_[1];
        const int columns = std::max(along_u.count(), along_u.is_odd() ? 4 : 3);
        const int rows = std::max(along_v.count(), along_v.is_odd() ? 4 : 3);
        Ring outer = outer_ring(is_falling_in_quad, [](size_t side, int64_t place) {
            return side % 2 == 0 ? std::pair(side == 0 ? 0 : one, place) : std::pair(place, side == 1 ? 0 : one);
        });
        const auto first = uint32_t(result_.points.size());
        for (int row = 1; row < rows - 1; ++row)
            for (int column = 1; column < columns - 1; ++column) add(along_u.place(column), along_v.place(row));
        const auto at = [&](int column, int row) { return first + uint32_t((row - 1) * (columns - 2) + column - 1); };
        // Points from one end to another, which may be the same.
        const auto run = [](int begin, int end, const auto& point) {
            Side side;
            for (int i = begin; i != end; i += begin < end ? 1 : -1) side.push_back(point(i));
            side.push_back(point(end));
            return side;
        };
        const auto in_column = [&](int column) { return [&, column](int row) { return at(column, row); }; };
        const auto in_row = [&](int row) { return [&, row](int column) { return at(column, row); }; };
        const int rings = (std::min(columns, rows) + 1) / 2;
        for (int ring = 1; ring < rings; ++ring) {
            const int right = columns - 1 - ring, top = rows - 1 - ring;
            const Ring inner = {run(top, ring, in_column(ring)), run(ring, right, in_row(ring)),
                                run(ring, top, in_column(right)), run(right, ring, in_row(top))};
            if (ring == 1)
                join_outermost(outer, inner);
            else
                for (size_t side = 0; side < 4; ++side) join_parallel(outer[side], inner[side]);
            outer = inner;
        }
        // An odd number of segments leaves a row of quads in the middle.
        const int last = rings - 1;
        if (columns > rows && along_v.is_odd())
            join_strip(outer[1], run(last, columns - 1 - last, in_row(last + 1)), false);
        else if (rows >= columns && along_u.is_odd())
            join_strip(outer[0], run(rows - 1 - last, last, in_column(last + 1)), along_v.is_odd());
    }

    /// Sides run along u = 0, v = 0 and w = 0, beginning at v = 1.
    void divide_triangle() {
        const Axis& axis = inner_[0];
        const int count = std::max(axis.count(), axis.is_odd() ? 4 : 3);
        const auto is_falling = [](size_t side) { return side != 1; };
        Ring outer = outer_ring(is_falling, [](size_t side, int64_t place) {
            return side == 0 ? std::pair(int64_t(0), place) : std::pair(place, side == 1 ? 0 : one - place);
        });
        constexpr int64_t third = 0x5555, two_thirds = 0xaaaa;
        const int rings = (count + 1) / 2;
        for (int ring = 1; ring < rings; ++ring) {
            const int begin = ring, end = count - 1 - ring;
            const int64_t inwards = product(axis.place(ring), two_thirds);
            Ring inner(3);
            for (size_t side = 0; side < 3; ++side)
                for (int i = begin; i < end; ++i) {
                    const int64_t along = axis.place(is_falling(side) ? end - (i - begin) : i) - (inwards + 1) / 2;
                    inner[side].push_back(side == 0   ? add(inwards, along)
                                          : side == 1 ? add(along, inwards)
                                                      : add(along, one - along - inwards));
                }
            if (begin == end) {
                const uint32_t middle = add(third, third);
                inner = {{middle}, {middle}, {middle}};
            } else {
                inner = closed(inner);
            }
            if (ring == 1)
                join_outermost(outer, inner);
            else
                for (size_t side = 0; side < 3; ++side) join_parallel(outer[side], inner[side]);
            outer = inner;
        }
        if (axis.is_odd()) add_triangle(outer[0][0], outer[1][0], outer[2][0]);
    }

    /// Walks along two sides, and adds the triangle of each step.
    struct Walk {
        Tessellator& to;
        const Side &outer, &inner;
        size_t out = 0, in = 0;
        void step_out() { to.add_triangle(outer[out], outer[out + 1], inner[in]), ++out; }
        void step_in() { to.add_triangle(inner[in], outer[out], inner[in + 1]), ++in; }
    };

    /// Joins two sides, of which the inner one has two points less. The diagonals are symmetric.
    void join_parallel(const Side& outer, const Side& inner) {
        Walk walk{*this, outer, inner};
        walk.step_out();
        while (walk.in + 1 < inner.size()) {
            const bool is_first_half = walk.in < inner.size() / 2;
            if (is_first_half)
                walk.step_in(), walk.step_out();
            else
                walk.step_out(), walk.step_in();
        }
        walk.step_out();
    }

    /// Joins the two sides of a row of quads.
    void join_strip(const Side& outer, const Side& inner, bool turns_in_middle) {
        Walk walk{*this, outer, inner};
        while (walk.in + 1 < inner.size())
            if (turns_in_middle && walk.in == inner.size() / 2 - 1)
                walk.step_in(), walk.step_out();
            else
                walk.step_out(), walk.step_in();
    }

    /// Returns when a point of a half side came, if the number of segments grew from 1: halves before quarters.
    static int birth_of(int point) {
        if (point == 1) return 32;
        const int zeros = std::countr_zero(unsigned(point - 1));
        return (16 >> zeros) + ((point - 1) >> (zeros + 1));
    }

    /// Joins two sides of any two levels: both are walked along in the order in which their points come.
    void join(const Side& outer, const Axis& outer_axis, const Side& inner, const Axis& inner_axis) {
        Walk walk{*this, outer, inner};
        const int outs = outer_axis.segments_of_half(), ins = inner_axis.segments_of_half();
        if (outs > 0) walk.step_out();
        for (int point = 2; point <= 32; ++point) {
            if (birth_of(point) < ins) walk.step_in();
            if (birth_of(point) < outs) walk.step_out();
        }
        if (inner_axis.is_odd()) walk.step_in();
        if (outer_axis.is_odd()) walk.step_out();
        for (int point = 32; point >= 2; --point) {
            if (birth_of(point) < outs) walk.step_out();
            if (birth_of(point) < ins) walk.step_in();
        }
        if (outs > 0) walk.step_out();
    }

    int corners_;
    TessellationSpacing spacing_;
    Tessellation result_;
    std::vector<Axis> outer_, inner_;
};

}  // namespace

Tessellation tessellate(int corners, TessellationSpacing spacing, const TessellationLevels& levels) {
    return Tessellator(corners, spacing).divided(levels);
}

}  // namespace relief::web
