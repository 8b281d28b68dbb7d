// relief mistakes: a page of all known mistakes, each with the picture that shows it best beside the right one. For
// staff.
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
#include "framework/staff/grade/mistake_pictures.h"

namespace relief {
namespace {

namespace fs = std::filesystem;

constexpr const char* mistakes_style = R"(
.filter { position: sticky; top: 0; z-index: 1; display: flex; flex-wrap: wrap; gap: 10px 18px; align-items: end; background: var(--ground); padding: 12px 0; margin: 0 0 12px; border-bottom: 1px solid var(--line); }
.filter[hidden] { display: none; }
.filter label { flex: 1 1 200px; max-width: 420px; font-size: 14px; color: var(--quiet); }
.filter output { color: var(--quiet); padding-bottom: 8px; }
section { margin: 0 0 40px; } h2 { font-size: 28px; } h3 { font-size: 20px; margin: 22px 0 12px; }
h3 .number { color: var(--accent); margin-right: 6px; }
.mistakes { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 520px), 1fr)); gap: 20px; }
article { background: var(--card); border: 1px solid var(--line); border-radius: 12px; padding: 16px 18px; break-inside: avoid; min-width: 0; }
article h4 { font-size: 17px; margin: 0 0 4px; } article h4 code { font-size: 16px; overflow-wrap: anywhere; }
article p { margin: 0 0 10px; } article .pictures { grid-template-columns: repeat(auto-fill, minmax(min(100%, 150px), 1fr)); gap: 12px; } article figcaption { font-size: 14px; } article .scale { font-size: 12px; }
article dl { display: grid; grid-template-columns: max-content 1fr; gap: 4px 14px; margin: 0 0 8px; font-size: 15px; }
dt { color: var(--quiet); } dd { margin: 0; overflow-wrap: anywhere; }
details summary { cursor: pointer; color: var(--quiet); font-size: 15px; padding: 4px 0; }
pre { background: var(--code); border-radius: 8px; padding: 10px 12px; margin: 4px 0 8px; font-size: 13px; line-height: 1.4; white-space: pre-wrap; overflow-wrap: anywhere; }
.problem { color: var(--bad); }
[hidden] { display: none !important; }
@media (max-width: 600px) { article dl { grid-template-columns: 1fr; } h1 { font-size: 34px; } header { padding-top: 28px; } header, main, footer { padding-left: 14px; padding-right: 14px; } article { padding: 12px; } }
@media print { .filter, details { display: none; } .mistakes { grid-template-columns: 1fr; } article .pictures { grid-template-columns: repeat(3, 1fr); } h2, h3 { break-after: avoid; } }
)";

constexpr const char* filter_script = R"(
const filter = document.querySelector(".filter"), words = filter.querySelector("input"), lab = filter.querySelector("select");
const all = [...document.querySelectorAll("article")];
const show = () => {
  const wanted = words.value.toLowerCase().split(/\s+/);
  let count = 0;
  for (const one of all) {
    const text = one.dataset.words.toLowerCase();
    one.hidden = !wanted.every(word => text.includes(word)) || (lab.value && one.closest("section[data-lab]").dataset.lab != lab.value);
    count += !one.hidden;
  }
  for (const part of document.querySelectorAll("main section"))
    part.hidden = ![...part.querySelectorAll("article")].some(one => !one.hidden);
  filter.querySelector("output").textContent = `${count} of ${all.length} shown`;
};
words.addEventListener("input", show);
lab.addEventListener("change", show);
filter.hidden = false;
show();
)";

class MistakesPage {
public:
    explicit MistakesPage(fs::path folder) : folder_(std::move(folder)) {}
    int failures() const { return failures_; }

