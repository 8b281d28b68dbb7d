// OpenGL 4.1 core, through the loader that glad generates when the build is configured.
#pragma once

#include <glad/gl.h>

#include <string>

namespace relief {

using LoadFunction = GLADapiproc(const char* name);

/// Fills the function pointers from the current context and puts the counters in front of them.
/// Throws Error when the context is older than 4.1.
void load_gl(LoadFunction* load);

/// Whether the current context draws on the CPU (Mesa's llvmpipe or softpipe).
bool is_software_renderer();

/// Where KHR_debug is present: names a GL object in debug messages and frame debuggers, else does nothing.
void label(GLenum kind, GLuint name, const std::string& text);

/// Where KHR_debug is present: errors are caught with their text as they happen.
void watch_errors();

/// The GL errors since the last call in one line, or "" if there were none.
std::string take_gl_errors();

}  // namespace relief
