// Reads a submission: a folder, an archive, or files. Only its task files count.
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
    std::vector<std::string> links;    ///< printable names of links that may stand for task files; at most ten
    std::vector<std::string> remarks;  ///< printable sentences: which of several files counts, which has a wrong name
    std::string problem;               ///< why nothing could be read, or empty
    std::string hash;                  ///< SHA-256 of everything that decides a mark; empty if nothing could be read
};

/// Returns the name of the submission at `path`, composed(): "jane" for "a/b/jane.tar.gz".
std::string submission_name(const std::filesystem::path& path);

/// A folder, an archive or a task file that belongs to a submission.
struct SubmissionPart {
    std::filesystem::path path;
    std::string file = {};  ///< the name under which a file was uploaded; empty: that of the path
    long long upload = 0;   ///< of two equal names, the one with the larger number counts

    bool operator==(const SubmissionPart&) const = default;
};

/// Takes the files whose paths end in one of `wanted` ("shaders/02_x/task.glsl"), in any folder. If several match,
/// takes the one in the fewest folders, then the latest copy ("work (1)" before "work"), then the first by name. If an
/// archive has the same path twice, takes the last. A task file that is not found this way is replaced by a file whose
/// name is near (see task_names.h). If there is neither, reads the archives in the folder or archive, but none in
/// these. Remarks say which file was taken, and why.
///
/// Follows no links: a link in the place of a task file is refused, unless the file is found elsewhere. Writes nothing,
/// and never throws because of the submission's content.
Submission read_submission(const std::string& name, const std::vector<SubmissionPart>& parts,
                           const std::set<std::string>& wanted);
/// Returns the submission that consists of one part, by its submission_name().
Submission read_submission(const std::filesystem::path& path, const std::set<std::string>& wanted);

/// Returns a hash of those task files of a submission that are named in `files`.
std::string hash_of_files(const Submission& submission, const std::set<std::string>& files);

}  // namespace relief::grade
