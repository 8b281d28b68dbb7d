#include "rings.h"

#include <algorithm>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "framework/library/kit/culling.h"
#include "framework/library/kit/view_axes.h"

namespace relief::ocean {
namespace {

constexpr int rings = 26, sectors = 48;
constexpr double sector = 2 * glm::pi<double>() / sectors;
constexpr double most = 64;  // segments along an edge of a patch

/// Returns the error in metres that covers `budget` pixels, at a distance in metres.
double tolerated(const Frame& frame, double budget, double distance) {
    return budget * distance * 2 * view_axes(frame.camera).half_height / frame.size.y;
}

std::array<PolarCircle, rings + 1> circles_of(const Frame& frame, const auto& exponent_at) {
    const double height = std::abs(frame.camera.eye().y), first = std::clamp(height, 0.5, 1e4),
                 last = 4e4 * std::max(1.0, first / 10), ratio = std::pow(last / first, 1.0 / (rings - 1));
    std::array<PolarCircle, rings + 1> circles;
    for (int i = 0; i <= rings; ++i) {
        const double radius = i == 0 ? 0 : first * std::pow(ratio, i - 1), exponent = exponent_at(radius);
        const double wanted = std::clamp(radius * sector / std::exp2(exponent), 1.0, most);
        circles[size_t(i)] = {radius, exponent, 1 << int(std::ceil(std::log2(wanted)))};
    }
    return circles;
}

/// Returns the corners of a box around a patch, relative to the eye. `highest` bounds the sea's height, metres.
std::array<glm::dvec3, 8> corners_of(const PolarCircle& inner, const PolarCircle& outer, double begin,
                                     double eye_height, double highest) {
    std::array<glm::dvec3, 8> corners;
    for (size_t i = 0; i < 8; ++i) {
        // The arc between two corners lies outside of its chord.
        const double radius = i & 1 ? outer.radius * 1.02 : inner.radius, angle = begin + (i & 2 ? sector : 0),
                     height = i & 4 ? highest : -highest;
        corners[i] = {radius * std::sin(angle), height - eye_height, radius * std::cos(angle)};
    }
    return corners;
}

glm::dmat4 clip_from_eye(const Camera& camera) {
    return camera.clip_from_world() * glm::translate(glm::dmat4(1), camera.eye());
}

}  // namespace

bool are_waves_visible(const Frame& frame, const Water& water, double budget) {
    double down = 0;  // largest downward component of a unit ray
    for (const glm::dvec2 clip : {glm::dvec2(0, -1), {-1, -1}, {1, -1}, {0, 0}, {0, 1}})
        down = std::max(down, -frame.camera.ray(clip).direction.y);
    if (down > 0.95) down = 1;
    const double nearest = std::max(0.0, frame.camera.eye().y - water.highest()) / std::max(down, 1e-9);
    return down > 0 && water.segment_exponent(tolerated(frame, budget, nearest)) < Water::endless;
}

PolarGrid grid_of(const Frame& frame, const Water& water, double budget, bool is_raised) {
    const double eye_height = frame.camera.eye().y, highest = is_raised ? water.highest() : 0;
    const auto circles = circles_of(frame, [&](double radius) {
        if (!is_raised) return Water::endless;
        return water.segment_exponent(tolerated(frame, budget, std::hypot(radius, eye_height)));
    });
    const glm::dmat4 clip = clip_from_eye(frame.camera);
    PolarGrid grid;
    for (size_t ring = 0; ring < rings; ++ring) {
        const PolarCircle &inner = circles[ring], &outer = circles[ring + 1];
        const double shortest = std::exp2(std::min(inner.detail, outer.detail));
        const int rows = int(std::ceil(std::clamp((outer.radius - inner.radius) / shortest, 1.0, most)));
        for (int i = 0; i < sectors; ++i)
            if (!is_outside(clip, corners_of(inner, outer, sector * i, eye_height, highest)))
                add_patch(grid, inner, outer, sector * i, sector, rows);
    }
    return grid;
}

void Rings::fill(PolarGrid grid) {
    grid_ = std::move(grid);
    if (!buffers_) buffers_.emplace();
    glBindVertexArray(buffers_->layout);
    glBindBuffer(GL_ARRAY_BUFFER, buffers_->vertices);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(grid_.vertices.size() * sizeof(PolarVertex)), grid_.vertices.data(),
                 GL_STREAM_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(PolarVertex), nullptr);
}

void Rings::draw(const Program& program, const Camera& camera, bool wire) const {
    program.set("u_clip_from_eye", clip_from_eye(camera));
    program.set("u_eye_height", camera.eye().y);
    program.set("u_near", std::min(0.1, 0.02 * camera.orbit().distance));
    const std::vector<unsigned> indices = wire ? edges_of(grid_.indices) : grid_.indices;
    glBindVertexArray(buffers_->layout);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_->indices);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(indices.size() * sizeof(unsigned)), indices.data(),
                 GL_STREAM_DRAW);
    glDrawElements(wire ? GL_LINES : GL_TRIANGLES, GLsizei(indices.size()), GL_UNSIGNED_INT, nullptr);
}

}  // namespace relief::ocean
