// What a lab is. A lab includes this file and nothing above it.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <span>

#include "framework/gl/gl.h"
#include "framework/gl/gpu_mesh.h"
#include "framework/gl/program.h"
#include "framework/gl/texture.h"
#include "framework/image/image.h"
#include "framework/lab/camera.h"
#include "framework/lab/knobs.h"
#include "framework/lab/probe.h"
#include "framework/lab/registry.h"
#include "framework/mesh/shapes.h"

namespace relief {

/// The input of a lab for one frame. Draw into `target`; framebuffer 0 does not exist everywhere.
/// What decides how a fragment lands is at GL's defaults (tests, masks, blending, culling, depth range), but for these:
/// the depth test is on, and the clear colour is the background (the picture's, or +infinity for a probe). Viewport,
/// textures and buffers are the lab's to bind.
struct Frame {
    GLuint target;
    glm::ivec2 size;  ///< pixels
    double time;      ///< seconds
    Camera camera;
    Probe probe;

    /// Through the centre of pixel (x, y) of the picture, row 0 at the top.
    Ray ray(int x, int y) const { return camera.ray({(x + 0.5) / size.x * 2 - 1, 1 - (y + 0.5) / size.y * 2}); }
};

/// One class a lab, in one file. Members that hold GL objects are made at first use, so a lab can be made
/// without a context, and loads what its knobs need and no more.
class Lab {
public:
    Lab() = default;
    Lab(const Lab&) = delete;  // textures and meshes are made by what their lab knows, so it stays where it is
    virtual ~Lab() = default;
    virtual void draw(const Frame& frame) = 0;
    virtual void knobs(Knobs&) {}
    /// The exact value of a probe at every pixel of this frame, in double precision, where mathematics gives
    /// it. Four channels, as the shader writes them; +infinity where there is no surface.
    virtual std::optional<Image> truth(const Frame&, const Probe&) const { return {}; }
};

}  // namespace relief
