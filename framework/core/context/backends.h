// The backends of a context, used by context.cpp only.
#pragma once

#include <memory>
#include <span>

#include "framework/core/base/module.h"
#include "framework/core/context/context.h"
#include "framework/core/gl/gl.h"

namespace relief {

/// Returns the kinds of context that a run tries in turn when it is asked for none.
std::span<const ContextKind> automatic_kinds();

std::unique_ptr<Context> open_osmesa();
std::unique_ptr<Context> open_egl();
/// Opens a context on a hardware driver. Throws Error if there is none.
std::unique_ptr<Context> open_gpu();
std::unique_ptr<Context> open_hidden_window();

/// Explains why the current context is below OpenGL 4.1 core. Names the driver, its OpenGL version and the environment
/// variables that choose a driver. `load` is the loader of the current context, which may have any version.
std::string too_little(LoadFunction* load);

/// The module with GLFW and the menu. Throws NoWindow if there is no display or the module does not open.
const Module& window_module();

}  // namespace relief

/// Entry point of the window module; the caller owns the result.
extern "C" relief::Context* relief_open_hidden_window();
