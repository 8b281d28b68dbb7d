// relief hand-in: packs the task files that a student wrote.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/log.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/source_text.h"
#include "framework/core/base/text.h"
#include "framework/course/app/command.h"
#include "framework/course/manifest/manifest.h"
#include "framework/course/task/rules.h"
#include "framework/course/task/starter.h"
#include "framework/course/task/stored_zip.h"
#include "framework/course/task/task_names.h"
#include "framework/course/task/task_text.h"

namespace relief::app {
namespace {

namespace fs = std::filesystem;

/// The task files of one lab, and faults that can be found without compiling and drawing.
class LabFiles {
public:
    explicit LabFiles(const LabEntry& lab) : manifest_(load_manifest(lab)) {
        const check::OtherShaders others(lab, manifest_);
        for (const TaskInfo& task : manifest_.tasks) {
            if (!seen_.insert(task.file).second) continue;
            const fs::path path = course_root() / task.file;
            look_beside(path, task.file);
            if (!fs::exists(path)) {
                say(task.file, "missing");
                is_faulty_ = true;
                continue;
            }
            files[task.file] = read_file(path, size_t{1} << 24);
            const std::string text = plain_source(files[task.file]);
            if (const auto fault = check::fault_of_task(text, task.file))
                fail(task.file, (fault->line > 0 ? fmt::format("line {}: ", fault->line) : "") + fault->message);
            else if (const std::string why = is_shader(task.file) ? check::broken_rule(text, others) : ""; !why.empty())
                fail(task.file, why);
            if (text.size() > max_bytes) fail(task.file, "larger than 1 MiB, which the grader refuses");
        }
        for (const TaskInfo& task : manifest_.tasks) {
            const auto file = files.find(task.file);
            const bool is_written = file != files.end() && !check::is_unfinished(plain_source(file->second), task);
            (is_written ? written : unwritten).push_back(task.id);
        }
    }

    bool has_tasks() const { return !manifest_.tasks.empty(); }
    /// Returns whether a file is missing, or the compiler or the grader will refuse one.
    bool is_faulty() const { return is_faulty_; }

    std::map<std::string, std::string> files;     ///< by their paths in the course
    std::vector<std::string> written, unwritten;  ///< ids of tasks
    std::vector<std::string> messages;

private:
    static constexpr size_t max_bytes = size_t{1} << 20;

    void say(const std::string& file, const std::string& message) {
        messages.push_back(fmt::format("{}: {}", file, message));
    }
    void fail(const std::string& file, const std::string& message) {
        say(file, message);
        is_faulty_ = true;
    }

    /// Names the files beside a task file that may be meant in its place.
    void look_beside(const fs::path& path, const std::string& file) {
        std::error_code unknown;
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(path.parent_path(), unknown))
            if (entry.is_regular_file(unknown)) names.push_back(entry.path().filename().string());
        std::sort(names.begin(), names.end());
        for (const std::string& name : names) {
            const fs::path beside = fs::path(file).parent_path() / name;
            if (check::is_near_task_file(beside.generic_string(), {file}))
                say(beside.generic_string(), fmt::format("not packed: only {} counts", path.filename().string()));
        }
    }

    Manifest manifest_;
    std::set<std::string> seen_;
    bool is_faulty_ = false;
};

std::string tasks_text(const std::vector<std::string>& ids) {
    return (ids.size() == 1 ? "task " : "tasks ") + join(ids, ", ");
}

/// Packs the labs in which something is written, or those that `labs` names. Returns 1 if a file is missing or will not
/// compile.
int hand_in(const std::vector<std::string>& words, const fs::path& output) {
    if (output.extension() != ".zip")
        throw UsageError(fmt::format("-o takes the name of a zip file, like hand-in.zip, not '{}'", output.string()));
    const bool is_asked = !words.empty();
    std::vector<const LabEntry*> labs;
    if (is_asked)
        labs = find_labs(join(words, ","));
    else
        for (const LabEntry& lab : registry()) labs.push_back(&lab);
    std::map<std::string, std::string> packed;
    std::vector<std::string> untouched;
    bool is_faulty = false;
    for (const LabEntry* entry : labs) {
        LabFiles lab(*entry);
        if (!lab.has_tasks()) {
            if (is_asked) throw UsageError(fmt::format("lab {} has no tasks", entry->two_digits()));
            continue;
        }
        if (lab.written.empty()) {
            untouched.push_back(entry->two_digits());
            for (const std::string& message : lab.messages) fmt::print("lab {}  {}\n", entry->two_digits(), message);
            continue;
        }
        fmt::print("lab {}  {} written{}\n", entry->two_digits(), tasks_text(lab.written),
                   lab.unwritten.empty() ? "" : "; not written: " + tasks_text(lab.unwritten));
        for (const std::string& message : lab.messages) fmt::print("        {}\n", message);
        is_faulty |= lab.is_faulty();
        packed.merge(lab.files);
    }
    if (!untouched.empty()) fmt::print("nothing written, so not packed: lab {}\n", join(untouched, ", "));
    if (packed.empty()) throw Error("no task is written: there is nothing to hand in");
    const bool is_replaced = fs::exists(output);
    write_file(output, check::stored_zip(packed));
    fmt::print("{}{}: {} task file{}. Hand in this file; ./relief check LAB says how good it is\n", output.string(),
               is_replaced ? ", which replaces the earlier one" : "", packed.size(), packed.size() == 1 ? "" : "s");
    return is_faulty ? 1 : 0;
}

class HandInCommand final : public Command {
public:
    void options(CommandOptions& options) override {
        options.words("LABS", labs_, "the labs to pack, like 3 or 1-5 [those in which a task is written]");
        options.value("-o", "FILE", output_, "the archive, a zip file [hand-in.zip]");
    }
    int run() override { return hand_in(labs_, output_); }

private:
    std::vector<std::string> labs_;
    std::string output_ = "hand-in.zip";
};
RELIEF_COMMAND(HandInCommand, 9, "hand-in", "packs the tasks that you wrote into one file, and says what is missing");

}  // namespace
}  // namespace relief::app
