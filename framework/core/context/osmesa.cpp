// A software context without a display, from Mesa's off-screen library.
#include <array>
#include <cstdlib>
#include <string_view>

#include "framework/core/base/error.h"
#include "framework/core/base/process.h"
#include "framework/core/context/backends.h"
#include "framework/core/gl/gl.h"

namespace relief {
namespace {

// The part of GL/osmesa.h (Mesa 11.2 and later) that is used here. Mesa dropped this library and its header in 25.1, so
// the course must build without them.
using OSMesaContext = struct osmesa_context*;
using CreateContext = OSMesaContext(const int* attributes, OSMesaContext shared);
using MakeCurrent = GLboolean(OSMesaContext context, void* pixels, GLenum type, GLsizei width, GLsizei height);
using DestroyContext = void(OSMesaContext context);
using GetProcAddress = GLADapiproc(const char* name);
constexpr int osmesa_format = 0x22, osmesa_depth_bits = 0x30, osmesa_profile = 0x33, osmesa_core_profile = 0x34,
              osmesa_major_version = 0x36, osmesa_minor_version = 0x37;

class OsMesa final : public Context {
public:
    OsMesa() {
        const int attributes[] = {osmesa_format,
                                  GL_RGBA,
                                  osmesa_depth_bits,
                                  0,
                                  osmesa_profile,
                                  osmesa_core_profile,
                                  osmesa_major_version,
                                  4,
                                  osmesa_minor_version,
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
            const int attributes[] = {osmesa_format, GL_RGBA, 0};
            create_(attributes, nullptr);
        };
        if (!ChildProcess(attempt).wait().crash.empty())
            throw Error("OSMesa crashes, as it does where it lacks the driver that is asked for" + driver_variables());
    }

    /// Explains why there is no OpenGL 4.1 core, by asking a context of any version.
    std::string reason() {
        const int attributes[] = {osmesa_format, GL_RGBA, 0};
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

    CreateContext* create_ = library().function<CreateContext>("OSMesaCreateContextAttribs");
    MakeCurrent* make_current_ = library().function<MakeCurrent>("OSMesaMakeCurrent");
    DestroyContext* destroy_ = library().function<DestroyContext>("OSMesaDestroyContext");
    GetProcAddress* load_ = library().function<GetProcAddress>("OSMesaGetProcAddress");
    OSMesaContext context_ = nullptr;
    // OSMesa requires a window buffer. It stays unused, because labs draw into framebuffers of their own.
    std::array<unsigned char, 4 * 4 * 4> window_{};
};

}  // namespace

std::unique_ptr<Context> open_osmesa() { return std::make_unique<OsMesa>(); }

}  // namespace relief
