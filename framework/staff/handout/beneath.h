// Files in a folder in which somebody else may have put links: nothing outside it is ever read, written or removed.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "framework/base/descriptor.h"

namespace relief {

/// Paths are relative to the folder. The folder itself may be named through links; below it none is followed.
class Beneath {
public:
    /// The folder must be there. Throws Error when it is not, or when another process has it open in this way.
    explicit Beneath(const std::filesystem::path& folder);

    enum class Kind { nothing, file, other, behind };
    struct Found {
        Kind kind = Kind::nothing;
        std::string bytes = {};                 ///< of a file that may be read
        std::filesystem::path in_the_way = {};  ///< of a path `behind` something that is not a folder, such as a link
    };
    /// `other` is a link, a folder, a device, or a file that may not be read.
    Found look(const std::filesystem::path& path) const;

    /// Whole or not at all, in place of what is there; makes the folders on its way. Throws Error.
    void write(const std::filesystem::path& path, std::string_view bytes, bool executable = false) const;

    /// A file, and the folders around it that are empty then. Throws Error.
    void remove(const std::filesystem::path& path) const;

private:
    /// The folder of a path; -1 when it is not there. `reached` becomes the last part that was looked at.
    Descriptor open_parent(const std::filesystem::path& path, bool make, std::filesystem::path& reached) const;
    [[noreturn]] void fail(const std::filesystem::path& path, const char* action) const;

    std::filesystem::path folder_;
    Descriptor top_;
};

}  // namespace relief
