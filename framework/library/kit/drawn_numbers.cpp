#include "framework/library/kit/drawn_numbers.h"

#include "framework/core/base/parallel.h"
#include "framework/core/gl/target.h"
#include "framework/core/gl/texel_target.h"

namespace relief {

namespace {

/// Restores, when it goes, the framebuffer and the viewport that were bound when it was made.
class BoundBefore {
public:
    BoundBefore() {
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer_);
        glGetIntegerv(GL_VIEWPORT, viewport_);
    }
    BoundBefore(const BoundBefore&) = delete;
    ~BoundBefore() {
        glBindFramebuffer(GL_FRAMEBUFFER, GLuint(framebuffer_));
        glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
    }

private:
    GLint framebuffer_ = 0, viewport_[4] = {};
};

}  // namespace

Image draw_numbers(glm::ivec2 size, const std::function<void()>& draw) {
    const BoundBefore before;
    const Target target(TargetKind::probe, size);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
    glViewport(0, 0, size.x, size.y);
    constexpr float nothing[] = {no_surface, no_surface, no_surface, no_surface};
    glClearBufferfv(GL_COLOR, 0, nothing);
    glClear(GL_DEPTH_BUFFER_BIT);
    draw();
    return target.read();
}

std::array<glm::vec4, 4> draw_pixel(glm::ivec2 size, glm::ivec2 pixel, const std::function<void()>& draw) {
    const BoundBefore before;
    const TexelTarget target(glm::ivec2(1), {GL_RGBA32F, GL_RGBA32F, GL_RGBA32F, GL_RGBA32F}, false, true);
    target.begin();
    constexpr float nothing[] = {0, 0, 0, 0};
    for (GLint i = 0; i < 4; ++i) glClearBufferfv(GL_COLOR, i, nothing);
    glClear(GL_DEPTH_BUFFER_BIT);
    glViewport(-pixel.x, pixel.y + 1 - size.y, size.x, size.y);
    draw();
    std::array<glm::vec4, 4> outputs;
    for (size_t i = 0; i < outputs.size(); ++i) {
        const Image texel = target.read(i);
        outputs[i] = {texel.values[0], texel.values[1], texel.values[2], texel.values[3]};
    }
    return outputs;
}

Image image_of_values(glm::ivec2 size, const std::function<glm::dvec4(int x, int y)>& value) {
    Image image(size.x, size.y, 4);
    // Rows of sky cost little and rows of ground much, so no thread gets half of the picture.
    parallel_each(size_t(size.y), 0, [&](size_t y) {
        for (int x = 0; x < size.x; ++x) {
            const glm::vec4 values(value(x, int(y)));
            for (int c = 0; c < 4; ++c) image.pixel(x, int(y))[c] = values[c];
        }
    });
    return image;
}

Image truth_of_rays(const Frame& frame, const std::function<std::optional<glm::dvec4>(const Ray&)>& value) {
    return image_of_values(frame.size,
                           [&](int x, int y) { return value(frame.ray(x, y)).value_or(glm::dvec4(no_surface)); });
}

}  // namespace relief
