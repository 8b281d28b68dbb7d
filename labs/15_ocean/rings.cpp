#include "rings.h"

#include <algorithm>
#include <array>

namespace relief::ocean {
namespace {

constexpr int rings = 26, sectors = 48;
constexpr double sector = 2 * glm::pi<double>() / sectors;
constexpr double most = 64;  // segments along an edge of a patch

/// A circle on which patches meet.
struct Circle {
    double radius, exponent;
    int segments;  ///< of a sector, a power of two: both of its rings have the same vertices on it
};

std::array<Circle, rings + 1> circles_of(const Frame& frame, const auto& exponent_at) {
    const double height = std::abs(frame.camera.eye().y), first = std::clamp(height, 0.5, 1e4),
                 last = 4e4 * std::max(1.0, first / 10), ratio = std::pow(last / first, 1.0 / (rings - 1));
    std::array<Circle, rings + 1> circles;
    for (int i = 0; i <= rings; ++i) {
        const double radius = i == 0 ? 0 : first * std::pow(ratio, i - 1), exponent = exponent_at(radius);
        const double wanted = std::clamp(radius * sector / std::exp2(exponent), 1.0, most);
        circles[size_t(i)] = {radius, exponent, 1 << int(std::ceil(std::log2(wanted)))};
    }
    return circles;
}

/// Returns whether a patch lies outside of the picture. `highest` is an upper bound of the sea's height in metres.
bool is_outside(const glm::dmat4& clip_from_eye, double eye_height, double highest, const Circle& inner,
                const Circle& outer, double angle) {
    std::array<bool, 5> all;
    all.fill(true);
    for (int i = 0; i < 8; ++i) {
        // The arc between two corners lies outside of its chord.
        const double radius = i & 1 ? outer.radius * 1.02 : inner.radius, at = angle + (i & 2 ? sector : 0),
                     height = i & 4 ? highest : -highest;
        const glm::dvec4 clip =
            clip_from_eye * glm::dvec4(radius * std::sin(at), height - eye_height, radius * std::cos(at), 1);
        const std::array outside = {clip.x<-clip.w, clip.x> clip.w, clip.y<-clip.w, clip.y> clip.w, clip.w < 0};
        for (size_t side = 0; side < 5; ++side) all[side] = all[side] && outside[side];
    }
    return std::find(all.begin(), all.end(), true) != all.end();
}

/// Adds the triangles between two rows of vertices. One row has a power of two times as many segments as the other.
void join_rows(std::vector<unsigned>& indices, unsigned a, int segments_a, unsigned b, int segments_b) {
    const bool a_is_finer = segments_a > segments_b;
    const unsigned fine = a_is_finer ? a : b, coarse = a_is_finer ? b : a;
    const unsigned count = unsigned(std::min(segments_a, segments_b)),
                   each = unsigned(std::max(segments_a, segments_b)) / count;
    for (unsigned i = 0; i < count; ++i) {
        // A fan of the first half of the fine segments, one of the second half, and the triangle between both.
        for (unsigned k = 0; k < each; ++k)
            indices.insert(indices.end(),
                           {coarse + i + (k < each / 2 ? 0 : 1), fine + i * each + k, fine + i * each + k + 1});
        indices.insert(indices.end(), {coarse + i, fine + i * each + each / 2, coarse + i + 1});
    }
}

void add_patch(RingGrid& grid, const Circle& inner, const Circle& outer, double angle) {
    const double shortest = std::exp2(std::min(inner.exponent, outer.exponent));
    const int rows = int(std::ceil(std::clamp((outer.radius - inner.radius) / shortest, 1.0, most)));
    unsigned before = 0;
    int segments_before = 0;
    for (int row = 0; row <= rows; ++row) {
        const int segments = row == 0      ? inner.segments
                             : row == rows ? outer.segments
                                           : std::max(inner.segments, outer.segments);
        const double along = double(row) / rows;
        const unsigned first = unsigned(grid.vertices.size());
        for (int i = 0; i <= segments; ++i)
            grid.vertices.push_back({float(glm::mix(inner.radius, outer.radius, along)),
                                     float(angle + sector * i / segments),
                                     float(glm::mix(inner.exponent, outer.exponent, along))});
        if (row > 0) join_rows(grid.indices, before, segments_before, first, segments);
        before = first, segments_before = segments;
    }
}

/// Returns the edges of triangles as lines. A browser cannot draw a triangle as lines.
std::vector<unsigned> edges_of(const std::vector<unsigned>& triangles) {
    std::vector<unsigned> edges;
    for (size_t i = 0; i < triangles.size(); i += 3)
        for (size_t k = 0; k < 3; ++k) edges.insert(edges.end(), {triangles[i + k], triangles[i + (k + 1) % 3]});
    return edges;
}

glm::dmat4 clip_from_eye(const Frame& frame) {
    const glm::dvec3 eye = frame.camera.eye();
    return frame.camera.clip_from_world() * glm::dmat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, eye.x, eye.y, eye.z, 1);
}

}  // namespace

bool Rings::are_raised(const Frame& frame, const Water& water) const {
    if (!displace) return false;
    double down = 0;  // largest downward component of a unit ray
    for (const glm::dvec2 clip : {glm::dvec2(0, -1), {-1, -1}, {1, -1}, {0, 0}, {0, 1}})
        down = std::max(down, -frame.camera.ray(clip).direction.y);
    if (down > 0.95) down = 1;
    const double nearest = std::max(0.0, frame.camera.eye().y - water.highest()) / std::max(down, 1e-9);
    return down > 0 && water.segment_exponent(tolerated(frame, nearest)) < Water::endless;
}

RingGrid Rings::grid(const Frame& frame, const Water& water, bool is_raised) const {
    const double eye_height = frame.camera.eye().y, highest = is_raised ? water.highest() : 0;
    const auto circles = circles_of(frame, [&](double radius) {
        return is_raised ? water.segment_exponent(tolerated(frame, std::hypot(radius, eye_height))) : Water::endless;
    });
    const glm::dmat4 clip = clip_from_eye(frame);
    RingGrid grid;
    for (size_t ring = 0; ring < rings; ++ring)
        for (int i = 0; i < sectors; ++i)
            if (!is_outside(clip, eye_height, highest, circles[ring], circles[ring + 1], sector * i))
                add_patch(grid, circles[ring], circles[ring + 1], sector * i);
    return grid;
}

void Rings::draw(const Program& program, const Frame& frame, const Water& water, bool is_raised, bool wire) {
    program.set("u_clip_from_eye", clip_from_eye(frame));
    program.set("u_eye_height", frame.camera.eye().y);
    program.set("u_near", std::min(0.1, 0.02 * frame.camera.orbit().distance));
    const RingGrid grid = this->grid(frame, water, is_raised);
    const std::vector<unsigned> indices = wire ? edges_of(grid.indices) : grid.indices;
    if (!buffers_) buffers_.emplace();
    glBindVertexArray(buffers_->layout);
    glBindBuffer(GL_ARRAY_BUFFER, buffers_->vertices);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(grid.vertices.size() * sizeof(RingVertex)), grid.vertices.data(),
                 GL_STREAM_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(RingVertex), nullptr);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_->indices);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(indices.size() * sizeof(unsigned)), indices.data(),
                 GL_STREAM_DRAW);
    glDrawElements(wire ? GL_LINES : GL_TRIANGLES, GLsizei(indices.size()), GL_UNSIGNED_INT, nullptr);
}

double Rings::tolerated(const Frame& frame, double distance) const {
    return double(budget) * distance * 2 * view_axes(frame.camera).half_height / frame.size.y;
}

}  // namespace relief::ocean
