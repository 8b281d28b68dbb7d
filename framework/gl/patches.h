// Patches on the GPU, and a draw call that works around a limit of Mesa.
#pragma once

#include <functional>
#include <optional>

#include "framework/gl/object.h"
#include "framework/mesh/patches.h"

namespace relief {

/// glDrawArrays of GL_PATCHES: `patches` of `control_points` vertices each, from `first_vertex` on. Program, state and
/// vertex array are the caller's.
///
/// Mesa's software renderer numbers the vertices that an evaluation shader makes in one draw with 16 bits: above 65,535
/// it draws others than asked for, without an error, in quadratic time. There 8 patches are a draw, which is 33,800
/// vertices at level 64; elsewhere all are. So gl_PrimitiveID means nothing to a shader: gl_VertexID does.
void draw_patches(int patches, int control_points, int first_vertex = 0);

/// A PatchMesh, uploaded when a draw first needs it, for shaders/common/patch.vert.
class GpuPatches {
public:
    explicit GpuPatches(std::function<PatchMesh()> make) : make_(std::move(make)) {}

    GLuint layout() const { return uploaded().layout; }
    int count() const { return uploaded().patches; }
    int control_points() const { return uploaded().control_points; }

private:
    struct Uploaded {
        VertexArrayName layout;
        BufferName points;
        int patches = 0, control_points = 0;
    };
    const Uploaded& uploaded() const;

    std::function<PatchMesh()> make_;
    mutable std::optional<Uploaded> uploaded_;
};

}  // namespace relief
