// Recognises how the numbers of a map encode vectors, from the numbers alone.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "framework/core/image/image.h"

namespace relief::inspect {

enum class MapKind { one_color, heights, normals, neither };

/// The colour conversion that was applied to the numbers after they were 0.5 n + 0.5.
enum class StoredCurve { none, srgb_added, srgb_removed };

struct Reading {
    StoredCurve curve = StoredCurve::none;
    bool is_signed = false;   ///< floats that hold n itself
    int x = 0, y = 1, z = 2;  ///< channel indices; z = -1: rebuilt from x and y

    /// Returns the decoded vector, not normalised. NaN if a value is not finite. Values are clamped to [-1e6, 1e6].
    glm::dvec3 vector(const float* texel) const;
};

/// Statistics of a map's vectors under one reading, from at most about 16,000 texels on a grid over the map.
struct VectorStatistics {
    size_t count = 0;       ///< finite texels outside the background
    double median_off = 0;  ///< median of | |n| - 1 |
    double unit = 0;        ///< share with a length from 0.9 to 1.1
    double away = 0;        ///< share whose unit vector has z < -0.05
    glm::dvec3 below{0};    ///< for each axis, share whose unit vector has a component < -0.05
    glm::dvec3 above{0};    ///< the same for a component > 0.05
    double longest_xy = 0;  ///< maximum length of (x, y)
    double long_xy = 0;     ///< its 99.5 % quantile
    double red_green = 0;   ///< correlation of x and y
    glm::dvec3 mean{0};     ///< mean of the unit vectors
};

struct Recognition {
    MapKind kind = MapKind::neither;
    Reading reading;
    VectorStatistics statistics = {};                     ///< under `reading`
    VectorStatistics as_it_is = {};                       ///< under the plain reading, without a curve
    bool object_space = false;                            ///< vectors in all directions: object or world space
    bool blue_down = false;                               ///< every vector points into the surface
    std::optional<std::array<float, 3>> background = {};  ///< a colour that is no normal and fills uncovered texels

    bool is_background(const float* texel) const;
};

Recognition recognize(const Image& map);

/// The axis that all vectors face; for a surface's normals in tangent space it is z.
struct FacedAxis {
    int axis;       ///< 0 to 2
    bool downward;  ///< they face its negative end
};
std::optional<FacedAxis> faced_axis(const VectorStatistics& statistics);

/// Returns the recognition of the same map as normals in tangent space, with x, y and z in these channels.
Recognition reordered(const Image& map, const Recognition& as, glm::ivec3 channels);

/// Returns the vectors under `as.reading`. NaN if a value is not finite, and in the background.
std::vector<glm::vec3> vectors_of(const Image& map, const Recognition& as);

}  // namespace relief::inspect
