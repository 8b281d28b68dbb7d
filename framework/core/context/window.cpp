// The context of a hidden window. Loads GLFW's module on demand, so that headless runs never load it.
#include "framework/core/base/error.h"
#include "framework/core/base/system.h"
#include "framework/core/context/backends.h"

namespace relief {

const Module& window_module() {
    if (!os::has_display()) throw NoWindow("there is no display (DISPLAY and WAYLAND_DISPLAY are empty)");
    try {
        static const Module module = open_own_module("relief-window.so", "libglfw3");
        return module;
    } catch (const Error& error) {
        throw NoWindow(error.what());
    }
}

std::unique_ptr<Context> open_hidden_window() {
    return std::unique_ptr<Context>(
        window_module().function<decltype(relief_open_hidden_window)>("relief_open_hidden_window")());
}

}  // namespace relief
