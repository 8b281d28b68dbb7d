// Where the words over a picture go: the one layout of their letters, for pictures and for the window.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "framework/core/lab/words.h"

namespace relief {

/// Letters in which words are drawn. Heights are in pixels, from the top of a line to its bottom.
struct Letters {
    std::function<float(const std::string& text, float height)> width;
    float usual;        ///< height of a title
    float least;        ///< smallest legible height
    float share = 1;    ///< of a line of PictureWord::Kind::text, that its letters fill
    bool even = false;  ///< whether heights are even: then the letters of labels.png are whole pixels wide
};

/// Text or a shape at its place, in pixels from the upper left corner of the picture.
struct PlacedWord {
    enum class Kind { ground, text, box, heat };
    Kind kind;
    glm::vec2 place, size;
    glm::vec4 color{1};
    std::string text = {};
    size_t of = 0;  ///< index of the word
};

struct WordLayout {
    std::vector<PlacedWord> placed;     ///< in the order in which to draw them
    std::vector<std::string> left_out;  ///< captions and legends for which a tile has no room
};

/// Places the words of a picture of `size` pixels; `words` are in pixels, too. A caption stays in its tile: it shrinks
/// down to the smallest legible height, and is then broken into lines. A legend has a strip at the lower end of its
/// tile, and notes have one at the lower end of the picture; captions are above both, or in the foot of their tile. No
/// text leaves the picture. A caption without room is left out, the title of a tile last.
WordLayout lay_out(const std::vector<PictureWord>& words, glm::vec2 size, const Letters& letters);

/// Returns the height in pixels of the foot of a tile `high` pixels high, for a title and `lines` - 1 other captions.
float foot_height(float high, int lines, const Letters& letters);

/// Breaks a text at blanks into lines that `fits` accepts. A word that no line has room for is a line of its own.
std::vector<std::string> broken_into_lines(const std::string& text,
                                           const std::function<bool(const std::string& line)>& fits);

}  // namespace relief
