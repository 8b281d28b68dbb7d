// relief mistakes: makes a page of all known mistakes, each with the picture that shows it best and the correct one; or
// the fingerprints by which `relief check` names them.
#include <fmt/format.h>

#include "framework/app/shot.h"
#include "framework/base/error.h"
#include "framework/base/file.h"
#include "framework/base/log.h"
#include "framework/base/paths.h"
#include "framework/image/file.h"
#include "framework/pages/check_figures.h"
#include "framework/pages/figures.h"
#include "framework/pages/page.h"
#include "framework/staff/grade/fingerprint_maker.h"

namespace relief {
namespace {

namespace fs = std::filesystem;

/// The longer side of a picture, in pixels: two of them fill a line of the page.
constexpr int large = 480;

class MistakesPage {
public:
    explicit MistakesPage(fs::path folder) : folder_(std::move(folder)) {}
    int failures() const { return failures_; }

    void add(const LabEntry& lab, MistakePictures& pictures, Progress& progress) {
        const Manifest& manifest = pictures.manifest();
        List tasks;
        size_t total = 0;
        for (const TaskInfo& task : manifest.tasks) {
            List mistakes;
            for (const MistakeInfo& mistake : manifest.mistakes) {
                if (mistake.task != task.id) continue;
                progress.next(lab.two_digits() + " " + mistake.id);
                mistakes.push_back(shown(lab, pictures, mistake));
                mistakes.back().fields["place"] = lab.two_digits() + "-" + mistake.id;
                total += 1;
            }
            tasks.push_back(Fields{{"id", task.id}, {"title", task.title}, {"mistakes", std::move(mistakes)}});
        }
        labs_.push_back(Fields{
            {"number", lab.two_digits()}, {"title", manifest.title}, {"total", total}, {"tasks", std::move(tasks)}});
    }

    std::string finish() const {
        return render({.title = "Relief: known mistakes",
                       .body = "framework/staff/pages/mistakes",
                       .styles = {"badge", "checks", "figures", "framework/staff/pages/mistakes"},
                       .scripts = {"wipe", "checks", "framework/staff/pages/mistakes"},
                       .pictures = PagePictures::beside},
                      {{"count", count_}, {"labs", labs_}, {"driver", describe_context().driver()}});
    }

private:
    Fields shown(const LabEntry& lab, MistakePictures& pictures, const MistakeInfo& mistake) {
        ++count_;
        Fields fields = described(pictures.manifest(), mistake);
        try {
            const MistakePicture picture = pictures.best(mistake);
            fields["words"] = mistake.id + " " + mistake.hint + " " + mistake.task + " " + picture.check->name;
            fields["check"] = picture.check->name;
            fields["badge"] = badge(picture.said.outcome);
            fields["found"] = picture.said.found;
            List shown = figures(lab, pictures.manifest(), mistake, picture);
            List difference;
            if (!shown.empty() && shown.back().fields.at("kind").text == "difference") {
                difference.push_back(std::move(shown.back()));
                shown.pop_back();
            }
            fields["figures"] = std::move(shown), fields["difference"] = std::move(difference);
        } catch (const CannotWrite&) {
            throw;
        } catch (const Error& error) {
            print_error(fmt::format("{}: {}: {}", lab.folder, mistake.id, error.what()));
            fields["problem"] = error.what();
            ++failures_;
        }
        return fields;
    }

    /// Everything but the pictures.
    static Fields described(const Manifest& manifest, const MistakeInfo& mistake) {
        List others, edits;
        for (const MistakeInfo& other : manifest.mistakes)
            if (other.same_as == mistake.id) others.push_back(Fields{{"id", other.id}, {"is_first", others.empty()}});
        for (const Edit& edit : mistake.edits)
            edits.push_back(Fields{{"file", edit.file},
                                   {"find", edit.find},
                                   {"replace", edit.replace.empty() ? "(nothing)" : edit.replace}});
        return {{"id", mistake.id},
                {"words", mistake.id + " " + mistake.hint + " " + mistake.task},
                {"hint", with_code(mistake.hint)},
                {"problem", ""},
                {"same_as", mistake.same_as},
                {"others", mistake.same_as.empty() ? rows(std::move(others)) : Value()},
                {"edits", std::move(edits)}};
    }

