// Which corners of a mesh coincide.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "framework/core/base/mesh.h"
#include "framework/library/mesh/buffer.h"

namespace relief {

/// Throws Error when an index has no vertex, or the number of indices is not a multiple of 3.
void check_indices(const Mesh& mesh);

/// Returns for each vertex the first one with the same position, normal and uv. 0 equals -0, and a NaN equals a NaN of
/// the same bits. Tangents are ignored.
Buffer<uint32_t> welded_vertices(const Mesh& mesh);

/// The corners (indices into mesh.indices) at each vertex, in rising order.
class CornerLists {
public:
    /// `vertex_of[i]` is the vertex that stands for vertex i, for example from welded_vertices().
    CornerLists(const Mesh& mesh, const Buffer<uint32_t>& vertex_of, unsigned threads);

    std::span<const uint32_t> at(size_t vertex) const {
        return {&corners_[begins_[vertex]], begins_[vertex + 1] - begins_[vertex]};
    }

private:
    Buffer<uint32_t> begins_, corners_;
};

}  // namespace relief
