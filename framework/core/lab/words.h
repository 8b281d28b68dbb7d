// The words over a lab's picture. Pages, slides and the window take them, and write them themselves.
#pragma once

#include <glm/glm.hpp>
#include <string>

namespace relief {

/// Text or a shape that a lab draws over its picture. Places and sizes are shares of the picture's size, from its upper
/// left corner. Colours are in stored sRGB.
struct PictureWord {
    enum class Kind {
        caption,  ///< a line in the middle of a tile, or in the strip below it; place and size are the tile's
        legend,   ///< a colour and its name, in the strip at the lower end of a tile; place and size are the tile's
        note,     ///< a sentence at the lower end of the picture
        text,     ///< `anchor` says which point of the text is at place.x; size.y is its height
        box,
        scale  ///< heat colours from `text` on the left to `end` on the right
    };
    Kind kind = Kind::text;
    glm::vec2 place{0}, size{0};
    std::string text = {}, end = {};  ///< UTF-8
    glm::vec4 color{1};
    int line = 0;      ///< of a caption: 0 is the title, -1 the last; a legend begins a row where it changes
    float foot = 0;    ///< of a caption or a legend: height of the strip below its tile, within size; 0: none
    float anchor = 0;  ///< of a text: 0 left, 0.5 middle, 1 right
    int parts = 1;     ///< of a logarithmic scale: its ticks divide it into parts of one ratio; 1: a linear scale
};

/// Returns the word in a picture that is larger by these factors.
inline PictureWord scaled(PictureWord word, glm::vec2 factors) {
    word.place *= factors, word.size *= factors, word.foot *= factors.y;
    return word;
}

}  // namespace relief
