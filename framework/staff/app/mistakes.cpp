// relief mistakes: makes a page of all known mistakes, each with its clearest picture and the correct one.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/log.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/core/image/file.h"
#include "framework/course/app/shot.h"
#include "framework/course/pages/check_figures.h"
#include "framework/course/pages/figures.h"
#include "framework/course/pages/page.h"
#include "framework/staff/app/quiz.h"
#include "framework/staff/app/share.h"
#include "framework/staff/grade/mistake_pictures.h"

namespace relief::app {
namespace {

namespace fs = std::filesystem;

/// The longer side of a picture, in pixels: enough for a large screen, where three pictures fill a line of the page.
constexpr int large = 480;

/// Draws a mistake's pictures and describes it: the contents of an article of the page.
class MistakeArticle {
public:
    MistakeArticle(const fs::path& folder, const LabEntry& lab, grade::MistakePictures& pictures,
                   const MistakeInfo& mistake)
        : folder_(folder), lab_(lab), pictures_(pictures), manifest_(pictures.manifest()), mistake_(mistake) {}

    /// The reason if no picture could be made. Valid after text().
    const std::string& problem() const { return problem_; }
    /// The picture with the mistake, relative to the page, and the words that find it. Valid after text().
    const std::string& picture() const { return picture_; }
    const std::string& words() const { return words_; }

    std::string text() {
        pages::Fields fields = described();
        words_ = mistake_.id + " " + mistake_.hint + " " + mistake_.task;
        try {
            const grade::MistakePicture picture = pictures_.best(mistake_);
            words_ += " " + picture.check->name;
            fields["check"] = picture.check->name;
            fields["badge"] = pages::badge(picture.said.outcome);
            fields["found"] = picture.said.found;
            pages::List shown = figures(picture);
            if (!shown.empty())
                picture_ = (clearest_ < shown.size() ? shown[clearest_] : shown.front()).fields.at("src").text;
            fields["figures"] = std::move(shown);
        } catch (const pages::CannotWrite&) {
            throw;
        } catch (const Error& error) {
            fields["problem"] = problem_ = error.what();
        }
        return pages::render("framework/staff/pages/mistake", fields);
    }

private:
    /// Returns all fields except the pictures.
    pages::Fields described() const {
        pages::List others, edits;
        for (const MistakeInfo& other : manifest_.mistakes)
            if (other.same_as == mistake_.id)
                others.push_back(pages::Fields{{"id", other.id}, {"is_first", others.empty()}});
        for (const Edit& edit : mistake_.edits)
            edits.push_back(pages::Fields{{"file", edit.file},
                                          {"find", edit.find},
                                          {"replace", edit.replace.empty() ? "(nothing)" : edit.replace}});
        return {{"id", mistake_.id},
                {"task", mistake_.task},
                {"hint", pages::with_code(mistake_.hint)},
                {"problem", ""},
                {"page", pages::Fields{{"pictures_inside", false}}},
                {"same_as", mistake_.same_as},
                {"others", mistake_.same_as.empty() ? pages::rows(std::move(others)) : pages::Value()},
                {"edits", std::move(edits)}};
    }

