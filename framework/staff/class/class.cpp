#include "framework/staff/class/class.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <mutex>
#include <random>
#include <set>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/log.h"
#include "framework/core/base/parallel.h"
#include "framework/core/base/sha256.h"
#include "framework/core/base/text.h"
#include "framework/staff/class/authorship.h"
#include "framework/staff/class/class_file.h"
#include "framework/staff/class/hand_in_log.h"
#include "framework/staff/class/progress.h"

namespace relief::grade {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

/// A submission before it is graded. Grading reads its files again, so that a thousand submissions fit in memory.
struct Entry {
    std::vector<SubmissionPart> parts;
    std::string name, hash;
    std::vector<std::string> remarks;  ///< which hand-in of several counts
    std::vector<const LabEntry*> labs;
    std::map<std::string, LabMark> kept;  ///< earlier marks of labs beyond the limit of hand-ins, by folder
    std::vector<GradedHandIn> hand_ins;   ///< entries that grading adds to the log
    SubmissionMark mark;
    bool done = false;
};

class Grading {
public:
    Grading(const ClassOptions& options, const SubmissionDone& done) : options_(options), done_(done) {}

    ClassReport run() {
        const auto begin = Clock::now();
        report_.isolation = isolation_for(options_.trust);
        open_course(report_.isolation.level);
        if (options_.keep_roster)
            look_through_roster();
        else
            look_through();
        prepare();
        bound_by_figures();
        report_.prepared = seconds_since(begin);
        grade_all();
        report_.seconds = seconds_since(begin);
        for (Entry& entry : entries_) report_.marks.push_back(std::move(entry.mark));
        return std::move(report_);
    }

    /// No submission runs here, so isolation is not needed.
    void enlist() {
        open_course(Isolation::limits);
        look_through();
        for (const Entry& entry : entries_)
            if (!entry.done) fs::remove(result_file(entry));
        try {
            prepare();
            bound_by_figures();
        } catch (const Error& error) {  // a machine that only sends jobs may be unable to draw
            print_note(
                fmt::format("the parts measure what the solutions take, since this machine cannot: {}", error.what()));
        }
    }

private:
    void open_course(Isolation isolation) {
        setup_ = options_.setup;
        setup_.isolation = isolation;
        find_seed();
        stage_.emplace(setup_.isolation);
        course_ = sha256(stage_->hash() + setup_.seed + (setup_.renderer.pinned ? "" : " unpinned"));
        for (const LabEntry& lab : registry()) manifests_.emplace(lab.folder, load_manifest(lab));
        make_folder(options_.output / "results");
        if (const fs::path file = class_file_of(options_.output); !file.empty()) {
            policy_ = read_class_file(file, options_.output);
            hand_ins_per_day_ = policy_.hand_ins_per_day;
            utc_offset_ = policy_.utc_offset;
        }
    }

    void find_seed() {
        const std::optional<Roster> before = read_roster(options_.output);
        if (before) course_before_ = before->course, figures_before_ = before->solution_cpu;
        if (before && (setup_.seed.empty() || options_.keep_roster)) setup_.seed = before->seed;
        if (setup_.seed.empty() && !options_.shard.whole())
            throw UsageError(
                "all parts of a class need the same hidden views: give each part the same RELIEF_SEED=WORD");
        if (setup_.seed.empty()) setup_.seed = new_seed();
        report_.seed = setup_.seed;
    }

    /// Returns the labs of --lab, else all labs with tasks. Only their task files are read.
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
        const HandIns hand_ins = hand_ins_of(options_.submissions, policy_);
        Roster roster{.course = course_, .seed = setup_.seed, .labs = {}, .submissions = {}};
        for (const LabEntry* lab : options_.labs) roster.labs.push_back(lab->folder);
        if (course_before_ == course_) roster.solution_cpu = figures_before_;
        for (const fs::path& path : options_.submissions) roster.given.push_back(fs::absolute(path).lexically_normal());
        const std::set<std::string> files = wanted();
        Progress progress(int(hand_ins.all.size()));
        for (const HandIn& hand_in : hand_ins.all) {
            progress.next("reading");
            const Submission submission = read_submission(hand_in.name, hand_in.parts, files);
            const int place = int(roster.submissions.size());
            Roster::One& one = roster.submissions.emplace_back(
                Roster::One{submission.name, submission.hash, hand_in.parts, hand_in.remarks});
            for (SubmissionPart& part : one.parts) part.path = fs::absolute(part.path).lexically_normal();
            if (place % options_.shard.count != options_.shard.index) continue;
            Entry& entry = entries_.emplace_back();
            entry.parts = hand_in.parts;
            entry.name = submission.name;
            entry.hash = submission.hash;
            entry.remarks = hand_in.remarks;
            entry.labs = labs_of(submission);
            for (const std::string& remark : remarks_of(entry, submission))
                print_note(fmt::format("{}: {}", printable(entry.name), remark));
            entry.done = take_over(entry, submission);
            if (!entry.done) apply_limit(entry, submission);
            report_.taken_over += entry.done;
        }
        for (const std::string& note : hand_ins.notes) print_note(note);
        for (const HandIns::Doubled& one : hand_ins.doubled) {
            print_error(one.message);
            report_.doubled.push_back(one.name);
        }
        write_roster(options_.output, roster);
    }

