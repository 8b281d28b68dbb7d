// Reads a submission: a folder or an archive. Only its task files count.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "framework/staff/grade/strangers_text.h"

namespace relief::grade {

/// Upper bound of the size of a task file. Honest ones are a page or two.
constexpr size_t max_task_bytes = size_t{1} << 20;

struct Submission {
    std::string name;                            ///< see submission_name()
    std::map<std::string, std::string> files;    ///< the text of task files, by their paths in the course
    std::map<std::string, std::string> refused;  ///< why task files were refused, by their paths
    std::vector<std::string> ignored;            ///< printable names of all other files; at most a hundred
    size_t ignored_count = 0;                    ///< number of all other files
    std::vector<std::string> links;  ///< printable names of links that may stand for task files; at most ten
    std::string doubt;               ///< says which of several equally good task files was taken; or empty
    std::string problem;             ///< why nothing could be read, or empty
    std::string hash;                ///< SHA-256 of everything that decides a mark; empty if nothing could be read
};

/// Returns the name of the submission at `path`, composed(): "jane" for "a/b/jane.tar.gz".
std::string submission_name(const std::filesystem::path& path);

/// Takes the files whose paths end in one of `wanted` ("shaders/02_x/task.glsl"), in any folder. If several match,
/// takes the one in the fewest folders, then the first by name. If an archive has the same path twice, takes the last.
/// Follows no links: a link in the place of a task file is refused, unless the file is found elsewhere. Writes nothing,
/// and never throws because of the submission's content.
Submission read_submission(const std::filesystem::path& path, const std::set<std::string>& wanted);

/// Returns a hash of those task files of a submission that are named in `files`.
std::string hash_of_files(const Submission& submission, const std::set<std::string>& files);

}  // namespace relief::grade
