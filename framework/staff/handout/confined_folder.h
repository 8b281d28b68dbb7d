// Files in a folder that may contain links made by others: nothing outside the folder is ever read, written or removed.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "framework/base/descriptor.h"

namespace relief {

/// Paths are relative to the folder. The folder itself may be named through links; below it none is followed.
class ConfinedFolder {
public:
    /// The folder must exist. Throws Error if it does not, or if another process has it open in this way.
    explicit ConfinedFolder(const std::filesystem::path& folder);

    enum class Kind { nothing, file, other, behind };
    struct Found {
        Kind kind = Kind::nothing;
        std::string bytes = {};                 ///< of a file that may be read
        std::filesystem::path in_the_way = {};  ///< of a path `behind` something that is not a folder, such as a link
    };
    /// `other` is a link, a folder, a device, or a file without permission to read.
    Found look(const std::filesystem::path& path) const;

    /// Replaces the file, whole or not at all, and makes its folders. Throws Error.
    void write(const std::filesystem::path& path, std::string_view bytes, bool executable = false) const;

    /// Removes a file, and its folders if they are then empty. Throws Error.
    void remove(const std::filesystem::path& path) const;

private:
    /// The folder of a path; -1 if it does not exist. `reached` becomes the last part that was looked at.
    Descriptor open_parent(const std::filesystem::path& path, bool make, std::filesystem::path& reached) const;
    [[noreturn]] void fail(const std::filesystem::path& path, const char* action) const;

    std::filesystem::path folder_;
    Descriptor top_;
};

}  // namespace relief
