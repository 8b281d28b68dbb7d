// A mesh in textures, for shaders that cast rays at it.
#pragma once

#include "framework/core/lab/lab.h"
#include "framework/library/mesh/tree.h"

namespace relief {

/// A mesh and its tree of boxes. Its textures have four floats a texel: see shaders/07_baking/ray_mesh.glsl.
class RayMesh {
public:
    explicit RayMesh(Mesh mesh);
    RayMesh(const RayMesh&) = delete;  // its textures refer to this object

    /// Binds s_nodes, s_corners and s_normals to three units from `unit` on, and sets u_nodes. Precondition: the
    /// program is in use.
    void set(const Program& program, int unit) const;

    const Mesh mesh;
    const TriangleTree tree;
    const GpuMesh uploaded;  ///< to draw it
    const Texture nodes, corners, normals;
};

}  // namespace relief
