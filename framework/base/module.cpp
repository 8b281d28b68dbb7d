#include "framework/base/module.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include "framework/base/error.h"

namespace relief {

Module::Module(std::span<const char* const> names, const char* package) {
    std::string reason;
    for (const char* name : names) {
        handle_ = dlopen(name, RTLD_NOW | RTLD_LOCAL);
        if (handle_) {
            name_ = name;
            return;
        }
        if (reason.empty()) reason = dlerror();
    }
    throw Error(fmt::format("install the Debian package {} ({})", package, reason));
}

void* Module::address(const char* name) const {
    void* const found = dlsym(handle_, name);
    if (!found) throw Error(fmt::format("{} has no function {}: it is damaged or too old", name_, name));
    return found;
}

const std::filesystem::path& framework_folder() {
    static const std::filesystem::path folder = [] {
        Dl_info framework{};
        dladdr(reinterpret_cast<const void*>(&framework_folder), &framework);
        return std::filesystem::path(framework.dli_fname).parent_path();
    }();
    return folder;
}

Module open_own_module(const char* name, const char* package) {
    const std::string path = (framework_folder() / name).string();
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) throw Error({path}, "is missing: build it with ./relief build");
    const char* const names[] = {path.c_str()};
    return Module(names, package);
}

}  // namespace relief
