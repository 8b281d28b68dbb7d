// Which corners of a mesh meet where.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "framework/base/buffer.h"
#include "framework/mesh/mesh.h"

namespace relief {

/// Throws Error when an index has no vertex, or the last triangle is not whole.
void check_indices(const Mesh& mesh);

/// For each vertex the first one that has the same position, normal and uv (0 and -0 are the same, and so are NaNs of
/// the same bits).
Buffer<uint32_t> welded_vertices(const Mesh& mesh);

/// The corners (indices into mesh.indices) at each vertex, in rising order.
class CornerLists {
public:
    /// `vertex_of[i]` is the vertex that vertex i counts as.
    CornerLists(const Mesh& mesh, const Buffer<uint32_t>& vertex_of, unsigned threads);

    std::span<const uint32_t> at(size_t vertex) const {
        return {&corners_[begins_[vertex]], begins_[vertex + 1] - begins_[vertex]};
    }

private:
    Buffer<uint32_t> begins_, corners_;
};

}  // namespace relief
