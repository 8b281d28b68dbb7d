// Where a camera's near plane cuts its rays.
#pragma once

#include "framework/core/base/ray.h"

namespace relief {

/// Returns the distance along a camera's ray at which it crosses the near plane, in units of its direction. The
/// rasteriser draws nothing nearer, so exact values begin there.
inline double near_plane(const glm::dmat4& clip_from_world, const Ray& ray) {
    const glm::dvec4 eye = clip_from_world * glm::dvec4(ray.origin, 1);
    const glm::dvec4 way = clip_from_world * glm::dvec4(ray.direction, 0);
    return -(eye.z + eye.w) / (way.z + way.w);
}

/// Returns the part of a camera's ray that is drawn: it begins at the near plane.
inline Ray drawn_part(const glm::dmat4& clip_from_world, const Ray& ray) {
    return {ray.at(near_plane(clip_from_world, ray)), ray.direction};
}

}  // namespace relief
