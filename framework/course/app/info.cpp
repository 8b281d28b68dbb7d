// relief info: prints the facts about the machine that a bug report needs.
#include <fmt/format.h>

#include <thread>

#include "framework/core/base/error.h"
#include "framework/core/base/from_staff.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/process.h"
#include "framework/core/base/system.h"
#include "framework/core/lab/registry.h"
#include "framework/course/app/command.h"
#include "framework/course/app/versions.h"

namespace relief::app {
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

/// Prints in a child process, so that a crashing driver ends only that process.
void print_context_apart(ContextKind kind) {
    const ChildEnd end = ChildProcess([kind] { print_context(kind); }).wait();
    if (!end.crash.empty())
        fmt::print("{:<8} missing: its driver crashes, {}{}\n", name_of(kind), end.crash, driver_variables());
    else if (end.code != 0)
        fmt::print("{:<8} missing: its driver ends the process with code {}{}\n", name_of(kind), end.code,
                   driver_variables());
}

int print_info() {
    fmt::print("relief   {} ({})\n", versions::relief, versions::commit);
    fmt::print("course   {} with {} labs\n", course_root().string(), registry().size());
    fmt::print("system   {}, {} threads\n", os::name(), std::thread::hardware_concurrency());
    for (const ContextKind kind : {ContextKind::osmesa, ContextKind::egl, ContextKind::window})
        print_context_apart(kind);
    fmt::print("{}", staff_info());
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
}  // namespace relief::app
