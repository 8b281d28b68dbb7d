#include "framework/library/kit/difference_map.h"

namespace relief {
namespace {

void draw_into(std::optional<TexelTarget>& target, glm::ivec2 size, const std::function<void()>& draw) {
    if (!target || glm::any(glm::lessThan(target->size(), size))) {
        const glm::ivec2 before = target ? target->size() : glm::ivec2(0);
        target.emplace(glm::max(before, size), std::initializer_list<GLenum>{GL_RGBA32F}, false, true);
    }
    target->begin();
    constexpr float nothing[] = {no_surface, no_surface, no_surface, no_surface};
    glClearBufferfv(GL_COLOR, 0, nothing);
    glClear(GL_DEPTH_BUFFER_BIT);
    glViewport(0, 0, size.x, size.y);
    draw();
}

}  // namespace

void DifferenceMap::draw(const Frame& frame, const Tile& tile, int left, const std::function<void()>& measured,
                         const std::function<void()>& exact) {
    if (tile.size.x <= 0 || tile.size.y <= 0) return;
    draw_into(measured_, tile.size, measured);
    draw_into(exact_, tile.size, exact);
    const Program& program = program_.with(metric_ == ErrorMetric::angle ? "ANGLE" : "");
    glUseProgram(program);
    program.set("u_corner", tile.corner);
    program.set("u_powers", glm::vec2(low_, high_));
    program.set("s_measured", 0);
    program.set("s_exact", 1);
    measured_->bind(0);
    exact_->bind(1);
    glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
    glViewport(tile.corner.x + left, tile.corner.y, tile.size.x - left, tile.size.y);
    window_.draw();
}

}  // namespace relief
