// How the numbers of a map become vectors, found out from the numbers alone.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "framework/image/image.h"

namespace relief {

enum class MapKind { one_color, heights, normals, neither };

/// What was done to the numbers after they were 0.5 n + 0.5.
enum class StoredCurve { none, srgb_added, srgb_removed };

struct Reading {
    StoredCurve curve = StoredCurve::none;
    bool is_signed = false;   ///< floats that hold n itself
    int x = 0, y = 1, z = 2;  ///< channels; z -1: rebuilt from x and y

    /// Any length. NaN where a value is not finite; values beyond a million count as a million.
    glm::dvec3 vector(const float* texel) const;
};

/// Statistics of a map's vectors by one reading, from at most some 16,000 texels that are spread over it.
struct VectorStatistics {
    size_t count = 0;       ///< finite texels, without those of the background
    double median_off = 0;  ///< of | |n| - 1 |
    double unit = 0;        ///< share with a length from 0.9 to 1.1
    double away = 0;        ///< share whose unit vector has z < -0.05
    double longest_xy = 0;  ///< length of (x, y)
    double long_xy = 0;     ///< its 99.5 % quantile
    double red_green = 0;   ///< correlation of x and y
    glm::dvec3 mean{0};     ///< of the unit vectors
};

struct Recognition {
    MapKind kind = MapKind::neither;
    Reading reading;
    VectorStatistics statistics = {};  ///< by that reading
    VectorStatistics as_it_is = {};    ///< without a curve
    bool object_space = false;         ///< vectors of all directions: the object's or the world's space
    bool blue_down = false;            ///< every vector points into the surface
    std::optional<std::array<float, 3>> background = {};  ///< a colour that is no normal and fills what is not covered

    bool is_background(const float* texel) const;
};

Recognition recognize(const Image& map);

/// The vectors by that reading; NaN where a value is not finite, and in the background.
std::vector<glm::vec3> vectors_of(const Image& map, const Recognition& as);

}  // namespace relief
