// A software context without a display, from Mesa's off-screen library.
#include "framework/core/gl/gl.h"  // before osmesa.h, which would include the system's gl.h

// glad undefines these macros at its end, and the osmesa.h of Mesa 25 needs them.
#ifndef APIENTRY
    #define APIENTRY GLAD_API_PTR
#endif
#ifndef GLAPI
    #define GLAPI extern
#endif
#include <GL/osmesa.h>

#include <array>
#include <cstdlib>
#include <string_view>

#include "framework/core/base/error.h"
#include "framework/core/base/process.h"
#include "framework/core/context/backends.h"

namespace relief {
namespace {

class OsMesa final : public Context {
public:
    OsMesa() {
        const int attributes[] = {OSMESA_FORMAT,
                                  OSMESA_RGBA,
                                  OSMESA_DEPTH_BITS,
                                  0,
                                  OSMESA_PROFILE,
                                  OSMESA_CORE_PROFILE,
                                  OSMESA_CONTEXT_MAJOR_VERSION,
                                  4,
                                  OSMESA_CONTEXT_MINOR_VERSION,
                                  1,
                                  0};
        refuse_drivers_that_crash();
        context_ = create_(attributes, nullptr);
        if (!context_) throw Error(reason());
        OsMesa::make_current();
        load_gl(reinterpret_cast<LoadFunction*>(load_));
    }
    ~OsMesa() override { destroy_(context_); }
    OsMesa(const OsMesa&) = delete;
    OsMesa& operator=(const OsMesa&) = delete;

    void make_current() override {
        if (!make_current_(context_, window_.data(), GL_UNSIGNED_BYTE, 4, 4))
            throw Error("OSMesa cannot make its context current");
    }

private:
    /// OSMesa does not check whether the driver in GALLIUM_DRIVER exists and crashes without it (Mesa 22.3 with zink
    /// and no Vulkan). So every driver but llvmpipe and softpipe is first tried in a child process.
    void refuse_drivers_that_crash() const {
        const char* const name = std::getenv("GALLIUM_DRIVER");
        if (!name || !*name || std::string_view(name) == "llvmpipe" || std::string_view(name) == "softpipe") return;
        const auto attempt = [this] {
            const int attributes[] = {OSMESA_FORMAT, OSMESA_RGBA, 0};
            create_(attributes, nullptr);
        };
        if (!ChildProcess(attempt).wait().crash.empty())
            throw Error("OSMesa crashes, as it does where it lacks the driver that is asked for" + driver_variables());
    }

    /// Explains why there is no OpenGL 4.1 core, by asking a context of any version.
    std::string reason() {
        const int attributes[] = {OSMESA_FORMAT, OSMESA_RGBA, 0};
        context_ = create_(attributes, nullptr);
        if (!context_) return "OSMesa has no driver" + driver_variables();
        OsMesa::make_current();
        std::string text = too_little(reinterpret_cast<LoadFunction*>(load_));
        destroy_(context_);
        return text;
    }

    static const Module& library() {
        static constexpr const char* names[] = {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"};
        static const Module module(names, "libosmesa6");
        return module;
    }

    decltype(&OSMesaCreateContextAttribs) create_ =
        library().function<decltype(OSMesaCreateContextAttribs)>("OSMesaCreateContextAttribs");
    decltype(&OSMesaMakeCurrent) make_current_ = library().function<decltype(OSMesaMakeCurrent)>("OSMesaMakeCurrent");
    decltype(&OSMesaDestroyContext) destroy_ =
        library().function<decltype(OSMesaDestroyContext)>("OSMesaDestroyContext");
    decltype(&OSMesaGetProcAddress) load_ = library().function<decltype(OSMesaGetProcAddress)>("OSMesaGetProcAddress");
    OSMesaContext context_ = nullptr;
    // OSMesa requires a window buffer. It stays unused, because labs draw into framebuffers of their own.
    std::array<unsigned char, 4 * 4 * 4> window_{};
};

}  // namespace

std::unique_ptr<Context> open_osmesa() { return std::make_unique<OsMesa>(); }

}  // namespace relief
