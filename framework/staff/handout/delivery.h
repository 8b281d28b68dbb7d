// Files handed out into a folder in which somebody has worked since: changed files stay, the others are updated.
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
/// By paths relative to the folder.
using HandedFiles = std::map<std::string, HandedFile>;

/// The result of a delivery, by path. An up-to-date file is in none of the lists.
struct Delivery {
    std::vector<std::string> added, updated, removed;
    struct Kept {
        std::string file, beside;  ///< what was handed out anew lies `beside`; empty: it is in the course no more
    };
    std::vector<Kept> kept;             ///< changed by their owner, and changed in the course too
    std::vector<std::string> not_open;  ///< links and files where folders should be: left alone with what lies behind

    bool changed_nothing() const;
};

/// The choice that the last delivery into a folder recorded (see deliver); nothing for a folder that is empty or not
/// there. Throws Error for any other folder: it is not a handout.
std::optional<std::string> delivered_choice(const std::filesystem::path& folder);

/// Brings a folder up to date. A file that is there as it was once handed out, or not at all, becomes the new one; one
/// that is in `files` no more is removed. Whatever else is there stays: when its new text is not the one that was
/// handed out last, that is put beside it, as task.glsl.new. Nothing is written through a link. The folder's record of
/// what was handed out, .relief-handout, begins with `choice`.
///
/// A new folder appears when it is whole. In one that is there each file is, and a run that was interrupted is
/// completed by the next. Throws Error as delivered_choice does, and for what cannot be written.
Delivery deliver(const HandedFiles& files, const std::string& choice, const std::filesystem::path& folder);

}  // namespace relief
