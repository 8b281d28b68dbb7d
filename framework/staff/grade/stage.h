// The copy of the course that a submission sees while it is drawn: programs, textures and shaders, but no solution.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "framework/core/base/descriptor.h"
#include "framework/course/manifest/manifest.h"
#include "framework/staff/grade/overlay.h"
#include "framework/staff/grade/sandbox.h"

namespace relief::grade {

/// Returns the files that a lab's students write.
std::set<std::string> task_files(const Manifest& manifest);
/// Returns these files with their solutions.
CourseFiles solution_files(const Manifest& manifest);

/// Returns the objects of a lab's sources in the build that made this program. Omits those of `replaced`, which may
/// contain only task files because other sources share an object, and those of the staff's sources.
std::vector<std::filesystem::path> built_objects(const LabEntry& lab, const CourseFiles& replaced);

/// A temporary folder that the sandbox's user can read. The destructor removes it.
class PublicFolder {
public:
    explicit PublicFolder(const std::filesystem::path& parent, const std::string& name);
    ~PublicFolder();
    PublicFolder(const PublicFolder&) = delete;
    PublicFolder& operator=(const PublicFolder&) = delete;
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// A lab's course for one submission.
struct StagedCourse {
    std::unique_ptr<PublicFolder> folder;
    std::vector<std::filesystem::path> objects = {};  ///< of the solutions that the program gets; see Stage::course()
    std::filesystem::path program;                    ///< draws with --course `folder`
    std::filesystem::path libraries;              ///< the program's libraries; without /proc it cannot find them itself
    std::vector<std::filesystem::path> readable;  ///< folders that must be readable in the sandbox
};

/// The result of compiling C++ tasks.
struct Compiled {
    Ending ending = Ending::exited;
    std::string message;  ///< the compiler's errors; empty if it succeeded
    double seconds = 0;
    bool stopped = false;  ///< true: we stopped it because it waited instead of computing
};

/// Created once per run. Holds copies of the programs, so that a build during the run cannot change them. Also holds
/// the textures as the build converted them, the shaders without solutions and, for C++ tasks, the library that
/// students build.
class Stage {
public:
    explicit Stage(Isolation isolation);
    Isolation isolation() const { return isolation_; }

    /// Reads all files for the lab's course. Call it before the first course() of the lab. Not thread-safe.
    void add(const LabEntry& lab);

    /// Returns the lab's course with `files` in place of its task files. A missing task file is replaced by its
    /// starter. `alone`: the id of a C++ task, whose functions `files` have, and of no other C++ task. The program gets
    /// the others' solutions as objects, without their text and without the task's own solution.
    StagedCourse course(const LabEntry& lab, const CourseFiles& files, const std::string& alone = {}) const;

    /// Compiles the C++ tasks of a course into a program, and sets the course's program to it. Does nothing if the lab
    /// has no C++ tasks. A program that contains only starters and solutions is compiled once a run. `ending` is
    /// `failed` if the machine could not run the compiler. `cpu`, `wall`: limits in seconds.
    Compiled compile(const LabEntry& lab, StagedCourse& course, double cpu, double wall) const;

    /// Returns the SHA-256 of everything except the submission that decides a mark.
    std::string hash() const;

private:
    struct LabPart {
        CourseFiles shaders;                         ///< with starters in place of the tasks
        CourseFiles sources;                         ///< C++ tasks' starters
        CourseFiles solutions;                       ///< of the C++ tasks
        std::vector<std::filesystem::path> objects;  ///< of the lab's other sources
        /// By C++ task: the objects of the C++ solutions without the task's functions, in a folder that no submission
        /// can read.
        std::map<std::string, std::vector<std::filesystem::path>> others;
        std::vector<std::filesystem::path> readable;
    };
    void copy_programs();
    void copy_assets();
    std::filesystem::path textures() const { return folder_.path() / "bin/textures"; }
    void build_lab(const LabEntry& lab, const Manifest& manifest, LabPart& part);
    void build_others(const LabEntry& lab, const Manifest& manifest, LabPart& part) const;
    void compile_ours(const LabEntry& lab, const std::filesystem::path& source, const std::filesystem::path& object,
                      const std::vector<std::string>& options) const;
    std::filesystem::path program_of_ours(const LabEntry& lab, const StagedCourse& course) const;
    std::vector<std::string> compiler(const LabEntry& lab) const;
    ProcessResult run_compiler(const LabEntry& lab, const StagedCourse& course, double cpu, double wall) const;
    void must(const std::vector<std::string>& command, const char* what) const;

    Isolation isolation_;
    PublicFolder folder_;
    Descriptor lock_;                      ///< lock on the folder: other runs remove unlocked folders
    std::map<std::string, LabPart> labs_;  ///< by folder
};

}  // namespace relief::grade
