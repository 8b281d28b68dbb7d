#include "framework/pages/lab_page.h"

#include <fmt/format.h>

#include "framework/pages/figures.h"
#include "framework/pages/page.h"

namespace relief {
namespace {

constexpr const char* style = R"(
main.lab { display: grid; grid-template-columns: minmax(0, 2.2fr) minmax(0, 1fr); gap: 32px; align-items: start; }
main.lab > * { min-width: 0; }
h2 { font-size: 24px; margin: 0 0 10px; }
.stage, .facts section { background: var(--card); border: 1px solid var(--line); border-radius: 12px; padding: 16px 18px; }
.stage[hidden] { display: none; }
.choose { display: flex; flex-wrap: wrap; gap: 10px 22px; margin: 0 0 12px; align-items: end; }
.choose label { font-size: 14px; color: var(--quiet); }
.choose > label { flex: 1 1 210px; min-width: 0; }
select { background: var(--ground); }
fieldset { border: 0; padding: 0; margin: 0; display: flex; gap: 16px; min-height: 38px; align-items: center; }
legend { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); }
fieldset label { color: var(--text); font-size: 16px; display: flex; gap: 6px; align-items: center; }
input[type=radio] { width: 18px; height: 18px; margin: 0; accent-color: var(--accent); }
.stage .wipe { margin: 8px 0 0; }
.sides { display: flex; justify-content: space-between; gap: 16px; margin: 6px 0 0; font-size: 15px; }
.sides span:last-child { text-align: right; }
.methods { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 220px), 1fr)); gap: 18px; margin: 0 0 20px; }
.methods.mapped { grid-template-columns: repeat(auto-fill, minmax(min(100%, 340px), 1fr)); }
figure { margin: 0; break-inside: avoid; }
figure div { display: flex; gap: 4px; } figure div img { flex: 1; min-width: 0; width: 100%; }
figure img, .hero { display: block; width: 100%; height: auto; border-radius: 6px; }
figcaption { font-size: 15px; margin-top: 5px; color: var(--quiet); } figcaption b { color: var(--text); }
.facts { display: grid; gap: 18px; }
.facts ul { margin: 0; padding-left: 20px; } .facts li { margin: 0 0 6px; }
.facts table { border-collapse: collapse; width: 100%; margin: 0 0 14px; font-size: 15px; }
.facts td, .facts th { text-align: left; vertical-align: top; padding: 6px 10px 6px 0; border-bottom: 1px solid var(--line); }
.facts th { color: var(--quiet); font-weight: 600; }
.facts :is(td, th):last-child { text-align: right; padding-right: 0; font-variant-numeric: tabular-nums; }
.facts p { margin: 0 0 8px; } .quiet { color: var(--quiet); }
.all { grid-column: 1 / -1; }
@media (max-width: 900px) { main.lab { grid-template-columns: minmax(0, 1fr); } }
@media (max-width: 600px) { .stage, .facts section { padding: 12px; } }
@media print { .stage { display: none; } main.lab { display: block; } .facts { margin-bottom: 18px; } .methods { grid-template-columns: 1fr 1fr 1fr; } .methods.mapped { grid-template-columns: 1fr 1fr; } .facts section { border: 0; padding: 0; } }
)";

// What the two boxes say is laid on each other. Without it all pictures lie side by side below.
constexpr const char* script = R"(
const stage = document.querySelector(".stage");
if (stage) {
  const methods = [...document.querySelectorAll(".methods figure")], [left, right] = stage.querySelectorAll("select");
  const map = stage.querySelector("[value=map]"), scale = stage.querySelector(".scale");
  const sides = stage.querySelectorAll(".sides span"), under = stage.querySelector("img"), over = under.cloneNode();
  const {label, slide} = wipe(under, over, "wipe", "wipe from the left method to the right", 50, value => `${value} % ${left.value}`);
  stage.querySelector(".laid").after(label);
  const lay = (image, side, box) => {
    const method = methods[box.selectedIndex], source = method.querySelector(map?.checked ? ".map" : ".picture");
    image.src = source.src;
    image.alt = source.alt;
    side.textContent = box.selectedOptions[0].textContent;
  };
  const show = () => {
    lay(over, sides[0], left);
    lay(under, sides[1], right);
    if (scale) scale.hidden = !map.checked;
    slide();
  };
  stage.addEventListener("change", show);
  stage.hidden = false;
  show();
}
)";

