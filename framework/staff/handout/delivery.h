// Delivers files into a folder in which somebody may have worked: files that they changed stay, the others are updated.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace relief {

struct HandedFile {
    std::string bytes;
    bool executable = false;
};
/// By path relative to the folder.
using HandedFiles = std::map<std::string, HandedFile>;

/// The result of a delivery: lists of paths. A file that was up to date is in none of them.
struct Delivery {
    std::vector<std::string> added, updated, removed;
    struct Kept {
        std::string file;
        std::string beside;  ///< the path of the new version; empty if the course no longer has the file
    };
    std::vector<Kept> kept;             ///< changed both by their owner and in the course
    std::vector<std::string> not_open;  ///< links and files in place of folders: left alone, with what lies behind them

    bool changed_nothing() const;
};

/// The `choice` of the last delivery into a folder; nothing if the folder is empty or does not exist. Throws Error for
/// any other folder: it is not a handout.
std::optional<std::string> delivered_choice(const std::filesystem::path& folder);

/// Brings a folder up to date. A file that is missing, or still as it was handed out, becomes the new version; it is
/// removed if `files` no longer has it. A file that its owner changed stays. If its new version differs from the one
/// that was handed out last, the new version is put beside it, as task.glsl.new. Nothing is written through a link. The
/// record of what was handed out, .relief-handout, begins with `choice`.
///
/// A new folder appears only when it is complete. In an existing folder each file is replaced atomically, and the next
/// run completes one that was interrupted. Throws Error as delivered_choice() does, and if a file cannot be written.
Delivery deliver(const HandedFiles& files, const std::string& choice, const std::filesystem::path& folder);

}  // namespace relief
