// OpenGL 4.1 core, through the loader that glad generates when the build is configured.
#pragma once

#include <glad/gl.h>

#include <string>

namespace relief {

using LoadFunction = GLADapiproc(const char* name);

/// Loads the function pointers from the current context and wraps them with the counters. Throws Error when the context
/// is older than OpenGL 4.1.
void load_gl(LoadFunction* load);

/// Returns whether the current context renders on the CPU (Mesa's llvmpipe or softpipe).
bool is_software_renderer();

/// From now on, draws with what all renderers have, so that pictures of two of them can be compared: without
/// anisotropic filtering (TextureOptions).
void draw_comparably();
bool draws_comparably();

/// Makes draws_comparably() true while it exists, then restores it.
class ComparableDrawing {
public:
    ComparableDrawing() : before_(draws_comparably()) { draw_comparably(); }
    ComparableDrawing(const ComparableDrawing&) = delete;
    ~ComparableDrawing();

private:
    bool before_;
};

/// Names a GL object in debug messages and frame debuggers. Does nothing without KHR_debug.
void label(GLenum kind, GLuint name, const std::string& text);

/// Collects GL errors with their text as they happen. Does nothing without KHR_debug.
void watch_errors();

/// Returns the GL errors since the last call in one line, or "" if there were none. Lists at most 8.
std::string take_gl_errors();

}  // namespace relief