    static std::vector<std::string> remarks_of(const Entry& entry, const Submission& submission) {
        std::vector<std::string> remarks = entry.remarks;
        remarks.insert(remarks.end(), submission.remarks.begin(), submission.remarks.end());
        return remarks;
    }

    /// Keeps every valid result, even if its submission has changed or gone since the roster was written.
    void look_through_roster() {
        const Roster roster = read_roster(options_.output).value();
        if (roster.course != course_)
            throw Error({options_.output / "class.json"},
                        "was written by another build of the course, or with other options: grade the class anew");
        const std::set<std::string> files = wanted();
        for (size_t i = size_t(options_.shard.index); i < roster.submissions.size();
             i += size_t(options_.shard.count)) {
            const Roster::One& one = roster.submissions[i];
            Entry entry{.parts = one.parts,
                        .name = one.name,
                        .hash = one.hash,
                        .remarks = one.remarks,
                        .labs = {},
                        .kept = {},
                        .hand_ins = {},
                        .mark = {}};
            if (auto mark = result_of(options_.output, one.name, course_)) {
                entry.mark = std::move(*mark);
                entry.done = true;
                ++report_.taken_over;
            } else {
                const Submission submission = read_submission(one.name, one.parts, files);
                if (!submission.problem.empty() && submission.hash != one.hash) {  // the roster's run could read it
                    report_.lost.push_back(one.name);
                    continue;
                }
                entry.labs = labs_of(submission);
                apply_limit(entry, submission);
            }
            entries_.push_back(std::move(entry));
        }
    }

    std::vector<const LabEntry*> labs_of(const Submission& submission) const {
        std::vector<const LabEntry*> labs;
        for (const LabEntry* lab : candidates())
            if (!options_.labs.empty() || has_file_of(submission, *lab)) labs.push_back(lab);
        return labs;
    }

    bool has_file_of(const Submission& submission, const LabEntry& lab) const {
        for (const std::string& file : task_files(manifests_.at(lab.folder)))
            if (submission.files.contains(file) || submission.refused.contains(file)) return true;
        return false;
    }

    fs::path result_file(const Entry& entry) const { return grade::result_file(options_.output, entry.name); }

    /// Takes over the result of an earlier run if nothing has changed since. A result from a run without a sandbox
    /// counts only with `trust`.
    bool take_over(Entry& entry, const Submission& submission) const {
        if (options_.fresh || entry.hash.empty()) return false;
        auto mark = result_of(options_.output, entry.name, course_);
        // A hand-in that the limit refused may be allowed on another day.
        const auto is_same = [](const LabMark& one, const LabEntry* lab) {
            return one.lab == lab->folder && one.kept.empty();
        };
        if (!mark || mark->hash != entry.hash || (!options_.trust && mark->isolation == name_of(Isolation::limits)) ||
            !std::equal(mark->labs.begin(), mark->labs.end(), entry.labs.begin(), entry.labs.end(), is_same))
            return false;
        entry.mark = std::move(*mark);
        // Other names for the same files change no mark.
        if (std::vector<std::string> remarks = remarks_of(entry, submission); remarks != entry.mark.remarks) {
            entry.mark.remarks = std::move(remarks);
            write_file_to_disk(result_file(entry), to_json(entry.mark));
        }
        return true;
    }

