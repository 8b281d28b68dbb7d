// A windowless EGL context: on a GPU if a driver offers one, else on Mesa's software renderer.
#define EGL_NO_X11
#define MESA_EGL_NO_X11_HEADERS
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstdlib>
#include <string_view>
#include <vector>

#include "framework/core/base/error.h"
#include "framework/core/context/backends.h"
#include "framework/core/gl/gl.h"

namespace relief {
namespace {

const Module& library() {
    static constexpr const char* names[] = {"libEGL.so.1", "libEGL.so"};
    static const Module module(names, "libegl1 and libgl1-mesa-dri");
    return module;
}

template <class Function>
Function* core(const char* name) {
    return library().function<Function>(name);
}

template <class Function>
Function extension(const char* name) {
    return reinterpret_cast<Function>(core<decltype(eglGetProcAddress)>("eglGetProcAddress")(name));
}

bool has_extension(const char* list, std::string_view name) {
    return list && std::string_view(list).find(name) != std::string_view::npos;
}

class Egl final : public Context {
public:
    explicit Egl(bool only_hardware) {
        for (const EGLDisplay display : displays(only_hardware))
            if (open(display)) {
                Egl::make_current();
                load_gl(reinterpret_cast<LoadFunction*>(get_address_));
                return;
            }
        if (!refused_.empty()) throw Error(refused_);
        if (only_hardware) throw Error("EGL finds no hardware driver" + driver_variables());
        throw Error("EGL finds no driver that draws without a surface" +
                    (driver_variables().empty() ? ": install the Debian package libgl1-mesa-dri" : driver_variables()));
    }
    ~Egl() override {
        make_current_(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        destroy_(display_, context_);
        terminate_(display_);
    }
    Egl(const Egl&) = delete;
    Egl& operator=(const Egl&) = delete;

    void make_current() override {
        bind_api_(EGL_OPENGL_API);
        if (!make_current_(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
            throw Error("EGL cannot make its context current without a surface");
    }

private:
    /// Hardware devices first, unless LIBGL_ALWAYS_SOFTWARE is set; then Mesa's surfaceless platform, unless
    /// `only_hardware`.
    static std::vector<EGLDisplay> displays(bool only_hardware) {
        std::vector<EGLDisplay> found;
        const auto get_display = extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
        if (!get_display) return found;
        if (!std::getenv("LIBGL_ALWAYS_SOFTWARE"))
            for (EGLDeviceEXT device : hardware())
                found.push_back(get_display(EGL_PLATFORM_DEVICE_EXT, device, nullptr));
        if (!only_hardware) found.push_back(get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
        return found;
    }

    static std::vector<EGLDeviceEXT> hardware() {
        const auto query = extension<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
        const auto text = extension<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
        EGLDeviceEXT devices[16];
        EGLint count = 0;
        if (!query || !text || !query(16, devices, &count)) return {};
        std::vector<EGLDeviceEXT> found;
        for (EGLint i = 0; i < count; ++i)
            if (!has_extension(text(devices[i], EGL_EXTENSIONS), "EGL_MESA_device_software"))
                found.push_back(devices[i]);
        return found;
    }

    bool open(EGLDisplay display) {
        if (display == EGL_NO_DISPLAY || !initialize_(display, nullptr, nullptr)) return false;
        bind_api_(EGL_OPENGL_API);
        const EGLint wanted[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        choose_(display, wanted, &config, 1, &count);
        const EGLint attributes[] = {
            EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 1, EGL_CONTEXT_OPENGL_PROFILE_MASK,
            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
        if (count > 0) context_ = create_(display, config, EGL_NO_CONTEXT, attributes);
        display_ = display;
        if (context_ != EGL_NO_CONTEXT) return true;
        if (count > 0) note_refusal(config);
        terminate_(display);
        return false;
    }

    /// Notes why OpenGL 4.1 core is refused, by asking a context of any version.
    void note_refusal(EGLConfig config) {
        context_ = create_(display_, config, EGL_NO_CONTEXT, nullptr);
        if (context_ == EGL_NO_CONTEXT) return;
        if (make_current_(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) {
            refused_ += (refused_.empty() ? "" : "; ") + too_little(reinterpret_cast<LoadFunction*>(get_address_));
            make_current_(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        }
        destroy_(display_, context_);
        context_ = EGL_NO_CONTEXT;
    }

    decltype(&eglGetProcAddress) get_address_ = core<decltype(eglGetProcAddress)>("eglGetProcAddress");
    decltype(&eglInitialize) initialize_ = core<decltype(eglInitialize)>("eglInitialize");
    decltype(&eglTerminate) terminate_ = core<decltype(eglTerminate)>("eglTerminate");
    decltype(&eglBindAPI) bind_api_ = core<decltype(eglBindAPI)>("eglBindAPI");
    decltype(&eglChooseConfig) choose_ = core<decltype(eglChooseConfig)>("eglChooseConfig");
    decltype(&eglCreateContext) create_ = core<decltype(eglCreateContext)>("eglCreateContext");
    decltype(&eglDestroyContext) destroy_ = core<decltype(eglDestroyContext)>("eglDestroyContext");
    decltype(&eglMakeCurrent) make_current_ = core<decltype(eglMakeCurrent)>("eglMakeCurrent");
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
    std::string refused_;  ///< drivers below OpenGL 4.1 core, each with its version
};

}  // namespace

std::span<const ContextKind> automatic_kinds() {
    static constexpr ContextKind kinds[] = {ContextKind::osmesa, ContextKind::egl};
    return kinds;
}

std::unique_ptr<Context> open_egl() { return std::make_unique<Egl>(false); }
std::unique_ptr<Context> open_gpu() { return std::make_unique<Egl>(true); }

}  // namespace relief
