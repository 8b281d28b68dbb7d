#include "framework/core/gl/gpu_mesh.h"

#include <cstddef>

namespace relief {

GpuMesh::Uploaded::Uploaded()
    : vertices({{0, 3, GL_FLOAT, offsetof(Vertex, position)},
                {1, 3, GL_FLOAT, offsetof(Vertex, normal)},
                {2, 4, GL_FLOAT, offsetof(Vertex, tangent)},
                {3, 2, GL_FLOAT, offsetof(Vertex, uv)}}) {}

const GpuMesh::Uploaded& GpuMesh::uploaded() const {
    if (uploaded_) return *uploaded_;
    const Mesh mesh = make_();
    Uploaded result;
    result.vertices.fill(std::span<const Vertex>(mesh.vertices));
    result.vertices.attach(result.layout);
    result.count = GLsizei(mesh.indices.size());
    GLint bound = 0;  // restored below: another mesh may be bound
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &bound);
    glBindVertexArray(result.layout);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, result.indices);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(mesh.indices.size() * sizeof(uint32_t)), mesh.indices.data(),
                 GL_STATIC_DRAW);
    glBindVertexArray(GLuint(bound));
    return uploaded_.emplace(std::move(result));
}

}  // namespace relief
