#include "framework/staff/pages/bench_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "framework/core/base/text.h"
#include "framework/course/pages/page.h"
#include "framework/staff/measure/answer.h"
#include "framework/staff/measure/plot.h"
#include "framework/staff/measure/sweep.h"

namespace relief::pages {
namespace {

std::optional<double> work_of(const measure::BenchRow& row, const std::string& name) {
    for (const auto& [work, value] : row.work)
        if (work == name) return value;
    return {};
}

/// Returns the name of a topic or of work in words: "moving frames", "texture bytes".
std::string spaced(std::string name) {
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == '_' || c == '-'; }, ' ');
    return name;
}

/// A column of a table, other than the first two and the pictures.
struct Column {
    std::string heading;
    std::function<std::string(const measure::BenchRow&)> cell;
};

/// Returns the names of all work that a scene's methods count, in order.
std::vector<std::string> works_of(std::span<const measure::BenchRow> rows, const std::vector<size_t>& scene) {
    std::vector<std::string> works;
    for (const size_t place : scene)
        for (const auto& [name, value] : rows[place].work)
            if (std::find(works.begin(), works.end(), name) == works.end()) works.push_back(name);
    return works;
}

/// Removes the work that is the same for all methods from `works`, and returns one text about it.
std::string take_same(std::span<const measure::BenchRow> rows, const std::vector<size_t>& scene,
                      std::vector<std::string>& works) {
    std::string same;
    std::erase_if(works, [&](const std::string& name) {
        std::set<std::optional<double>> values;
        for (const size_t place : scene) values.insert(work_of(rows[place], name));
        if (scene.size() < 2 || values.size() > 1) return false;
        same += fmt::format("{}{} {}", same.empty() ? "All: " : ", ", rounded(**values.begin()), spaced(name));
        return true;
    });
    return same;
}

using PutPicture = std::function<void(const std::string& name, const Image& picture)>;

/// Returns the SVG without the XML declaration of a file, for use in a page.
std::string drawing(const std::string& svg) {
    const size_t begin = svg.find("<svg");
    return begin == std::string::npos ? "" : svg.substr(begin);
}

class TopicPart {
public:
    TopicPart(const TopicResult& result, const PutPicture& put) : result_(result), put_(put) {
        double longest = 0;
        for (const measure::BenchRow& row : result.rows) longest = std::max(longest, row.times.median);
        if (longest >= 1e6) scale_ = 1e-6, unit_ = "ms";
    }

    Fields fields() const {
        const measure::BenchTopic& topic = *result_.topic;
        const measure::BenchMachine& machine = result_.machine;
        const std::vector<size_t> chief = measure::chief_scene(result_.rows);
        List scenes;
        Value chief_plot;
        for (const std::vector<size_t>& scene : measure::scenes_of(result_.rows)) {
            Fields fields = table(scene);
            const Value plot = plot_of(scenes.size(), scene);
            (scene == chief ? chief_plot : fields["plot"]) = plot;
            scenes.emplace_back(std::move(fields));
        }
        const size_t count = scenes.size();
        return {{"name", topic.name},
                {"label", spaced(topic.name)},
                {"help", capitalized(topic.help)},
                {"question", topic.question},
                {"answer", measure::answer_of(result_.rows, chief)},
                {"chief_scene", chief.empty() ? "" : measure::knob_text(result_.rows[chief.front()].scene)},
                {"chief", std::move(chief_plot)},
                {"quick", machine.is_quick},
                {"all", count == 1 ? "All figures" : fmt::format("All {} scenes", count)},
                {"renderer", machine.renderer},
                {"cpu", machine.cpu},
                {"clock", measure::clocks_of(result_.rows)},
                {"load", topic.sweeps ? "" : measure::load_text(machine)},
                {"any_wide", std::any_of(result_.rows.begin(), result_.rows.end(),
                                         [](const measure::BenchRow& row) { return row.is_wide(); })},
                {"compiler", machine.compiler},
                {"commit", machine.commit},
                {"scenes", std::move(scenes)}};
    }

private:
    /// Returns both plots of a scene, and the names of the numbers in the narrow one; or nothing.
    Value plot_of(size_t number, const std::vector<size_t>& scene) const {
        if (number >= result_.scenes.size() || result_.scenes[number].broad.empty()) return {};
        List key;
        for (const size_t row : measure::numbered_rows(*result_.topic, result_.rows, scene))
            key.push_back(Fields{{"name", measure::short_name(result_.rows[row])},
                                 {"kind", result_.rows[row].peer  ? "peer"
                                          : result_.topic->sweeps ? ""
                                                                  : "front"}});
        return Fields{{"broad", drawing(result_.scenes[number].broad)},
                      {"narrow", drawing(result_.scenes[number].narrow)},
                      {"key", rows(std::move(key))}};
    }

