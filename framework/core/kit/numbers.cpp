#include "framework/core/kit/numbers.h"

#include "framework/core/base/parallel.h"
#include "framework/core/gl/missing_tasks.h"
#include "framework/core/gl/target.h"

namespace relief {

Image draw_numbers(glm::ivec2 size, const std::function<void()>& draw) {
    GLint framebuffer = 0, viewport[4] = {};
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
    glGetIntegerv(GL_VIEWPORT, viewport);
    const Target target(TargetKind::probe, size);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
    glViewport(0, 0, size.x, size.y);
    constexpr float nothing[] = {no_surface, no_surface, no_surface, no_surface};
    glClearBufferfv(GL_COLOR, 0, nothing);
    glClear(GL_DEPTH_BUFFER_BIT);
    {
        const TellMissingTasks told;  // the placeholder of a missing task then writes not_written, not numbers
        draw();
    }
    Image drawn = target.read();
    glBindFramebuffer(GL_FRAMEBUFFER, GLuint(framebuffer));
    glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
    return drawn;
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
