#include "encoded_texture.h"

#include <cmath>
#include <vector>

#include "framework/core/gl/counters.h"

namespace relief {

EncodedTexture::EncodedTexture(glm::ivec2 size, std::span<const uint8_t> blocks, bool is_signed) {
    create(int64_t(blocks.size()), [&] {
        glCompressedTexImage2D(GL_TEXTURE_2D, 0, is_signed ? GL_COMPRESSED_SIGNED_RG_RGTC2 : GL_COMPRESSED_RG_RGTC2,
                               size.x, size.y, 0, GLsizei(blocks.size()), blocks.data());
    });
}

EncodedTexture::EncodedTexture(const Image& vectors) {
    std::vector<int8_t> rows;  // from the bottom to the top
    for (int y = vectors.height - 1; y >= 0; --y)
        for (int i = 0; i < 3 * vectors.width; ++i) rows.push_back(int8_t(std::lround(127 * vectors.pixel(0, y)[i])));
    create(int64_t(rows.size()), [&] {
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8_SNORM, vectors.width, vectors.height, 0, GL_RGB, GL_BYTE, rows.data());
        glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    });
}

EncodedTexture::~EncodedTexture() { counters().texture_bytes -= bytes_; }

/// Keeps the texture that is bound to the active unit.
template <class Upload>
void EncodedTexture::create(int64_t bytes, Upload upload) {
    GLint bound = 0;
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
    glBindTexture(GL_TEXTURE_2D, name_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    upload();
    glBindTexture(GL_TEXTURE_2D, GLuint(bound));
    counters().texture_bytes += bytes_ = bytes;
}

void EncodedTexture::bind(int unit) const {
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    glBindTexture(GL_TEXTURE_2D, name_);
}

}  // namespace relief
