// Replaces osmesa.cpp and egl.cpp on systems that have neither: pictures are drawn by a hidden window's context.
#include "framework/core/base/error.h"
#include "framework/core/context/backends.h"

namespace relief {

std::span<const ContextKind> automatic_kinds() {
    static constexpr ContextKind kinds[] = {ContextKind::window};
    return kinds;
}

std::unique_ptr<Context> open_osmesa() { throw Error("this system has no OSMesa"); }
std::unique_ptr<Context> open_egl() { throw Error("this system has no EGL"); }
std::unique_ptr<Context> open_gpu() { return open_hidden_window(); }

}  // namespace relief
