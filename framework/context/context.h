// OpenGL 4.1 core contexts: OSMesa (software, no display), EGL without a surface (software or
// a GPU, no display), or a GLFW window (a display). Each is opened by dlopen when it is asked for.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "framework/base/error.h"

namespace relief {

enum class ContextKind { osmesa, egl, window };

/// No window can be opened: no display, no GLFW, or no driver for it.
class NoWindow : public Error {
public:
    using Error::Error;
};

/// A context, current on this thread from its construction on, with the GL functions loaded. One at a time.
class Context {
public:
    virtual ~Context() = default;
    virtual void make_current() = 0;
};

/// Throws Error that names the Debian package to install, or says what else is missing.
std::unique_ptr<Context> open_context(ContextKind kind);

/// The first of OSMesa and EGL that opens; a line on standard error for each that does not.
/// Throws Error when none does.
std::unique_ptr<Context> open_any_context();

/// "auto" is nothing. Throws UsageError for an unknown name.
std::optional<ContextKind> context_kind(const std::string& name);
const char* name_of(ContextKind kind);
std::unique_ptr<Context> open_context(std::optional<ContextKind> kind);

/// The variables of the environment that choose a driver, as " (GALLIUM_DRIVER=softpipe is set)"; nothing when none is.
std::string driver_variables();

/// True when a window can be opened: X11 or Wayland is named in the environment.
bool has_display();

/// Makes Mesa's software renderer give the same bits on every x86-64 machine, about a fifth slower (golden
/// pictures, marks). Call before the first context of the process is opened.
void pin_software_renderer();
bool is_pinned();

/// The current context's description.
struct ContextInfo {
    std::string version, renderer, vendor, shading_language;
    int max_texture = 0, max_samples = 0, max_patch_vertices = 0, max_tessellation = 0;
    float max_anisotropy = 1;
    bool debug = false;

    /// Everything that determines the bits of a picture, in one line.
    std::string driver() const;
};
ContextInfo describe_context();

}  // namespace relief
