// Libraries that are opened at first use, so that a run opens only the ones that it needs.
#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace relief {

/// An open shared library. It stays open until the process ends, because drivers do not survive being unloaded.
class Module {
public:
    /// Opens the first of `names` that exists. `package` is the Debian 12 package to install. Throws Error that names
    /// the package and the linker's reason.
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

/// Returns the folder of the framework's library, which also holds other files that the build made.
const std::filesystem::path& framework_folder();

/// Returns whether this program opens modules of this project. A program that is linked as a whole, as for Windows and
/// for a browser, has the window at most.
bool opens_own_modules();

/// Opens a module of this project from the folder of the framework's library. Throws Error when it is missing or cannot
/// be opened.
Module open_own_module(const char* name, const char* package);

}  // namespace relief