    void add(const LabEntry& lab, MistakePictures& pictures, Progress& progress) {
        const Manifest& manifest = pictures.manifest();
        labs_ += fmt::format("<option value=\"{0}\">{0} {1}</option>", lab.two_digits(), html(manifest.title));
        text_ += fmt::format(
            "<section data-lab=\"{0}\" aria-labelledby=\"lab-{0}\"><h2 id=\"lab-{0}\"><span "
            "class=\"number\">{0}</span> {1}</h2>\n",
            lab.two_digits(), html(manifest.title));
        for (const TaskInfo& task : manifest.tasks) {
            text_ += fmt::format("<section><h3><span class=\"number\">{}</span>{}</h3>\n<div class=\"mistakes\">\n",
                                 html(task.id), html(task.title));
            for (const MistakeInfo& mistake : manifest.mistakes) {
                if (mistake.task != task.id) continue;
                progress.next(lab.two_digits() + " " + mistake.id);
                add(lab, pictures, mistake);
            }
            text_ += "</div></section>\n";
        }
        text_ += "</section>\n";
    }

    std::string finish() const {
        const std::string body = fmt::format(
            R"(<header><h1>Known mistakes</h1>
<p>The grader’s legend: <code>mistake</code> in <code>results.json</code>, and on the pages of <code>relief grade</code>, is
one of these {} ids, told when a submission draws what it draws. Each is shown by the check of its task that makes it most
visible. Not for students: the edits give solutions away.</p></header>
<main><div class="filter" hidden><label>words in id, hint, task or check<input type="search" autocomplete="off"></label>
<label>lab<select autocomplete="off"><option value="">all</option>{}</select></label><output></output></div>
{}</main>
<footer>Made by <code>./relief mistakes</code>; drawn by {}.</footer>
)",
            count_, labs_, text_, html(describe_context().driver()));
        return closed_page("Relief: known mistakes", check_style() + mistakes_style, body,
                           check_script() + filter_script, PagePictures::beside);
    }

private:
    void add(const LabEntry& lab, MistakePictures& pictures, const MistakeInfo& mistake) {
        ++count_;
        std::string shown, words = mistake.id + " " + mistake.hint + " " + mistake.task;
        try {
            const MistakePicture picture = pictures.best(mistake);
            words += " " + picture.check->name;
            shown = figures(lab, pictures.manifest(), mistake, picture);
        } catch (const CannotWrite&) {
            throw;
        } catch (const Error& error) {
            print_error(fmt::format("{}: {}: {}", lab.folder, mistake.id, error.what()));
            shown = "<p class=\"problem\">No picture: " + html(error.what()) + "</p>\n";
            ++failures_;
        }
        text_ += fmt::format("<article data-words=\"{}\"><h4><code>{}</code></h4>\n<p>{}</p>\n{}{}{}</article>\n",
                             html(words), html(mistake.id), html_with_code(mistake.hint), shown,
                             same(pictures.manifest(), mistake), edits(mistake));
    }

    /// `more`: what stands below it, as HTML.
    std::string figure(const std::string& file, const Image& image, const char* kind, const std::string& caption,
                       const std::string& alt, const std::string& more = {}) const {
        if (image.pixel_count() == 0) return {};
        write_beside_page(folder_ / file, encode_image(image, ImageFormat::png));
        return fmt::format(
            R"(<figure class="{}"><img src="{}" width="{}" height="{}" alt="{}" loading="lazy"><figcaption>{}</figcaption>{}</figure>
)",
            kind, html(file), image.width, image.height, html(alt), html(caption), more);
    }

    std::string figures(const LabEntry& lab, const Manifest& manifest, const MistakeInfo& mistake,
                        const MistakePicture& picture) const {
        const CheckInfo& check = *picture.check;
        const ComparedImages shown = compare_images(picture.is_probe ? &manifest.probe(check.shot.probe.name) : nullptr,
                                                    picture.wrong, picture.right);
        const std::string what = picture.is_probe ? ", “" + check.shot.probe.name + "” as colours" : "";
        const std::string number = fmt::format("{}", &mistake - manifest.mistakes.data());
        // Mistakes that are shown by one check share its right picture, unless its colours are chosen for both.
        const std::string right =
            picture.is_probe ? number + "-right" : fmt::format("check-{}", &check - manifest.checks.data());
        std::string text = fmt::format("<div class=\"pictures\" data-check=\"{}\">\n", html(mistake.id));
        text += figure(lab.folder + "/" + number + ".png", shown.drawn, "mine", "with the mistake" + what,
                       check.name + ", with the mistake");
        text += figure(lab.folder + "/" + right + ".png", shown.expected, "expected", "right",
                       check.name + ", as it should be");
        text += figure(lab.folder + "/" + number + "-difference.png", shown.difference, "difference",
                       "where they differ", check.name + ", where they differ: " + shown.differs, shown.scale);
        return text + fmt::format("</div>\n<dl><dt>check</dt><dd>{}</dd><dt>found</dt><dd>{}: {}</dd></dl>\n",
                                  html(check.name), outcome_badge(picture.said.outcome), html(picture.said.found));
    }

    static std::string same(const Manifest& manifest, const MistakeInfo& mistake) {
        if (!mistake.same_as.empty())
            return fmt::format(
                "<p class=\"quiet\">No check distinguishes it from <code>{}</code>: the grader names that one.</p>\n",
                html(mistake.same_as));
        std::string others;
        for (const MistakeInfo& other : manifest.mistakes)
            if (other.same_as == mistake.id)
                others += (others.empty() ? "" : ", ") + fmt::format("<code>{}</code>", html(other.id));
        return others.empty() ? ""
                              : "<p class=\"quiet\">Also stands for " + others + ": no check distinguishes them.</p>\n";
    }

    static std::string edits(const MistakeInfo& mistake) {
        std::string text = "<details><summary>The edit</summary>\n";
        for (const Edit& edit : mistake.edits)
            text += fmt::format(
                "<p class=\"quiet\">In <code>{}</code></p>\n<pre>{}</pre>\n<p "
                "class=\"quiet\">becomes</p>\n<pre>{}</pre>\n",
                html(edit.file), html(edit.find), edit.replace.empty() ? "(nothing)" : html(edit.replace));
        return text + "</details>\n";
    }

    fs::path folder_;
    std::string labs_, text_;
    int count_ = 0, failures_ = 0;
};

