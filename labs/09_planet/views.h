// The views of lab 09's picture, side by side.
#pragma once

#include <string>
#include <vector>

#include "framework/library/kit/tiles.h"
#include "settings.h"

namespace relief::planet {

/// A view of the planet in its tile: from an eye, or as faces spread out flat.
struct View {
    Tile tile;
    std::string title;
    Plan plan;      ///< which patches
    Eye seen_from;  ///< the plan's eye, or another one that looks at the plan's patches
    MapRecipe recipe;
    bool is_flat = false, shows_patches = false, shows_frames = false;
    int lit_by = Settings::lit_by_map;
    int most_texels = 0;            ///< this view's share of a picture's
    std::vector<Leaf> leaves = {};  ///< the patches to draw, from cover_with_patches()
    std::string bounded = {};       ///< the limits that reduced patches or texels, in words; or empty
};

/// Returns the views of the picture, without patches.
std::vector<View> views_of(const Settings& settings, const Frame& frame);

/// Covers the planet with the patches to draw. Limits the texels of their maps to the view's share.
void cover_with_patches(View& view);

}  // namespace relief::planet
