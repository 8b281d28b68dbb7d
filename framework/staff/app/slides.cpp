// relief slides: makes HTML and PDF from the decks in slides/ with marp-cli. The labs draw the pictures.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <mutex>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/log.h"
#include "framework/core/base/parallel.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/process.h"
#include "framework/core/base/text.h"
#include "framework/core/lab/registry.h"
#include "framework/course/app/command.h"
#include "framework/course/pages/template.h"
#include "framework/staff/app/tool.h"
#include "framework/staff/slides/deck.h"

namespace relief::app {
namespace {

namespace fs = std::filesystem;

struct SlidesArguments {
    std::vector<std::string> decks;
    std::string output;
    bool solutions = false, no_pdf = false;
};
using Words = std::vector<std::string>;

fs::path source_folder() { return course_root() / "slides"; }
/// Returns the folder of drawings, which handouts use, too.
fs::path drawings_folder() { return course_root() / "assets" / "diagrams"; }

/// Returns the names of the requested decks, or of all, without .md.
Words decks_asked_for(const Words& asked) {
    Words all, chosen;
    if (fs::is_directory(source_folder()))
        for (const auto& entry : fs::directory_iterator(source_folder()))
            if (entry.path().extension() == ".md") all.push_back(entry.path().stem().string());
    std::sort(all.begin(), all.end());
    if (all.empty()) throw Error({source_folder()}, "there are no decks here");
    if (asked.empty()) return all;
    for (const std::string& word : asked) {
        Words found;
        const auto number = parse_int(word);  // 1 means 01, not a part of 10
        const std::string part = number ? fmt::format("{:02}_", *number) : word;
        for (const std::string& name : all)
            if (("_" + name).find("_" + part) != std::string::npos) found.push_back(name);  // the beginning of a word
        if (found.empty()) throw UsageError(unknown("deck", word, all));
        if (found.size() > 1)
            throw UsageError(fmt::format("'{}' can be any of these decks: {}", word, join(found, ", ")));
        chosen.push_back(found.front());
    }
    return chosen;
}

/// Returns the last line of its error output, which names the error.
std::string last_words(const ProcessResult& done) {
    if (done.ending != Ending::exited) return name_of(done.ending);
    Words lines = split(done.errors, '\n');
    std::erase(lines, "");
    if (lines.empty()) return fmt::format("exit code {}", done.code);
    std::string said = lines.back();
    if (said.starts_with("relief: ")) said.erase(0, 8);
    return said;
}

/// One command of `relief`, and the files for its picture.
struct Drawing {
    Words command;
    std::vector<fs::path> files;
    std::string asked_by;  ///< deck and line of the first request
};

/// Returns the file with the words of a picture, to be laid over it.
fs::path words_of(const fs::path& picture) { return picture.string() + ".html"; }

/// Returns the error, or "" on success.
std::string draw(const Drawing& drawing, const fs::path& folder) {
    constexpr double patience = 1200;
    const fs::path& file = drawing.files.front();
    // Not the running program: a lab's own program knows only its lab.
    Words command = {(executable_folder() / "relief").string()};
    command.insert(command.end(), drawing.command.begin(), drawing.command.end());
    fs::path scratch;
    if (drawing.command.front() == "bench") {
        scratch = file.string() + ".bench";
        command.insert(command.end(), {"-o", scratch.string()});
    } else {
        command.insert(command.end(), {"-o", file.string(), "--words", words_of(file).string()});
    }
    const ProcessResult done = run_tool(command, folder, patience);
    const std::string problem = done.succeeded() ? "" : last_words(done);
    if (!scratch.empty()) {
        const fs::path plot = scratch / (drawing.command.at(1) + ".svg");
        const bool is_there = fs::exists(plot);
        if (is_there) fs::rename(plot, file);
        fs::remove_all(scratch);
        if (problem.empty() && !is_there) return "there is no plot: is gnuplot installed (Debian package gnuplot-nox)?";
    }
    if (!problem.empty()) return problem;
    for (size_t i = 1; i < drawing.files.size(); ++i) {
        fs::copy_file(file, drawing.files[i], fs::copy_options::overwrite_existing);
        if (scratch.empty())
            fs::copy_file(words_of(file), words_of(drawing.files[i]), fs::copy_options::overwrite_existing);
    }
    return {};
}

fs::path marp() {
    const fs::path program = course_root() / "build/marp/node_modules/.bin/marp";
    if (!fs::exists(program))
        throw Error("marp-cli is not installed: run the script ./relief slides at the course's top, which installs it");
    return program;
}

/// Returns a deck with the script of its drawings that move. The buttons below the slides become a landmark: Marp
/// leaves them outside of all landmarks.
std::string completed(std::string html) {
    const size_t end = html.rfind("</body>");
    if (end != std::string::npos && html.find(" data-moves=\"") != std::string::npos)
        html.insert(end, "<script>" + pages::page_file("drawings", ".js") + "</script>");
    constexpr std::string_view buttons = "<div class=\"bespoke-marp-osc\"";
    if (const size_t at = html.find(buttons); at != std::string::npos)
        html.insert(at + buttons.size(), " role=\"navigation\" aria-label=\"slides\"");
    return html;
}

void convert(const Words& decks, const fs::path& folder, bool as_pdf) {
    Words command = {marp().string(), "--no-stdin",
                     "--config-file", (source_folder() / "marp.yml").string(),
                     "--theme-set",   (source_folder() / "relief.css").string()};
    if (as_pdf) command.push_back("--pdf");
    command.push_back("--");
    for (const std::string& name : decks) command.push_back(name + ".md");
    if (const ProcessResult done = run_tool(command, folder, 1200); !done.succeeded())
        throw Error(fmt::format("marp-cli fails: {}", last_words(done)));
    for (const std::string& name : decks) {
        const fs::path made = folder / (name + (as_pdf ? ".pdf" : ".html"));
        if (!fs::exists(made)) throw Error({folder / (name + ".md")}, "marp-cli made no file from it");
        if (!as_pdf) write_file(made, completed(read_file(made)));
    }
}

/// Returns the folder for the decks. The gallery includes build/slides and may be published, so solutions go elsewhere.
fs::path folder_for(const SlidesArguments& arguments) {
    const fs::path usual = course_root() / "build" / (arguments.solutions ? "slides-with-solutions" : "slides");
    const fs::path folder = fs::absolute(arguments.output.empty() ? usual : fs::path(arguments.output));
    make_folder(folder);
    if (fs::equivalent(folder, source_folder()))
        throw UsageError("that folder holds the sources of the decks: name another folder");
    if (fs::exists(drawings_folder()))
        fs::copy(drawings_folder(), folder / "diagrams",
                 fs::copy_options::recursive | fs::copy_options::overwrite_existing);
    return folder;
}

struct NamedDeck {
    std::string name;
    slides::Deck deck;
};
std::vector<NamedDeck> read_decks(const Words& names, bool solutions) {
    std::vector<NamedDeck> decks;
    for (const std::string& name : names) {
        const fs::path file = source_folder() / (name + ".md");
        decks.push_back({name, slides::read_deck(read_file(file), file, name, solutions)});
    }
    return decks;
}

/// Returns the commands that draw the decks' figures, each once.
std::vector<Drawing> drawings_of(const std::vector<NamedDeck>& decks, const fs::path& folder) {
    std::vector<Drawing> drawings;
    std::map<Words, size_t> known;
    for (const auto& [name, deck] : decks) {
        const fs::path file = source_folder() / (name + ".md");
        if (!deck.figures.empty()) make_folder(folder / name);
        for (const slides::DeckFigure& figure : deck.figures) {
            const auto [place, is_new] = known.emplace(figure.command, drawings.size());
            if (is_new) drawings.push_back({figure.command, {}, fmt::format("{}:{}", shown(file), figure.line)});
            drawings[place->second].files.push_back(folder / figure.file);
        }
    }
    return drawings;
}

/// Writes the decks for Marp, with the words of their pictures, which have been drawn.
void write_decks(const std::vector<NamedDeck>& decks, const fs::path& folder) {
    for (const auto& [name, deck] : decks) {
        std::string text = deck.text;
        for (const slides::DeckFigure& figure : deck.figures) {
            const fs::path words = words_of(folder / figure.file);
            if (!fs::exists(words)) continue;
            if (figure.has_words) text = slides::with_words(text, figure.file, read_file(words));
            fs::remove(words);
        }
        write_file(folder / (name + ".md"), slides::with_moving_drawings(text, drawings_folder()));
    }
}

/// Returns whether all figures could be drawn. Prints an error for each failure.
bool draw_all(std::vector<Drawing> drawings, const fs::path& folder, Progress& progress) {
    Words problems(drawings.size());
    std::mutex mutex;
    const auto draw_one = [&](size_t i) {
        {
            const std::lock_guard lock(mutex);
            progress.next("relief " + join(drawings[i].command, " "));
        }
        problems[i] = draw(drawings[i], folder);
    };
    // Plots measure time, so they run alone, before the pictures.
    const auto pictures = std::stable_partition(drawings.begin(), drawings.end(),
                                                [](const Drawing& one) { return one.command.front() == "bench"; });
    const size_t plots = size_t(pictures - drawings.begin());
    for (size_t i = 0; i < plots; ++i) draw_one(i);
    parallel_each(drawings.size() - plots, 0, [&](size_t i) { draw_one(plots + i); });
    for (size_t i = 0; i < drawings.size(); ++i)
        if (!problems[i].empty())
            print_error(
                fmt::format("{}: relief {}: {}", drawings[i].asked_by, join(drawings[i].command, " "), problems[i]));
    return std::all_of(problems.begin(), problems.end(), [](const std::string& one) { return one.empty(); });
}

/// Returns 1 if a figure of a deck cannot be drawn.
int make_slides(const SlidesArguments& arguments) {
    const Words names = decks_asked_for(arguments.decks);
    marp();  // checks that Marp exists before pictures are drawn
    const fs::path folder = folder_for(arguments);
    const std::vector<NamedDeck> decks = read_decks(names, arguments.solutions);
    const std::vector<Drawing> drawings = drawings_of(decks, folder);
    {
        Progress progress(int(drawings.size()) + 1 + !arguments.no_pdf);
        if (!draw_all(drawings, folder, progress)) return 1;
        write_decks(decks, folder);
        progress.next("slides as HTML");
        convert(names, folder, false);
        if (!arguments.no_pdf) {
            progress.next("slides as PDF");
            convert(names, folder, true);
        }
    }
    for (const std::string& name : names) {
        fs::remove(folder / (name + ".md"));
        fmt::print("{}\n", (folder / (name + ".html")).lexically_normal().string());
        if (!arguments.no_pdf) fmt::print("{}\n", (folder / (name + ".pdf")).lexically_normal().string());
    }
    return 0;
}

class SlidesCommand final : public Command {
public:
    void options(CommandOptions& options) override {
        options.words("DECK", slides_.decks, "a number, a name or the beginning of a word in one [all]");
        options.value("-o", "FOLDER", slides_.output,
                      "folder for the decks [the course's build/slides, or build/slides-with-solutions]");
        options.flag("--solutions", slides_.solutions, "add the slides that show the tasks' solutions");
        options.flag("--no-pdf", slides_.no_pdf, "make HTML only, which needs no browser");
    }
    int run() override { return make_slides(slides_); }

private:
    SlidesArguments slides_;
};
RELIEF_COMMAND(SlidesCommand, 14, "slides", "makes the slides: a deck for each lab, as HTML and PDF");

}  // namespace

}  // namespace relief::app
