// Cube maps of light given by a formula, created when a draw first binds them.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "framework/core/gl/object.h"

namespace relief {

/// A cube map of three floats a texel, with all mip levels and trilinear filtering. GL filters across face edges only
/// while GL_TEXTURE_CUBE_MAP_SEAMLESS is enabled.
class CubeTexture {
public:
    /// `side` is the number of texels along each edge, a power of two. `light` returns the light from a direction of
    /// unit length, that of a texel's centre. It is called from several threads and must be thread-safe.
    CubeTexture(std::string title, int side, std::function<glm::dvec3(const glm::dvec3& direction)> light);

    int side() const { return side_; }
    /// Throws Error when `side` is below 1 or too large for the driver.
    operator GLuint() const;

private:
    struct Loaded {
        TextureName name;
        int64_t bytes = 0;
        Loaded();
        Loaded(const Loaded&) = delete;
        ~Loaded();
    };

    std::string title_;
    int side_;
    std::function<glm::dvec3(const glm::dvec3& direction)> light_;
    mutable std::optional<Loaded> loaded_;
};

/// Binds the texture to a texture unit.
void bind(int unit, const CubeTexture& texture);

/// Returns the direction that GL samples at a point of a face, not normalised. `s` grows to the right and `t`
/// downwards, both in [-1, 1]. Faces 0 to 5 are +x, -x, +y, -y, +z, -z.
glm::dvec3 cube_map_direction(int face, double s, double t);

}  // namespace relief
