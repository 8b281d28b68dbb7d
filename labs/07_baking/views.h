// The views of lab 07's picture, side by side.
#pragma once

#include <string>
#include <vector>

#include "framework/library/kit/tiles.h"
#include "settings.h"
#include "truth.h"

namespace relief::baking {

enum class Draws { model, map, cover, cut };

struct View {
    Tile tile{};
    Draws draws = Draws::model;
    Sight sight{};
    int frame = interpolated;  ///< the renderer's
    std::string title{};
    bool wears_file = false;  ///< the normal map in the model's file instead of the baked one

    bool needs_bake() const { return (sight.shown == Shown::mapped && !wears_file) || draws != Draws::model; }
};

/// Returns the views of the picture, each in its tile. A probe of the map has one view. Throws Error if the knobs want
/// the normal map of a file that has none.
std::vector<View> views_of(const Settings& settings, const Frame& frame);

}  // namespace relief::baking