class Writer {
public:
    explicit Writer(const LabPage& page) : page_(page), manifest_(*page.manifest) {}

    std::string body() const {
        return header() + "<main class=\"lab\">\n" + (page_.methods.empty() ? hero() : stage()) + facts() + all() +
               "</main>\n" + footer();
    }

private:
    std::string header() const {
        return fmt::format(
            "<header><p class=\"up\"><a href=\"index.html\"><span aria-hidden=\"true\">←</span> All labs</a></p>\n"
            "<h1><span class=\"number\">{}</span> {}</h1>\n{}</header>\n",
            page_.lab->two_digits(), html(manifest_.title),
            link_row({{"Handout", page_.handout},
                      {"Slides", page_.slides},
                      {"Slides as PDF", page_.slides_to_print},
                      {"Run time against error", page_.bench}}));
    }

    std::string hero() const {
        return fmt::format(
            "<img class=\"hero\" src=\"{}\" alt=\"The picture that the lab opens with\" width=\"800\" "
            "height=\"450\">\n",
            html(page_.picture));
    }

    static std::string said(const LabPage::Method& method) {
        return html(method.name) + (method.error.empty() ? "" : ": " + html(method.error));
    }

    static std::string image(const std::string& kind, const std::string& file, glm::ivec2 size,
                             const std::string& alt) {
        return fmt::format(R"(<img class="{}" src="{}" width="{}" height="{}" alt="{}" loading="lazy">)", kind,
                           html(file), size.x, size.y, html(alt));
    }

    bool has_maps() const { return !page_.methods.empty() && !page_.methods.front().error_map.empty(); }