    pages::List figures(const grade::MistakePicture& picture) {
        const CheckInfo& check = *picture.check;
        const pages::ComparedImages shown = pages::compare_images(
            picture.is_probe ? &manifest_.probe(check.shot.probe.name) : nullptr, picture.wrong, picture.right);
        const std::string what = picture.is_probe     ? ", “" + check.shot.probe.name + "” as colours"
                                 : picture.screenshot ? ", in the screenshot “" + picture.screenshot->name + "”"
                                                      : "";
        const std::string number = fmt::format("{}", &mistake_ - manifest_.mistakes.data());
        // Mistakes shown by the same check share its correct picture, unless it is a probe: then its colour scale
        // depends on the mistake.
        const std::string right = picture.is_probe     ? number + "-right"
                                  : picture.screenshot ? "screenshot-" + picture.screenshot->name
                                                       : fmt::format("check-{}", &check - manifest_.checks.data());
        pages::List all;
        const auto add = [&](const std::string& name, const Image& image, const char* kind, const std::string& caption,
                             const std::string& alt, pages::Value scale = {}) {
            if (image.pixel_count() == 0) return;
            const std::string file = lab_.folder + "/" + name + ".png";
            pages::write_beside_page(folder_ / file, encode_image(image, ImageFormat::png));
            all.push_back(pages::figure(image, file, kind, caption, check.name + alt, std::move(scale)));
        };
        // A picture of one colour says nothing in the index: there the difference stands for it.
        const double contrast = grade::contrast_of(shown.drawn);
        clearest_ = contrast < grade::min_contrast && grade::contrast_of(shown.difference) > contrast ? 2 : 0;
        add(number, shown.drawn, "mine", "with the mistake" + what, ", with the mistake");
        add(right, shown.expected, "expected", "right", ", as it should be");
        add(number + "-difference", shown.difference, "difference", "where they differ",
            ", where they differ: " + shown.differs, shown.scale);
        return all;
    }

