// The tiles of a lab's picture, the mean error of each, a place that hides none of these numbers, and the rows of the
// start page. Without GL. In the window module only.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "framework/core/image/image.h"
#include "framework/core/lab/words.h"
#include "framework/course/window/menu_layout.h"

namespace relief::window {

/// Place and size in shares of the picture's size, from its upper left corner.
struct TileMean {
    glm::vec2 place{0}, size{0};
    float foot = 0;  ///< as of its captions
    double mean = 0;
};

/// Returns the mean of an error in each tile that has a caption; finds the tiles by the words of the lab's picture.
/// Leaves out tiles without an error. Returns nothing for less than two tiles.
std::vector<TileMean> tile_means(const std::vector<PictureWord>& words, const Image& error);

/// Distributes `count` cards over rows of at most `columns`, as evenly as possible: a row of one card is left only if
/// the columns are less than three. Returns the number of cards in each row, the longer rows first.
std::vector<size_t> even_rows(size_t count, size_t columns);

/// Returns the upper left corner of a box of `size` near `pixel`, in `room`: to the lower right, or where it hides no
/// `words`, if there is such a place beside the pixel.
glm::ivec2 beside(glm::ivec2 pixel, glm::ivec2 size, const Box& room, const std::vector<Box>& words);

}  // namespace relief::window
