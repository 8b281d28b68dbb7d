// The bounds of a height map's regions as a texture.
#pragma once

#include "framework/gl/object.h"
#include "framework/image/height_bounds.h"

namespace relief::occlusion {

/// All levels in one, as shaders/11_parallax_occlusion/bounds.glsl finds them. The map is square. Leaves what is bound
/// to the active unit.
inline TextureName upload_bounds(const Image& heights) {
    GLint bound = 0;
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
    const std::vector<Image> levels = min_max_mips(heights);
    const int side = heights.width;
    TextureName name;
    glBindTexture(GL_TEXTURE_2D, name);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RG32F, side + side / 2, side, 0, GL_RG, GL_FLOAT, nullptr);
    for (size_t k = 0; k < levels.size(); ++k) {
        const Image& level = levels[k];
        const int left = k == 0 ? 0 : side, bottom = k == 0 ? 0 : side - (side >> (k - 1));
        for (int y = 0; y < level.height; ++y)  // row 0 of an image is the top
            glTexSubImage2D(GL_TEXTURE_2D, 0, left, bottom + level.height - 1 - y, level.width, 1, GL_RG, GL_FLOAT,
                            level.pixel(0, y));
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindTexture(GL_TEXTURE_2D, GLuint(bound));
    return name;
}

}  // namespace relief::occlusion
