#include "framework/app/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <functional>

#include "framework/app/commands.h"
#include "framework/app/menu.h"
#include "framework/app/versions.h"
#include "framework/base/error.h"
#include "framework/base/file.h"
#include "framework/base/log.h"
#include "framework/base/memory.h"
#include "framework/base/text.h"
#include "framework/context/backends.h"
#include "framework/lab/knobs.h"
#include "framework/lab/manifest.h"
#if __has_include("framework/measure/bench.h")  // not in a student's course
    #include "framework/grade/drawing.h"
#endif

namespace relief {
namespace {

constexpr const char* context_help = "auto (osmesa, then egl), osmesa, egl or window";

std::string knobs_and_probes(const std::string& lab_text) {
    if (lab_text.empty()) return "The knobs and probes of a lab: relief shot LAB --help";
    try {
        const LabEntry& entry = find_lab(lab_text);
        std::string text = fmt::format("Knobs of {} (--set name=value):\n", entry.folder);
        for (const KnobText& knob : describe_knobs(*entry.make()))
            text += fmt::format("  {:<14} {}; {} [{}]\n", knob.name, knob.help, knob.range, knob.value);
        text += "Probes:\n";
        for (const ProbeInfo& probe : load_manifest(entry).probes)
            text += fmt::format("  {:<14} {}\n", probe.name, probe.unit.empty() ? "no unit" : "unit: " + probe.unit);
        return text;
    } catch (const Error& error) {
        return error.what();
    }
}

int run_menu(const std::string& lab_folder) {
    return window_module().function<decltype(relief_run_menu)>("relief_run_menu")(lab_folder.c_str());
}

/// The window where there is a display, else the gallery.
int open_menu_or_gallery(const std::string& lab_folder) {
    try {
        return run_menu(lab_folder);
    } catch (const NoWindow& error) {
        print_note(fmt::format("{}; making the gallery instead", error.what()));
    }
    return make_gallery({}, {}, {});
}

/// What CLI11 could not place, with the nearest thing that it knows.
std::string unexpected(const CLI::App& app) {
    const CLI::App* command = &app;
    for (const CLI::App* chosen : app.get_subcommands()) command = chosen;
    const std::vector<std::string> rest = app.remaining(true);
    const std::string word = rest.empty() ? "" : rest.front();
    std::vector<std::string> known;
    if (word.starts_with("-")) {
        for (const CLI::Option* option : command->get_options())
            for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
        return unknown("option", word.substr(0, word.find('=')), known);
    }
    if (command != &app) return fmt::format("'{}' is one argument too many for {}", word, command->get_name());
    for (const CLI::App* one : app.get_subcommands([](const CLI::App*) { return true; }))
        known.push_back(one->get_name());
    return unknown("command", word, known);
}

class CommandLine {
public:
    // Each lab's executable is named lab-NN and knows one lab: LAB need not be said there.
    explicit CommandLine(const std::string& program) {
        app_.name(program);
        if (program.starts_with("lab-") && registry().size() == 1) only_lab_ = registry().front().folder;
        shot_.lab = run_lab_ = golden_lab_ = check_lab_ = mistakes_lab_ = only_lab_;
        app_.require_subcommand(0, 1);
        app_.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
        app_.set_version_flag("--version", fmt::format("relief {} ({})", versions::relief, versions::commit));
        app_.add_flag("--verbose", verbose_, "print each event on standard error");
        app_.set_help_flag("-h,--help", "this text");
        app_.get_formatter()->column_width(34);
        add_list(), add_info(), add_run(), add_shot(), add_gallery(), add_check(), add_golden(), add_new_lab();
#if __has_include("framework/measure/bench.h")
        add_bench(), add_handout(), add_grade(), add_slides(), add_mistakes();
#endif
        // An empty word is most often a script's variable that was never set; it must not mean "all" or "as usual".
        const CLI::Validator not_empty([](std::string& word) { return word.empty() ? "must not be empty" : ""; }, "");
        for (CLI::App* sub : app_.get_subcommands([](const CLI::App*) { return true; }))
            for (CLI::Option* option : sub->get_options())
                if (option->get_items_expected_max() > 0) option->check(not_empty);
    }

