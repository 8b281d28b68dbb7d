#include "framework/core/gl/depth_target.h"

#include <fmt/format.h>

#include <algorithm>

#include "framework/core/base/error.h"
#include "framework/core/gl/counters.h"

namespace relief {

DepthTarget::DepthTarget(glm::ivec2 size, Lookup lookup) : size_(size) {
    const GLint filter = lookup == Lookup::linear ? GL_LINEAR : GL_NEAREST;
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    label(GL_FRAMEBUFFER, framebuffer_, "depth map");
    glBindTexture(GL_TEXTURE_2D, depth_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, size.x, size.y, 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
    constexpr float far[] = {1, 1, 1, 1};
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, far);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_, 0);
    glBindTexture(GL_TEXTURE_2D, 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    const std::string errors = take_gl_errors();
    if (status != GL_FRAMEBUFFER_COMPLETE || !errors.empty())
        throw Error(fmt::format("this driver cannot hold a depth map of {}x{}{}", size.x, size.y,
                                errors.empty() ? "" : ": " + errors));
    counters().texture_bytes += bytes_ = int64_t(size.x) * size.y * 4;
}

DepthTarget::~DepthTarget() { counters().texture_bytes -= bytes_; }

void DepthTarget::bind(int unit) const {
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    glBindTexture(GL_TEXTURE_2D, depth_);
}

void DepthTarget::begin() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, size_.x, size_.y);
}

Image DepthTarget::read() const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    Image image(size_.x, size_.y, 1);
    std::vector<float> rows(image.values.size());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size_.x, size_.y, GL_DEPTH_COMPONENT, GL_FLOAT, rows.data());
    for (int y = 0; y < size_.y; ++y)
        std::copy_n(rows.data() + size_t(size_.y - 1 - y) * size_t(size_.x), size_.x, image.pixel(0, y));
    return image;
}

}  // namespace relief
