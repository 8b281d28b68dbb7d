// The tiles of a lab's picture, and the mean error of each. Without GL. In the window module only.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "framework/core/image/image.h"
#include "framework/core/lab/words.h"

namespace relief::window {

/// Place and size in shares of the picture's size, from its upper left corner.
struct TileMean {
    glm::vec2 place{0}, size{0};
    double mean = 0;
};

/// Returns the mean of an error in each tile that has a caption; finds the tiles by the words of the lab's picture.
/// Leaves out tiles without an error. Returns nothing for less than two tiles.
std::vector<TileMean> tile_means(const std::vector<PictureWord>& words, const Image& error);

}  // namespace relief::window
