// What a student hands in: a folder or an archive, of which only the task files count.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "framework/staff/grade/strangers_text.h"

namespace relief {

/// A task file is a page or two; nobody types a million characters.
constexpr size_t max_task_bytes = size_t{1} << 20;

struct Submission {
    std::string name;                            ///< of the folder, or of the archive without its ending
    std::map<std::string, std::string> files;    ///< task files, by their names in the course
    std::map<std::string, std::string> refused;  ///< task files that were not taken, and why
    std::vector<std::string> ignored;            ///< names of all else, printable; a hundred at most
    size_t ignored_count = 0;                    ///< how many there are
    std::vector<std::string> links;  ///< printable names of links that may stand for task files; ten at most
    std::string problem;             ///< why nothing could be read, or empty
    /// SHA-256 of all that a mark can depend on. Empty where nothing could be read.
    std::string hash;
};

/// The name of a submission: "a/b/jane.tar.gz" is jane's.
std::string submission_name(const std::filesystem::path& path);

/// Takes the files that end in one of `wanted` ("shaders/02_x/task.glsl"), in whatever folders they lie; of several,
/// the one in the fewest folders, of those the first by name, and where an archive has it twice the last. Never
/// throws for what is in the submission, follows no link in it and writes nothing: a link in a task file's place is
/// refused, unless the file lies elsewhere.
Submission read_submission(const std::filesystem::path& path, const std::set<std::string>& wanted);

}  // namespace relief