    const fs::path& folder_;
    const LabEntry& lab_;
    grade::MistakePictures& pictures_;
    const Manifest& manifest_;
    const MistakeInfo& mistake_;
    std::string problem_, picture_, words_;
    size_t clearest_ = 0;  ///< index of the figure that stands for the mistake
};

/// The mistakes of one task. One process draws them all, because they share the solution's pictures.
struct Part {
    const LabEntry* lab;
    std::string task;
    size_t work;  ///< rough estimate
};

/// Returns the parts lab by lab, in each lab the longest first.
std::vector<Part> parts_of(const std::vector<const LabEntry*>& labs) {
    std::vector<Part> parts;
    for (const LabEntry* lab : labs) {
        const Manifest manifest = load_manifest(*lab);
        const size_t first = parts.size();
        for (const TaskInfo& task : manifest.tasks) {
            const auto is_its = [&](const auto& one) { return one.task == task.id; };
            const auto count = std::count_if(manifest.mistakes.begin(), manifest.mistakes.end(), is_its) *
                               std::count_if(manifest.checks.begin(), manifest.checks.end(), is_its);
            if (count > 0) parts.push_back({lab, task.id, size_t(count)});
        }
        std::stable_sort(parts.begin() + std::ptrdiff_t(first), parts.end(),
                         [](const Part& a, const Part& b) { return a.work > b.work; });
    }
    return parts;
}

/// Messages from drawing processes: a drawn mistake, or the name of a mistake before it is drawn.
using nlohmann::json;

std::string text_of(const json& message) { return message.dump(-1, ' ', false, json::error_handler_t::replace); }

/// Draws mistakes in a child process.
void draw_parts(const std::vector<Part>& parts, const fs::path& folder, ContextChoice choice, const NextPart& next,
                const Say& say) {
    const auto context = open_context(choice);
    say(text_of({{"driver", describe_context().driver()}}));
    std::optional<grade::MistakePictures> pictures;
    const LabEntry* lab = nullptr;
    while (const auto place = next()) {
        const Part& part = parts[*place];
        if (part.lab != lab)
            pictures.emplace(*part.lab, check::Renderer{.context = choice, .threads = 0, .pinned = is_pinned()}, large);
        lab = part.lab;
        for (const MistakeInfo& mistake : pictures->manifest().mistakes) {
            if (mistake.task != part.task) continue;
            const std::string name = lab->two_digits() + " " + mistake.id;
            say(text_of({{"begins", name}}));
            MistakeArticle article(folder, *lab, *pictures, mistake);
            std::string text = article.text();
            say(text_of({{"drawn", name},
                         {"text", std::move(text)},
                         {"picture", article.picture()},
                         {"words", article.words()},
                         {"problem", article.problem()}}));
        }
    }
}

/// The drawn mistakes of a page.
struct Drawn {
    struct One {
        std::string article, picture, words;
    };
    std::map<std::string, One> mistakes;  ///< by lab and mistake: "10 towards-the-eye"
    std::string driver;
    int failures = 0;
};

Drawn draw_all(const std::vector<const LabEntry*>& labs, int count, const fs::path& folder, ContextChoice choice) {
    const std::vector<Part> parts = parts_of(labs);
    Drawn drawn;
    Progress progress(count);
    share_among_processes(
        parts.size(), [&](const NextPart& next, const Say& say) { draw_parts(parts, folder, choice, next, say); },
        [&](const std::string& text) {
            const json message = json::parse(text);
            if (message.contains("driver")) drawn.driver = message.at("driver");
            if (message.contains("begins")) progress.next(std::string(message.at("begins")));
            if (!message.contains("drawn")) return;
            const std::string name = message.at("drawn"), problem = message.at("problem");
            drawn.mistakes[name] = {message.at("text"), message.at("picture"), message.at("words")};
            if (problem.empty()) return;
            print_error(fmt::format("{}: {}", name, problem));
            ++drawn.failures;
        });
    return drawn;
}

/// Returns the demands of a task's text, with the calls that test them; nothing if there are none.
pages::Value demands_of(const Manifest& manifest, const std::string& task) {
    pages::List examples;
    for (const ExampleInfo& example : manifest.examples) {
        if (example.task != task || (example.hidden && example.edits.empty())) continue;
        pages::List calls;
        for (const ExampleInfo& one : manifest.examples)  // a hidden one may add calls to a public one
            if (one.task == task && one.asks == example.asks)
                for (const std::string& call : one.calls) calls.push_back(pages::Fields{{"call", call}});
        examples.push_back(pages::Fields{{"asks", example.asks}, {"calls", std::move(calls)}});
    }
    if (examples.empty()) return {};
    const bool is_one = examples.size() == 1;
    return pages::Fields{{"count", fmt::format("{} demand{}", examples.size(), is_one ? "" : "s")},
                         {"them", is_one ? "it" : "them"},
                         {"examples", std::move(examples)}};
}

std::string page_of(const std::vector<const LabEntry*>& labs, int count, const Drawn& drawn) {
    pages::List all, articles;
    for (const LabEntry* lab : labs) {
        const Manifest manifest = load_manifest(*lab);
        const size_t first = articles.size();
        pages::List tasks;
        for (const TaskInfo& task : manifest.tasks) {
            pages::List mistakes;
            for (const MistakeInfo& mistake : manifest.mistakes) {
                if (mistake.task != task.id) continue;
                const Drawn::One& one = drawn.mistakes.at(lab->two_digits() + " " + mistake.id);
                const std::string place = lab->two_digits() + "-" + mistake.id;
                mistakes.push_back(pages::Fields{{"id", mistake.id},
                                                 {"hint", without_backticks(mistake.hint)},
                                                 {"place", place},
                                                 {"picture", one.picture},
                                                 {"words", one.words}});
                articles.push_back(pages::Fields{
                    {"id", mistake.id},
                    {"place", place},
                    {"lab", lab->two_digits()},
                    {"task", task.id},
                    {"article", one.article},
                    {"previous",
                     articles.size() > first ? pages::Value(articles.back().fields.at("place")) : pages::Value()},
                    {"next", ""}});
                if (articles.size() > first + 1) articles[articles.size() - 2].fields["next"] = place;
            }
            tasks.push_back(pages::Fields{{"id", task.id},
                                          {"title", task.title},
                                          {"demands", demands_of(manifest, task.id)},
                                          {"mistakes", std::move(mistakes)}});
        }
        all.push_back(pages::Fields{{"number", lab->two_digits()},
                                    {"title", manifest.title},
                                    {"total", manifest.mistakes.size()},
                                    {"tasks", std::move(tasks)}});
    }
    return pages::render({.title = "Relief: known mistakes",
                          .body = "framework/staff/pages/mistakes",
                          .styles = {"badge", "checks", "figures", "framework/staff/pages/mistakes"},
                          .scripts = {"wipe", "checks", "framework/staff/pages/mistakes"},
                          .pictures = pages::PagePictures::beside},
                         {{"count", count},
                          {"one_lab", labs.size() == 1},
                          {"labs", std::move(all)},
                          {"articles", std::move(articles)},
                          {"driver", drawn.driver}});
}

/// Returns the labs with known mistakes, and the number of mistakes. Only that lab if `lab` is not empty.
std::pair<std::vector<const LabEntry*>, int> with_mistakes(const std::string& lab) {
    std::vector<const LabEntry*> labs;
    int count = 0;
    for (const LabEntry& entry : registry()) {
        if (!lab.empty() && &entry != &find_lab(lab)) continue;
        const int mistakes = int(load_manifest(entry).mistakes.size());
        if (mistakes > 0) labs.push_back(&entry);
        count += mistakes;
    }
    if (labs.empty()) throw UsageError("there are no known mistakes to show");
    return {labs, count};
}

/// Writes a page of the known mistakes of one lab, or of all if `lab` is empty. It goes to `folder`, or to the course's
/// build folder if that is empty. Returns 1 if one of them has no picture.
int show_mistakes(const std::string& lab, fs::path folder, ContextChoice choice) {
    if (folder.empty()) folder = course_root() / "build" / "mistakes";
    const auto [labs, count] = with_mistakes(lab);
    make_folder(folder);
    const Drawn drawn = draw_all(labs, count, folder, choice);
    write_file(folder / "index.html", page_of(labs, count, drawn));
    fmt::print("{}\n", fs::absolute(folder / "index.html").lexically_normal().string());
    return drawn.failures == 0 ? 0 : 1;
}

/// Writes a page of questions about the known mistakes of one lab, or of all if `lab` is empty. It goes to `folder`, or
/// to the course's build folder if that is empty.
int show_quiz(const std::string& lab, fs::path folder, ContextChoice choice) {
    if (folder.empty()) folder = course_root() / "build" / "quiz";
    make_folder(folder);
    write_quiz(with_mistakes(lab).first, folder, choice);
    fmt::print("{}\n", fs::absolute(folder / "index.html").lexically_normal().string());
    return 0;
}

class MistakesCommand final : public Command {
public:
    void options(CommandOptions& options) override {
        options.lab(lab_, false);
        options.flag("--quiz", is_quiz_, "for students, without edits: questions with pictures and four hints each");
        options.value("-o", "FOLDER", output_, "folder for the page [the course's build/mistakes, or build/quiz]");
        options.value("--context", "NAME", context_, context_help);
    }
    int run() override { return (is_quiz_ ? show_quiz : show_mistakes)(lab_, output_, context_kind(context_)); }

private:
    std::string lab_, output_, context_ = "auto";
    bool is_quiz_ = false;
};
RELIEF_COMMAND(MistakesCommand, 15, "mistakes", "makes a page of all known mistakes, each beside the correct picture");

Image picture_with_mistake(const LabEntry& entry, const std::string& id, const Shot& shot, bool light,
                           ContextChoice choice) {
    grade::MistakePictures pictures(entry, {.context = choice, .pinned = is_pinned()});
    grade::DrawnAttempt drawn = std::move(pictures.draw(pictures.manifest().mistake(id), {shot}, light).front());
    if (!drawn.image) throw Error(fmt::format("with the mistake '{}': {}", id, drawn.error));
    refuse_unusable(*drawn.image, shot);
    return *std::move(drawn.image);
}
const decltype(draw_with_mistake)::Provided for_shot(draw_with_mistake, picture_with_mistake);

}  // namespace

}  // namespace relief::app
