#include "framework/grade/class.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <set>
#include <thread>

#include "framework/base/error.h"
#include "framework/base/file.h"
#include "framework/base/log.h"
#include "framework/grade/report.h"

namespace relief {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

/// What is known of a submission before it is graded; its files are read again then, so that a thousand fit.
struct Entry {
    fs::path path;
    std::string name, hash;
    std::vector<const LabEntry*> labs;
    SubmissionMark mark;
    bool done = false;
};

class Grading {
public:
    explicit Grading(const ClassOptions& options) : options_(options) {}

    ClassReport run() {
        const auto begin = Clock::now();
        report_.isolation = isolation_for(options_.trust);
        stage_.emplace(report_.isolation.level);
        course_ = stage_->hash();
        for (const LabEntry& lab : registry()) manifests_.emplace(lab.folder, load_manifest(lab));
        make_folder(options_.output / "results");
        make_folder(options_.output / "gradescope");
        look_through();
        prepare();
        report_.prepared = seconds_since(begin);
        grade_all();
        report_.seconds = seconds_since(begin);
        write_summaries();
        return std::move(report_);
    }

private:
    /// With --labs those; else those of which a submission has a file. Theirs are the files that are taken.
    std::vector<const LabEntry*> candidates() const {
        if (!options_.labs.empty()) return options_.labs;
        std::vector<const LabEntry*> all;
        for (const LabEntry& lab : registry())
            if (!manifests_.at(lab.folder).tasks.empty()) all.push_back(&lab);
        return all;
    }
    std::set<std::string> wanted() const {
        std::set<std::string> files;
        for (const LabEntry* lab : candidates()) files.merge(task_files(manifests_.at(lab->folder)));
        return files;
    }

    void look_through() {
        std::set<std::string> names;
        const std::set<std::string> files = wanted();
        Progress progress(int(options_.submissions.size()));
        for (const fs::path& path : options_.submissions) {
            progress.next("reading");
            const Submission submission = read_submission(path, files);
            Entry& entry = entries_.emplace_back();
            entry.path = path, entry.name = submission.name, entry.hash = submission.hash;
            if (!names.insert(file_name_of(entry.name)).second)
                throw UsageError(
                    fmt::format("two submissions are named '{}': rename one, or grade them into folders of "
                                "their own",
                                printable(entry.name)));
            for (const LabEntry* lab : candidates())
                if (!options_.labs.empty() || has_file_of(submission, *lab)) entry.labs.push_back(lab);
            entry.done = take_over(entry);
            report_.taken_over += entry.done;
        }
    }

    bool has_file_of(const Submission& submission, const LabEntry& lab) const {
        for (const std::string& file : task_files(manifests_.at(lab.folder)))
            if (submission.files.contains(file) || submission.refused.contains(file)) return true;
        return false;
    }

    fs::path result_file(const Entry& entry) const {
        return options_.output / "results" / (file_name_of(entry.name) + ".json");
    }

    /// A result that is there and still true is not made again.
    bool take_over(Entry& entry) const {
        const fs::path file = result_file(entry);
        if (options_.fresh || entry.hash.empty() || !fs::exists(file)) return false;
        try {
            SubmissionMark mark = from_json(read_file(file, size_t{1} << 26));
            const bool same_labs =
                std::equal(mark.labs.begin(), mark.labs.end(), entry.labs.begin(), entry.labs.end(),
                           [](const LabMark& one, const LabEntry* lab) { return one.lab == lab->folder; });
            if (mark.name != entry.name || mark.hash != entry.hash || mark.course != course_ || !mark.graded() ||
                mark.isolation != name_of(report_.isolation.level) || !same_labs)
                return false;
            entry.mark = std::move(mark);
            return true;
        } catch (const Error&) {  // half a file, or one of another time: grade anew
            return false;
        }
    }

    void prepare() {
        std::vector<const LabEntry*> needed;
        for (const Entry& entry : entries_)
            for (const LabEntry* lab : entry.labs)
                if (!entry.done && std::find(needed.begin(), needed.end(), lab) == needed.end()) needed.push_back(lab);
        Progress progress(int(needed.size()));
        for (const LabEntry* lab : needed) {
            progress.next("the solution of lab " + lab->two_digits());
            stage_->add(*lab);
            graders_.emplace(lab->folder,
                             std::make_unique<LabGrader>(*lab, *stage_, report_.isolation.level, options_.limits));
        }
    }

