// A height map as a bilinear surface, in double precision: height, slope, and the first hit of a ray. The reference for
// the shaders' searches.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "framework/core/base/ray.h"
#include "framework/core/image/image.h"
#include "framework/staff/reference/height_cell.h"

namespace relief {

/// The bilinear surface through the texel centres. Positions are in texels, with (0, 0) at the lower left corner of the
/// map and v upwards. The first texel of the lowest row has its centre at (0.5, 0.5), and uv = texels / size. Beyond
/// the border the map repeats (`wraps`), or the border texels are repeated.
class HeightField {
public:
    /// `heights` has one channel, row 0 at the top. Throws Error if it is empty or a height is not finite.
    HeightField(const Image& heights, bool wraps);

    glm::ivec2 size() const { return size_; }
    double lowest() const { return lowest_; }
    double highest() const { return highest_; }

    double height(glm::dvec2 texel) const;
    /// Returns (dh/du, dh/dv) per texel. On the border of two cells, takes the slope of the cell to the right or above.
    glm::dvec2 slope(glm::dvec2 texel) const;

    /// Returns (dh/du, dh/dv) per texel by central differences of the interpolated surface over two texels. These are
    /// the slopes of a normal map made with central differences, also between its texels.
    glm::dvec2 central_slope(glm::dvec2 texel) const;

    struct Hit {
        double t;          ///< in multiples of the ray's direction
        glm::dvec2 texel;  ///< not wrapped: may lie beyond the border
        int64_t cells;     ///< number of visited cells
    };
    /// Returns the first point with t in [0, t_end] at which the ray is on or below the surface. The ray's x and y are
    /// in texels, z is a height. If the ray starts on or below the surface, the result is its origin. Returns nothing
    /// if there is no such point, or if the ray is not finite.
    ///
    /// The walk from cell to cell (Amanatides and Woo 1987) solves one quadratic per cell; its error is about 1e-13
    /// texels. Throws Error if the ray would cross more than max_cells, as a horizontal ray can.
    ///
    /// `bend` (at least 0) adds bend t² to the ray's height, as over a base that curves away from its tangent plane.
    /// t_end must then be finite.
    std::optional<Hit> first_hit(const Ray& ray, double t_end, double bend = 0) const;
    static constexpr double max_cells = 1 << 24;

    /// Returns whether a light in `direction` (x and y in texels, z a height) is visible from the surface at `texel`.
    /// Grazing light passes: the ray starts above the surface by 1e-10 of the map's range, or of its highest height if
    /// that is more. Light from the horizon or below is always blocked, because the map has no end.
    bool is_lit(glm::dvec2 texel, glm::dvec3 direction) const;

private:
    size_t place_of(glm::dvec2 corner) const;
    /// The part of a ray that can hit: from the highest height to a little below the lowest one.
    struct Stretch {
        double begin, end;
    };
    std::optional<Stretch> stretch_of(const Ray& ray, double t_end, double bend) const;
    size_t place(int64_t column, int64_t row) const { return size_t((row + 1) * (size_.x + 2) + column + 1); }
    HeightCell cell(size_t place) const;

    glm::ivec2 size_;
    bool wraps_;
    double lowest_, highest_;
    // Row 0 is the lowest. A border of one texel all around makes the corners of every cell neighbours in memory.
    std::vector<double> padded_;
    std::vector<double> tops_;  ///< the highest corner of each cell, at the same indices: enough to reject most cells
};

}  // namespace relief
