// relief grade: grades a class, and tests the grader.
#include "framework/staff/app/grade.h"

#include <fmt/format.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/log.h"
#include "framework/core/base/parallel.h"
#include "framework/core/base/text.h"
#include "framework/course/app/command.h"
#include "framework/staff/app/questions.h"
#include "framework/staff/class/class.h"
#include "framework/staff/class/exports.h"
#include "framework/staff/class/gradescope.h"
#include "framework/staff/class/merge.h"
#include "framework/staff/class/progress.h"
#include "framework/staff/cluster/slurm.h"
#include "framework/staff/originality/originality.h"
#include "framework/staff/pages/export_pictures.h"
#include "framework/staff/pages/originality_page.h"
#include "framework/staff/pages/summaries.h"
#include "framework/staff/proof/mutation_test.h"
#include "framework/staff/proof/self_test.h"

namespace relief::app {
namespace {

struct GradeArguments {
    std::vector<std::string> paths, labs, earlier;
    std::string output, class_file, jobs, seconds, sample, seed, shard, merge, mutate, slurm, status, questions;
    std::string context = "auto", threads = "0";
    bool trust = false, fresh = false, self_test = false, json = false, resume = false, unpinned = false,
         gradescope = false, originality = false;
};

namespace fs = std::filesystem;

int whole_number(const std::string& text, const char* option, int low, int high) {
    const auto value = parse_int(text);
    if (!value || *value < low || *value > high)
        throw UsageError(fmt::format("{} takes a whole number from {} to {}, not '{}'", option, low, high, text));
    return *value;
}

grade::ClassOptions options_of(const GradeArguments& arguments) {
    grade::ClassOptions options;
    options.jobs = arguments.jobs.empty() ? grade::processors_from_slurm().value_or(int(hardware_threads()))
                                          : whole_number(arguments.jobs, "--jobs", 1, 256);
    grade::GradeSetup& setup = options.setup;
    if (!arguments.seconds.empty()) setup.seconds = whole_number(arguments.seconds, "--seconds", 1, 3600);
    const char* const seed = std::getenv("RELIEF_SEED");  // not in an argument: any user of the machine can read a
                                                          // command line
    setup.seed = arguments.seed.empty() && seed ? seed : arguments.seed;
    setup.renderer = {context_kind(arguments.context), whole_number(arguments.threads, "--threads", 0, 16),
                      !arguments.unpinned};
    if (setup.renderer.context == ContextKind::window)
        throw UsageError("grade draws without a window: choose osmesa or egl");
    options.trust = arguments.trust;
    options.fresh = arguments.fresh;
    for (const std::string& lab : arguments.labs) {
        const LabEntry& entry = find_lab(lab);
        if (load_manifest(entry).tasks.empty())
            throw UsageError(fmt::format("lab {} has no tasks", entry.two_digits()));
        options.labs.push_back(&entry);
    }
    return options;
}

void print_isolation(const grade::IsolationReport& isolation) {
    print_note(fmt::format("isolation: {}{}", name_of(isolation.level),
                           isolation.reason.empty() ? "" : "; " + isolation.reason));
}

int test_the_grader(grade::ClassOptions& options, int sample) {
    if (options.labs.empty())
        for (const LabEntry& lab : registry())
            if (!load_manifest(lab).checks.empty()) options.labs.push_back(&lab);
    const grade::IsolationReport isolation = grade::isolation_for(options.trust);
    options.setup.isolation = isolation.level;
    print_isolation(isolation);
    grade::SelfTest sum;
    for (const LabEntry* lab : options.labs) {
        const grade::SelfTest test = grade::test_grader(*lab, options.setup, {options.jobs, sample});
        sum.mistakes += test.mistakes;
        sum.caught += test.caught;
        sum.left_out += test.left_out;
        sum.equivalents += test.equivalents;
        sum.right += test.right;
        for (const std::string& wrong : test.wrong) sum.wrong.push_back("lab " + lab->two_digits() + ": " + wrong);
        fmt::print(
            "lab {}: {} of {} known mistakes caught, {}; {} of {} correct variants get all points; {:.1f} s\n",
            lab->two_digits(), test.caught, test.mistakes,
            sample > 0 ? "names not tested" : fmt::format("{} named, {} examples tried", test.named, test.examples),
            test.right, test.equivalents, test.seconds);
        if (!options.setup.seed.empty())
            fmt::print("        hidden views of {} of {} checks\n", test.hidden_views, test.checks);
        std::fflush(stdout);
    }
    for (const std::string& wrong : sum.wrong) print_error(wrong);
    fmt::print("kill rate {} %, {} of {} correct variants get all points, {} wrong verdicts\n",
               rounded(sum.mistakes ? 100.0 * sum.caught / sum.mistakes : 100.0, 4), sum.right, sum.equivalents,
               sum.wrong.size());
    if (sum.left_out > 0)
        fmt::print("only a sample: {} mistakes and variants were left out, and the names of mistakes were not tested\n",
                   sum.left_out);
    return sum.wrong.empty() ? 0 : 1;
}

constexpr double kill_rate_goal = 0.97;

void print_mutants(const LabEntry& lab, const grade::MutationTest& test) {
    fmt::print("{:<6}", "task");
    for (const char* fate : grade::mutant_fates) fmt::print("{:>10}", fate);
    const auto row = [&](const std::string& name, const std::string& task) {
        fmt::print("\n{:<6}", name);
        for (size_t i = 0; i < grade::mutant_fates.size(); ++i)
            fmt::print("{:>10}", test.count(grade::MutantFate(i), task));
    };
    for (const TaskInfo& task : load_manifest(lab).tasks) row(task.id, task.id);
    row("all", "");
    fmt::print("\n");
    for (const auto& [mutant, fate, accused, largest, share, where] : test.results) {
        if (fate != grade::MutantFate::survived && fate != grade::MutantFate::elsewhere) continue;
        fmt::print("{} line {}: {}: {} -> {}\n", mutant.task, mutant.line, mutant.rule, mutant.was,
                   mutant.now.empty() ? "nothing" : mutant.now);
        if (fate == grade::MutantFate::survived)
            fmt::print("    {} % of the pixels differ, by {:.0f}/255 at most: {}\n", rounded(100 * share),
                       255 * largest, where);
        else
            fmt::print("    only other tasks lose points\n");
    }
    const size_t killed = test.count(grade::MutantFate::killed);
    fmt::print(
        "lab {}: {} mutants; {} of {} that can be seen are killed, {} %; {} % of those that lose points lose them in "
        "their own task only; survivors were looked at in {} views; {:.0f} s\n",
        lab.two_digits(), test.results.size(), killed,
        killed + test.count(grade::MutantFate::elsewhere) + test.count(grade::MutantFate::survived),
        rounded(100 * test.kill_rate()), rounded(100 * test.own_rate()), test.views, test.seconds);
}

void print_mutants_json(const LabEntry& lab, const grade::MutationTest& test) {
    nlohmann::ordered_json all = {
        {"lab", lab.folder}, {"views", test.views}, {"kill_rate", test.kill_rate()}, {"own_rate", test.own_rate()}};
    for (const auto& [mutant, fate, accused, largest, share, where] : test.results)
        all["mutants"].push_back({{"task", mutant.task},
                                  {"line", mutant.line},
                                  {"rule", mutant.rule},
                                  {"was", mutant.was},
                                  {"now", mutant.now},
                                  {"fate", grade::mutant_fates[size_t(fate)]},
                                  {"accuses_others", accused},
                                  {"largest", largest},
                                  {"share", share},
                                  {"where", where}});
    fmt::print("{}\n", all.dump(2));
}

/// Returns 1 if the lab's checks detect too few mutants.
int mutate(const GradeArguments& arguments, grade::ClassOptions& options, int sample) {
    if (!arguments.output.empty() || !arguments.labs.empty())
        throw UsageError("--mutate takes neither -o nor --lab: it names its lab, and prints what it finds");
    const LabEntry& lab = find_lab(arguments.mutate);
    if (load_manifest(lab).tasks.empty()) throw UsageError(fmt::format("lab {} has no tasks", lab.two_digits()));
    const grade::IsolationReport isolation = grade::isolation_for(options.trust);
    options.setup.isolation = isolation.level;
    if (options.setup.seed.empty()) options.setup.seed = "mutants";
    print_isolation(isolation);
    const grade::MutationTest test = grade::test_mutants(lab, options.setup, {options.jobs, sample});
    if (arguments.json)
        print_mutants_json(lab, test);
    else
        print_mutants(lab, test);
    if (test.kill_rate() >= kill_rate_goal) return 0;
    print_error(
        fmt::format("fewer than {} % of the mutants that can be seen are killed", rounded(100 * kill_rate_goal)));
    return 1;
}

int make_gradescope(const grade::ClassOptions& options) {
    const std::string seed = options.setup.seed.empty() ? grade::new_seed() : options.setup.seed;
    grade::write_gradescope(options.output, options.labs, seed);
    fmt::print("{}: setup.sh, run_autograder with the seed, and the course with its solutions\n",
               options.output.string());
    fmt::print(
        "zip the contents and upload the archive to Gradescope, for an image with Debian 12: cd '{}' && zip -r "
        "../autograder.zip .\n",
        options.output.string());
    return 0;
}

/// Sets the requested submissions. With --resume they are the submissions of the last run into the folder.
void name_submissions(const GradeArguments& arguments, grade::ClassOptions& options) {
    if (arguments.resume) {
        if (!arguments.paths.empty() || !arguments.labs.empty())
            throw UsageError("--resume uses the submissions and labs of the last run: name none");
        const auto roster = grade::read_roster(options.output);
        if (!roster) throw UsageError(fmt::format("there is nothing to resume in '{}'", options.output.string()));
        for (const std::string& lab : roster->labs) options.labs.push_back(&find_lab(lab));
        options.submissions = roster->given;
    } else {
        if (arguments.paths.empty()) throw UsageError("grade needs submissions: folders or archives of task files");
        options.submissions.assign(arguments.paths.begin(), arguments.paths.end());
    }
    if (options.keep_roster) return;
    for (const fs::path& path : options.submissions)
        if (std::error_code unknown; !fs::exists(path, unknown))
            throw UsageError(fmt::format("there is no '{}'", grade::printable(path.string())));
}

}  // namespace

int print_report(const grade::ClassReport& report, const grade::ClassRecord& record, const fs::path& folder,
                 const grade::Shard& shard) {
    fmt::print("{}", grade::to_table(record));
    for (const std::string& note : record.notes) print_note(note);
    size_t failed = 0;
    for (const grade::SubmissionMark& mark : report.marks) failed += !mark.graded();
    fmt::print("{}: {} graded, {} unchanged, {} not graded; {:.1f} s, of them {:.1f} for the solutions\n",
               folder.string(), report.marks.size() - report.taken_over - failed, report.taken_over,
               failed + report.lost.size() + report.doubled.size(), report.seconds, report.prepared);
    fmt::print("all jobs together: {:.1f} s compiling, {:.1f} s drawing, {:.1f} s comparing\n", report.times.compile,
               report.times.draw, report.times.compare);
    std::fflush(stdout);
    print_isolation(report.isolation);
    if (!shard.whole())
        print_note(fmt::format("part {} of {} ({}); when all parts are done: relief grade --merge {}", shard.index + 1,
                               shard.count, shard.from, folder.string()));
    if (!report.lost.empty()) print_error("cannot be read any more, so without a mark: " + grade::some_of(report.lost));
    if (failed > 0)
        print_error("the machine failed on some submissions: run the same command again, it repeats only those");
    if (!report.doubled.empty())
        print_error("without a mark, since their names are not unique: " + grade::some_of(report.doubled));
    return failed == 0 && report.lost.empty() && report.doubled.empty() ? 0 : 1;
}

grade::SubmissionDone pages_into(const fs::path& folder) {
    return [folder](const grade::SubmissionMark& mark, const std::vector<grade::CheckPictures>& pictures) {
        for (const pages::PageFor reader : pages::page_readers)
            pages::write_page(folder / pages::page_file(mark.name, reader),
                              pages::student_page(mark, pictures, reader));
        pages::write_pictures(folder / pages::pictures_file(mark.name), pages::export_pictures(pictures));
    };
}

namespace {

/// Returns the options that every job of a class needs.
std::vector<std::string> words_for_jobs(const GradeArguments& arguments) {
    std::vector<std::string> words;
    if (arguments.context != "auto") words = {"--context", arguments.context};
    if (arguments.threads != "0") words.insert(words.end(), {"--threads", arguments.threads});
    if (!arguments.seconds.empty()) words.insert(words.end(), {"--seconds", arguments.seconds});
    if (arguments.trust) words.emplace_back("--trust");
    if (arguments.unpinned) words.emplace_back("--unpinned");
    return words;
}

/// Copies the pages and pictures of graded parts from their own folders into `folder`.
void bring_pages_of_parts(const grade::ClassReport& report, const fs::path& folder) {
    for (const fs::path& part : grade::class_parts(folder))
        if (part != folder)
            for (const grade::SubmissionMark& mark : report.marks)
                for (const fs::path& file :
                     {pages::page_file(mark.name, pages::PageFor::instructor),
                      pages::page_file(mark.name, pages::PageFor::student), pages::pictures_file(mark.name)})
                    if (fs::exists(part / file) &&
                        fs::exists(part / "results" / (grade::file_name_of(mark.name) + ".json")))
                        pages::write_page(folder / file, read_file(part / file));
}

/// Reads the class file of the command line, else that of the last run into `folder` or of a part.
grade::ClassFile class_file_for(const GradeArguments& arguments, const fs::path& folder,
                                const std::vector<fs::path>& parts) {
    const bool is_given = !arguments.class_file.empty();
    fs::path file = arguments.class_file == "none" ? "" : arguments.class_file;
    if (!file.empty() && !fs::is_regular_file(file))
        throw UsageError(fmt::format("there is no class file '{}'", grade::printable(file.string())));
    if (!is_given) file = grade::class_file_of(folder);
    for (const fs::path& part : parts)
        if (!is_given && file.empty()) file = grade::class_file_of(part);
    return grade::read_class_file(file, folder);
}

/// Keeps the class file for write_summaries(). Reads it first, so that a mistake in it is reported before hours of
/// grading.
void prepare_class_file(const GradeArguments& arguments, const fs::path& folder, const std::vector<fs::path>& parts,
                        const std::vector<const LabEntry*>& labs) {
    const grade::ClassFile policy = class_file_for(arguments, folder, parts);
    for (const LabEntry* lab : labs)
        if (!policy.labs.empty() && !policy.lab(lab->folder))
            throw UsageError(fmt::format("lab {} is not assigned in {}", lab->two_digits(), policy.file.string()));
    grade::keep_class_file(policy.file, folder);
}

/// Creates the folder for marks, which only its owner may read. An existing folder keeps its permissions.
void make_results_folder(const fs::path& folder) {
    const bool is_new = !fs::exists(folder);
    make_folder(folder);
    if (is_new) fs::permissions(folder, fs::perms::owner_all);
}

int grade_on_slurm(const GradeArguments& arguments, grade::ClassOptions& options) {
    const int parts = whole_number(arguments.slurm, "--slurm", 1, 1000);
    if (!arguments.shard.empty()) throw UsageError("--slurm sends all parts: it takes no --shard");
    if (!arguments.seed.empty())
        throw UsageError(
            "--slurm takes no --seed, which everybody on this machine can read in the list of processes: set "
            "RELIEF_SEED, or leave the seed to chance");
    require_slurm(parts);
    name_submissions(arguments, options);
    make_results_folder(options.output);
    prepare_class_file(arguments, options.output, {}, options.labs);
    return start_class(options, parts, arguments.jobs.empty() ? 0 : options.jobs, words_for_jobs(arguments));
}

/// Writes questions about each submission into the folder `questions`, with the class's seed.
void ask_class(const grade::ClassOptions& options, const grade::ClassReport& report, int count) {
    QuestionOptions asked{.submissions = options.submissions,
                          .policy = grade::read_class_file(grade::class_file_of(options.output), options.output),
                          .labs = options.labs,
                          .folder = options.output / "questions",
                          .count = count,
                          .jobs = options.jobs,
                          .seed = report.seed,
                          .setup = options.setup};
    asked.setup.isolation = report.isolation.level;
    write_questions(asked);
}

/// Compares the submissions with each other, and grades none.
int compare_submissions(const GradeArguments& arguments, grade::ClassOptions& options) {
    for (const auto& [given, option] : {std::pair(!arguments.shard.empty(), "--shard"),
                                        {!arguments.slurm.empty(), "--slurm"},
                                        {arguments.fresh, "--fresh"}})
        if (given)
            throw UsageError(
                fmt::format("--originality grades nothing, so it takes no {}: grade in a run of its own", option));
    name_submissions(arguments, options);
    std::vector<fs::path> earlier(arguments.earlier.begin(), arguments.earlier.end());
    const grade::ClassFile policy = class_file_for(arguments, options.output, {});
    const grade::OriginalityReport report = grade::compare_class(options.submissions, earlier, options.labs, policy);
    make_results_folder(options.output);
    const Descriptor at_work = grade::hold_output(options.output, grade::Hold::alone);
    pages::write_originality(report, options.output);
    for (const grade::Author& author : report.authors)
        for (const std::string& problem : author.problems)
            print_note(fmt::format("{} is not compared in full: {}", author.name, problem));
    fmt::print("{}", grade::originality_table(report));
    fmt::print("{}: {} pairs of submissions compared, {} to look at, in {:.1f} s\n",
               (options.output / "originality.html").string(), report.compared, report.pairs.size(), report.seconds);
    if (report.of_teams > 0)
        fmt::print("{} of members of one team share code, and are not listed\n",
                   amount_of(double(report.of_teams), "pair"));
    fmt::print("Shared code is no proof of anything. Read both texts: a person decides.\n");
    return 0;
}

/// Returns 1 if the machine failed on a submission, a part of the class is missing, or the self-test finds a wrong
/// mark.
int grade_submissions(const GradeArguments& arguments) {
    std::string purpose;
    for (const auto& [given, option] : {std::pair(!arguments.merge.empty(), "--merge"),
                                        {!arguments.status.empty(), "--status"},
                                        {arguments.self_test, "--self-test"},
                                        {!arguments.mutate.empty(), "--mutate"},
                                        {arguments.gradescope, "--gradescope"},
                                        {arguments.originality, "--originality"}}) {
        if (!given) continue;
        if (!arguments.paths.empty() && !arguments.originality)
            throw UsageError(
                fmt::format("{} takes no submissions: '{}' is one argument too many", option, arguments.paths.front()));
        if (!purpose.empty()) throw UsageError(fmt::format("{} and {} do not go together", purpose, option));
        purpose = option;
    }
    if (!arguments.earlier.empty() && !arguments.originality) throw UsageError("--earlier goes with --originality");
    for (const auto& [given, option] : {std::pair(arguments.resume && !arguments.originality, "--resume"),
                                        {!arguments.shard.empty(), "--shard"},
                                        {!arguments.slurm.empty(), "--slurm"},
                                        {!arguments.questions.empty(), "--questions"}})
        if (given && !purpose.empty()) throw UsageError(fmt::format("{} and {} do not go together", purpose, option));
    for (const auto& [given, option] :
         {std::pair(!arguments.shard.empty(), "--shard"), {!arguments.slurm.empty(), "--slurm"}})
        if (given && !arguments.questions.empty())
            throw UsageError(fmt::format("{} grades parts: ask with relief questions SUBMISSION... instead", option));
    if (!arguments.class_file.empty() &&
        (arguments.self_test || !arguments.mutate.empty() || arguments.gradescope || !arguments.status.empty()))
        throw UsageError("--class goes with submissions, --resume or --merge");
    if (!arguments.status.empty()) return print_status(arguments.status, arguments.json);
    if (!arguments.merge.empty()) {
        std::vector<Descriptor> at_work;
        if (fs::is_directory(arguments.merge))
            at_work.push_back(grade::hold_output(arguments.merge, grade::Hold::alone));
        const std::vector<fs::path> parts = grade::class_parts(arguments.merge);
        for (const fs::path& part : parts)
            if (part != arguments.merge) at_work.push_back(grade::hold_output(part, grade::Hold::alone));
        prepare_class_file(arguments, arguments.merge, parts, {});
        const grade::ClassReport report = grade::merge_class(arguments.merge);
        bring_pages_of_parts(report, arguments.merge);
        return print_report(report, pages::write_summaries(report, arguments.merge), arguments.merge, {});
    }
    grade::ClassOptions options = options_of(arguments);
    const int sample = arguments.sample.empty() ? 0 : whole_number(arguments.sample, "--sample", 1, 1000);
    if (arguments.self_test) return test_the_grader(options, sample);
    if (!arguments.mutate.empty()) return mutate(arguments, options, sample);
    if (sample > 0) throw UsageError("--sample goes with --self-test or --mutate");
    if (arguments.json) throw UsageError("--json goes with --mutate or --status");
    if (arguments.output.empty()) throw UsageError("grade needs a folder for its results: -o FOLDER");
    options.output = arguments.output;
    const int questions =
        arguments.questions.empty() ? 0 : whole_number(arguments.questions, "--questions", 1, most_questions);
    if (arguments.gradescope) return make_gradescope(options);
    if (arguments.originality) return compare_submissions(arguments, options);
    if (!arguments.slurm.empty()) return grade_on_slurm(arguments, options);
    options.shard = grade::shard_of(arguments.shard);
    options.keep_roster = arguments.resume && !options.shard.whole();
    name_submissions(arguments, options);
    make_results_folder(options.output);
    const Descriptor at_work =
        grade::hold_output(options.output, options.shard.whole() ? grade::Hold::alone : grade::Hold::as_part);
    if (!options.keep_roster) prepare_class_file(arguments, options.output, {}, options.labs);
    const grade::ClassReport report = grade::grade_class(options, pages_into(options.output));
    if (!options.shard.whole())
        return print_report(report, grade::class_record(report.marks, {}, {}), arguments.output, options.shard);
    const int code =
        print_report(report, pages::write_summaries(report, options.output), arguments.output, options.shard);
    if (questions > 0) ask_class(options, report, questions);
    return code;
}

class GradeCommand final : public Command {
public:
    void options(CommandOptions& options) override {
        options.words("PATH", grade_.paths, "submissions");
        options.value("-o", "FOLDER", grade_.output,
                      "folder for the results; unchanged submissions in it are not graded again");
        options.value("--class", "FILE", grade_.class_file,
                      "class file: roster, labs that count, due dates, late days, attempts (see labs/staff/README.md) "
                      "[the last run's]; none: "
                      "without one");
        options.values("--lab", "LAB", grade_.labs,
                       "grade only this lab; may be repeated [the labs whose files a submission has]");
        options.value(
            "--jobs", "N", grade_.jobs,
            "submissions graded at a time [one per processor; in a job of Slurm, of those that it was given]");
        options.value("--seconds", "S", grade_.seconds,
                      "processor time for drawing a lab once, seconds [ten times the solution's, at least 10]");
        options.value("--seed", "WORD", grade_.seed,
                      "seed of the hidden views [RELIEF_SEED, else the folder's, else random]");
        options.value("--shard", "I/N", grade_.shard,
                      "grade the i-th of n parts [from SLURM_ARRAY_TASK_ID, TEST_SHARD_INDEX or GTEST_SHARD_INDEX]");
        options.value("--merge", "FOLDER", grade_.merge, "merge the parts in this folder; takes no submissions");
        options.value(
            "--slurm", "N", grade_.slurm,
            "send the class to Slurm in n parts, and end: jobs grade it and write the report. --jobs asks for "
            "processors per part; sbatch reads SBATCH_PARTITION, SBATCH_TIMELIMIT and so on");
        options.value("--status", "FOLDER", grade_.status,
                      "say how far the class in this folder is, part by part; takes no submissions");
        options.value("--questions", "N", grade_.questions,
                      "also ask each student N questions about their own code, in the folder questions of -o FOLDER");
        options.flag("--gradescope", grade_.gradescope,
                     "write an autograder for Gradescope to -o FOLDER; takes no submissions");
        options.flag("--originality", grade_.originality,
                     "grade nothing: list the submissions that share code that the starter does not have, and write "
                     "originality.html, .csv and .json to -o FOLDER, for staff only");
        options.values("--earlier", "FOLDER", grade_.earlier,
                       "with --originality: a folder with the submissions of an earlier class, to compare with these; "
                       "may be repeated");
        options.flag("--resume", grade_.resume, "continue the last run into this folder where it stopped");
        options.value("--context", "NAME", grade_.context, "auto (osmesa, then egl), osmesa or egl");
        options.value("--threads", "N", grade_.threads,
                      "extra threads of the software renderer, for each submission [0]");
        options.flag("--unpinned", grade_.unpinned,
                     "use every CPU feature: results are reproducible on this machine only");
        options.flag("--trust", grade_.trust, "grade even if there is no sandbox: only for submissions that you trust");
        options.flag(
            "--self-test", grade_.self_test,
            "test the grader with solutions, starters, known mistakes and correct variants; takes no submissions");
        options.value("--mutate", "LAB", grade_.mutate,
                      "test a lab's checks with small changes of its solution; takes no submissions");
        options.value("--sample", "N", grade_.sample,
                      "with --self-test: only N mistakes and variants per lab; with --mutate: only N mutants");
        options.flag("--json", grade_.json, "with --mutate or --status: print JSON, for scripts");
        options.flag("--fresh", grade_.fresh, "grade everything again, unchanged submissions too");
    }
    int run() override { return grade_submissions(grade_); }

private:
    GradeArguments grade_;
};
RELIEF_COMMAND(GradeCommand, 12, "grade", "grades a class: submissions are folders or archives of task files");

}  // namespace

}  // namespace relief::app
