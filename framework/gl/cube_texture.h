// Cube maps of light by a formula, made when a draw first binds them.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "framework/gl/object.h"

namespace relief {

/// Six faces of three floats, with all mip levels, read trilinearly. Where faces meet, GL filters across only while
/// GL_TEXTURE_CUBE_MAP_SEAMLESS is enabled.
class CubeTexture {
public:
    /// `side` texels along each edge, a power of two. `light` is called from several threads, with the direction of a
    /// texel's middle, of unit length.
    CubeTexture(std::string title, int side, std::function<glm::dvec3(const glm::dvec3& direction)> light);

    int side() const { return side_; }
    /// Throws Error when it is too large for the driver.
    operator GLuint() const;

private:
    struct Loaded {
        TextureName name;
        int64_t bytes = 0;
        Loaded() = default;
        Loaded(const Loaded&) = delete;
        ~Loaded();
    };

    std::string title_;
    int side_;
    std::function<glm::dvec3(const glm::dvec3& direction)> light_;
    mutable std::optional<Loaded> loaded_;
};

/// Makes the texture current on a unit.
void bind(int unit, const CubeTexture& texture);

/// The direction that GL reads at a place of a face, not made unit: s to the right and t down, each from -1 to 1. Faces
/// are +x, -x, +y, -y, +z, -z.
glm::dvec3 cube_map_direction(int face, double s, double t);

}  // namespace relief
