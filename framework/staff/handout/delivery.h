// Delivers files into a folder in which somebody may have worked: keeps files that they changed, and updates the
// others.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace relief::handout {

struct HandedFile {
    std::string bytes;
    bool executable = false;
};
/// Keyed by path relative to the folder.
using HandedFiles = std::map<std::string, HandedFile>;

/// The result of a delivery: lists of paths. Files that were up to date are in no list.
struct Delivery {
    std::vector<std::string> added, updated, removed;
    struct Kept {
        std::string file;
        std::string beside;  ///< path of the new version; empty if the course no longer has the file
    };
    std::vector<Kept> kept;             ///< changed both by the owner and in the course
    std::vector<std::string> not_open;  ///< links and files in place of folders: left alone, with everything behind
                                        ///< them

    bool changed_nothing() const;
};

/// Returns the `choice` of the last delivery into a folder; nothing if the folder is empty or does not exist. Throws
/// Error for any other folder, because it is not a handout.
std::optional<std::string> delivered_choice(const std::filesystem::path& folder);

/// Brings a folder up to date. A file that is missing or unchanged since its delivery gets the new version, or is
/// removed if `files` no longer has it. A file that its owner changed stays. If its new version differs from the last
/// delivered one, the new version is put beside it, as task.glsl.new. Never writes through a link. The record of
/// delivered files, .relief-handout, begins with `choice`.
///
/// A new folder appears only when it is complete. In an existing folder each file is replaced atomically, and the next
/// run completes an interrupted one. Throws the same errors as delivered_choice(), and Error if a file cannot be
/// written.
Delivery deliver(const HandedFiles& files, const std::string& choice, const std::filesystem::path& folder);

}  // namespace relief::handout
