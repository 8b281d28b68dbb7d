// A wall displaced by a height map, in double precision: the first hit of a ray, and the slope there.
#pragma once

#include <optional>

#include "framework/staff/reference/height_field.h"

namespace relief {

/// A displaced wall of `metres` x `metres`, centred in the plane z = 0, with u along x and v along y. The relief is
/// `scale` metres deep, below the plane. Its bilinear heights repeat `tiles` times along a side.
class DisplacedWall {
public:
    DisplacedWall(const Image& heights, double metres, double tiles, double scale);

    struct Seen {
        double distance;
        glm::dvec2 slope;  ///< heights per tile, by central differences
        glm::dvec3 normal;
    };
    /// Returns the first hit with either side of the relief, from the distance `begin` on. The ray's direction has unit
    /// length.
    std::optional<Seen> look(const Ray& ray, double begin) const;

private:
    glm::dvec2 at_texel(const Ray& ray, double t) const;
    Seen seen(double t, glm::dvec2 texel) const;

    HeightField above_, below_;
    double metres_, scale_, tiles_;  ///< metres; metres; tiles per metre
    glm::dvec2 texels_;              ///< texels per metre
};

}  // namespace relief
