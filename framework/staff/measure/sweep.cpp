#include "framework/staff/measure/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "framework/core/base/text.h"
#include "framework/staff/measure/gnuplot.h"
#include "framework/staff/measure/plot.h"

namespace relief::measure {
namespace {

using Place = BenchSweep::Place;

std::string amount(double hardness) { return plain(with_digits(hardness, 4)); }

/// Returns a text such as "from 10 on" or "up to 0.1 and at 8" for the points where `is` is true; "" if there is none.
template <class Is>
std::string where(std::span<const Place> places, Is is) {
    std::vector<std::string> parts;
    for (size_t i = 0; i < places.size(); ++i) {
        if (!is(places[i])) continue;
        const size_t begin = i;
        while (i + 1 < places.size() && is(places[i + 1])) ++i;
        const std::string low = amount(places[begin].hardness), high = amount(places[i].hardness);
        if (begin == 0 && i + 1 == places.size()) return "everywhere";
        parts.push_back(i + 1 == places.size() ? "from " + low + " on"
                        : begin == 0           ? "up to " + high
                        : begin == i           ? "at " + low
                                               : "from " + low + " to " + high);
    }
    return join(parts, " and ");
}

bool is_lost(const Place& place) { return place.not_finite > 0 || place.endless > 0; }

constexpr std::array our_colors = {"#a34a16", "#d98a3d", "#7a5c2e", "#c23b22", "#6d7d2f", "#8a857b", "#c9a227"};
constexpr std::array peer_colors = {"#23629b", "#3fa0c9", "#6a5acd", "#1d8a7a"};
constexpr std::array our_points = {7, 5, 9, 11, 13, 15, 7};
constexpr std::array peer_points = {6, 4, 8, 10};

/// The curves of one scene.
class Panel {
public:
    Panel(std::span<const BenchRow> rows, const std::vector<size_t>& scene, size_t number, const PanelStyle& style)
        : rows_(rows), number_(number), style_(style) {
        for (const size_t place : scene)
            if (rows[place].sweep && !rows[place].sweep->places.empty()) places_.push_back(place);
        double low = 1e300, high = 0;
        for (const size_t row : places_)
            for (const Place& place : rows[row].sweep->places) {
                left_ = std::min(left_, place.hardness), right_ = std::max(right_, place.hardness);
                any_lost_ |= is_lost(place);
                if (is_lost(place)) continue;
                any_zero_ |= place.error < smallest;
                if (place.error >= smallest) low = std::min(low, place.error), high = std::max(high, place.error);
            }
        if (high == 0) low = high = 1;
        floor_ = std::pow(10, std::floor(std::log10(low)) - (any_zero_ ? 1 : 0));
        ceiling_ = std::pow(10, std::ceil(std::log10(high * 1.2)) + (any_lost_ ? 1 : 0));
    }

    std::string script() const {
        if (places_.empty()) return {};
        const BenchRow& first = rows_[places_.front()];
        std::string text = fmt::format(
            "unset arrow\nunset label\nset grid xtics ytics lc rgb '#ece8e0'\nset format x '%g'\nset format y '%g'\n"
            "set logscale xy\nset xtics autofreq rotate by -30 font ',{}'\nset ytics autofreq font ',{}'\n"
            "set title {} noenhanced font ',{}'\nset border 3 lc rgb '#8a857b'\nset tics nomirror textcolor rgb '{}'\n"
            "set xlabel {} noenhanced offset 0,-0.4\nset ylabel {} noenhanced\n"
            "set key at graph 0.5,-0.38 center top horizontal maxcols 3 samplen 1.5 spacing 0.85 font ',{}' "
            "noenhanced\nset xrange [{}:{}]\nset yrange [{}:{}]\n",
            style_.names, style_.axes, gnuplot_text(title(first)), style_.title, gnuplot_text_color,
            gnuplot_text(first.item), gnuplot_text("error, " + plural(first.error.unit)), style_.names - 1, left_ / 1.3,
            right_ * 1.3, floor_, ceiling_);
        if (any_zero_) text += fmt::format("set ytics add ('0' {})\n", floor_);
        if (any_lost_) text += fmt::format("set ytics add ('none' {})\n", ceiling_);
        text += stated();
        std::vector<std::string> plots;
        for (const bool peer : {true, false}) {  // the course's methods are drawn last, on top
            size_t count = 0;
            for (const size_t row : places_)
                if (rows_[row].peer == peer) curve(row, count++, text, plots);
        }
        return text + "plot " + join(plots, ", \\\n  ") + "\n";
    }

private:
    /// Returns a title such as "hits angle": the values of the scene's knobs.
    static std::string title(const BenchRow& row) {
        std::string text;
        for (const auto& [knob, value] : row.scene) text += (text.empty() ? "" : ", ") + value;
        std::replace(text.begin(), text.end(), '-', ' ');
        return text;
    }

    static constexpr double smallest = 1e-9;  ///< smaller values count as 0

    /// Returns a line at the stated error if it is the same for all methods of the course.
    std::string stated() const {
        std::optional<double> limit;
        for (const size_t row : places_) {
            if (rows_[row].peer) continue;
            if (limit && *limit != rows_[row].sweep->stated) return {};
            limit = rows_[row].sweep->stated;
        }
        if (!limit || *limit <= floor_ || *limit >= ceiling_) return {};
        return fmt::format(
            "set arrow from graph 0,first {0} to graph 1,first {0} nohead lc rgb '#8a857b' dt 2\n"
            "set label 'stated' at graph 0.01,first {0} offset 0,0.4 font ',{1}' textcolor rgb '#6b655a'\n",
            *limit, style_.names - 1);
    }