    std::string stage() const {
        const auto box = [&](const char* name, size_t chosen) {
            std::string options;
            for (size_t i = 0; i < page_.methods.size(); ++i)
                options += fmt::format("<option value=\"{}\"{}>{}</option>", html(page_.methods[i].name),
                                       i == chosen ? " selected" : "", said(page_.methods[i]));
            return fmt::format("<label>{}<select autocomplete=\"off\">{}</select></label>\n", name, options);
        };
        const std::string maps =
            R"(<fieldset><legend>shown</legend><label><input type="radio" name="shown" value="picture" checked autocomplete="off">picture</label><label><input type="radio" name="shown" value="map" autocomplete="off">error map</label></fieldset>
)";
        std::string scale = error_scale(page_.marks);
        scale.insert(scale.find("aria-hidden"), "hidden ");
        return fmt::format(
            R"(<section aria-labelledby="methods"><h2 id="methods">Methods compared</h2>
<p class="quiet">One view by each value of the knob <code>{}</code>.{}</p>
<div class="stage" hidden><div class="choose">
{}{}{}</div>
<img src="{}" width="{}" height="{}" alt="">
<p class="sides"><span></span><span></span></p>
{}</div></section>
)",
            html(page_.knob),
            has_maps()
                ? " Beside each: the mean error of its “" + html(page_.probe) + "”, compared with the exact value."
                : "",
            box("left", 0), box("right", page_.methods.size() - 1), has_maps() ? maps : "",
            html(page_.methods.back().picture), page_.size.x, page_.size.y, has_maps() ? scale : "");
    }

    std::string all() const {
        if (page_.methods.empty()) return {};
        std::string figures;
        for (const LabPage::Method& method : page_.methods) {
            figures +=
                "<figure><div>" + image("picture", method.picture, page_.size, manifest_.title + ", " + method.name);
            if (!method.error_map.empty())
                figures +=
                    image("map", method.error_map, page_.map_size, "error of " + method.name + ": " + method.error);
            figures += fmt::format("</div><figcaption><b>{}</b> {}</figcaption></figure>\n", html(method.name),
                                   html(method.error));
        }
        return fmt::format(
            "<section class=\"all\" aria-labelledby=\"all\"><h2 id=\"all\">Side by side</h2>\n<div "
            "class=\"methods{}\">\n"
            "{}</div>{}</section>\n",
            has_maps() ? " mapped" : "", figures, has_maps() ? error_scale(page_.marks) : "");
    }

    std::string facts() const {
        std::string learns, tasks;
        for (const std::string& line : manifest_.learns) learns += "<li>" + html(line) + "</li>";
        for (const TaskInfo& task : manifest_.tasks)
            tasks += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td></tr>\n", html(task.id), html(task.title),
                                 task.points);
        std::string text = "<div class=\"facts\">";
        if (!learns.empty())
            text += "<section aria-labelledby=\"learns\"><h2 id=\"learns\">You learn</h2><ul>" + learns +
                    "</ul></section>\n";
        const std::string number = page_.lab->two_digits();
        if (!tasks.empty())
            text += fmt::format(
                "<section aria-labelledby=\"tasks\"><h2 id=\"tasks\">You write</h2>\n<table><thead><tr><th "
                "scope=\"col\">task</th><th scope=\"col\">what</th><th scope=\"col\">points</th></tr></thead><tbody>\n"
                "{}<tr><td></td><td class=\"quiet\">total</td><td>{}</td></tr></tbody></table>\n"
                "<p class=\"quiet\">To check your work:</p><p><code>./relief check {}</code></p></section>\n",
                tasks, manifest_.points(), number);
        text += fmt::format(
            "<section aria-labelledby=\"try\"><h2 id=\"try\">You try</h2>\n<p class=\"quiet\">To open the lab in a "
            "window, "
            "with its "
            "knobs and its error map:</p><p><code>./relief run {0}</code></p>\n<p class=\"quiet\">To draw one "
            "picture:</p><p>"
            "<code>./relief shot {0}{1}</code></p></section>\n",
            number, page_.methods.empty() ? "" : " --set " + html(page_.knob) + "=" + html(page_.methods.back().name));
        return text + "</div>\n";
    }

    std::string footer() const {
        const auto link = [](const LabPage* to, const char* before, const char* after) {
            return to ? fmt::format("<a href=\"{}\">{}{} {}{}</a>", lab_page_file(*to->lab), before,
                                    to->lab->two_digits(), html(to->manifest->title), after)
                      : std::string("<span></span>");
        };
        return "<footer><nav class=\"turn\" aria-label=\"neighbours\">" +
               link(page_.previous, "<span aria-hidden=\"true\">←</span> ", "") +
               link(page_.next, "", " <span aria-hidden=\"true\">→</span>") + "</nav></footer>\n";
    }

    const LabPage& page_;
    const Manifest& manifest_;
};

}  // namespace

std::string link_row(const std::vector<std::pair<std::string, std::string>>& links) {
    std::string items;
    for (const auto& [name, place] : links)
        if (!place.empty()) items += fmt::format("<li><a href=\"{}\">{}</a></li>", html(place), html(name));
    return items.empty() ? "" : "<ul class=\"links\">" + items + "</ul>\n";
}

const char* const site_style = R"(
header .up { margin: 0 0 18px; }
.links { list-style: none; display: flex; flex-wrap: wrap; gap: 8px; padding: 0; margin: 14px 0 0; }
.links a { display: block; background: var(--card); border: 1px solid var(--line); border-radius: 8px; padding: 6px 14px; color: var(--text); text-decoration: none; }
.links a:hover { border-color: var(--accent); }
.turn { display: flex; flex-wrap: wrap; justify-content: space-between; gap: 8px 24px; border-top: 1px solid var(--line); padding-top: 20px; font-size: 16px; }
@media (max-width: 600px) { h1 { font-size: 34px; } header { padding-top: 28px; } header, main, footer { padding-left: 16px; padding-right: 16px; } }
@media print { .links, .up, .turn { display: none; } }
)";

std::string lab_page_file(const LabEntry& lab) { return lab.folder + ".html"; }

std::string lab_page(const LabPage& page) {
    const std::string title = "Lab " + page.lab->two_digits() + ": " + page.manifest->title;
    return closed_page(title, figures_style() + site_style + style, Writer(page).body(),
                       page.methods.empty() ? "" : wipe_function + std::string(script), PagePictures::beside);
}

}  // namespace relief