    int run(int argc, char** argv) {
        try {
            app_.parse(argc, argv);
        } catch (const CLI::Success& wanted) {
            return app_.exit(wanted);  // --help and --version
        } catch (const CLI::ExtrasError&) {
            throw UsageError(unexpected(app_));
        } catch (const CLI::ParseError& error) {
            throw UsageError(std::string(error.what()) + "; --help shows what is taken");
        }
        set_verbose(verbose_);
        print_event("started: libraries are linked, the command line is read");
        return command_ ? command_() : open_menu_or_gallery(only_lab_);
    }

private:
    CLI::App* add(const char* name, const char* help, std::function<int()> command) {
        CLI::App* sub = app_.add_subcommand(name, help);
        sub->add_flag("--verbose", verbose_, "print each event on standard error");
        sub->callback([this, command = std::move(command)] { command_ = command; });
        return sub;
    }
    void add_lab(CLI::App* sub, std::string& lab, bool required) {
        CLI::Option* option = sub->add_option("LAB", lab, "a number, a name or any part of one");
        if (required && only_lab_.empty()) option->required();
    }

    void add_list() {
        CLI::App* sub = add("list", "labs, titles, points", [this] { return list_labs(json_); });
        sub->add_flag("--json", json_, "for scripts");
    }
    void add_info() {
        add("info", "contexts, drivers, libraries: paste it into every bug report", [] { return print_info(); });
    }
    void add_run() {
        CLI::App* sub = add("run", "a lab in a window", [this] {
            const std::string folder = find_lab(run_lab_).folder;
            return run_menu(folder);
        });
        add_lab(sub, run_lab_, true);
    }
    void add_shot() {
        CLI::App* sub = add("shot", "a picture of a lab, without a display", [this] { return take_shot(shot_); });
        add_lab(sub, shot_.lab, true);
        sub->add_option("-o", shot_.output, "FILE.png, .exr, .ppm or .pfm, or - for standard output")
            ->type_name("FILE");
        sub->add_option("--size", shot_.size, "in pixels [1280x720]")->type_name("WxH");
        sub->add_option("--time", shot_.time, "of an animation [0]")->type_name("SECONDS");
        sub->add_option("--context", shot_.context, context_help)->type_name("NAME");
        sub->add_option("--set", shot_.set, "turn a knob; may be repeated")
            ->type_name("KNOB=VALUE")
            ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
            ->allow_extra_args(false);
        sub->add_option("--camera", shot_.camera, "degrees and metres; X,Y,Z: where it looks; V: its field of view")
            ->type_name("YAW,PITCH,DISTANCE[,X,Y,Z[,V]]");
        sub->add_option("--probe", shot_.probe, "the quantity itself, as the shader has it")->type_name("NAME");
        sub->add_option("--truth", shot_.truth, "its exact value")->type_name("NAME");
        sub->add_option("--error", shot_.error, "how far the one is from the other")->type_name("NAME");
#if __has_include("framework/measure/bench.h")
        sub->add_option("--mistake", shot_.mistake, "drawn with a known mistake: an id of the lab's manifest")
            ->type_name("ID");
#endif
        sub->footer([this] { return knobs_and_probes(shot_.lab); });
    }
    void add_gallery() {
        CLI::App* sub = add("gallery", "the course's web site: every lab, its methods side by side, its handout",
                            [this] { return make_gallery(output_, labs_, context_kind(context_)); });
        sub->add_option("-o", output_, "where to [the course's build/gallery]")->type_name("FOLDER");
        sub->add_option("--labs", labs_, "like 1-5 or 1,3,10-12 [all]")->type_name("LABS");
        sub->add_option("--context", context_, context_help)->type_name("NAME");
    }
    void add_golden() {
        CLI::App* sub = add("golden", "compare with the reference screenshots",
                            [this] { return check_golden(golden_lab_, update_, output_, context_kind(context_)); });
        add_lab(sub, golden_lab_, false);
        sub->add_flag("--update", update_, "renew those that differ");
        sub->add_option("-o", output_, "write what differs: now, reference, difference")->type_name("FOLDER");
        sub->add_option("--context", context_, context_help)->type_name("NAME");
    }
    void add_check() {
        CLI::App* sub = add("check", "your work on a lab: what is wrong, and what to look at next",
                            [this] { return check_own_work(check_lab_, json_, open_, output_); });
        add_lab(sub, check_lab_, true);
        sub->add_flag("--json", json_, "for scripts");
        sub->add_flag("--open", open_, "as a page with the pictures, in the browser");
        sub->add_option("-o", output_, "the page into a file, and not opened without --open")->type_name("FILE.html");
    }
#if __has_include("framework/measure/bench.h")
    void add_handout() {
        CLI::App* sub = add("handout", "the course for students: starters, no solutions, no hidden checks",
                            [this] { return make_handout(output_, labs_); });
        sub->add_option("-o", output_,
                        "where to: new, or a handout, which is brought up to date without touching what its "
                        "owner changed")
            ->type_name("FOLDER");
        sub->add_option("--labs", labs_,
                        "like 1-5 or 1,3,10-12, added to those that are there [new: all; else those that are there]")
            ->type_name("LABS");
    }
    void add_grade() {
        CLI::App* sub = add("grade", "marks for a class: submissions are folders or archives of task files",
                            [this] { return grade_submissions(grade_); });
        sub->add_option("PATH", grade_.paths, "submissions")->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
        sub->add_option("-o", grade_.output, "where to; what is there and unchanged is not graded again")
            ->type_name("FOLDER");
        sub->add_option("--lab", grade_.labs, "only this lab; may be given several times [those handed in]")
            ->type_name("LAB")
            ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
        sub->add_option("--jobs", grade_.jobs, "submissions at a time [one for each processor]")->type_name("N");
        sub->add_option("--seconds", grade_.seconds, "for drawing a lab once [20, more where the solution is slow]")
            ->type_name("S");
        sub->add_option("--seed", grade_.seed, "of the hidden views [RELIEF_SEED; the folder's; by chance]")
            ->type_name("WORD");
        sub->add_option("--shard", grade_.shard,
                        "the i-th of n parts of the class [a Slurm array's, TEST_SHARD_INDEX or GTEST_SHARD_INDEX]")
            ->type_name("I/N");
        sub->add_option("--merge", grade_.merge, "no submissions: put the parts together that lie in this folder")
            ->type_name("FOLDER");
        sub->add_flag("--gradescope", grade_.gradescope, "no submissions: an autograder for Gradescope into -o FOLDER");
        sub->add_flag("--resume", grade_.resume, "the submissions of the last run into the folder, where it ended");
        sub->add_option("--context", grade_.context, "auto (osmesa, then egl), osmesa or egl")->type_name("NAME");
        sub->add_option("--threads", grade_.threads, "of the software renderer, for each submission [0]")
            ->type_name("N");
        sub->add_flag("--unpinned", grade_.unpinned, "by all that this processor can do: marks hold on it only");
        sub->add_flag("--trust", grade_.trust, "also where submissions can be kept from nothing");
        sub->add_flag("--self-test", grade_.self_test,
                      "no submissions: solutions, starters, known mistakes and correct variants");
        sub->add_option("--sample", grade_.sample, "of each lab so many mistakes and variants, for a quick self-test")
            ->type_name("N");
        sub->add_flag("--fresh", grade_.fresh, "everything anew");
    }
    void add_mistakes() {
        CLI::App* sub = add("mistakes", "a page of the known mistakes, each beside what is right: the grader's legend",
                            [this] { return show_mistakes(mistakes_lab_, output_, context_kind(context_)); });
        add_lab(sub, mistakes_lab_, false);
        sub->add_option("-o", output_, "where to [the course's build/mistakes]")->type_name("FOLDER");
        sub->add_option("--context", context_, context_help)->type_name("NAME");
    }
    void add_bench() {
        CLI::App* sub =
            add("bench", "run time against error: tables, a CSV and a plot for each topic, a page of them all",
                [this] { return run_bench(bench_); });
        sub->add_option("TOPIC", bench_.topics, "all of them when none is named");
        sub->add_option("-o", bench_.output, "where they go [the course's build/bench]")->type_name("FOLDER");
        sub->add_option("--set", bench_.set,
                        "of what is swept only this: map=bricks,posts or method=linear; may be repeated")
            ->type_name("KNOB=VALUE,...")
            ->expected(1)
            ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
        sub->add_option("--repeats", bench_.repeats,
                        "samples of each method, in turns, 10 or more [15; with --quick 3]")
            ->type_name("N");
        sub->add_option("--context", bench_.context, context_help)->type_name("NAME");
        sub->add_flag("--quick", bench_.quick, "few scenes and small sizes, for a first look");
        sub->add_flag("--work", bench_.work,
                      "no times: hold work and error of the quick sweep to tests/measure/baseline.csv");
        sub->add_flag("--update", bench_.update, "with --work: renew what they are held to");
        sub->footer([] { return bench_topics_text(); });
    }
    void add_slides() {
        CLI::App* sub = add("slides", "what an instructor shows: a deck for each lab, as HTML and PDF",
                            [this] { return make_slides(slides_); });
        sub->add_option("DECK", slides_.decks, "a number, a name or any part of one; all of them when none is named")
            ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
        sub->add_option("-o", slides_.output, "where to [the course's build/slides, or build/slides-with-solutions]")
            ->type_name("FOLDER");
        sub->add_flag("--solutions", slides_.solutions, "with the slides that show tasks' solutions");
        sub->add_flag_callback(
            "--no-pdf", [this] { slides_.pdf = false; }, "HTML only, which needs no browser");
    }
#endif
    void add_new_lab() {
        CLI::App* sub =
            add("new-lab", "a new lab that builds, runs and is tested", [this] { return make_new_lab(new_name_); });
        sub->add_option("NAME", new_name_, "like wet_stone (numbered from 20 on) or 21_wet_stone")->required();
    }

