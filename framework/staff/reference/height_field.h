// A height map as a surface, in double precision: its height, its slope, and where a ray meets it
// first. The reference for the shaders' searches.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "framework/image/image.h"
#include "framework/mesh/ray.h"
#include "framework/staff/reference/height_cell.h"

namespace relief {

/// The bilinear surface through the texel centres. Places are in texels, (0, 0) at the lower left corner of the map, v
/// upwards: the centre of the lowest row's first texel is (0.5, 0.5), and uv = texels / size. Beyond the border the map
/// repeats, or keeps its last texel.
class HeightField {
public:
    /// One-channel heights, row 0 at the top. Throws Error when the map is empty or a height is not finite.
    HeightField(const Image& heights, bool wraps);

    glm::ivec2 size() const { return size_; }
    double lowest() const { return lowest_; }
    double highest() const { return highest_; }

    double height(glm::dvec2 texel) const;
    /// dh/du and dh/dv, per texel. On a line between two cells, of the cell to the right and above.
    glm::dvec2 slope(glm::dvec2 texel) const;

    /// Half the difference between the heights one texel further on and one texel back, of the interpolated surface:
    /// what a normal map of central differences has between its texels, too.
    glm::dvec2 central_slope(glm::dvec2 texel) const;

    struct Hit {
        double t;          ///< in lengths of the ray's direction
        glm::dvec2 texel;  ///< where, beyond the border too: not wrapped
        int64_t cells;     ///< how many cells were looked at
    };
    /// The first place with t in [0, t_end] at which the ray (x and y in texels, z in heights) is not above the
    /// surface: the ray's origin if that is on or below it. Nothing when there is none, or when the ray is not finite.
    /// The walk (Amanatides and Woo 1987) solves one quadratic a cell; its error is some 1e-13 texels. Throws Error
    /// when the ray would pass more than max_cells, as a level one can.
    ///
    /// `bend` (at least 0) adds bend t² to the ray's height, as over a base that falls away from its tangent plane.
    /// Then t_end must be finite.
    std::optional<Hit> first_hit(const Ray& ray, double t_end, double bend = 0) const;
    static constexpr double max_cells = 1 << 24;

    /// Whether nothing stands between the surface at `texel` and a light that lies towards `direction` (x and y in
    /// texels, z in heights). Light that only grazes the surface passes: the ray begins 1e-10 of the map's range (or
    /// of its highest height) above it. Light from the horizon or below never arrives: the map goes on for ever.
    bool is_lit(glm::dvec2 texel, glm::dvec3 direction) const;

private:
    size_t place_of(glm::dvec2 corner) const;
    /// Of a ray: above the highest height nothing can be hit; a little below the lowest one everything has been.
    struct Stretch {
        double begin, end;
    };
    std::optional<Stretch> stretch_of(const Ray& ray, double t_end, double bend) const;
    size_t place(int64_t column, int64_t row) const { return size_t((row + 1) * (size_.x + 2) + column + 1); }
    HeightCell cell(size_t place) const;

    glm::ivec2 size_;
    bool wraps_;
    double lowest_, highest_;
    // Row 0 is the lowest, and there is a border of one texel all around, so that a cell's corners are neighbours.
    std::vector<double> padded_;
    std::vector<double> tops_;  ///< the highest corner of each cell, in the same places: most cells need no more
};

}  // namespace relief
