// The exact values of lab 08's probes.
#pragma once

#include "framework/core/base/from_staff.h"
#include "framework/core/lab/lab.h"
#include "lights.h"
#include "scene.h"

namespace relief::materials {

struct Setting {
    const Scene& scene;
    bool has_maps;
    Lights lights;
    double fence;  ///< tiles of wire for each tile of the file
};

/// Returns the exact values of a probe, in double precision, by rays that meet all layers. Masks follow their formulas.
/// There is one ray through the centre of each pixel, unless stated otherwise. The probes:
///  - `material`: index of the first surface in the scene
///  - `order`: place of the first surface in the correct drawing order
///  - `normal`: normal of the first surface
///  - `lamp`: share of the lamp's light on the first surface
///  - `specular`: colour and exponent of the highlight of the first surface
///  - `color`: linear light of all layers and the sky; with maps the mean over 32 x 32 rays
///  - `layers`: number of surfaces up to the first opaque one
///  - `coverage`: share of the pixel that the nearest masked surface covers, by 64 x 64 rays
/// In a large picture a pixel has fewer rays: together they are at most 16 million.
inline FromStaff<std::optional<Image>(const Frame& frame, const Setting& setting)> truth;

/// Returns the share of a mask that is covered, by its formula. `mask` is the name of an asset.
inline FromStaff<std::optional<double>(const std::string& mask)> true_coverage;

/// Returns the share of the lamp's light that reaches a place, in metres.
inline FromStaff<std::optional<double>(const Lights& lights, const glm::dvec3& place)> true_share;

}  // namespace relief::materials