    void curve(size_t row, size_t count, std::string& text, std::vector<std::string>& plots) const {
        const BenchRow& of = rows_[row];
        const std::string name = short_name(of);
        const std::string block = fmt::format("$curve{}_{}", number_, row);
        text += block + " << END\n";
        for (const Place& place : of.sweep->places) {
            const double y = is_lost(place) ? ceiling_ : std::clamp(place.error, floor_, ceiling_);
            const std::string said = place.not_finite > 0
                                         ? fmt::format("{} % not finite", rounded(100 * place.not_finite))
                                     : place.endless > 0 ? fmt::format("{} % do not end", rounded(100 * place.endless))
                                                         : amount_of(place.error, of.error.unit);
            text += fmt::format("{} {} {}\n", place.hardness, y,
                                gnuplot_text(fmt::format("#{} {} at {}: {}", row, name, amount(place.hardness), said)));
        }
        text += "END\n";
        const size_t i = count % (of.peer ? peer_colors.size() : our_colors.size());
        const char* const color = of.peer ? peer_colors[i] : our_colors[i];
        plots.push_back(fmt::format("{} using 1:2 with linespoints lw {} dt {} pt {} ps 0.5 lc rgb '{}' title {}",
                                    block, of.peer ? 1.4 : 2, of.peer ? "'-'" : "1",
                                    of.peer ? peer_points[i] : our_points[i], color, gnuplot_text(name)));
        plots.push_back(
            fmt::format("{} using 1:2:3 with labels hypertext point pt 7 ps 0.35 lc rgb '{}' notitle", block, color));
    }

    std::span<const BenchRow> rows_;
    size_t number_;
    PanelStyle style_;
    std::vector<size_t> places_;
    double left_ = 1e300, right_ = 0, floor_ = 1, ceiling_ = 1;
    bool any_zero_ = false, any_lost_ = false;
};

}  // namespace

double with_digits(double number, int digits) {
    if (number == 0 || !std::isfinite(number)) return number;
    const double unit = std::pow(10, std::floor(std::log10(std::abs(number))) - digits + 1);
    return std::round(number / unit) * unit;
}

bool holds(const BenchSweep& sweep, const Place& place) { return !is_lost(place) && place.error <= sweep.stated; }

BenchSubject swept(BenchSweep sweep, const std::string& unit) {
    std::vector<double> kept, finite;
    double wrong = 0, not_finite = 0, endless = 0;
    for (const Place& place : sweep.places) {
        if (!is_lost(place)) finite.push_back(place.error);
        if (holds(sweep, place)) kept.push_back(place.error);
        wrong += !is_lost(place) && place.error > sweep.stated;
        not_finite += place.not_finite > 0, endless += place.endless > 0;
    }
    BenchSubject subject;
    subject.error = error_figures(kept.empty() ? finite : kept, unit);
    subject.work = {{"wrong", wrong}, {"not_finite", not_finite}, {"endless", endless}};
    subject.sweep = std::move(sweep);
    return subject;
}

std::string verdict_of(const BenchSweep& sweep, const std::string& unit) {
    std::vector<std::string> parts;
    const auto add = [&](const std::string& what, const std::string& at) {
        if (!at.empty()) parts.push_back(what + " " + at);
    };
    add("off by more than " + amount_of(sweep.stated, unit),
        where(sweep.places, [&](const Place& place) { return !is_lost(place) && place.error > sweep.stated; }));
    add("not finite", where(sweep.places, [](const Place& place) { return place.not_finite > 0; }));
    add("does not end", where(sweep.places, [](const Place& place) { return place.endless > 0; }));
    if (parts.empty()) parts.push_back("keeps " + amount_of(sweep.stated, unit) + " for all inputs of this sweep");
    return join(parts, ", ") + (sweep.why.empty() ? "." : ". " + sweep.why);
}

std::string sweep_panel(std::span<const BenchRow> rows, const std::vector<size_t>& scene, const PanelStyle& style) {
    const std::string panel = Panel(rows, scene, 0, style).script();
    return panel.empty() ? "" : "set rmargin 5\n" + panel;  // room for the axis' last number, which is rotated and
                                                            // extends past the axis
}

std::string sweep_script(const BenchTopic& topic, std::span<const BenchRow> rows, const BenchMachine& machine) {
    const std::vector<std::vector<size_t>> scenes = scenes_of(rows);
    // A single panel is for a slide and needs large letters.
    const PanelStyle style =
        scenes.size() == 1 ? PanelStyle{.title = 15, .axes = 13, .names = 12} : PanelStyle{.axes = 10};
    std::vector<std::string> panels;
    for (const std::vector<size_t>& scene : scenes)
        if (std::string panel = Panel(rows, scene, panels.size(), style).script(); !panel.empty())
            panels.push_back(std::move(panel));
    if (panels.empty()) return {};
    return gnuplot_panels(topic.name + ", " + (machine.renderer == "none" ? machine.cpu : machine.renderer), panels,
                          {.size = {480, 450}, .below = 165, .least_columns = 1, .most_columns = 3});
}

}  // namespace relief::measure
