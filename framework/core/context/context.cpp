#include "framework/core/context/context.h"

#include <fmt/format.h>

#include <array>
#include <cstdlib>

#include "framework/core/base/error.h"
#include "framework/core/base/log.h"
#include "framework/core/base/system.h"
#include "framework/core/base/text.h"
#include "framework/core/context/backends.h"
#include "framework/core/gl/gl.h"

namespace relief {
namespace {

constexpr std::array kinds = {ContextKind::osmesa, ContextKind::egl, ContextKind::gpu, ContextKind::window};
bool pinned = false, optimizes_shaders = false;

std::string text_of(GLenum name) {
    const auto* const text = reinterpret_cast<const char*>(glGetString(name));
    return text ? text : "";
}

int limit_of(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

std::unique_ptr<Context> open_backend(ContextKind kind) {
    switch (kind) {
        case ContextKind::osmesa:
            return open_osmesa();
        case ContextKind::egl:
            return open_egl();
        case ContextKind::gpu:
            return open_gpu();
        case ContextKind::window:
            break;
    }
    return open_hidden_window();
}

}  // namespace

const char* name_of(ContextKind kind) {
    switch (kind) {
        case ContextKind::osmesa:
            return "osmesa";
        case ContextKind::egl:
            return "egl";
        case ContextKind::gpu:
            return "gpu";
        case ContextKind::window:
            break;
    }
    return "window";
}

std::optional<ContextKind> context_kind(const std::string& name) {
    if (name == "auto") return {};
    std::vector<std::string> known = {"auto"};
    for (const ContextKind kind : kinds) {
        if (name == name_of(kind)) return kind;
        known.emplace_back(name_of(kind));
    }
    throw UsageError(unknown("context", name, known));
}

std::string driver_variables() {
    std::string list;
    for (const char* name : {"GALLIUM_DRIVER", "MESA_LOADER_DRIVER_OVERRIDE", "LIBGL_ALWAYS_SOFTWARE",
                             "LIBGL_DRIVERS_PATH", "MESA_GL_VERSION_OVERRIDE", "__EGL_VENDOR_LIBRARY_FILENAMES"})
        if (const char* const value = std::getenv(name); value && *value)
            list += fmt::format("{}{}={}", list.empty() ? "" : ", ", name, value);
    return list.empty() ? "" : fmt::format(" ({} is set)", list);
}

std::string too_little(LoadFunction* load) {
    const auto get_string = reinterpret_cast<PFNGLGETSTRINGPROC>(load("glGetString"));
    const auto text = [&](GLenum name) {
        const auto* const found = get_string ? reinterpret_cast<const char*>(get_string(name)) : nullptr;
        return std::string(found ? found : "no name");
    };
    return fmt::format("the driver is {}, which has OpenGL {} and no 4.1 core{}", text(GL_RENDERER), text(GL_VERSION),
                       driver_variables());
}

std::unique_ptr<Context> open_context(ContextKind kind) {
    if (!optimizes_shaders && !std::getenv("GALLIVM_PERF")) os::set_environment("GALLIVM_PERF", "nopt");
    try {
        std::unique_ptr<Context> context = open_backend(kind);
        if (kind == ContextKind::gpu && is_software_renderer())
            throw Error("its driver is " + text_of(GL_RENDERER) + ", which draws on the CPU");
        watch_errors();
        take_gl_errors();
        print_event(fmt::format("context: {}, {}", name_of(kind), text_of(GL_RENDERER)));
        return context;
    } catch (const Error& error) {
        throw Error(fmt::format("no {} context: {}", name_of(kind), error.what()));
    }
}

std::unique_ptr<Context> open_context(std::optional<ContextKind> kind) {
    if (kind) return open_context(*kind);
    std::string reasons;
    for (const ContextKind each : automatic_kinds()) {
        try {
            return open_context(each);
        } catch (const Error& error) {
            print_event(error.what());
            reasons += reasons.empty() ? error.what() : fmt::format("; {}", error.what());
        }
    }
    throw Error(reasons);
}

bool draws_without_display() { return automatic_kinds().front() != ContextKind::window; }

// Measured: with the first two variables, one real CPU and four emulated models give the same pictures. Without them,
// CPUs with and without fused multiply-add differ: mostly by 1/255, but by up to 252/255 in 0.01 % of the pixels.
void pin_software_renderer() {
    os::set_environment("GALLIUM_OVERRIDE_CPU_CAPS", "sse4.1");
    os::set_environment("LP_NATIVE_VECTOR_WIDTH", "128");
    os::set_environment("LIBGL_ALWAYS_SOFTWARE", "1");
    draw_comparably();
    pinned = true;
}

bool is_pinned() { return pinned; }

void optimize_shaders() { optimizes_shaders = true; }

ContextInfo describe_context() {
    ContextInfo info;
    info.version = text_of(GL_VERSION);
    info.renderer = text_of(GL_RENDERER);
    info.vendor = text_of(GL_VENDOR);
    info.shading_language = text_of(GL_SHADING_LANGUAGE_VERSION);
    info.max_texture = limit_of(GL_MAX_TEXTURE_SIZE);
    info.max_samples = limit_of(GL_MAX_SAMPLES);
    info.max_patch_vertices = limit_of(GL_MAX_PATCH_VERTICES);
    info.max_tessellation = limit_of(GL_MAX_TESS_GEN_LEVEL);
    if (GLAD_GL_EXT_texture_filter_anisotropic) glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &info.max_anisotropy);
    info.debug = GLAD_GL_KHR_debug != 0;
    return info;
}

std::string ContextInfo::driver() const {
    return fmt::format("{}, {}{}", renderer, version, is_pinned() ? ", pinned to sse4.1" : "");
}

}  // namespace relief
