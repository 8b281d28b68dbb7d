#include "framework/course/app/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <functional>
#include <span>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/from_staff.h"
#include "framework/core/base/log.h"
#include "framework/core/base/system.h"
#include "framework/core/base/text.h"
#include "framework/core/context/backends.h"
#include "framework/core/context/context.h"
#include "framework/core/lab/registry.h"
#include "framework/course/app/command.h"
#include "framework/course/app/gallery.h"
#include "framework/course/app/shot_options.h"
#include "framework/course/app/versions.h"
#include "framework/course/check/guarded_drawing.h"
#include "framework/course/manifest/manifest.h"
#include "framework/course/window/menu.h"
#include "framework/library/kit/word_layout.h"

namespace relief::app {
namespace {

int run_menu(const window::MenuStart& start) {
    return window_module().function<decltype(relief_run_menu)>("relief_run_menu")(start);
}

/// Opens the window if there is a display, else makes the gallery.
int open_menu_or_gallery(const std::string& lab_folder) {
    try {
        return run_menu({.lab_folder = lab_folder});
    } catch (const NoWindow& error) {
        if (!draws_without_display()) throw;
        print_note(fmt::format(
            "{}: the course page is made instead; it is there in seconds, and complete in minutes (Ctrl-C ends it)",
            error.what()));
    }
    const auto context = open_context(std::nullopt);
    return make_gallery({});
}

/// Returns a message for the argument that CLI11 could not parse, with the nearest known name.
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
    for (const CommandEntry& one : commands()) known.emplace_back(one.name);
    // The script `relief` has commands of its own, and asks for the nearest one.
    if (const char* const own = std::getenv("RELIEF_SCRIPT_COMMANDS"))
        for (const std::string& name : split(own, ' ')) known.push_back(name);
    constexpr std::array staffs = {"bench",    "handout",  "grade", "web",      "slides",
                                   "mistakes", "synctest", "map",   "questions"};
    if (std::find(staffs.begin(), staffs.end(), word) != staffs.end())
        return fmt::format("'{}' is a command for staff only (framework/staff), which is not {}", word,
                           staff_is_here() ? "built: ./relief build" : "in this course");
    return unknown("command", word, known);
}

/// Declares a command's options in CLI11.
class OptionsOfCommand final : public CommandOptions {
public:
    /// `only_lab` is the folder of the lab of an executable with one lab, else empty.
    OptionsOfCommand(CLI::App& command, const std::string& only_lab) : command_(command), only_lab_(only_lab) {}

    void lab(std::string& value, bool required) override {
        value = only_lab_;
        CLI::Option* option = add("LAB", value, "a number, a name or the beginning of a word in one");
        option->trigger_on_parse();  // because from CLI11 2.4 on, --help prints the lab's knobs before other options
                                     // are set
        if (required && only_lab_.empty()) option->required();
    }
    void words(const char* name, std::vector<std::string>& values, const char* help) override {
        add(name, values, help)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    }
    void word(const char* name, std::string& value, const char* help) override { add(name, value, help)->required(); }
    void value(const char* name, const char* type, std::string& value, const char* help) override {
        add(name, value, help)->type_name(type);
    }
    void values(const char* name, const char* type, std::vector<std::string>& values, const char* help) override {
        add(name, values, help)
            ->type_name(type)
            ->expected(1)
            ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
            ->allow_extra_args(false);
    }
    void flag(const char* name, bool& value, const char* help) override { command_.add_flag(name, value, help); }
    void footer(std::function<std::string()> text) override { command_.footer(std::move(text)); }

private:
    template <class Value>
    CLI::Option* add(const char* name, Value& value, const char* help) {
        // An empty word is usually an unset variable of a script. It must not mean "all" or "the default".
        static const CLI::Validator not_empty([](std::string& word) { return word.empty() ? "must not be empty" : ""; },
                                              "");
        return command_.add_option(name, value, help)->check(not_empty);
    }

