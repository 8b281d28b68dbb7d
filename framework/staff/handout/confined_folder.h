// Access to a folder that may contain links made by others: reads, writes and removals never leave the folder.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "framework/core/base/descriptor.h"

namespace relief::handout {

/// Paths are relative to the folder. The path of the folder itself may contain links; links below it are not followed.
class ConfinedFolder {
public:
    /// Opens and locks the folder. Throws Error if it does not exist, or if another process has locked it.
    explicit ConfinedFolder(const std::filesystem::path& folder);

    enum class Kind { nothing, file, other, behind };
    struct Found {
        Kind kind = Kind::nothing;
        std::string bytes = {};                 ///< content of a `file`
        std::filesystem::path in_the_way = {};  ///< for `behind`: the part of the path that is not a folder
    };
    /// Inspects a path. `other`: a link, a folder, a device, or a file that cannot be read. `behind`: a part of the
    /// path is a link or a file, so the rest cannot be reached.
    Found look(const std::filesystem::path& path) const;

    /// Replaces the file atomically, and creates its folders. Throws Error.
    void write(const std::filesystem::path& path, std::string_view bytes, bool executable = false) const;

    /// Removes the file, and its parent folders that are then empty. Throws Error.
    void remove(const std::filesystem::path& path) const;

private:
    /// Opens the folder that holds `path`; -1 if that fails. Sets `reached` to the last part that was tried.
    Descriptor open_parent(const std::filesystem::path& path, bool make, std::filesystem::path& reached) const;
    [[noreturn]] void fail(const std::filesystem::path& path, const char* action) const;

    std::filesystem::path folder_;
    Descriptor top_;
};

}  // namespace relief::handout