    CLI::App app_{
        "Relief: surface detail in OpenGL, lab by lab.\n"
        "Without a command: the menu window, or the gallery where there is no display."};
    std::string only_lab_, run_lab_, golden_lab_, check_lab_, mistakes_lab_, new_name_, labs_, output_,
        context_ = "auto";
    bool verbose_ = false, json_ = false, update_ = false, open_ = false;
    ShotArguments shot_;
    BenchArguments bench_;
    GradeArguments grade_;
    SlidesArguments slides_;
    std::function<int()> command_;
};

}  // namespace

int run_command_line(int argc, char** argv) {
    take_large_pages();
    clean_up_when_interrupted();
    try {
#if __has_include("framework/measure/bench.h")
        // How `grade` starts itself in a sandbox: not for people, and not in --help.
        if (argc == 4 && std::string_view(argv[1]) == "draw-checks") draw_request(argv[3]);
#endif
        const std::string program = std::filesystem::path(argc > 0 ? argv[0] : "").filename().string();
        const int code = CommandLine(program).run(argc, argv);
        // A script must not take half an answer, or none, for a whole one.
        if (std::fflush(stdout) != 0 || std::ferror(stdout)) throw Error("cannot write to standard output");
        return code;
    } catch (const UsageError& error) {
        print_error(error.what());
        return 2;
    } catch (const Error& error) {
        print_error(error.what());
        if (!error.details().empty()) print_event(error.details());
    } catch (const std::bad_alloc&) {
        print_error("there is not enough memory for this");
    } catch (const std::exception& error) {
        print_error(error.what());
    }
    return 1;
}

}  // namespace relief
