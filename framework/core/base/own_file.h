// A file of the user, which a knob accepts in addition to its named choices.
#pragma once

#include <cctype>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "framework/core/base/log.h"

namespace relief {

class OwnFile {
public:
    virtual ~OwnFile() = default;
    OwnFile() = default;
    OwnFile(const OwnFile&) = delete;
    OwnFile& operator=(const OwnFile&) = delete;

    /// Reads a file, and prints its notes on standard error. Throws Error that names the file when it is missing,
    /// damaged, too large or unsuitable; then the previous file's contents stay.
    void read(const std::filesystem::path& file) {
        notes_ = load(file);
        for (const std::string& note : notes_) print_note(note);
        file_ = std::filesystem::absolute(file);
        ++version_;
    }

    /// Names the kind of file: "a picture's file".
    virtual const char* kind() const = 0;
    /// Returns whether a file of this name is for this knob and not for one of another kind.
    virtual bool accepts(const std::filesystem::path& file) const = 0;

    /// Absolute path; empty until a file has been read.
    const std::filesystem::path& file() const { return file_; }
    /// Increases with each file that is read.
    int version() const { return version_; }
    /// What the file holds that was not read or was changed, one line each. Each names the file.
    const std::vector<std::string>& notes() const { return notes_; }

private:
    /// Reads the contents and returns the notes. Throws as read() does, and changes nothing then.
    virtual std::vector<std::string> load(const std::filesystem::path& file) = 0;

    std::filesystem::path file_;
    std::vector<std::string> notes_;
    int version_ = 0;
};

/// Returns the ending of a file's name, such as ".obj", in lower case.
inline std::string lower_ending(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    for (char& c : ending) c = char(std::tolower(static_cast<unsigned char>(c)));
    return ending;
}

/// Returns whether a file's name ends in .obj, .gltf or .glb, in any case.
inline bool is_named_as_model(const std::filesystem::path& file) {
    const std::string ending = lower_ending(file);
    return ending == ".obj" || ending == ".gltf" || ending == ".glb";
}

}  // namespace relief
