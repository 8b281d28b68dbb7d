// A software context without any display, from Mesa's off-screen library.
#include "framework/gl/gl.h"  // before osmesa.h, which would bring the system's gl.h

#include <GL/osmesa.h>

#include <array>

#include "framework/base/error.h"
#include "framework/context/backends.h"

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
        context_ = create_(attributes, nullptr);
        if (!context_) throw Error("this OSMesa has no OpenGL 4.1 core profile: it needs Mesa 20 or newer");
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
    // OSMesa insists on a window buffer; nobody draws into it, because its pixels are not those of a framebuffer.
    std::array<unsigned char, 4 * 4 * 4> window_{};
};

}  // namespace

std::unique_ptr<Context> open_osmesa() { return std::make_unique<OsMesa>(); }

}  // namespace relief