    Fields table(const std::vector<size_t>& scene) const {
        std::vector<std::string> works = works_of(result_.rows, scene);
        const std::string same = take_same(result_.rows, scene, works);
        const std::vector<Column> columns = columns_of(scene, works);
        const bool has_pictures = std::any_of(scene.begin(), scene.end(), [&](size_t place) {
            const measure::BenchRow& row = result_.rows[place];
            return row.picture.width > 0 || row.error_map.width > 0;
        });
        List headings, methods, says = verdicts(scene);
        const bool has_verdicts = !says.empty();
        for (const Column& column : columns) headings.push_back(column.heading);
        const std::vector<size_t> front = measure::front_of(result_.rows, scene);
        for (const size_t place : scene) methods.push_back(line(place, columns, front));
        return {{"scene", measure::knob_text(result_.rows[scene.front()].scene)},
                {"plot", Value()},
                {"same", same},
                {"headings", std::move(headings)},
                {"has_pictures", has_pictures},
                {"columns", std::max<size_t>(1, columns.size() + has_pictures)},
                {"methods", std::move(methods)},
                {"has_verdicts", has_verdicts},
                {"verdicts", std::move(says)}};
    }

    /// Returns the verdict on each sweep of a scene; methods with the same verdict share a line.
    List verdicts(const std::vector<size_t>& scene) const {
        std::vector<std::pair<std::string, const measure::BenchRow*>> lines;  // a verdict and the first row with it
        std::map<std::string, std::string> names;
        for (const size_t place : scene) {
            const measure::BenchRow& row = result_.rows[place];
            if (!row.sweep) continue;
            const std::string text = measure::verdict_of(*row.sweep, row.error.unit);
            std::string& known = names[text];
            if (known.empty()) lines.emplace_back(text, &row);
            known += (known.empty() ? "" : ", ") + row.method;
        }
        List result;
        for (const auto& [text, row] : lines)
            result.push_back(Fields{{"kind", row->peer ? "peer" : "other"}, {"names", names[text]}, {"text", text}});
        return result;
    }

    std::vector<Column> columns_of(const std::vector<size_t>& scene, const std::vector<std::string>& works) const {
        bool any_time = false, any_wrong = false;
        std::set<std::string> units;
        for (const size_t place : scene) {
            const measure::BenchRow& row = result_.rows[place];
            if (!row.error.unit.empty()) units.insert(row.error.unit);
            any_time |= row.repeats > 0, any_wrong |= row.error.wrong.has_value();
        }
        std::vector<Column> columns;
        if (any_time) {
            columns.push_back(
                {fmt::format("{} a {}", unit_, result_.rows[scene.front()].item), [this](const measure::BenchRow& row) {
                     return row.repeats > 0 ? rounded(row.times.median * scale_) : "";
                 }});
            columns.push_back({"p10 to p90", [this](const measure::BenchRow& row) {
                                   if (row.repeats == 0) return std::string();
                                   return rounded(row.times.p10 * scale_) + " to " + rounded(row.times.p90 * scale_) +
                                          (row.is_wide() ? " *" : "");
                               }});
        }
        if (!units.empty()) {
            const bool several = units.size() > 1;
            const auto add = [&](const std::string& heading, double measure::BenchError::*value) {
                columns.push_back({heading, [=](const measure::BenchRow& row) {
                                       return row.error.unit.empty()
                                                  ? ""
                                                  : amount_of(row.error.*value, several ? row.error.unit : "");
                                   }});
            };
            add("mean error, " + (several ? "in units of their own" : plural(*units.begin())),
                &measure::BenchError::mean);
            add("p99", &measure::BenchError::p99);
            add("largest", &measure::BenchError::largest);
        }
        if (any_wrong)
            columns.push_back({"wrong", [](const measure::BenchRow& row) {
                                   return row.error.wrong ? rounded(*row.error.wrong * 100) + " %" : "";
                               }});
        for (const std::string& name : works)
            columns.push_back({spaced(name), [=](const measure::BenchRow& row) {
                                   const std::optional<double> amount = work_of(row, name);
                                   return amount ? rounded(*amount) : "";
                               }});
        return columns;
    }

