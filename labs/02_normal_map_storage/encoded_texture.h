// Textures in formats that Texture does not have: compressed blocks, and signed bytes.
#pragma once

#include <glm/glm.hpp>
#include <span>

#include "framework/core/gl/object.h"
#include "framework/core/image/image.h"

namespace relief {

/// A 2-D texture without mip levels, with nearest filtering.
class EncodedTexture {
public:
    /// BC5 (RGTC of two channels): blocks of 4 x 4 texels, row by row from the bottom, 16 bytes each. `size` in texels;
    /// its last blocks may be partly outside.
    EncodedTexture(glm::ivec2 size, std::span<const uint8_t> blocks, bool is_signed);
    /// Three signed bytes a texel, of an image with three channels in [-1, 1].
    explicit EncodedTexture(const Image& vectors);
    ~EncodedTexture();
    EncodedTexture(const EncodedTexture&) = delete;
    EncodedTexture& operator=(const EncodedTexture&) = delete;

    /// Returns the number of bytes of its texels.
    int64_t bytes() const { return bytes_; }
    /// Binds the texture to a texture unit.
    void bind(int unit) const;

private:
    template <class Upload>
    void create(int64_t bytes, Upload upload);

    TextureName name_;
    int64_t bytes_ = 0;
};

}  // namespace relief
