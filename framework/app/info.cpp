// relief info: what a bug report needs to say about the machine.
#include <fmt/format.h>
#include <sys/utsname.h>

#include <cstdlib>
#include <thread>

#include "framework/app/command.h"
#include "framework/app/versions.h"
#include "framework/base/error.h"
#include "framework/base/paths.h"
#include "framework/lab/registry.h"

namespace relief {
namespace {

void print_context(ContextKind kind) {
    try {
        const auto context = open_context(kind);
        const ContextInfo info = describe_context();
        fmt::print("{:<8} OpenGL {}, GLSL {}\n", name_of(kind), info.version, info.shading_language);
        fmt::print("         {} ({})\n", info.renderer, info.vendor);
        fmt::print("         texture {}, samples {}, anisotropy {}, patch vertices {}, tessellation level {}, {}\n",
                   info.max_texture, info.max_samples, info.max_anisotropy, info.max_patch_vertices,
                   info.max_tessellation, info.debug ? "KHR_debug" : "no KHR_debug");
    } catch (const Error& error) {
        fmt::print("{:<8} missing: {}\n", name_of(kind), error.what());
    }
}

int print_info() {
    utsname system{};
    uname(&system);
    fmt::print("relief   {} ({})\n", versions::relief, versions::commit);
    fmt::print("course   {} with {} labs\n", course_root().string(), registry().size());
    fmt::print("system   {} {} {}, {} threads\n", system.sysname, system.release, system.machine,
               std::thread::hardware_concurrency());
    for (const ContextKind kind : {ContextKind::osmesa, ContextKind::egl, ContextKind::window}) print_context(kind);
    fmt::print("built    by {}\n", versions::compiler);
    fmt::print("         with {}\n", versions::libraries);
    return 0;
}

class InfoCommand final : public Command {
public:
    void options(CommandOptions&) override {}
    int run() override { return print_info(); }
};
RELIEF_COMMAND(InfoCommand, 2, "info", "lists contexts, drivers and libraries: paste it into every bug report");

}  // namespace

}  // namespace relief