    Fields line(size_t place, const std::vector<Column>& columns, const std::vector<size_t>& front) const {
        const measure::BenchRow& row = result_.rows[place];
        const bool is_front = std::find(front.begin(), front.end(), place) != front.end();
        List cells;
        for (const Column& column : columns) cells.push_back(column.cell(row));
        return {{"row", place},
                {"kind", is_front   ? "front"
                         : row.peer ? "peer"
                                    : "other"},
                {"words", words(row)},
                {"method", row.method},
                {"knobs", measure::knob_text(row.knobs)},
                {"problem", row.is_measured() ? "" : row.state},
                {"cells", std::move(cells)},
                {"pictures", pictures(row, place)}};
    }

    /// Returns the text above the pictures of a point.
    std::string words(const measure::BenchRow& row) const {
        std::string text = measure::row_name(row);
        if (row.repeats > 0) text += fmt::format(": {} {} a {}", rounded(row.times.median * scale_), unit_, row.item);
        if (row.is_wide()) text += " (p90 over twice p10)";
        if (!row.error.unit.empty()) text += ", mean error " + amount_of(row.error.mean, row.error.unit);
        if (row.error.wrong) text += fmt::format(", {} % wrong", rounded(*row.error.wrong * 100));
        return text;
    }

    List pictures(const measure::BenchRow& row, size_t place) const {
        List pictures;
        const std::string error = "error: black 0, pale " + amount_of(row.error_map_max, row.error.unit) + " and more";
        const std::tuple<const Image*, const char*, std::string> all[] = {{&row.picture, "", "picture"},
                                                                          {&row.error_map, "-error", error}};
        for (const auto& [image, kind, name] : all) {
            if (image->width == 0) continue;
            const std::string file = fmt::format("{}/{}{}.png", row.topic, place, kind);
            put_(file, *image);
            pictures.push_back(Fields{{"alt", name}, {"src", file}});
        }
        return pictures;
    }

    const TopicResult& result_;
    const PutPicture& put_;
    double scale_ = 1;
    const char* unit_ = "ns";
};

/// A topic's part of a page.
struct Section {
    std::string name, text;
};

/// Returns the sections of a page by bench_page(), in order. Escaped text cannot contain a section's tags.
std::vector<Section> sections_of(const std::string& page) {
    constexpr std::string_view opening = "<section id=\"", closing = "</section>";
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

bool draw_plots(TopicResult& result) {
    const auto slide = measure::slide_plot(*result.topic, result.rows, result.machine.is_quick);
    if (!slide) return false;
    result.plot = *slide;
    if (result.plot.empty()) return true;
    const std::string note = result.machine.is_quick ? "quick run" : "";
    for (const std::vector<size_t>& scene : measure::scenes_of(result.rows)) {
        const auto draw = [&](const measure::PlotStyle& style, const char* kind) {
            return measure::scene_plot(*result.topic, result.rows, scene, style,
                                       fmt::format("{}-{}{}", result.topic->name, result.scenes.size(), kind));
        };
        // Wide plots are shown at 0.8 of their size or larger, narrow ones at 0.95 or larger. The page says what they
        // show.
        const auto broad =
                       draw({.size = {1100, 560}, .title = 0, .axes = 18, .names = 18, .all_names = true, .note = note},
                            "-broad"),
                   narrow = draw({.size = {324, 400},
                                  .title = 0,
                                  .axes = 15,
                                  .names = 15,
                                  .note = note,
                                  .numbered = measure::numbered_rows(*result.topic, result.rows, scene)},
                                 "-narrow");
        result.scenes.push_back({broad.value_or(""), narrow.value_or("")});
    }
    return true;
}

std::string bench_page(std::span<const TopicResult> results, const PutPicture& put, const std::string& before) {
    std::vector<Section> sections = sections_of(before);
    for (const TopicResult& result : results) {
        const std::string& name = result.topic->name;
        const auto found =
            std::find_if(sections.begin(), sections.end(), [&](const Section& one) { return one.name == name; });
        Section& section = found == sections.end() ? sections.emplace_back() : *found;
        section = {name, render("framework/staff/pages/topic", TopicPart(result, put).fields())};
    }
    List topics;
    for (const Section& section : sections)
        topics.push_back(Fields{{"name", section.name}, {"label", spaced(section.name)}, {"section", section.text}});
    return render({.title = "Relief: speed and error",
                   .body = "framework/staff/pages/bench",
                   .styles = {"framework/staff/pages/bench"},
                   .scripts = {"framework/staff/pages/bench"},
                   .pictures = PagePictures::beside},
                  {{"topics", std::move(topics)}});
}

}  // namespace relief::pages
