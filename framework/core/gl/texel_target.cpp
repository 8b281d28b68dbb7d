#include "framework/core/gl/texel_target.h"

#include <fmt/format.h>

#include <algorithm>

#include "framework/core/base/error.h"
#include "framework/core/gl/counters.h"

namespace relief {
namespace {

int bytes_of_texel(GLenum format) { return format == GL_RGBA32F ? 16 : format == GL_RGBA16 ? 8 : 4; }

}  // namespace

TexelTarget::TexelTarget(glm::ivec2 size, std::initializer_list<GLenum> formats, bool mips, bool depth) : size_(size) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    label(GL_FRAMEBUFFER, framebuffer_, "texels");
    std::vector<GLenum> places;
    for (const GLenum format : formats) {
        textures_.emplace_back();
        glBindTexture(GL_TEXTURE_2D, textures_.back());
        int level = 0;
        for (glm::ivec2 extent = size;; extent = glm::max(extent / 2, 1)) {
            glTexImage2D(GL_TEXTURE_2D, level, GLint(format), extent.x, extent.y, 0, GL_RGBA, GL_FLOAT, nullptr);
            bytes_ += int64_t(extent.x) * extent.y * bytes_of_texel(format);
            if (!mips || (extent.x == 1 && extent.y == 1)) break;
            ++level;
        }
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, level);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, mips ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, mips ? GL_LINEAR : GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        places.push_back(GLenum(GL_COLOR_ATTACHMENT0 + places.size()));
        glFramebufferTexture2D(GL_FRAMEBUFFER, places.back(), GL_TEXTURE_2D, textures_.back(), 0);
    }
    glBindTexture(GL_TEXTURE_2D, 0);
    if (depth) {
        glBindRenderbuffer(GL_RENDERBUFFER, depth_.emplace());
        glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, size.x, size.y);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, *depth_);
    }
    glDrawBuffers(GLsizei(places.size()), places.data());
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    const std::string errors = take_gl_errors();
    if (status != GL_FRAMEBUFFER_COMPLETE || !errors.empty())
        throw Error(fmt::format("this driver cannot hold {} textures of {}x{} to draw into{}", places.size(), size.x,
                                size.y, errors.empty() ? "" : ": " + errors));
    counters().texture_bytes += bytes_;
}

TexelTarget::~TexelTarget() { counters().texture_bytes -= bytes_; }

void TexelTarget::bind(int unit, size_t attachment) const {
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    glBindTexture(GL_TEXTURE_2D, textures_[attachment]);
}

void TexelTarget::begin() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, size_.x, size_.y);
}

void TexelTarget::make_mips() const {
    for (const TextureName& texture : textures_) {
        glBindTexture(GL_TEXTURE_2D, texture);
        glGenerateMipmap(GL_TEXTURE_2D);
    }
}

Image TexelTarget::read(size_t attachment) const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    glReadBuffer(GLenum(GL_COLOR_ATTACHMENT0 + attachment));
    Image image(size_.x, size_.y, 4);
    std::vector<float> rows(image.values.size());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size_.x, size_.y, GL_RGBA, GL_FLOAT, rows.data());
    const size_t width = size_t(size_.x) * 4;
    for (int y = 0; y < size_.y; ++y)
        std::copy_n(rows.data() + size_t(size_.y - 1 - y) * width, width, image.pixel(0, y));
    return image;
}

}  // namespace relief
