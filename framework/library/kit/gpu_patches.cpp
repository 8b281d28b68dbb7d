#include "framework/library/kit/gpu_patches.h"

#include <algorithm>
#include <cstddef>

namespace relief {

void draw_patches(int patches, int control_points, int first_vertex) {
    glPatchParameteri(GL_PATCH_VERTICES, control_points);
    const int together = is_software_renderer() ? 8 : std::max(patches, 1);
    for (int begin = 0; begin < patches; begin += together)
        glDrawArrays(GL_PATCHES, first_vertex + begin * control_points,
                     std::min(together, patches - begin) * control_points);
}

const GpuPatches::Uploaded& GpuPatches::uploaded() const {
    if (uploaded_) return *uploaded_;
    const PatchMesh mesh = make_();
    Uploaded result;
    GLint bound = 0;  // restored below: another mesh may be bound
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &bound);
    result.patches = int(mesh.patches()), result.control_points = mesh.corners;
    glBindVertexArray(result.layout);
    glBindBuffer(GL_ARRAY_BUFFER, result.points);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(mesh.points.size() * sizeof(PatchCorner)), mesh.points.data(),
                 GL_STATIC_DRAW);
    const auto attribute = [](GLuint location, GLint size, size_t offset) {
        glEnableVertexAttribArray(location);
        glVertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, sizeof(PatchCorner),
                              reinterpret_cast<const void*>(offset));
    };
    attribute(0, 3, offsetof(PatchCorner, vertex) + offsetof(Vertex, position));
    attribute(1, 3, offsetof(PatchCorner, vertex) + offsetof(Vertex, normal));
    attribute(2, 4, offsetof(PatchCorner, vertex) + offsetof(Vertex, tangent));
    attribute(3, 2, offsetof(PatchCorner, vertex) + offsetof(Vertex, uv));
    attribute(4, 3, offsetof(PatchCorner, direction));
    attribute(5, 2, offsetof(PatchCorner, height_uv));
    attribute(6, 4, offsetof(PatchCorner, edge_uv));
    attribute(7, 2, offsetof(PatchCorner, spacing));
    glBindVertexArray(GLuint(bound));
    return uploaded_.emplace(std::move(result));
}

}  // namespace relief
