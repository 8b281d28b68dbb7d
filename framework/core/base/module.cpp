#include "framework/core/base/module.h"

#include <fmt/format.h>

#include "framework/core/base/error.h"
#include "framework/core/base/from_staff.h"
#include "framework/core/base/system.h"

namespace relief {

Module::Module(std::span<const char* const> names, const char* package) {
    std::string reason;
    for (const char* name : names) {
        std::string why;
        handle_ = os::open_library(name, why);
        if (handle_) {
            name_ = name ? name : "this program";
            return;
        }
        if (reason.empty()) reason = why;
    }
    throw Error(fmt::format("install the Debian package {} ({})", package, reason));
}

void* Module::address(const char* name) const {
    void* const found = os::function(handle_, name);
    if (!found) throw Error(fmt::format("{} has no function {}: it is damaged or too old", name_, name));
    return found;
}

const std::filesystem::path& framework_folder() {
    static const std::filesystem::path folder =
        os::library_of(reinterpret_cast<const void*>(&framework_folder)).parent_path();
    return folder;
}

bool open_staff_library() {
    static const bool is_open = [] {
        constexpr const char* name = "librelief-staff.so";
        std::error_code ignored;
        if (!std::filesystem::exists(framework_folder() / name, ignored)) return false;
        open_own_module(name, "libseccomp2");
        return true;
    }();
    return is_open;
}

bool opens_own_modules() {
#ifdef RELIEF_LINKED_MODULE
    return false;
#else
    return true;
#endif
}

Module open_own_module(const char* name, const char* package) {
#ifdef RELIEF_LINKED_MODULE
    if (std::string_view(name) == RELIEF_LINKED_MODULE) {
        const char* const this_program[] = {nullptr};
        return Module(this_program, package);
    }
#endif
    if (!opens_own_modules())
        throw Error(fmt::format("this program has no {}: build the course on Linux, which has it", name));
    const std::string path = (framework_folder() / name).string();
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored))
        throw Error({path}, fmt::format("is missing: ./relief build installs {} and builds it", package));
    const char* const names[] = {path.c_str()};
    return Module(names, package);
}

}  // namespace relief