    List figures(const LabEntry& lab, const Manifest& manifest, const MistakeInfo& mistake,
                 const MistakePicture& picture) const {
        const CheckInfo& check = *picture.check;
        const ComparedImages shown = compare_images(picture.is_probe ? &manifest.probe(check.shot.probe.name) : nullptr,
                                                    picture.wrong, picture.right);
        const std::string what = picture.is_probe ? ", “" + check.shot.probe.name + "” as colours" : "";
        const std::string number = fmt::format("{}", &mistake - manifest.mistakes.data());
        // Mistakes that are shown by one check share its right picture, unless its colours are chosen for both.
        const std::string right =
            picture.is_probe ? number + "-right" : fmt::format("check-{}", &check - manifest.checks.data());
        List all;
        const auto add = [&](const std::string& name, const Image& image, const char* kind, const std::string& caption,
                             const std::string& alt, Value scale = {}) {
            if (image.pixel_count() == 0) return;
            const std::string file = lab.folder + "/" + name + ".png";
            write_beside_page(folder_ / file, encode_image(image, ImageFormat::png));
            all.push_back(figure(image, file, kind, caption, check.name + alt, std::move(scale)));
        };
        add(number, shown.drawn, "mine", "with the mistake" + what, ", with the mistake");
        add(right, shown.expected, "expected", "right", ", as it should be");
        add(number + "-difference", shown.difference, "difference", "where they differ",
            ", where they differ: " + shown.differs, shown.scale);
        return all;
    }

    fs::path folder_;
    List labs_;
    int count_ = 0, failures_ = 0;
};

/// That lab, or all if `lab` is empty, where there are known mistakes; and how many there are.
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

/// Writes a page of the known mistakes of one lab, or of all if `lab` is empty, to `folder`, or to the course's build
/// folder if that is empty. Returns 1 if one of them has no picture.
int show_mistakes(const std::string& lab, fs::path folder, ContextChoice choice) {
    if (folder.empty()) folder = course_root() / "build" / "mistakes";
    const auto [labs, count] = with_mistakes(lab);
    make_folder(folder);
    const auto context = open_context(choice);
    MistakesPage page(folder);
    {
        Progress progress(count);
        for (const LabEntry* entry : labs) {
            MistakePictures pictures(*entry, {.context = choice, .threads = 0, .pinned = is_pinned()}, large);
            page.add(*entry, pictures, progress);
        }
    }
    write_file(folder / "index.html", page.finish());
    fmt::print("{}\n", fs::absolute(folder / "index.html").lexically_normal().string());
    return page.failures() == 0 ? 0 : 1;
}

/// Writes the file by which `relief check` names mistakes, of one lab, or of all if `lab` is empty.
int renew_fingerprints(const std::string& lab, ContextChoice choice) {
    const auto [labs, count] = with_mistakes(lab);
    pin_software_renderer();
    const auto context = open_context(choice);
    if (!is_software_renderer())
        throw Error("fingerprints are made on Mesa's software renderer, as checks are drawn; this is " +
                    describe_context().renderer);
    Progress progress(count);
    for (const LabEntry* entry : labs) {
        MistakePictures pictures(*entry, {.context = choice, .threads = 0, .pinned = true});
        const Fingerprints made = make_fingerprints(
            *entry, pictures, [&](const std::string& id) { progress.next(entry->two_digits() + " " + id); });
        const fs::path file = fingerprints_file(*entry);
        const std::string text = text_of(made, *entry, pictures.manifest());
        const bool is_same = fs::exists(file) && read_file(file) == text;
        if (!is_same) write_file(file, text);
        fmt::print("{}: {}\n", shown(file), is_same ? "the same" : "renewed");
    }
    return 0;
}

class MistakesCommand final : public Command {
public:
    void options(CommandOptions& options) override {
        options.lab(lab_, false);
        options.value("-o", "FOLDER", output_, "folder for the page [the course's build/mistakes]");
        options.flag("--update", update_,
                     "no page: renew the files by which everybody's `relief check` names mistakes");
        options.value("--context", "NAME", context_, context_help);
    }
    int run() override {
        if (update_ && !output_.empty()) throw UsageError("--update writes into the labs' folders: leave out -o");
        const ContextChoice choice = context_kind(context_);
        return update_ ? renew_fingerprints(lab_, choice) : show_mistakes(lab_, output_, choice);
    }

private:
    std::string lab_, output_, context_ = "auto";
    bool update_ = false;
};
RELIEF_COMMAND(MistakesCommand, 14, "mistakes", "makes a page of all known mistakes, each beside the correct picture");

Image picture_with_mistake(const LabEntry& entry, const std::string& id, const Shot& shot, bool light,
                           ContextChoice choice) {
    MistakePictures pictures(entry, {.context = choice, .pinned = is_pinned()});
    DrawnAttempt drawn = std::move(pictures.draw(pictures.manifest().mistake(id), {shot}, light).front());
    if (!drawn.image) throw Error(fmt::format("with the mistake '{}': {}", id, drawn.error));
    refuse_unusable(*drawn.image, shot);
    return *std::move(drawn.image);
}
const decltype(draw_with_mistake)::Provided for_shot(draw_with_mistake, picture_with_mistake);

}  // namespace

}  // namespace relief
