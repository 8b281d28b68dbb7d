#include "framework/core/gl/gpu_mesh.h"

#include <cstddef>

namespace relief {

const GpuMesh::Uploaded& GpuMesh::uploaded() const {
    if (uploaded_) return *uploaded_;
    const Mesh mesh = make_();
    Uploaded result;
    GLint bound = 0;  // restored below: another mesh may be bound
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &bound);
    result.count = GLsizei(mesh.indices.size());
    result.vertex_count = GLsizei(mesh.vertices.size());
    glBindVertexArray(result.layout);
    glBindBuffer(GL_ARRAY_BUFFER, result.vertices);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(mesh.vertices.size() * sizeof(Vertex)), mesh.vertices.data(),
                 GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, result.indices);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(mesh.indices.size() * sizeof(uint32_t)), mesh.indices.data(),
                 GL_STATIC_DRAW);
    const auto attribute = [](GLuint location, GLint size, size_t offset) {
        glEnableVertexAttribArray(location);
        glVertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                              reinterpret_cast<const void*>(offset));
    };
    attribute(0, 3, offsetof(Vertex, position));
    attribute(1, 3, offsetof(Vertex, normal));
    attribute(2, 4, offsetof(Vertex, tangent));
    attribute(3, 2, offsetof(Vertex, uv));
    glBindVertexArray(GLuint(bound));
    return uploaded_.emplace(std::move(result));
}

}  // namespace relief
