#include "framework/gl/target.h"

#include <fmt/format.h>

#include "framework/base/error.h"

namespace relief {
namespace {

constexpr int samples_of_pictures = 4;

void attach(GLuint framebuffer, GLenum place, GLuint renderbuffer, GLenum format, int samples, glm::ivec2 size) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, size.x, size.y);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, renderbuffer);
}

}  // namespace

Target::Target(TargetKind kind, glm::ivec2 size) : kind_(kind), size_(size) {
    const GLenum format = kind == TargetKind::picture ? GL_RGBA8 : GL_RGBA32F;
    GLint most = 1;
    glGetIntegerv(GL_MAX_SAMPLES, &most);
    const int samples = kind == TargetKind::probe ? 0 : std::min(most, samples_of_pictures);
    attach(drawn_, GL_COLOR_ATTACHMENT0, color_, format, samples, size);
    attach(drawn_, GL_DEPTH_ATTACHMENT, depth_, GL_DEPTH_COMPONENT32F, samples, size);
    label(GL_FRAMEBUFFER, drawn_, "target");
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (samples > 1) {
        resolved_.emplace();
        attach(resolved_->framebuffer, GL_COLOR_ATTACHMENT0, resolved_->color, format, 0, size);
        label(GL_FRAMEBUFFER, resolved_->framebuffer, "target, resolved");
    }
    const std::string errors = take_gl_errors();
    if (status != GL_FRAMEBUFFER_COMPLETE || !errors.empty())
        throw Error(fmt::format("this driver cannot hold a picture of {}x{}{}", size.x, size.y,
                                errors.empty() ? "" : ": " + errors));
}

GLuint Target::resolve() const {
    if (!resolved_) return drawn_;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_->framebuffer);
    glDisable(GL_SCISSOR_TEST);  // a blit obeys it
    glBlitFramebuffer(0, 0, size_.x, size_.y, 0, 0, size_.x, size_.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    return resolved_->framebuffer;
}

Image Target::read() const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, resolve());
    Image image(size_.x, size_.y, 4, kind_ == TargetKind::picture ? 8 : 32);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    const size_t row = size_t(size_.x) * 4;
    const auto take = [&](const auto& rows, float scale) {
        for (int y = 0; y < size_.y; ++y)
            for (size_t i = 0; i < row; ++i) image.pixel(0, y)[i] = float(rows[(size_.y - 1 - y) * row + i]) / scale;
    };
    if (kind_ == TargetKind::picture) {
        std::vector<uint8_t> rows(row * size_.y);
        glReadPixels(0, 0, size_.x, size_.y, GL_RGBA, GL_UNSIGNED_BYTE, rows.data());
        take(rows, 255);
    } else {
        std::vector<float> rows(row * size_.y);
        glReadPixels(0, 0, size_.x, size_.y, GL_RGBA, GL_FLOAT, rows.data());
        take(rows, 1);
    }
    return image;
}

}  // namespace relief