    void grade_all() {
        std::vector<Entry*> waiting;
        for (Entry& entry : entries_)
            if (!entry.done) waiting.push_back(&entry);
        Progress progress(int(waiting.size()));
        std::atomic<size_t> next = 0;
        std::exception_ptr failure;
        const auto work = [&] {
            for (size_t i = next++; i < waiting.size(); i = next++) try {
                    {
                        const std::lock_guard lock(mutex_);
                        progress.next(printable(waiting[i]->name));
                    }
                    grade(*waiting[i]);
                } catch (...) {  // nothing can be written: go no further
                    const std::lock_guard lock(mutex_);
                    failure = std::current_exception();
                    next = waiting.size();
                }
        };
        std::vector<std::jthread> threads;
        for (int i = 1; i < std::min(options_.jobs, int(waiting.size())); ++i) threads.emplace_back(work);
        work();
        threads.clear();
        if (failure) std::rethrow_exception(failure);
    }

    void grade(Entry& entry) {
        const auto begin = Clock::now();
        const Submission submission = read_submission(entry.path, wanted());
        SubmissionMark& mark = entry.mark;
        mark.name = submission.name, mark.hash = submission.hash, mark.course = course_;
        mark.isolation = name_of(report_.isolation.level);
        mark.problem = submission.problem;
        if (mark.problem.empty() && entry.labs.empty()) mark.problem = "there is no task file in it";
        mark.ignored = submission.ignored, mark.ignored_count = submission.ignored_count;
        for (const LabEntry* lab : entry.labs) mark.labs.push_back(mark_lab(*graders_.at(lab->folder), submission));
        mark.seconds = seconds_since(begin);
        entry.done = true;
        const std::lock_guard lock(mutex_);
        for (const LabMark& lab : mark.labs) {
            report_.times.compile += lab.times.compile, report_.times.draw += lab.times.draw;
            report_.times.compare += lab.times.compare;
        }
        write_file_to_disk(result_file(entry), to_json(mark));
    }

    /// Whatever goes wrong in here is the grader's fault and costs nobody a mark.
    static LabMark mark_lab(const LabGrader& grader, const Submission& submission) {
        try {
            return grader.mark(submission);
        } catch (const std::exception& error) {
            LabMark lab{.lab = grader.lab().folder, .tasks = {}, .log = {}, .times = {}};
            for (const TaskInfo& info : grader.manifest().tasks) {
                TaskMark& task = lab.tasks.emplace_back();
                task.id = info.id, task.title = info.title, task.file = info.file, task.of = info.points;
                task.checks.push_back(
                    {.name = "all", .outcome = Outcome::machine, .found = error.what(), .look_at = {}});
            }
            return lab;
        }
    }

    void write_summaries() {
        for (Entry& entry : entries_) {
            write_file(options_.output / "gradescope" / (file_name_of(entry.name) + ".json"),
                       to_gradescope(entry.mark));
            report_.marks.push_back(std::move(entry.mark));
        }
        write_file(options_.output / "results.csv", to_csv(report_.marks));
        write_file(options_.output / "junit.xml", to_junit(report_.marks));
        write_file(options_.output / "report.html", to_html(report_));
    }

    const ClassOptions& options_;
    ClassReport report_;
    std::optional<Stage> stage_;
    std::string course_;
    std::map<std::string, Manifest> manifests_;
    std::vector<Entry> entries_;
    std::map<std::string, std::unique_ptr<LabGrader>> graders_;
    std::mutex mutex_;
};

}  // namespace

IsolationReport isolation_for(bool trust) {
    const IsolationReport isolation = probe_isolation();
    if (isolation.level != Isolation::namespaces && !trust)
        throw Error(
            fmt::format("submissions cannot be kept from the rest of this machine: {}. With --trust they run all "
                        "the same, with limits on time and memory only",
                        isolation.reason));
    return isolation;
}

ClassReport grade_class(const ClassOptions& options) {
    if (options.submissions.empty()) throw UsageError("grade needs submissions: folders or archives");
    return Grading(options).run();
}

}  // namespace relief
