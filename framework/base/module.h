// Libraries that are opened at first use, so that a run opens none that it does not need.
#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace relief {

/// An open shared library; it stays open as long as the process (drivers do not survive being unloaded).
class Module {
public:
    /// Opens the first of `names` that is there. `package` is what Debian 12 calls the package to install.
    /// Throws Error that names the package and the linker's reason.
    Module(std::span<const char* const> names, const char* package);

    template <class Function>
    Function* function(const char* name) const {
        return reinterpret_cast<Function*>(address(name));
    }

    const std::string& name() const { return name_; }

private:
    void* address(const char* name) const;
    void* handle_ = nullptr;
    std::string name_;
};

/// The folder of the framework's library, with the other files that the build made for it.
const std::filesystem::path& framework_folder();

/// Opens one of the project's own modules, which lie beside the framework's library.
Module open_own_module(const char* name, const char* package);

}  // namespace relief
