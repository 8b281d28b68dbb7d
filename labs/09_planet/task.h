// The functions that task.cpp of lab 09 defines: when a patch is split, how deep its skirts are, and when it is hidden.
#pragma once

#include <span>

namespace relief::planet {

/// Returns the distance in metres at which an error of `error` metres is `budget` pixels high. The picture is `pixels`
/// high, and its vertical field of view is `field_of_view_rad`.
double split_distance(double error, double budget, double pixels, double field_of_view_rad);

/// Returns how far the skirt of a patch reaches below its border, in metres. `level` is that of the patch, and
/// `errors[l]` the largest error of the ground at level l, in metres. Neighbours differ by one level at most.
double skirt_depth(std::span<const double> errors, int level);

/// Returns whether the planet itself hides a patch. `eye` is the distance of the eye from the planet's centre, and the
/// ground is `lowest` to `highest` metres from it. `angle` (radians) is the smallest angle between the directions from
/// the centre to the eye and to a place of the patch.
bool behind_horizon(double eye, double angle, double lowest, double highest);

}  // namespace relief::planet
