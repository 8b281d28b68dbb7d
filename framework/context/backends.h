// The three ways to a context, for context.cpp alone.
#pragma once

#include <memory>

#include "framework/base/module.h"
#include "framework/context/context.h"
#include "framework/gl/gl.h"

namespace relief {

std::unique_ptr<Context> open_osmesa();
std::unique_ptr<Context> open_egl();
std::unique_ptr<Context> open_hidden_window();

/// Why a driver is of no use that opens a context and none of OpenGL 4.1 core: which it is and what it has. Asks the
/// context of any kind that is current.
std::string too_little(LoadFunction* load);

/// The module with GLFW and the menu in it. Throws NoWindow.
const Module& window_module();

}  // namespace relief

/// What the window module offers to this layer; the caller owns the result.
extern "C" relief::Context* relief_open_hidden_window();
