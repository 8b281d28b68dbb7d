#include "polar_grid.h"

#include <algorithm>

namespace relief {
namespace {

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

}  // namespace

void add_patch(PolarGrid& grid, const PolarCircle& inner, const PolarCircle& outer, double begin, double width,
               int rows) {
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
                                     float(begin + width * i / segments),
                                     float(glm::mix(inner.detail, outer.detail, along))});
        if (row > 0) join_rows(grid.indices, before, segments_before, first, segments);
        before = first, segments_before = segments;
    }
}

std::vector<unsigned> edges_of(const std::vector<unsigned>& triangles) {
    std::vector<unsigned> edges;
    for (size_t i = 0; i < triangles.size(); i += 3)
        for (size_t k = 0; k < 3; ++k) edges.insert(edges.end(), {triangles[i + k], triangles[i + (k + 1) % 3]});
    return edges;
}

}  // namespace relief
