// A hidden window's context: from the module that holds GLFW, so that headless runs never load it.
#include "framework/base/error.h"
#include "framework/context/backends.h"

namespace relief {

const Module& window_module() {
    static const Module module = open_own_module("relief-window.so", "libglfw3");
    return module;
}

std::unique_ptr<Context> open_hidden_window() {
    if (!has_display()) throw Error("there is no display (DISPLAY and WAYLAND_DISPLAY are empty)");
    return std::unique_ptr<Context>(
        window_module().function<decltype(relief_open_hidden_window)>("relief_open_hidden_window")());
}

}  // namespace relief
