#include "framework/core/gl/target.h"

#include <fmt/format.h>

#include "framework/core/base/error.h"

namespace relief {
namespace {

constexpr int samples_of_pictures = 4;

void attach(GLenum place, GLuint renderbuffer, GLenum format, int samples, glm::ivec2 size) {
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, size.x, size.y);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, renderbuffer);
}

// A blit would do the same. But the software renderer compiles its blit shader in every process (50 ms), while this
// program comes from its shader cache.
std::vector<ShaderSource> resolving(int samples) {
    ShaderSource vertex, fragment;
    vertex.stage = "resolve.vert";
    vertex.text =
        "#version 410 core\n"
        "void main() {\n"
        "    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);\n"
        "}\n";
    fragment.stage = "resolve.frag";
    fragment.text = fmt::format(
        "#version 410 core\n"
        "uniform sampler2DMS s_samples;\n"  // texture unit 0
        "out vec4 o_mean;\n"
        "void main() {{\n"
        "    vec4 sum = vec4(0.0);\n"
        "    for (int i = 0; i < {0}; ++i) sum += texelFetch(s_samples, ivec2(gl_FragCoord.xy), i);\n"
        "    o_mean = sum / {0}.0;\n"
        "}}\n",
        samples);
    return {vertex, fragment};
}

/// Returns the program that averages samples. All targets that live share it.
std::shared_ptr<const Program> resolving_program(int samples) {
    static std::weak_ptr<const Program> living;
    std::shared_ptr<const Program> program = living.lock();
    if (!program) living = program = std::make_shared<const Program>(resolving(samples));
    return program;
}

}  // namespace

Target::Samples::Samples(int count) : resolve(resolving_program(count)) {}

Target::Target(TargetKind kind, glm::ivec2 size) : kind_(kind), size_(size) {
    const GLenum format = kind == TargetKind::picture ? GL_RGBA8 : GL_RGBA32F;
    GLint in_textures = 1, in_renderbuffers = 0;
    glGetIntegerv(GL_MAX_COLOR_TEXTURE_SAMPLES, &in_textures);
    // ES promises samples in renderbuffers for bytes only.
    if (in_textures <= 1 && kind == TargetKind::picture) glGetIntegerv(GL_MAX_SAMPLES, &in_renderbuffers);
    const int most = std::max(in_textures, in_renderbuffers);
    const int samples = kind == TargetKind::probe ? 0 : std::min(most, samples_of_pictures);
    glBindFramebuffer(GL_FRAMEBUFFER, drawn_);
    attach(GL_DEPTH_ATTACHMENT, depth_, GL_DEPTH_COMPONENT32F, samples, size);
    if (samples > 1 && in_textures > 1) {
        samples_.emplace(samples);
        glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, samples_->color);
        glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples, format, size.x, size.y, GL_TRUE);
        glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D_MULTISAMPLE, samples_->color, 0);
    } else {
        attach(GL_COLOR_ATTACHMENT0, color_.emplace(), format, samples, size);
    }
    label(GL_FRAMEBUFFER, drawn_, "target");
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (samples_) {
        glBindFramebuffer(GL_FRAMEBUFFER, samples_->framebuffer);
        attach(GL_COLOR_ATTACHMENT0, samples_->means, format, 0, size);
        label(GL_FRAMEBUFFER, samples_->framebuffer, "target, resolved");
    }
    if (samples > 1 && !samples_) {
        glBindFramebuffer(GL_FRAMEBUFFER, blitted_.emplace().framebuffer);
        attach(GL_COLOR_ATTACHMENT0, blitted_->means, format, 0, size);
    }
    const std::string errors = take_gl_errors();
    if (status != GL_FRAMEBUFFER_COMPLETE || !errors.empty())
        throw Error(fmt::format("this driver cannot allocate a picture of {}x{}{}", size.x, size.y,
                                errors.empty() ? "" : ": " + errors));
}

GLuint Target::resolve() const {
    if (blitted_) {
        glDisable(GL_SCISSOR_TEST);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_);
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, blitted_->framebuffer);
        glBlitFramebuffer(0, 0, size_.x, size_.y, 0, 0, size_.x, size_.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        return blitted_->framebuffer;
    }
    if (!samples_) return drawn_;
    glBindFramebuffer(GL_FRAMEBUFFER, samples_->framebuffer);
    glViewport(0, 0, size_.x, size_.y);
    for (const GLenum capability : {GL_BLEND, GL_CULL_FACE, GL_DEPTH_TEST, GL_SCISSOR_TEST}) glDisable(capability);
    glUseProgram(*samples_->resolve);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, samples_->color);
    glBindVertexArray(samples_->nothing);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
    glUseProgram(0);
    return samples_->framebuffer;
}

Image Target::read(int channels) const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, resolve());
    Image image(size_.x, size_.y, channels, kind_ == TargetKind::picture ? 8 : 32);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    const size_t width = size_t(size_.x), count = size_t(channels);
    const auto take = [&](const auto* rows, float scale) {
        for (int y = 0; y < size_.y; ++y) {
            const auto* from = rows + size_t(size_.y - 1 - y) * width * 4;
            float* to = image.pixel(0, y);
            for (size_t x = 0; x < width; ++x, from += 4)
                for (size_t c = 0; c < count; ++c) *to++ = float(from[c]) / scale;
        }
    };
    if (kind_ == TargetKind::picture) {
        std::vector<uint8_t> rows(width * size_t(size_.y) * 4);
        glReadPixels(0, 0, size_.x, size_.y, GL_RGBA, GL_UNSIGNED_BYTE, rows.data());
        take(rows.data(), 255);
    } else {
        std::vector<float> rows(width * size_t(size_.y) * 4);
        glReadPixels(0, 0, size_.x, size_.y, GL_RGBA, GL_FLOAT, rows.data());
        take(rows.data(), 1);
    }
    return image;
}

}  // namespace relief
