// The exact values of lab 08's probes.
#pragma once

#include "framework/base/from_staff.h"
#include "framework/lab/lab.h"
#include "lights.h"
#include "scene.h"

namespace relief::materials {

struct Setting {
    const Scene& scene;
    bool has_maps;
    Lights lights;
    double fence;  ///< tiles of a mask to one of the file's
};

/// From the ray through the middle of a pixel, which meets every layer; masks by their formulas, in double precision.
/// Of the first surface: `material` (its index in the scene), `order` (its place in the right order of drawing),
/// `normal`, `lamp` (share of the lamp's light), `specular` (colour and exponent). `color`: light, with everything that
/// lies over each other, and the sky; with maps it is the mean over 32 x 32 rays. `layers`: how many surfaces there are
/// up to the first opaque one. `coverage`: share of the pixel in which the nearest masked surface is there, by
/// 64 x 64 rays.
inline FromStaff<std::optional<Image>(const Frame& frame, const Probe& probe, const Setting& setting)> truth;

/// Share of a mask that is covered, by its formula; `mask` is the name of an asset.
inline FromStaff<std::optional<double>(const std::string& mask)> true_coverage;

/// The share of a lamp's light at a place.
inline FromStaff<std::optional<double>(const Lights& lights, const glm::dvec3& place)> true_share;

}  // namespace relief::materials
