#include "framework/staff/pages/bench_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "framework/base/text.h"
#include "framework/pages/page.h"
#include "framework/staff/measure/plot.h"

namespace relief {
namespace {

constexpr const char* style = R"(
header, main, footer { max-width: 1400px; }
section { margin: 0 0 56px; }
nav ul { list-style: none; margin: 18px 0 0; padding: 0; display: flex; flex-wrap: wrap; gap: 8px; }
nav a { display: block; background: var(--card); border: 1px solid var(--line); border-radius: 8px; padding: 6px 12px;
  color: var(--text); text-decoration: none; }
nav a:hover { border-color: var(--accent); }
figure { margin: 18px 0; background: #fff; border: 1px solid var(--line); border-radius: 10px; padding: 8px; }
figure svg { display: block; width: 100%; height: auto; }
figure .point { cursor: pointer; }
figure .point:hover, figure .point.chosen { stroke: #23211d; stroke-width: 0.5; }
.quiet { color: var(--quiet); max-width: 52em; margin: 0 0 6px; }
h3 { font-size: 17px; margin: 26px 0 6px; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-size: 14px; font-variant-numeric: tabular-nums; background: var(--card);
  border: 1px solid var(--line); }
th, td { text-align: right; padding: 4px 8px; border-bottom: 1px solid var(--line); white-space: nowrap; }
th { color: var(--quiet); font-weight: 600; }
th:nth-child(1), td:nth-child(1), th:nth-child(2), td:nth-child(2), td.why { text-align: left; }
td.why { color: var(--bad); white-space: normal; }
tr.front td:first-child { color: var(--accent); font-weight: 700; }
tr.peer td:first-child { color: #2c7cc0; }
tr.chosen { outline: 2px solid var(--accent); outline-offset: -2px; }
tr[data-row] { cursor: pointer; }
td img { display: block; width: 36px; height: 36px; image-rendering: pixelated; border-radius: 4px; margin-left: auto; }
td.looks { padding: 2px 6px; }
td.looks img { display: inline-block; margin-left: 4px; }
#look { position: fixed; right: 20px; bottom: 20px; background: var(--card); border: 1px solid var(--line);
  border-radius: 12px; padding: 14px 16px; box-shadow: 0 8px 30px rgba(0,0,0,.25); max-width: min(600px, calc(100vw - 40px)); }
#look p { margin: 0 0 8px; font-size: 14px; }
#look .looks { display: flex; gap: 12px; }
#look .looks div { flex: 1; font-size: 13px; color: var(--quiet); }
#look img { display: block; width: 256px; max-width: 100%; image-rendering: pixelated; border-radius: 6px; }
#look button { position: absolute; top: 8px; right: 10px; border: 0; background: none; color: var(--text); font-size: 20px;
  cursor: pointer; }
#look[hidden] { display: none; }
@page { size: A4 landscape; margin: 12mm; }
@media print { #look, nav { display: none; } .wide { overflow: visible; } th, td { padding: 2px 6px; }
  header, main, footer { padding: 0; } section { break-before: page; } section:first-of-type { break-before: auto; }
  figure { border: 0; padding: 0; } figure svg { max-height: 118mm; } table { font-size: 7.5pt; } tr, figure { break-inside: avoid; } td img { width: 26px; height: 26px; } }
@media (max-width: 600px) { h1 { font-size: 32px; } #look { left: 10px; right: 10px; bottom: 10px; } }
)";

// A point and its row in the table are one: to rest on either, or to click it, shows its pictures. A click keeps them.
constexpr const char* script = R"(
const look = document.getElementById('look'), words = look.querySelector('p'), images = look.querySelector('.looks');
let kept = null;
function all(key) { return document.querySelectorAll('[data-key="' + key + '"]'); }
function show(key) {
  document.querySelectorAll('.chosen').forEach(e => e.classList.remove('chosen'));
  if (!key) { look.hidden = true; return; }
  all(key).forEach(e => e.classList.add('chosen'));
  const row = document.querySelector('tr[data-key="' + key + '"]');
  words.textContent = row.dataset.words;
  images.replaceChildren();
  row.querySelectorAll('img').forEach(image => {
    const box = document.createElement('div'), copy = document.createElement('img');
    copy.src = image.src; copy.alt = image.alt;
    box.append(copy, image.alt);
    images.append(box);
  });
  look.hidden = false;
}
function keep(key) { kept = kept === key ? null : key; show(kept || key); }
document.querySelectorAll('figure[data-topic]').forEach(figure => figure.querySelectorAll('.point').forEach(point => {
  point.dataset.key = figure.dataset.topic + '-' + point.dataset.row;
  point.addEventListener('mouseenter', () => show(point.dataset.key));
  point.addEventListener('mouseleave', () => show(kept));
}));
document.querySelectorAll('tr[data-key]').forEach(row => { row.tabIndex = 0; });
document.querySelectorAll('[data-key]').forEach(element => {
  element.addEventListener('click', () => keep(element.dataset.key));
  element.addEventListener('keydown', event => { if (event.key === 'Enter') keep(element.dataset.key); });
});
document.addEventListener('keydown', event => { if (event.key === 'Escape') { kept = null; show(null); } });
look.querySelector('button').addEventListener('click', () => { kept = null; show(null); });
)";

std::optional<double> work_of(const BenchRow& row, const std::string& name) {
    for (const auto& [work, value] : row.work)
        if (work == name) return value;
    return {};
}

std::string spaced(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

class TopicPart {
public:
    explicit TopicPart(const TopicResult& result) : result_(result) {
        double longest = 0;
        for (const BenchRow& row : result.rows) longest = std::max(longest, row.times.median);
        if (longest >= 1e6) scale_ = 1e-6, unit_ = "ms";
    }

    std::string text() const {
        const BenchTopic& topic = *result_.topic;
        const BenchMachine& machine = result_.machine;
        std::string text = fmt::format(
            "<section id=\"{0}\" aria-labelledby=\"{0}-title\"><h2 id=\"{0}-title\">{0}</h2>\n<p "
            "class=\"quiet\">{1}</p>\n"
            "<p class=\"quiet\">Drawn by {2} on {3}; time by the {4} clock; {5}, {6}. "
            "<a href=\"{0}.csv\">{0}.csv</a></p>\n",
            html(topic.name), html(topic.help), html(machine.renderer), html(machine.cpu), html(machine.clock),
            html(machine.compiler), html(machine.commit));
        // An SVG of its own has a first line that a page does not want.
        if (const size_t svg = result_.plot.find("<svg"); svg != std::string::npos)
            text += fmt::format("<figure data-topic=\"{}\">{}</figure>\n", html(topic.name), result_.plot.substr(svg));
        for (const std::vector<size_t>& scene : scenes_of(result_.rows)) text += table(scene);
        return text + "</section>\n";
    }

private:
    std::string table(const std::vector<size_t>& scene) const {
        const BenchRow& first = result_.rows[scene.front()];
        std::string unit = "", text;
        const std::string several = "in units of their own";
        std::vector<std::string> works;
        bool any_time = false, any_wrong = false, any_picture = false;
        for (const size_t place : scene) {
            const BenchRow& row = result_.rows[place];
            if (!row.error.unit.empty()) unit = unit.empty() || unit == row.error.unit ? row.error.unit : several;
            any_time |= row.repeats > 0, any_wrong |= row.error.wrong.has_value();
            for (const auto& [name, value] : row.work)
                if (std::find(works.begin(), works.end(), name) == works.end()) works.push_back(name);
            any_picture |= row.picture.width > 0 || row.error_map.width > 0;
        }
        if (!first.scene.empty()) text += "<h3>" + html(knob_text(first.scene)) + "</h3>\n";
        // What is the same for all is said once.
        std::string same;
        std::erase_if(works, [&](const std::string& name) {
            std::set<std::optional<double>> values;
            for (const size_t place : scene) values.insert(work_of(result_.rows[place], name));
            if (scene.size() < 2 || values.size() > 1) return false;
            same += fmt::format("{}{} {}", same.empty() ? "All: " : ", ", rounded(**values.begin()), spaced(name));
            return true;
        });
        if (!same.empty()) text += "<p class=\"quiet\">" + html(same) + "</p>\n";
        text += "<div class=\"wide\"><table><thead><tr><th>method</th><th>knobs</th>";
        if (any_time) text += fmt::format("<th>{} a {}</th><th>p10 to p90</th>", unit_, html(first.item));
        if (!unit.empty())
            text += fmt::format("<th>mean error, {}</th><th>p99</th><th>largest</th>",
                                html(unit == several ? unit : plural(unit)));
        if (any_wrong) text += "<th>wrong</th>";
        for (const std::string& name : works) text += "<th>" + html(spaced(name)) + "</th>";
        if (any_picture) text += "<th>pictures</th>";
        text += "</tr></thead><tbody>\n";
        const std::vector<size_t> front = front_of(result_.rows, scene);
        for (const size_t place : scene) {
            const BenchRow& row = result_.rows[place];
            const bool is_front = std::find(front.begin(), front.end(), place) != front.end();
            text += fmt::format(
                "<tr class=\"{}\" data-row=\"{}\" data-key=\"{}-{}\" data-words=\"{}\"><td>{}</td><td>{}</td>",
                is_front   ? "front"
                : row.peer ? "peer"
                           : "other",
                place, html(row.topic), place, html(words(row)), html(row.method), html(knob_text(row.knobs)));
            if (!row.is_measured()) {
                const int columns = 2 * any_time + 3 * !unit.empty() + any_wrong + int(works.size()) + any_picture;
                text += fmt::format("<td class=\"why\" colspan=\"{}\">{}</td></tr>\n", std::max(1, columns),
                                    html(row.state));
                continue;
            }
            const bool timed = row.repeats > 0, known = !row.error.unit.empty();
            const auto cell = [&](bool has, const std::string& value) {
                text += "<td>" + (has ? value : "") + "</td>";
            };
            if (any_time) {
                cell(timed, rounded(row.times.median * scale_));
                cell(timed, rounded(row.times.p10 * scale_) + " to " + rounded(row.times.p90 * scale_));
            }
            if (!unit.empty())
                for (const double value : {row.error.mean, row.error.p99, row.error.largest})
                    cell(known, html(amount_of(value, unit == several ? row.error.unit : "")));
            if (any_wrong) cell(row.error.wrong.has_value(), rounded(row.error.wrong.value_or(0) * 100) + " %");
            for (const std::string& name : works) {
                const std::optional<double> amount = work_of(row, name);
                cell(amount.has_value(), amount ? rounded(*amount) : "");
            }
            if (any_picture) text += "<td class=\"looks\">" + pictures(row) + "</td>";
            text += "</tr>\n";
        }
        return text + "</tbody></table></div>\n";
    }

    /// What stands over the pictures of a point.
    std::string words(const BenchRow& row) const {
        std::string text = row_name(row);
        if (row.repeats > 0) text += fmt::format(": {} {} a {}", rounded(row.times.median * scale_), unit_, row.item);
        if (!row.error.unit.empty()) text += ", mean error " + amount_of(row.error.mean, row.error.unit);
        if (row.error.wrong) text += fmt::format(", {} % wrong", rounded(*row.error.wrong * 100));
        return text;
    }

    static std::string pictures(const BenchRow& row) {
        std::string text;
        const std::string error = "error: black 0, pale " + amount_of(row.error_map_max, row.error.unit) + " and more";
        const std::pair<const Image*, std::string> all[] = {{&row.picture, "picture"}, {&row.error_map, error}};
        for (const auto& [image, name] : all)
            if (image->width > 0)
                text += fmt::format("<img alt=\"{}\" loading=\"lazy\" src=\"{}\">", html(name), picture_uri(*image));
        return text;
    }

    const TopicResult& result_;
    double scale_ = 1;
    const char* unit_ = "ns";
};

/// A topic's part of a page, by its name in HTML.
struct Section {
    std::string name, text;
};

/// Those of a page that bench_page() has made, in its order; what it has escaped cannot look like the marks of one.
std::vector<Section> sections_of(const std::string& page) {
    constexpr std::string_view opening = "<section id=\"", closing = "</section>\n";
    std::vector<Section> sections;
    for (size_t at = 0; (at = page.find(opening, at)) != std::string::npos;) {
        const size_t name = at + opening.size(), name_end = page.find('"', name), end = page.find(closing, at);
        if (end == std::string::npos) break;
        sections.push_back({page.substr(name, name_end - name), page.substr(at, end + closing.size() - at)});
        at = end;
    }
    return sections;
}

}  // namespace

std::string bench_page(std::span<const TopicResult> results, const std::string& before) {
    std::vector<Section> sections = sections_of(before);
    for (const TopicResult& result : results) {
        const std::string name = html(result.topic->name);
        const auto found =
            std::find_if(sections.begin(), sections.end(), [&](const Section& one) { return one.name == name; });
        Section& section = found == sections.end() ? sections.emplace_back() : *found;
        section = {name, TopicPart(result).text()};
    }
    std::string contents, parts;
    for (const Section& section : sections) {
        contents += fmt::format("<li><a href=\"#{0}\">{0}</a></li>", section.name);
        parts += section.text;
    }
    const std::string body = fmt::format(
        R"(<header><h1>Run time against error</h1>
<p>Every method has a price and an error. Each panel compares methods on one scene, timed in turns: down is right, left is
quick. Those that no other is better than stand on the line; the others are pale; what others do is blue. Rest on a point,
or on its line in the table, and its pictures appear; a click keeps them.</p>
<nav aria-label="topics"><ul>{}</ul></nav></header>
<main>
{}</main>
<aside id="look" aria-live="polite" hidden><button aria-label="close">×</button><p></p><div class="looks"></div></aside>
<footer>Made by <code>./relief bench</code>.</footer>
)",
        contents, parts);
    return closed_page("Relief: run time against error", style, body, script);
}

}  // namespace relief
