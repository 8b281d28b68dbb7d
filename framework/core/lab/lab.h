// The interface of a lab. Of this room, a lab includes this file alone.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "framework/core/gl/gl.h"
#include "framework/core/gl/gpu_mesh.h"
#include "framework/core/gl/program.h"
#include "framework/core/gl/texture.h"
#include "framework/core/image/image.h"
#include "framework/core/lab/camera.h"
#include "framework/core/lab/knobs.h"
#include "framework/core/lab/probe.h"
#include "framework/core/lab/registry.h"
#include "framework/core/lab/words.h"

namespace relief {

/// The input of a lab for one frame. Draw into `target`; framebuffer 0 does not exist everywhere.
/// The state of fragment operations (tests, masks, blending, culling, offsets, depth range) has GL's defaults, with two
/// exceptions: the depth test is on, and the clear colour is the background (the picture's, or +infinity for a probe).
/// Setting the viewport, the scissor box and the sample mask, and binding framebuffer, textures and buffers, is up to
/// the lab. Making a Target or the like binds another framebuffer.
struct Frame {
    GLuint target;
    glm::ivec2 size;  ///< pixels
    double time;      ///< seconds
    Camera camera;
    Probe probe;
    std::vector<PictureWord>* words = nullptr;  ///< takes the words over the picture; null: they are in the picture
    bool studio = false;  ///< the lab's objects stand on a floor before a backdrop (kit/studio.h); never on a probe

    /// Returns the ray through the centre of pixel (x, y) of the picture; row 0 is the top.
    Ray ray(int x, int y) const { return camera.ray({(x + 0.5) / size.x * 2 - 1, 1 - (y + 0.5) / size.y * 2}); }
};

/// A lab is one class in one file. It creates its GL objects at first use. So it can be constructed without a context,
/// and loads only the data that its knobs need.
class Lab {
public:
    Lab() = default;
    Lab(const Lab&) = delete;  // not movable: its textures and meshes refer to it
    virtual ~Lab() = default;
    virtual void draw(const Frame& frame) = 0;
    virtual void knobs(Knobs&) {}
    /// Returns the exact value of the frame's probe at every pixel, in double precision, or nothing if there is no
    /// exact solution. Four channels, as the shader writes them; +infinity where there is no surface. Needs no context:
    /// the window calls it on another thread, for a lab of its own, and parallel_each() may end it by throwing
    /// Cancelled.
    virtual std::optional<Image> truth(const Frame&) const { return {}; }
};

}  // namespace relief
