// The functions that task.cpp of lab 09 defines: how fine a patch is, how deep its skirts are, and when it is hidden.
#pragma once

#include <span>

namespace relief::planet {

/// The distance at which an error of `error` metres is `budget` pixels high, in a picture that is `pixels` high and
/// sees the angle `field_of_view_rad` from its lower edge to its upper one.
double split_distance(double error, double budget, double pixels, double field_of_view_rad);

/// How far the skirt of a patch of a level reaches below its border, metres. `errors[l]` is the largest error of the
/// ground of level l. Neighbours differ by one level at most.
double skirt_depth(std::span<const double> errors, int level);

/// Whether the planet itself hides a patch. `eye` is the distance of the eye from the planet's centre; the ground is
/// `lowest` to `highest` metres from it. `angle` (radians) is the smallest between the directions from the centre to
/// the eye and to a place of the patch.
bool behind_horizon(double eye, double angle, double lowest, double highest);

}  // namespace relief::planet
