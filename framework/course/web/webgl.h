// WebGL 2 as the OpenGL 4.1 that labs call.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <string>

namespace relief::web {

/// Creates the context of a page's canvas, named by a CSS selector, and loads its functions. Where WebGL 2 lacks a
/// function or an argument of one, another function takes its place, so that labs draw as they are:
/// - Shaders are converted by es_shader().
/// - 16-bit normalised textures become 32-bit floats, and border clamping becomes edge clamping.
/// - Doubles in uniforms, depth ranges and clear depths are rounded to single precision.
/// - Capabilities that ES lacks (multisampling) cannot be changed.
/// - Tessellation is emulated, and so are patches drawn as lines: see patch_drawing.h.
/// A geometry stage does not exist: glCreateShader() throws Error for one. Textures are never filtered anisotropically,
/// as in the pictures that checks compare with.
/// Throws Error if the browser has no WebGL 2, or cannot draw into floats.
void open_webgl(const char* canvas);

/// Limits the rounds of the loops in a task file: see es_shader(). `text` returns the text that shaders include now.
void limit_loops(std::function<std::string()> text);

/// Moves all vertices of later drawings by a part of a pixel, see check::vertex_moves.
void move_vertices(glm::vec2 pixels);

/// Returns the renderer's name, with that of the device if the browser tells it.
std::string renderer_name();

}  // namespace relief::web
