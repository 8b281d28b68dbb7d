// relief questions: asks students about their own code.
#include "framework/staff/app/questions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/log.h"
#include "framework/core/base/parallel.h"
#include "framework/core/base/text.h"
#include "framework/course/app/command.h"
#include "framework/staff/class/authorship.h"
#include "framework/staff/class/class.h"
#include "framework/staff/pages/question_pages.h"
#include "framework/staff/pages/summaries.h"
#include "framework/staff/questions/questions.h"

namespace relief::app {
namespace {

namespace fs = std::filesystem;

class QuestionRun {
public:
    explicit QuestionRun(const QuestionOptions& options) : options_(options), stage_(options.setup.isolation) {
        for (const LabEntry& lab : registry())
            if (options.labs.empty() || std::find(options.labs.begin(), options.labs.end(), &lab) != options.labs.end())
                if (const Manifest manifest = load_manifest(lab); !manifest.tasks.empty())
                    files_[&lab] = grade::task_files(manifest);
    }

    int run() {
        read();
        int parts = 0;
        std::set<const LabEntry*> needed;
        for (const One& one : all_) {
            parts += int(one.labs.size()) * grade::QuestionMaker::parts;
            needed.insert(one.labs.begin(), one.labs.end());
        }
        Progress progress(parts + int(needed.size()));
        for (const One& one : all_) ask(one, progress);
        // All at once, so that an interrupted run leaves no sheets of another key.
        for (const auto& [sheet, page] : sheets_)
            if (std::error_code ignored; page.empty())  // there may be one of an earlier run
                fs::remove(sheet, ignored);
            else
                pages::write_page(sheet, page);
        pages::write_page(options_.folder / "key.html", pages::question_key(students_));
        pages::write_page(options_.folder / "questions.json",
                          pages::questions_json(students_, options_.keeps_seed ? options_.seed : ""));
        return has_sheets() ? 0 : 1;
    }

    void print() const {
        for (const pages::StudentQuestions& student : students_) {
            const std::string name = grade::printable(student.name);
            for (const std::string& problem : student.problems) print_note(fmt::format("{}: {}", name, problem));
            if (student.questions.empty())
                fmt::print("{}: no sheet\n", name);
            else
                fmt::print("{}: {} of {} questions\n", name, student.questions.size(), student.wanted);
        }
        if (!has_sheets()) return;
        fmt::print("{}: for the students, without answers\n{}: for you\n", (options_.folder / "sheets").string(),
                   (options_.folder / "key.html").string());
    }

private:
    bool has_sheets() const {
        return std::any_of(sheets_.begin(), sheets_.end(), [](const auto& sheet) { return !sheet.second.empty(); });
    }

    struct One {
        grade::Submission submission;
        std::vector<const LabEntry*> labs;
    };

    void read() {
        std::set<std::string> wanted;
        for (const auto& [lab, files] : files_) wanted.insert(files.begin(), files.end());
        const grade::HandIns hand_ins = grade::hand_ins_of(options_.submissions, options_.policy);
        for (const grade::HandIn& hand_in : hand_ins.all) {
            One one{grade::read_submission(hand_in.name, hand_in.parts, wanted), {}};
            for (const LabEntry& lab : registry())
                if (const auto files = files_.find(&lab); files != files_.end())
                    for (const std::string& file : files->second)
                        if (one.submission.files.contains(file) || one.submission.refused.contains(file)) {
                            one.labs.push_back(&lab);
                            break;
                        }
            if (one.labs.empty() && one.submission.problem.empty())
                one.submission.problem = "there is no task file in it";
            all_.push_back(std::move(one));
        }
        for (const grade::HandIns::Doubled& several : hand_ins.doubled) {
            One& one = all_.emplace_back();
            one.submission.name = several.name;
            one.submission.problem = several.message;
        }
    }

    const grade::QuestionMaker& maker_of(const LabEntry& lab, Progress& progress) {
        std::unique_ptr<grade::QuestionMaker>& maker = makers_[&lab];
        if (maker) return *maker;
        progress.next("the solution of lab " + lab.two_digits());
        stage_.add(lab);
        maker = std::make_unique<grade::QuestionMaker>(lab, stage_, options_.setup);
        return *maker;
    }