    /// Applies the limit of hand-ins to the labs of a submission. A lab is no new hand-in if its files equal the last
    /// graded ones. A lab beyond the limit keeps its earlier mark; without one it is graded.
    void apply_limit(Entry& entry, const Submission& submission) {
        if (hand_ins_per_day_ == 0) return;
        const std::vector<GradedHandIn> log = read_hand_in_log(options_.output, entry.name);
        auto earlier = earlier_marks(options_.output, entry.name, course_);
        if (earlier && !options_.trust && earlier->isolation == name_of(Isolation::limits)) earlier.reset();
        bool is_known = earlier.has_value();  // whether each lab has a mark of an earlier run
        for (const LabEntry* lab : entry.labs) {
            const LabMark* const before = earlier ? earlier->lab(lab->folder) : nullptr;
            is_known &= before != nullptr;
            if (!has_file_of(submission, *lab)) continue;
            const std::string files = hash_of_files(submission, task_files(manifests_.at(lab->folder)));
            const GradedHandIn* const last = last_hand_in(log, lab->folder);
            if (last && last->files == files) continue;
            if (before && hand_ins_on_day(log, lab->folder, options_.now, utc_offset_) >= hand_ins_per_day_) {
                LabMark& kept = entry.kept[lab->folder] = *before;
                kept.kept = fmt::format(
                    "the last hand-in is not graded, because of the limit of {} on {}; this is the mark of an earlier "
                    "one",
                    hand_ins_per_day_, moment_text(options_.now, utc_offset_).substr(0, 10));
            } else
                entry.hand_ins.push_back({lab->folder, options_.now, files});
        }
        if (entry.kept.empty() || !entry.hand_ins.empty() || !is_known) return;
        if (options_.fresh && entry.kept.size() < entry.labs.size()) return;
        // Nothing else has changed, so the pages keep their pictures.
        SubmissionMark& mark = entry.mark = *earlier;
        mark.hash = submission.hash;
        mark.ignored = submission.ignored;
        mark.ignored_count = submission.ignored_count;
        mark.remarks = remarks_of(entry, submission);
        mark.labs.clear();
        for (const LabEntry* lab : entry.labs)
            mark.labs.push_back(entry.kept.contains(lab->folder) ? entry.kept.at(lab->folder)
                                                                 : *earlier->lab(lab->folder));
        write_file_to_disk(result_file(entry), to_json(mark));
        entry.done = true;
    }

    void prepare() {
        constexpr int many = 5;  // reuse_shaders() takes as long as a submission, and saves about a quarter of each
        std::vector<const LabEntry*> needed;
        std::map<std::string, int> submissions;  // by lab's folder
        for (const Entry& entry : entries_)
            for (const LabEntry* lab : entry.labs)
                if (!entry.done && !entry.kept.contains(lab->folder) && submissions[lab->folder]++ == 0)
                    needed.push_back(lab);
        Progress progress(int(needed.size()));
        for (const LabEntry* lab : needed) {
            progress.next("the solution of lab " + lab->two_digits());
            stage_->add(*lab);
            const auto& [folder, grader] =
                *graders_.emplace(lab->folder, std::make_unique<LabGrader>(*lab, *stage_, setup_)).first;
            if (submissions.at(folder) >= many) grader->reuse_shaders();
        }
    }

    /// Gives a submission the same limit of processor time on every machine, fast or slow, idle or busy.
    void bound_by_figures() {
        std::map<std::string, double> measured;
        for (const auto& [folder, grader] : graders_) measured[folder] = grader->solution_cpu();
        const auto figures = add_solution_cpu(options_.output, measured);
        for (const auto& [folder, grader] : graders_) grader->bound_by(figures.at(folder));
    }

    void grade_all() {
        std::vector<Entry*> waiting;
        for (Entry& entry : entries_)
            if (!entry.done) waiting.push_back(&entry);
        Progress progress(int(waiting.size()));
        parallel_each(waiting.size(), unsigned(options_.jobs), [&](size_t i) {
            {
                const std::lock_guard lock(mutex_);
                progress.next(printable(waiting[i]->name));
            }
            grade(*waiting[i]);
        });
    }

