// Meshes that are uploaded when a draw first needs them.
#pragma once

#include <functional>
#include <optional>

#include "framework/core/base/mesh.h"
#include "framework/core/gl/vertex_stream.h"

namespace relief {

/// Attribute locations, the same in every lab: 0 position, 1 normal, 2 tangent (with the handedness in w), 3 uv.
class GpuMesh {
public:
    explicit GpuMesh(std::function<Mesh()> make) : make_(std::move(make)) {}

    GLuint layout() const { return uploaded().layout; }  ///< vertex array, including the index buffer
    GLsizei count() const { return uploaded().count; }   ///< number of indices, GL_UNSIGNED_INT
    GLsizei vertices() const { return uploaded().vertices.count(); }

private:
    struct Uploaded {
        Uploaded();
        VertexArrayName layout;
        VertexStream vertices;
        BufferName indices;
        GLsizei count = 0;
    };
    const Uploaded& uploaded() const;

    std::function<Mesh()> make_;
    mutable std::optional<Uploaded> uploaded_;
};

/// `upload([] { return make_quad({.width = 2}); })`: the mesh is made and uploaded at first use.
inline GpuMesh upload(std::function<Mesh()> make) { return GpuMesh(std::move(make)); }

}  // namespace relief