    void ask(const One& one, Progress& progress) {
        const std::string name = one.submission.name;
        pages::StudentQuestions student{name, {}, size_t(options_.count), {}};
        if (!one.submission.problem.empty()) student.problems.push_back(one.submission.problem);
        std::vector<grade::LabQuestions> labs;
        for (const LabEntry* lab : one.labs) {
            const grade::QuestionMaker& maker = maker_of(*lab, progress);
            labs.push_back(maker.ask(
                one.submission, size_t(options_.count), options_.seed, options_.jobs, [&](const std::string& part) {
                    progress.next(fmt::format("{}, lab {}: {}", grade::printable(name), lab->two_digits(), part));
                }));
            if (!labs.back().problem.empty())
                student.problems.push_back(fmt::format("lab {}: {}", lab->two_digits(), labs.back().problem));
        }
        student.questions = grade::chosen_questions(labs, student.wanted);
        sheets_[options_.folder / "sheets" / (grade::file_name_of(name) + ".html")] =
            student.questions.empty() ? "" : pages::question_sheet(student);
        for (grade::Question& question : student.questions) question.pictures.clear();
        students_.push_back(std::move(student));
    }

    const QuestionOptions& options_;
    grade::Stage stage_;
    std::map<const LabEntry*, std::set<std::string>> files_;
    std::map<const LabEntry*, std::unique_ptr<grade::QuestionMaker>> makers_;
    std::vector<One> all_;
    std::vector<pages::StudentQuestions> students_;
    std::map<fs::path, std::string> sheets_;  ///< the pages; empty without questions
};

/// Returns the seed of the last run into the folder, else a random one.
std::string seed_in(const fs::path& folder) {
    if (const fs::path file = folder / "questions.json"; fs::is_regular_file(file)) {
        const auto before = nlohmann::json::parse(read_file(file), nullptr, false);
        if (before.is_object() && before.contains("seed") && before["seed"].is_string()) return before["seed"];
    }
    return grade::new_seed();
}

int number_in(const std::string& text, const char* option, int low, int high) {
    const auto value = parse_int(text);
    if (!value || *value < low || *value > high)
        throw UsageError(fmt::format("{} takes a whole number from {} to {}, not '{}'", option, low, high, text));
    return *value;
}

class QuestionsCommand final : public Command {
public:
    void options(CommandOptions& options) override {
        options.words("SUBMISSION", paths_, "folders or archives of task files, as for grade");
        options.value("-o", "FOLDER", folder_,
                      "folder for the sheets of students, the key with the answers, and questions.json");
        options.value("--count", "N", count_, "questions for each submission, 1 to 20 [5]");
        options.values("--lab", "LAB", labs_,
                       "ask only about this lab; may be repeated [the labs whose files a submission has]");
        options.value("--seed", "WORD", seed_,
                      "the same questions for the same seed [RELIEF_SEED, else the folder's, else random]");
        options.value("--jobs", "N", jobs_, "changed files drawn at a time [one per processor]");
        options.value("--context", "NAME", context_, "auto (osmesa, then egl), osmesa or egl");
        options.flag("--trust", trust_, "ask even if there is no sandbox: only for submissions that you trust");
    }
    int run() override {
        if (paths_.empty()) throw UsageError("questions needs a submission: a folder or an archive of task files");
        if (folder_.empty()) throw UsageError("questions needs a folder for its sheets: -o FOLDER");
        QuestionOptions options;
        options.count = number_in(count_, "--count", 1, most_questions);
        options.jobs = jobs_.empty() ? int(hardware_threads()) : number_in(jobs_, "--jobs", 1, 256);
        for (const std::string& path : paths_) {
            if (std::error_code unknown; !fs::exists(path, unknown))
                throw UsageError(fmt::format("there is no '{}'", grade::printable(path)));
            options.submissions.emplace_back(path);
        }
        for (const std::string& lab : labs_) {
            const LabEntry& entry = find_lab(lab);
            if (load_manifest(entry).tasks.empty())
                throw UsageError(fmt::format("lab {} has no tasks", entry.two_digits()));
            options.labs.push_back(&entry);
        }
        options.folder = folder_;
        options.setup.renderer.context = context_kind(context_);
        if (options.setup.renderer.context == ContextKind::window)
            throw UsageError("questions draws without a window: choose osmesa or egl");
        options.setup.isolation = grade::isolation_for(trust_).level;
        const char* const seed = std::getenv("RELIEF_SEED");
        options.seed = !seed_.empty() ? seed_ : seed ? seed : seed_in(options.folder);
        options.keeps_seed = !seed_.empty() || !seed;  // a seed in the environment is a secret
        return write_questions(options);
    }

private:
    std::vector<std::string> paths_, labs_;
    std::string folder_, count_ = "5", seed_, jobs_, context_ = "auto";
    bool trust_ = false;
};
RELIEF_COMMAND(QuestionsCommand, 18, "questions", "asks a student about their own code: a sheet, and a key for you");

}  // namespace

int write_questions(const QuestionOptions& options) {
    const bool is_new = !fs::exists(options.folder);
    make_folder(options.folder);
    if (is_new) fs::permissions(options.folder, fs::perms::owner_all);
    QuestionRun run(options);
    const int code = run.run();
    run.print();
    return code;
}

}  // namespace relief::app
