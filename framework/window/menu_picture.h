// A picture in a handout: an image, or a diagram as sharp as the screen shows it. In the window module only.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "framework/gl/texture.h"

namespace relief {

class HandoutPicture {
public:
    /// A diagram ends in .svg. Throws Error if it cannot be read.
    explicit HandoutPicture(const std::filesystem::path& file);
    HandoutPicture(const HandoutPicture&) = delete;
    HandoutPicture& operator=(const HandoutPicture&) = delete;

    /// At the cursor, as large as it is, or as a diagram's letters want it at the text's scale; at most `width` pixels
    /// wide. Throws Error if it cannot be drawn.
    void draw(float width);

private:
    void draw_image(float width) const;
    void draw_diagram(float width);

    std::string name_, svg_;          ///< `svg_`: of a diagram
    glm::ivec2 size_{0};              ///< of an image in pixels, once it is read; of a diagram in units of its own
    glm::ivec2 drawn_{0};             ///< of a diagram, pixels
    std::optional<Texture> texture_;  ///< of a diagram as large as it was drawn last
};

}  // namespace relief
