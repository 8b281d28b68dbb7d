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

/// The look of a curve. Its colour, dashes and points all differ from those of its neighbours: readers with
/// deuteranopia tell brown from green by the dashes.
struct Look {
    const char *color, *dashes;
    int point;
};
constexpr const char* whole = "solid";
constexpr std::array our_looks = {Look{"#23211d", whole, 7},  Look{"#a84300", whole, 5},   Look{"#00694f", "'_'", 9},
                                  Look{"#8a3a80", whole, 11}, Look{"#7d5a00", "'_.'", 13}, Look{"#23211d", "'_'", 15},
                                  Look{"#a84300", "'_.'", 9}, Look{"#00694f", whole, 11},  Look{"#8a3a80", "'_'", 7},
                                  Look{"#7d5a00", whole, 5},  Look{"#23211d", "'_.'", 11}};
constexpr std::array peer_looks = {Look{"#0a5c9e", "'-'", 6}, Look{"#3f51a8", "'.'", 4}, Look{"#0a5c9e", "'-.'", 8},
                                   Look{"#3f51a8", "'-'", 10}};

/// The curves of one scene.
class SweepPlot {
public:
    SweepPlot(std::span<const BenchRow> rows, const std::vector<size_t>& scene, const PlotStyle& style)
        : rows_(rows), style_(style) {
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
        const double low = any_zero_ ? 10 * floor_ : floor_, high = any_lost_ ? ceiling_ / 10 : ceiling_;
        std::string text = fmt::format(
            "set grid xtics ytics lc rgb '{}'\nset logscale xy\nset xtics {}\nset ytics {}\n"
            "set xlabel {} noenhanced\nset ylabel {} noenhanced\nset xrange [{}:{}]\nset yrange [{}:{}]\n",
            gnuplot_grid_color, decade_tics(left_, right_, plot_size().x / (4.8 * style_.axes)),
            decade_tics(low, high, plot_size().y / (1.6 * style_.axes)), gnuplot_text(hardness()),
            gnuplot_text("error, " + plural(first.error.unit)), left_ / 1.3, right_ * 1.3, floor_, ceiling_);
        text += names_at_ends();
        if (any_zero_) text += fmt::format("set ytics add ('0' {})\n", floor_);
        if (any_lost_) text += fmt::format("set ytics add ('none' {})\n", ceiling_);
        text += stated();
        std::vector<std::string> plots;
        for (const size_t row : places_) curve(row, text, plots);
        return gnuplot_script(style_, margins(), title(first), text + "plot " + join(plots, ", \\\n  ") + "\n");
    }

private:
    PlotMargins margins() const {
        constexpr size_t none = 4;  // letters of the label of results that are lost
        return plot_margins(style_, std::max(longest_decade(floor_, ceiling_), none), names_width() + 16);
    }
    glm::dvec2 plot_size() const { return margins().inside(style_.size); }

    /// Returns a title such as "hits angle": the values of the scene's knobs.
    std::string title(const BenchRow& row) const {
        std::string text;
        for (const auto& [knob, value] : row.scene) text += (text.empty() ? "" : ", ") + value;
        std::replace(text.begin(), text.end(), '-', ' ');
        return style_.note.empty() ? text : text + ", " + style_.note;
    }

    std::string label(size_t row) const { return point_label(rows_[row], row, style_); }

    double names_width() const {
        size_t longest = 0;
        for (const size_t row : places_) longest = std::max(longest, label(row).size());
        return 0.62 * style_.names * double(longest) + 14;
    }

    /// Returns the last position of a curve, from 0 at the floor to 1 at the ceiling.
    double end_of(size_t row) const {
        const Place& last = rows_[row].sweep->places.back();
        const double y = is_lost(last) ? ceiling_ : std::clamp(last.error, floor_, ceiling_);
        return std::log(y / floor_) / std::log(ceiling_ / floor_);
    }

    /// Names the curves at their ends. Names of near curves are moved apart; a line leads from the curve to its name.
    std::string names_at_ends() const {
        std::vector<size_t> order = places_;
        std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return end_of(a) > end_of(b); });
        const double high = std::min(1.25 * style_.names / plot_size().y, 1.0 / double(order.size()));
        std::vector<double> at;
        for (const size_t row : order)
            at.push_back(at.empty() ? std::min(end_of(row), 1.0) : std::min(end_of(row), at.back() - high));
        // If the last ones are below the axis, they push the ones above them up.
        for (size_t i = at.size(), lowest = 0; i-- > 0; ++lowest) at[i] = std::max(at[i], double(lowest) * high);
        std::string text;
        for (size_t i = 0; i < order.size(); ++i) {
            const Look look = look_of(order[i]);
            text += fmt::format(
                "set label {} at graph 1.05,graph {:.3f} left font ',{}' textcolor rgb '{}' noenhanced\n"
                "set arrow from first {},graph {:.3f} to graph 1.04,graph {:.3f} nohead lw 0.7 lc rgb '{}'\n",
                gnuplot_text(label(order[i])), at[i], style_.names, look.color,
                rows_[order[i]].sweep->places.back().hardness, end_of(order[i]), at[i], look.color);
        }
        return text;
    }

    /// Returns the name of the swept quantity, without its explanation in parentheses if there is no room for it.
    std::string hardness() const {
        const std::string& item = rows_[places_.front()].item;
        const std::string shown =
            0.6 * style_.axes * double(item.size()) < style_.size.x - 60 ? item : item.substr(0, item.find(" ("));
        return style_.title == 0 && !style_.note.empty() ? shown + ", " + style_.note : shown;
    }

    Look look_of(size_t row) const {
        const size_t i = size_t(std::count_if(places_.begin(), std::find(places_.begin(), places_.end(), row),
                                              [&](size_t other) { return rows_[other].peer == rows_[row].peer; }));
        return rows_[row].peer ? peer_looks[i % peer_looks.size()] : our_looks[i % our_looks.size()];
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
            *limit, style_.names);
    }

    void curve(size_t row, std::string& text, std::vector<std::string>& plots) const {
        const BenchRow& of = rows_[row];
        const std::string name = short_name(of);
        const std::string block = fmt::format("$curve_{}", row);
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
        const Look look = look_of(row);
        plots.push_back(fmt::format("{} using 1:2 with linespoints lw 2 dt {} pt {} ps 0.6 lc rgb '{}' title {}", block,
                                    look.dashes, look.point, look.color, gnuplot_text(name)));
        plots.push_back(fmt::format("{} using 1:2:3 with labels hypertext point pt 7 ps 0.35 lc rgb '{}' notitle",
                                    block, look.color));
    }

    std::span<const BenchRow> rows_;
    PlotStyle style_;
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

std::string sweep_script(std::span<const BenchRow> rows, const std::vector<size_t>& scene, const PlotStyle& style) {
    return SweepPlot(rows, scene, style).script();
}

}  // namespace relief::measure