/// Writes a page of the known mistakes of one lab, or of all if `lab` is empty, to `folder`, or to the course's build
/// folder if that is empty. Returns 1 if one of them has no picture.
int show_mistakes(const std::string& lab, fs::path folder, ContextChoice choice) {
    if (folder.empty()) folder = course_root() / "build" / "mistakes";
    std::vector<const LabEntry*> labs;
    int count = 0;
    for (const LabEntry& entry : registry()) {
        if (!lab.empty() && &entry != &find_lab(lab)) continue;
        const int mistakes = int(load_manifest(entry).mistakes.size());
        if (mistakes > 0) labs.push_back(&entry);
        count += mistakes;
    }
    if (labs.empty()) throw UsageError("there are no known mistakes to show");
    make_folder(folder);
    const auto context = open_context(choice);
    MistakesPage page(folder);
    {
        Progress progress(count);
        for (const LabEntry* entry : labs) {
            MistakePictures pictures(*entry, {.context = choice, .threads = 0, .pinned = is_pinned()});
            page.add(*entry, pictures, progress);
        }
    }
    write_file(folder / "index.html", page.finish());
    fmt::print("{}\n", fs::absolute(folder / "index.html").lexically_normal().string());
    return page.failures() == 0 ? 0 : 1;
}

class MistakesCommand final : public Command {
public:
    void options(CommandOptions& options) override {
        options.lab(lab_, false);
        options.value("-o", "FOLDER", output_, "folder for the page [the course's build/mistakes]");
        options.value("--context", "NAME", context_, context_help);
    }
    int run() override { return show_mistakes(lab_, output_, context_kind(context_)); }

private:
    std::string lab_, output_, context_ = "auto";
};
RELIEF_COMMAND(MistakesCommand, 14, "mistakes", "makes a page of all known mistakes, each beside the right picture");

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
