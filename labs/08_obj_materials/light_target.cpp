#include "light_target.h"

#include <fmt/format.h>

#include <algorithm>

#include "framework/core/base/error.h"
#include "framework/core/gl/counters.h"

namespace relief {

LightTarget::LightTarget(glm::ivec2 size, int samples, int attachments) : size_(size) {
    GLint max_samples = 1;
    glGetIntegerv(GL_MAX_COLOR_TEXTURE_SAMPLES, &max_samples);
    samples_ = std::clamp(samples, 1, int(max_samples));
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    label(GL_FRAMEBUFFER, framebuffer_, "light");
    glBindRenderbuffer(GL_RENDERBUFFER, depth_);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples_ > 1 ? samples_ : 0, GL_DEPTH_COMPONENT32F, size.x,
                                     size.y);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
    for (int i = 0; i < attachments; ++i) {
        glBindTexture(target(), textures_.emplace_back());
        if (samples_ > 1) {
            glTexImage2DMultisample(target(), samples_, GL_RGBA32F, size.x, size.y, GL_TRUE);
        } else {
            glTexParameteri(target(), GL_TEXTURE_MAX_LEVEL, 0);
            glTexParameteri(target(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
            glTexParameteri(target(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
            glTexImage2D(target(), 0, GL_RGBA32F, size.x, size.y, 0, GL_RGBA, GL_FLOAT, nullptr);
        }
        glFramebufferTexture2D(GL_FRAMEBUFFER, GLenum(GL_COLOR_ATTACHMENT0 + i), target(), textures_.back(), 0);
        bytes_ += int64_t(size.x) * size.y * samples_ * 16;
    }
    glBindTexture(target(), 0);
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    const std::string errors = take_gl_errors();
    if (status != GL_FRAMEBUFFER_COMPLETE || !errors.empty())
        throw Error(fmt::format("this driver cannot hold light of {}x{} in floats{}", size.x, size.y,
                                errors.empty() ? "" : ": " + errors));
    counters().texture_bytes += bytes_;
}

LightTarget::~LightTarget() { counters().texture_bytes -= bytes_; }

void LightTarget::begin(int first, int count) const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    std::vector<GLenum> places;
    for (int i = 0; i < count; ++i) places.push_back(GLenum(GL_COLOR_ATTACHMENT0 + first + i));
    glDrawBuffers(count, places.data());
}

void LightTarget::bind(int unit, int attachment) const {
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    glBindTexture(target(), textures_[size_t(attachment)]);
}

}  // namespace relief
