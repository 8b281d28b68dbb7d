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

GpuPatches::Uploaded::Uploaded()
    : points({{0, 3, GL_FLOAT, offsetof(PatchCorner, vertex) + offsetof(Vertex, position)},
              {1, 3, GL_FLOAT, offsetof(PatchCorner, vertex) + offsetof(Vertex, normal)},
              {2, 4, GL_FLOAT, offsetof(PatchCorner, vertex) + offsetof(Vertex, tangent)},
              {3, 2, GL_FLOAT, offsetof(PatchCorner, vertex) + offsetof(Vertex, uv)},
              {4, 3, GL_FLOAT, offsetof(PatchCorner, direction)},
              {5, 2, GL_FLOAT, offsetof(PatchCorner, height_uv)},
              {6, 4, GL_FLOAT, offsetof(PatchCorner, edge_uv)},
              {7, 2, GL_FLOAT, offsetof(PatchCorner, spacing)}}) {}

const GpuPatches::Uploaded& GpuPatches::uploaded() const {
    if (uploaded_) return *uploaded_;
    const PatchMesh mesh = make_();
    Uploaded result;
    result.points.fill(std::span<const PatchCorner>(mesh.points));
    result.points.attach(result.layout);
    result.patches = int(mesh.patches()), result.control_points = mesh.corners;
    return uploaded_.emplace(std::move(result));
}

}  // namespace relief
