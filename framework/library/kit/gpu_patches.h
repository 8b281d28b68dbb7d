// Patches on the GPU, and a draw call that works around a limit of Mesa.
#pragma once

#include <functional>
#include <optional>

#include "framework/core/gl/vertex_stream.h"
#include "framework/library/mesh/patches.h"

namespace relief {

/// Draws `patches` patches of `control_points` vertices each with glDrawArrays(GL_PATCHES), starting at `first_vertex`.
/// The caller sets the program, the state and the vertex array.
///
/// Mesa's software renderer indexes the vertices of one tessellated draw with 16 bits. Above 65,535 it draws wrong
/// vertices, without an error, in quadratic time. So it gets one draw call for every 8 patches, which make 33,800
/// vertices at level 64. A GPU gets a single draw call. Shaders must use gl_VertexID instead of gl_PrimitiveID, which
/// restarts with each draw call.
void draw_patches(int patches, int control_points, int first_vertex = 0);

/// A PatchMesh with the vertex layout of shaders/common/patch.vert, uploaded when a draw first needs it.
class GpuPatches {
public:
    explicit GpuPatches(std::function<PatchMesh()> make) : make_(std::move(make)) {}

    GLuint layout() const { return uploaded().layout; }
    int count() const { return uploaded().patches; }
    int control_points() const { return uploaded().control_points; }

private:
    struct Uploaded {
        Uploaded();
        VertexArrayName layout;
        VertexStream points;
        int patches = 0, control_points = 0;
    };
    const Uploaded& uploaded() const;

    std::function<PatchMesh()> make_;
    mutable std::optional<Uploaded> uploaded_;
};

}  // namespace relief
