// Reads a submission: a folder or an archive, in which only the task files count.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "framework/staff/grade/strangers_text.h"

namespace relief {

/// The largest task file. Honest ones are a page or two.
constexpr size_t max_task_bytes = size_t{1} << 20;

struct Submission {
    std::string name;                            ///< see submission_name()
    std::map<std::string, std::string> files;    ///< the text of task files, by their paths in the course
    std::map<std::string, std::string> refused;  ///< the reasons why task files were not taken, by their paths
    std::vector<std::string> ignored;            ///< printable names of all other files; at most a hundred
    size_t ignored_count = 0;                    ///< how many other files there are
    std::vector<std::string> links;  ///< printable names of links that may stand for task files; at most ten
    std::string doubt;               ///< which of several equally good task files was taken, or empty
    std::string problem;             ///< why nothing could be read, or empty
    std::string hash;                ///< SHA-256 of everything that decides a mark; empty if nothing could be read
};

/// The name of the submission at `path`, composed(): "jane" for "a/b/jane.tar.gz".
std::string submission_name(const std::filesystem::path& path);

/// Takes the files whose paths end in one of `wanted` ("shaders/02_x/task.glsl"), in any folder. If several match, it
/// takes the one in the fewest folders; among those the first by name; if an archive has that path twice, the last.
/// Follows no links: a link in the place of a task file is refused, unless the file is found elsewhere. Writes nothing,
/// and never throws because of what the submission holds.
Submission read_submission(const std::filesystem::path& path, const std::set<std::string>& wanted);

}  // namespace relief