    void grade(Entry& entry) {
        const auto begin = Clock::now();
        const Submission submission = read_submission(entry.name, entry.parts, wanted());
        SubmissionMark& mark = entry.mark;
        mark.name = submission.name;
        mark.hash = submission.hash;
        mark.course = course_;
        mark.isolation = name_of(report_.isolation.level);
        mark.problem = submission.problem;
        if (mark.problem.empty() && submission.files.empty() && submission.refused.empty())
            mark.problem = "there is no task file in it" + why_none(submission);
        mark.ignored = submission.ignored;
        mark.ignored_count = submission.ignored_count;
        mark.remarks = remarks_of(entry, submission);
        std::vector<CheckPictures> pictures;
        // Logged first, so that a killed run does not give a hand-in away.
        log_hand_ins(options_.output, entry.name, entry.hand_ins, utc_offset_);
        for (const LabEntry* lab : entry.labs)
            if (const auto kept = entry.kept.find(lab->folder); kept != entry.kept.end())
                mark.labs.push_back(kept->second);
            else
                mark.labs.push_back(mark_lab(*graders_.at(lab->folder), submission, pictures));
        mark.seconds = seconds_since(begin);
        if (done_) done_(mark, pictures);
        if (hand_ins_per_day_ > 0) keep_marks(options_.output, mark);
        entry.done = true;
        const std::lock_guard lock(mutex_);
        for (const LabMark& lab : mark.labs) report_.times.add(lab.times);
        write_file_to_disk(result_file(entry), to_json(mark));
    }

    /// Returns the reason for a missing task file, if it is a link or has an unclear name.
    static std::string why_none(const Submission& submission) {
        if (!submission.links.empty())
            return fmt::format(": '{}' is a link, and links are not followed", submission.links.front());
        if (!submission.remarks.empty()) return ": " + submission.remarks.front();
        return submission.ignored.empty() ? "" : ": only " + some_of(submission.ignored);
    }

    /// Treats an exception as the grader's fault: it costs no student a point.
    static LabMark mark_lab(const LabGrader& grader, const Submission& submission,
                            std::vector<CheckPictures>& pictures) {
        try {
            return grader.mark(submission, &pictures);
        } catch (const std::exception& error) {
            LabMark lab{.lab = grader.lab().folder};
            for (const TaskInfo& info : grader.manifest().tasks) {
                check::TaskVerdict& task = lab.tasks.emplace_back(check::unjudged(info));
                task.checks.push_back({.outcome = check::Outcome::machine, .found = error.what(), .name = "all"});
            }
            return lab;
        }
    }

    const ClassOptions& options_;
    GradeSetup setup_;
    const SubmissionDone& done_;
    ClassReport report_;
    std::optional<Stage> stage_;
    std::string course_, course_before_;            ///< hashes of this run and of the previous class.json
    std::map<std::string, double> figures_before_;  ///< in the previous class.json
    ClassFile policy_;                              ///< empty without a class file
    int hand_ins_per_day_ = 0;                      ///< 0: any number
    UtcOffset utc_offset_{0};
    std::map<std::string, Manifest> manifests_;
    std::vector<Entry> entries_;
    std::map<std::string, std::unique_ptr<LabGrader>> graders_;
    std::mutex mutex_;
};

}  // namespace

std::string new_seed() {
    std::random_device random;
    std::string seed;
    for (int i = 0; i < 4; ++i) seed += fmt::format("{:08x}", random());
    return seed;
}

IsolationReport isolation_for(bool trust) {
    const IsolationReport isolation = probe_isolation();
    if (isolation.level == Isolation::limits && !trust && !isolation.remedy.empty())
        print_note(isolation.remedy.substr(0, isolation.remedy.size() - 1));
    if (isolation.level == Isolation::limits && !trust)
        throw Error(
            fmt::format("submissions cannot be isolated on this machine: {}. With --trust they run anyway, "
                        "with limits on time and memory only",
                        isolation.reason));
    return isolation;
}

Descriptor hold_output(const fs::path& folder, Hold hold) {
    Descriptor held(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    // A file system without locks reports another error; then the folder stays unlocked.
    if (held >= 0 && flock(held, (hold == Hold::alone ? LOCK_EX : LOCK_SH) | LOCK_NB) != 0 && errno == EWOULDBLOCK)
        throw Error(fmt::format("another grader is at work in '{}': wait until it has ended, or name another folder",
                                printable(folder.string())));
    return held;
}

void enlist_class(const ClassOptions& options) {
    if (options.submissions.empty()) throw UsageError("grade needs submissions: folders or archives");
    Grading(options, {}).enlist();
}

ClassReport grade_class(const ClassOptions& options, const SubmissionDone& done) {
    if (options.submissions.empty()) throw UsageError("grade needs submissions: folders or archives");
    return Grading(options, done).run();
}

}  // namespace relief::grade
