// OpenGL 4.1 core contexts: OSMesa (software, no display), EGL without a surface (software or GPU, no display), or a
// GLFW window (needs a display). Each library is opened by dlopen on first use.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "framework/core/base/error.h"

namespace relief {

/// `gpu` is EGL on a hardware driver, or a hidden window's context on systems without EGL. It never is software.
enum class ContextKind { osmesa, egl, gpu, window };

/// No window can be opened: no display, no GLFW, or no driver for it.
class NoWindow : public Error {
public:
    using Error::Error;
};

/// A context with the GL functions loaded. It is current on its thread from construction. At most one at a time.
class Context {
public:
    virtual ~Context() = default;
    virtual void make_current() = 0;
};

/// Opens a context of this kind. Throws Error that names the Debian package to install or the missing part.
std::unique_ptr<Context> open_context(ContextKind kind);

/// Parses the name of a kind; "auto" gives nothing. Throws UsageError for an unknown name.
std::optional<ContextKind> context_kind(const std::string& name);
const char* name_of(ContextKind kind);
/// Opens a context of this kind. Without a kind, opens OSMesa or, if it is missing or fails, EGL. On systems without
/// both, opens a hidden window. Throws Error with each reason.
std::unique_ptr<Context> open_context(std::optional<ContextKind> kind);

/// Returns whether this system can draw without a display.
bool draws_without_display();

/// Returns the environment variables that choose a driver, as " (GALLIUM_DRIVER=softpipe is set)", or "" if none is
/// set.
std::string driver_variables();

/// Makes Mesa's software renderer produce the same bits on every x86-64 machine, about 20 % slower. Golden pictures and
/// marks need this. After it, EGL opens no hardware driver. Precondition: no context of this process has been opened.
void pin_software_renderer();

/// Makes Mesa's software renderer optimise the code of shaders, for a process that draws one picture many times.
/// Without it, a program compiles in a third of the time, and a frame takes up to 1.9 times as long (median 1.1), with
/// the same bits: a command that draws each picture once ends earlier, with the sea of lab 15 seven times. A variable
/// GALLIVM_PERF of the user decides instead. Precondition: no context of this process has been opened.
void optimize_shaders();
bool is_pinned();

/// Properties of the current context.
struct ContextInfo {
    std::string version, renderer, vendor, shading_language;
    int max_texture = 0, max_samples = 0, max_patch_vertices = 0, max_tessellation = 0;
    float max_anisotropy = 1;
    bool debug = false;

    /// Returns everything that determines the bits of a picture, in one line.
    std::string driver() const;
};
ContextInfo describe_context();

}  // namespace relief