    CLI::App& command_;
    const std::string& only_lab_;
};

class RunCommand final : public Command {
public:
    void options(CommandOptions& options) override {
        options.lab(lab_, true);
        options.value("--check", "NAME", check_, "show this check, with its knobs, camera and probe");
        shot_.options(options);
        options.value("--probe", "NAME", probe_, "show a quantity as the shader computes it, instead of the picture");
        options.flag("--error-map", error_map_, "beside the picture, show how far it is from the exact values (key E)");
    }
    int run() override {
        const LabEntry& lab = find_lab(lab_);
        const Manifest manifest = load_manifest(lab);
        Shot shot;
        shot.camera = manifest.camera;
        if (!check_.empty()) shot = manifest.view_of_check(check_);
        shot_.apply(shot);
        if (!probe_.empty()) shot.probe.name = manifest.probe(probe_).name;
        const auto made = make_lab(lab, shot);  // rejects a wrong knob or value before a window opens
        shot_.note_knobs_without_effect(*made);
        return run_menu({lab.folder, shot, error_map_, check_});
    }

private:
    std::string lab_, check_, probe_;
    ShotOptions shot_;
    bool error_map_ = false;
};
RELIEF_COMMAND(RunCommand, 3, "run", "opens a lab in a window");

/// Returns whether a command line needs the staff's library: for help, for its commands, and for its additions to
/// others. All other command lines start faster without it.
bool needs_staff(std::span<char* const> arguments) {
    std::string_view command;
    for (const std::string_view word : arguments.subspan(std::min<size_t>(1, arguments.size()))) {
        if (word == "-h" || word == "--help" || word.starts_with("--mistake") || word.starts_with("--submission"))
            return true;
        if (command.empty() && !word.starts_with('-')) command = word;
    }
    return command == "info" || command == "explain" || (!command.empty() && !has_command(std::string(command)));
}

constexpr const char* introduction =
    "Relief: surface detail in OpenGL, lab by lab.\n\n"
    "relief COMMAND [OPTIONS]    runs a command; relief help COMMAND: its options\n"
    "relief 03                   opens lab 03 in a window, as relief run 03\n"
    "relief                      opens the menu; without a display, the course page\n\n"
    "Examples:\n"
    "    relief list                        the labs, and your points\n"
    "    relief check 02 --open             what is wrong in lab 02, with pictures\n"
    "    relief shot 14 --set view=above    a picture of lab 14\n";

/// Returns the program's own help: its commands by those who need them, in lines of 80 letters.
std::string help_of_program() {
    constexpr size_t indent = 13, width = 80;
    struct Group {
        const char* title;
        int end;  ///< of CommandEntry::order
    };
    std::string text = introduction;
    int begin = 0;
    for (const auto& [title, end] : {Group{"students", 10}, Group{"teachers", 20}, Group{"maintainers", 1000}}) {
        std::string group;
        for (const CommandEntry& entry : commands()) {
            if (entry.order < begin || entry.order >= end) continue;
            const auto fits = [](const std::string& line) { return line.size() <= width - indent; };
            const std::vector<std::string> lines = broken_into_lines(entry.help, fits);
            for (size_t i = 0; i < lines.size(); ++i)
                group += fmt::format("{:<{}}{}\n", i == 0 ? fmt::format("  {}", entry.name) : "", indent, lines[i]);
        }
        if (!group.empty()) text += fmt::format("\nCommands for {}:\n{}", title, group);
        begin = end;
    }
    return text + "\nOptions: --version; --verbose prints each event to standard error\n";
}

class CommandLine {
public:
    // A lab's executable, lab-NN, has one lab, so LAB is not needed there.
    explicit CommandLine(const std::string& program) {
        app_.name(program);
        if (program.starts_with("lab-") && registry().size() == 1) only_lab_ = registry().front().folder;
        app_.require_subcommand(0, 1);
        app_.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
        app_.set_version_flag("-v,--version", fmt::format("relief {} ({})", versions::relief, versions::commit),
                              "print the version");
        app_.add_flag("--verbose", verbose_, "print each event to standard error");
        app_.set_help_flag("-h,--help", "print this help");
        app_.get_formatter()->column_width(34);
        for (const CommandEntry& entry : commands()) {
            CLI::App* sub = app_.add_subcommand(entry.name, entry.help);
            sub->add_flag("--verbose", verbose_, "print each event to standard error");
            Command* const command = made_.emplace_back(entry.make()).get();
            OptionsOfCommand options(*sub, only_lab_);
            command->options(options);
            sub->callback([this, command] { chosen_ = command; });
        }
        // After the commands, which have the formatter that the program had when they were added.
        app_.formatter_fn([](const CLI::App*, const std::string&, CLI::AppFormatMode) { return help_of_program(); });
    }

    int run(int argc, char** argv) {
        try {
            app_.parse(argc, argv);
        } catch (const CLI::Success& wanted) {
            return app_.exit(wanted);  // --help and --version
        } catch (const CLI::ExtrasError&) {
            throw UsageError(unexpected(app_));
        } catch (const CLI::ParseError& error) {
            throw UsageError(std::string(error.what()) + "; --help shows the options");
        }
        set_verbose(verbose_);
        show_all_messages(verbose_);
        print_event("started: libraries are linked, the command line is read");
        return chosen_ ? chosen_->run() : open_menu_or_gallery(only_lab_);
    }

private:
    CLI::App app_;
    std::string only_lab_;
    bool verbose_ = false;
    std::vector<std::unique_ptr<Command>> made_;
    Command* chosen_ = nullptr;
};

}  // namespace

namespace {

/// Rewrites the short forms of a command line: "help" and "help shot" ask for help, and "03" runs that lab.
void spell_out(std::vector<std::string>& words) {
    if (words.size() < 2) return;
    if (words[1] == "help") {
        words.erase(words.begin() + 1);
        words.push_back("--help");
    } else if (!words[1].empty() && words[1].find_first_not_of("0123456789") == std::string::npos) {
        words.insert(words.begin() + 1, "run");
    }
}

/// Runs a command and returns its exit code.
int run_words(std::vector<std::string> words) {
    spell_out(words);
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    const int argc = int(pointers.size());
    char** const argv = pointers.data();
    try {
        // An internal command by which `grade` starts itself in a sandbox. It is not in --help.
        if (argc == 4 && std::string_view(argv[1]) == "draw-checks") check::draw_request(argv[3]);
        if (needs_staff({argv, size_t(argc)})) open_staff_library();
        const std::string program = std::filesystem::path(argc > 0 ? argv[0] : "").filename().string();
        const int code = CommandLine(program).run(argc, argv);
        // A script must not mistake truncated or missing output for a complete answer.
        if (std::fflush(stdout) != 0 || std::ferror(stdout)) throw Error("cannot write to standard output");
        return code;
    } catch (const UsageError& error) {
        print_error(error.what());
        return 2;
    } catch (const Error& error) {
        print_error(error.what());
        for (const std::string& line : lines_for_terminal(error.details())) fmt::print(stderr, "{}\n", line);
    } catch (const std::bad_alloc&) {
        print_error("there is not enough memory");
    } catch (const std::exception& error) {
        print_error(error.what());
    }
    return 1;
}

}  // namespace

int run_command_line(int argc, char** argv) {
    os::take_large_pages();
    os::prepare_standard_streams();
    clean_up_when_interrupted();
    const int code = run_words(os::utf8_arguments(argc, argv));
    if (code != 0) os::keep_terminal_open();
    return code;
}

}  // namespace relief::app
