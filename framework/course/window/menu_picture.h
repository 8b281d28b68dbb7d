// A picture in a handout: an image, or a diagram rendered at the screen's resolution. In the window module only.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "framework/core/gl/texture.h"

namespace relief::window {

class HandoutPicture {
public:
    /// A file that ends in .svg is a diagram. Throws Error if it cannot be read.
    explicit HandoutPicture(const std::filesystem::path& file);
    HandoutPicture(const HandoutPicture&) = delete;
    HandoutPicture& operator=(const HandoutPicture&) = delete;

    /// Draws it at the cursor, at most `width` pixels wide. An image has its own size; a diagram is scaled to the size
    /// of the text. Throws Error if it cannot be drawn.
    void draw(float width);

private:
    void draw_image(float width) const;
    void draw_diagram(float width);

    std::string name_, svg_;          ///< `svg_`: the text of a diagram
    glm::ivec2 size_{0};              ///< of an image in pixels, once it is loaded; of a diagram in SVG units
    glm::ivec2 drawn_{0};             ///< size of a diagram's texture in pixels
    std::optional<Texture> texture_;  ///< of a diagram, rendered at size `drawn_`
};

}  // namespace relief::window
