// The words beside the garden of lab 08.
#pragma once

#include "framework/library/kit/labels.h"
#include "scene.h"

namespace relief::materials {

/// Lists the materials below a tile: name, features and triangles, in the colour of the program. `highlight` is the
/// number of a material, from 1 on, or 0.
void list_materials(Labels& labels, glm::ivec2 size, const Tile& tile, const Scene& scene, int highlight);

}  // namespace relief::materials
