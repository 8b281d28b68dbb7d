#include "framework/staff/measure/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <iterator>
#include <limits>
#include <map>

#include "framework/core/base/error.h"
#include "framework/core/base/text.h"
#include "framework/staff/measure/answer.h"
#include "framework/staff/measure/gnuplot.h"
#include "framework/staff/measure/sweep.h"

namespace relief::measure {
namespace {

constexpr const char *quiet_color = "#6b655a", *front_color = "#a34a16", *pale_color = "#8f887b",
                     *peer_color = "#23629b", *text_color = gnuplot_text_color;

/// The plot of one scene, in seconds, milliseconds or nanoseconds.
class ScenePlot {
public:
    ScenePlot(std::span<const BenchRow> rows, const std::vector<size_t>& scene, const PlotStyle& style)
        : rows_(rows), style_(style) {
        for (const size_t place : scene)
            if (rows[place].is_timed()) timed_.push_back(place);
        double longest = 0;
        for (const size_t place : timed_) longest = std::max(longest, rows[place].times.median);
        if (longest >= 1e9)
            scale_ = 1e-9, unit_ = "s";
        else if (longest >= 1e6)
            scale_ = 1e-6, unit_ = "ms";
        front_ = front_of(rows, timed_);
        has_errors_ = has_errors(rows, timed_);
        if (!has_errors_) style_.size.y = int(5.5 * style.axes + 2.4 * style.names * double(timed_.size() + 1));
        const Span all = span();
        margins_ = plot_margins(style, has_errors_ ? longest_decade(all.floor, all.ceiling) : 0, 1.4 * style.axes);
    }

    std::string script() const {
        if (timed_.empty()) return {};
        const BenchRow& first = rows_[timed_.front()];
        std::string title = first.scene.empty() ? first.topic : knob_text(first.scene);
        if (0.62 * style_.title * double(title.size() + style_.note.size()) > style_.size.x) title.clear();
        if (!style_.note.empty()) title += (title.empty() ? "" : ", ") + style_.note;
        const bool any_wide =
            std::any_of(timed_.begin(), timed_.end(), [&](size_t place) { return rows_[place].is_wide(); });
        std::string below = fmt::format("{} per {}", unit_, first.item);
        if (style_.title == 0 && !style_.note.empty()) below += ", " + style_.note;
        constexpr const char* note = "; hollow: p90 over twice p10";  // the page says so, too
        if (any_wide && 0.62 * style_.axes * double(below.size() + std::string_view(note).size()) < plot_size().x)
            below += note;
        return gnuplot_script(style_, margins_, title,
                              fmt::format("set xlabel '{}' noenhanced\n", below) + (has_errors_ ? points() : bars()));
    }

private:
    std::string label(size_t place) const { return point_label(rows_[place], place, style_); }
    /// Returns the text that a browser shows at a point.
    std::string title(size_t place) const {
        return gnuplot_text(fmt::format("#{} {}{}", place, row_name(rows_[place]),
                                        rows_[place].is_wide() ? ", p90 over twice p10" : ""));
    }
    double time(size_t place) const { return rows_[place].times.median * scale_; }

    /// Returns how many numbers of `letters` letters have room below the plot.
    double room_for_tics(double letters) const { return plot_size().x / (0.7 * style_.axes * (letters + 1)); }

    /// Returns tics of a log axis: within its decades as many numbers as have room.
    std::string time_tics(double left, double right) const {
        const double decades = std::log10(right / left);
        if (decades > 2) return "set xtics " + decade_tics(left, right, room_for_tics(5)) + "\n";
        const double room = room_for_tics(double(plain(std::floor(right)).size())) / decades;
        const std::pair<double, std::vector<int>> choices[] = {
            {0.14, {1, 2, 3, 5, 7}}, {0.3, {1, 2, 5}}, {0.47, {1, 3}}, {1, {1}}};  // with the least distance of two
        const auto choice = std::find_if(std::begin(choices), std::end(choices) - 1,
                                         [&](const auto& one) { return one.first * room >= 1; });
        std::string text;
        for (double decade = std::pow(10, std::floor(std::log10(left))); decade < right; decade *= 10)
            for (const int times : choice->second)
                text += fmt::format("{0}'{1}' {1}", text.empty() ? "" : ", ", plain(times * decade));
        return fmt::format("set xtics ({})\n", text);
    }

    bool is_front(size_t place) const { return std::find(front_.begin(), front_.end(), place) != front_.end(); }

    /// The range of the axes. A log axis has no zero, so zeros lie at `floor`, with a label of their own.
    struct Span {
        double left = std::numeric_limits<double>::max(), right = 0, floor = 0, ceiling = 0;
        bool any_zero = false;
        std::string unit;
    };
    Span span() const {
        Span all;
        double low = std::numeric_limits<double>::max(), high = 0;
        for (const size_t place : timed_) {
            const BenchRow& row = rows_[place];
            all.left = std::min(all.left, row.times.p10 * scale_);
            all.right = std::max(all.right, row.times.p90 * scale_);
            if (row.error.unit.empty()) continue;
            all.unit = row.error.unit;
            const double error = row.error.mean;
            all.any_zero |= error <= 0;
            if (error > 0) low = std::min(low, error), high = std::max(high, error);
        }
        if (high == 0) low = high = 1;
        all.floor = std::pow(10, std::floor(std::log10(low)) - (all.any_zero ? 1 : 0));
        all.ceiling = std::pow(10, std::ceil(std::log10(high * 1.5)));
        return all;
    }

    std::string axes(const Span& all) const {
        const double left = all.left / 1.25, right = all.right * 1.9;
        const double low = all.any_zero ? 10 * all.floor : all.floor;
        std::string text = fmt::format(
            "set ylabel 'mean error, {}' noenhanced\nset logscale xy\n"
            "set xrange [{}:{}]\nset yrange [{}:{}]\nset grid xtics ytics lc rgb '{}'\nset bars 0\n"
            "set ytics {}\n{}",
            plural(all.unit), left, right, all.floor, all.ceiling, gnuplot_grid_color,
            decade_tics(low, all.ceiling, plot_size().y / (1.6 * style_.axes)), time_tics(left, right));
        if (all.any_zero) text += fmt::format("set ytics add ('0' {})\n", all.floor);
        return text;
    }

    /// A rectangle of the plot, in pixels from its lower left corner.
    struct Room {
        glm::dvec2 low, high;
        bool meets(const Room& other) const {
            return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y && other.low.y < high.y;
        }
    };
    glm::dvec2 plot_size() const { return margins_.inside(style_.size); }
    double width(const std::string& name) const { return 0.66 * style_.names * double(name.size()); }
    double height() const { return 1.3 * style_.names; }

    /// Returns the position of a point in the plot.
    glm::dvec2 place_of(double time, double error, const Span& all) const {
        return plot_size() * glm::dvec2(std::log(1.25 * time / all.left) / std::log(2.375 * all.right / all.left),
                                        std::log(error / all.floor) / std::log(all.ceiling / all.floor));
    }
    glm::dvec2 place_of(size_t row, const Span& all) const {
        return place_of(time(row), std::max(rows_[row].error.mean, all.floor), all);
    }

    /// Draws rows with a time but no error as vertical lines with their names along them. A name is moved down if it
    /// would overlap another. Adds the covered rectangles to `taken`.
    std::string upright_lines(const Span& all, std::vector<Room>& taken) const {
        std::string text;
        for (const size_t place : timed_) {
            if (!rows_[place].error.unit.empty()) continue;
            const std::string name = short_name(rows_[place]) + (rows_[place].is_wide() ? " (p90 over twice p10)" : "");
            const double x = place_of(time(place), all.ceiling, all).x;
            const double top = 0.97 * plot_size().y;
            Room room{{x - height() - 0.4 * style_.axes, top - width(name)}, {x, top}};
            for (bool moved = true; moved;) {
                moved = false;
                for (const Room& other : taken)
                    if (room.meets(other)) {
                        const double down = room.high.y - other.low.y;
                        room.low.y -= down, room.high.y -= down, moved = true;
                    }
            }
            text += fmt::format("set arrow from {0},graph 0 to {0},graph 1 nohead lc rgb '{1}' dt 3\n", time(place),
                                peer_color);
            if (room.low.y < 0 || room.low.x < 0) continue;  // no room left
            const double rim = 0.4 * style_.names;           // sizes are approximate
            taken.push_back({room.low - rim, room.high + rim});
            text += fmt::format(
                "set label {} at {},graph {:.3f} rotate by 90 right font ',{}' textcolor rgb '{}' noenhanced offset "
                "-0.5,0\n",
                gnuplot_text(name), time(place), room.high.y / plot_size().y, style_.names, peer_color);
        }
        return text;
    }

    /// A position of a name beside its point, in letters of the axes. A letter is 0.7 of its size wide and 1.5 high.
    struct Side {
        const char* align;
        double x, y;
    };
    static constexpr std::array<Side, 8> sides = {{{"left", 0.7, 0.45},
                                                   {"right", -0.7, 0.45},
                                                   {"left", 0.7, -0.45},
                                                   {"right", -0.7, -0.45},
                                                   {"left", 0.7, 1.35},
                                                   {"right", -0.7, 1.35},
                                                   {"left", 0.7, -1.35},
                                                   {"right", -0.7, -1.35}}};

    /// A rectangle that no name may cover, and the row whose name stands beside it.
    struct Mark {
        Room room;
        std::optional<size_t> of = {};
    };
    /// Returns the bars of all points with the points, and the steps of the front.
    std::vector<Mark> marks(const Span& all) const {
        constexpr double radius = 4;
        std::vector<Mark> marks;
        const auto line = [&](glm::dvec2 a, glm::dvec2 b) { marks.push_back({{glm::min(a, b), glm::max(a, b)}}); };
        for (const size_t place : timed_) {
            const BenchRow& row = rows_[place];
            if (row.error.unit.empty()) continue;
            const double error = std::max(row.error.mean, all.floor);
            const glm::dvec2 point = place_of(place, all);
            const double begin = std::min(place_of(row.times.p10 * scale_, error, all).x, point.x - radius),
                         end = std::max(place_of(row.times.p90 * scale_, error, all).x, point.x + radius);
            marks.push_back({{{begin, point.y - radius}, {end, point.y + radius}}, place});
        }
        std::vector<size_t> front = front_;
        std::sort(front.begin(), front.end(), [&](size_t a, size_t b) { return time(a) < time(b); });
        for (size_t i = 1; i < front.size(); ++i) {
            const glm::dvec2 from = place_of(front[i - 1], all), to = place_of(front[i], all);
            line(from, {to.x, from.y}), line({to.x, from.y}, to);
        }
        return marks;
    }

    /// Returns the points whose name has room beside them, with the index of its position in `sides`. The front comes
    /// first, and names do not overlap.
    std::map<size_t, size_t> named_points(const Span& all, std::vector<Room> taken) const {
        std::map<size_t, size_t> named;
        const std::vector<Mark> marks = this->marks(all);
        const auto name = [&](size_t place) {
            const glm::dvec2 point = place_of(place, all);
            const double length = width(label(place));
            const size_t first = point.x > 0.7 * plot_size().x ? 1 : 0;
            for (const size_t i :
                 {first, 1 - first, 2 + first, 3 - first, 4 + first, 5 - first, 6 + first, 7 - first}) {
                const glm::dvec2 near = point + glm::dvec2(0.7 * sides[i].x, 1.5 * sides[i].y) * double(style_.axes);
                const double left = sides[i].x > 0 ? near.x : near.x - length;
                const Room room{{left, near.y - height() / 2}, {left + length, near.y + height() / 2}};
                if (left < 0 || room.high.x > plot_size().x + margins_.right - 2 || room.low.y < 0 ||
                    std::any_of(taken.begin(), taken.end(), [&](const Room& other) { return room.meets(other); }) ||
                    std::any_of(marks.begin(), marks.end(),
                                [&](const Mark& mark) { return mark.of != place && room.meets(mark.room); }))
                    continue;
                const double rim = 0.2 * style_.names;  // sizes are approximate
                taken.push_back({room.low - rim, room.high + rim});
                named.emplace(place, i);
                return;
            }
        };
        for (const auto wanted : {0, 1, 2})
            for (const size_t place : timed_) {
                if (rows_[place].error.unit.empty()) continue;
                const int kind = is_front(place) ? 0 : rows_[place].peer ? 1 : 2;
                if (kind == wanted && (kind < 2 || style_.all_names)) name(place);
            }
        return named;
    }

    /// Lines of data by the names of their blocks: pale, front, peers, sweeps, steps. The first three have a second
    /// block for times with is_wide(), such as pale_wide. None is empty.
    using Blocks = std::map<std::string, std::string>;
    Blocks blocks(const Span& all, const std::map<size_t, size_t>& named) const {
        Blocks blocks;
        std::map<std::string, std::string> by_method;
        for (const size_t place : timed_) {
            const BenchRow& row = rows_[place];
            if (row.error.unit.empty()) continue;
            const double y = std::max(row.error.mean, all.floor);
            const auto found = named.find(place);
            std::string names;
            for (size_t side = 0; side < sides.size(); ++side)
                names += " " + gnuplot_text(found != named.end() && found->second == side ? label(place) : "");
            by_method[row.method] += fmt::format("{} {}\n", time(place), y);
            const std::string kind = row.peer ? "peers" : is_front(place) ? "front" : "pale";
            blocks[kind + (row.is_wide() ? "_wide" : "")] +=
                fmt::format("{} {} {} {} {}{}\n", time(place), y, row.times.p10 * scale_, row.times.p90 * scale_,
                            title(place), names);
        }
        for (const auto& [method, points] : by_method) blocks["sweeps"] += points + "\n";
        std::vector<size_t> line = front_;
        std::sort(line.begin(), line.end(), [&](size_t a, size_t b) { return time(a) < time(b); });
        for (const size_t place : line)
            blocks["steps"] += fmt::format("{} {}\n", time(place), std::max(rows_[place].error.mean, all.floor));
        return blocks;
    }

    /// Back to front: lines of a method's sweep, the front's steps, points, names.
    std::string layers(const Blocks& blocks) const {
        std::vector<std::string> plots;
        const auto add = [&](const std::string& name, const std::string& how) {
            if (blocks.contains(name)) plots.push_back(fmt::format("${} {}", name, how));
        };
        const auto dots = [&](const std::string& name, const char* color, double size, int shape) {
            const auto dot = [&](const std::string& block, int of_shape) {
                add(block, fmt::format("using 1:2:3:4 with xerrorbars pt 0 lw 1 lc rgb '{}'", color));
                add(block, fmt::format("using 1:2:5 with labels hypertext point pt {} ps {} lc rgb '{}'", of_shape,
                                       size, color));
            };
            dot(name, shape);
            dot(name + "_wide", shape - 1);  // the hollow shape
        };
        const auto names = [&](const std::string& name, const char* color) {
            const std::string look = fmt::format("font ',{}' textcolor rgb '{}' noenhanced", style_.names, color);
            for (const char* block : {"", "_wide"})
                for (size_t i = 0; i < sides.size(); ++i)
                    add(name + block, fmt::format("using 1:2:{} with labels {} offset {},{} {}", 6 + i, sides[i].align,
                                                  sides[i].x, sides[i].y, look));
        };
        add("sweeps", "using 1:2 with lines lw 0.7 lc rgb '#ddd7cb'");
        add("steps", fmt::format("using 1:2 with steps lw 2 lc rgb '{}'", front_color));
        constexpr int disc = 7, diamond = 13;
        dots("pale", pale_color, 0.45, disc);
        dots("front", front_color, 0.6, disc);
        dots("peers", peer_color, 0.8, diamond);
        if (style_.all_names) names("pale", quiet_color);
        names("front", front_color);
        names("peers", peer_color);
        return "plot " + join(plots, ", \\\n  ") + "\n";
    }

    std::string points() const {
        const Span all = span();
        std::vector<Room> taken;
        const double rim = 0.6 * style_.names;  // places are approximate
        for (const Mark& mark : marks(all)) taken.push_back({mark.room.low - rim, mark.room.high + rim});
        const auto marked = std::ptrdiff_t(taken.size());
        std::string text = axes(all) + upright_lines(all, taken);
        taken.erase(taken.begin(), taken.begin() + marked);  // a point's own bar is no obstacle to its name
        const std::map<size_t, size_t> named = named_points(all, std::move(taken));
        for (const auto& [place, side] : named)
            if (std::abs(sides[side].y) > 1)
                text += fmt::format(
                    "set arrow from first {},first {} rto character {},character {} nohead lw 0.7 lc rgb '{}'\n",
                    time(place), std::max(rows_[place].error.mean, all.floor), 0.8 * sides[side].x,
                    0.75 * sides[side].y, quiet_color);
        const Blocks data = blocks(all, named);
        for (const auto& [name, block] : data) text += fmt::format("${} << END\n{}END\n", name, block);
        return text + layers(data);
    }

    /// Returns the step of an axis from 0 to `end` whose numbers have room.
    double step_of_tics(double end) const {
        const double letters = std::max(3.0, std::log10(end) + 1), least = end / room_for_tics(letters);
        const double decade = std::pow(10, std::floor(std::log10(least)));
        for (const double times : {1.0, 2.0, 5.0})
            if (times * decade >= least) return times * decade;
        return 10 * decade;
    }

    /// Bars, each below its name.
    std::string bars() const {
        std::string data;
        double end = 0;
        for (size_t i = 0; i < timed_.size(); ++i) {
            const BenchRow& row = rows_[timed_[i]];
            end = std::max(end, row.times.p90 * scale_);
            data += fmt::format("{} {} {} {} {} {} {}\n", timed_.size() - i, time(timed_[i]), row.times.p10 * scale_,
                                row.times.p90 * scale_, title(timed_[i]), 2 * row.peer + row.is_wide(),
                                gnuplot_text(short_name(row)));
        }
        std::string text = fmt::format(
            "$bars << END\n{}END\nunset ytics\nset yrange [0.4:{}]\nset xrange [0:*]\n{}"
            "set grid xtics lc rgb '{}'\nplot ",
            data, double(timed_.size()) + 0.6, end > 0 ? fmt::format("set xtics {}\n", step_of_tics(end)) : "",
            gnuplot_grid_color);
        for (const int kind : {0, 1, 2, 3})
            text += fmt::format(
                "$bars using ($6=={}?$2/2:1/0):($1-0.3):($2/2):(0.16) with boxxyerror fs {} lc rgb '{}', \\\n  ", kind,
                kind % 2 == 1 ? "empty" : "solid noborder", kind < 2 ? "#e3b99d" : "#aac6df");
        return text + fmt::format(
                          "$bars using 2:($1-0.3):3:4 with xerrorbars pt 0 lw 1 lc rgb '{0}', \\\n"
                          "  $bars using 2:($1-0.3):5 with labels hypertext point pt 7 ps 0.4 lc rgb '{0}', \\\n"
                          "  $bars using (0):($1+0.2):7 with labels left offset 0.6,0 font ',{1}' textcolor rgb "
                          "'{0}' noenhanced\n",
                          text_color, style_.names);
    }

    std::span<const BenchRow> rows_;
    PlotStyle style_;
    PlotMargins margins_{};
    bool has_errors_ = false;
    std::vector<size_t> timed_, front_;
    double scale_ = 1;
    const char* unit_ = "ns";
};

}  // namespace

std::vector<std::vector<size_t>> scenes_of(std::span<const BenchRow> rows) {
    std::vector<std::vector<size_t>> scenes;
    for (size_t i = 0; i < rows.size(); ++i) {
        if (i == 0 || rows[i].scene != rows[i - 1].scene) scenes.emplace_back();
        scenes.back().push_back(i);
    }
    return scenes;
}

bool has_errors(std::span<const BenchRow> rows, const std::vector<size_t>& scene) {
    std::string unit;
    int count = 0;
    for (const size_t place : scene) {
        const BenchRow& row = rows[place];
        if (!row.is_measured() || row.error.unit.empty()) continue;
        if (count++ > 0 && row.error.unit != unit) return false;
        unit = row.error.unit;
    }
    return count >= 2;
}

std::vector<size_t> front_of(std::span<const BenchRow> rows, const std::vector<size_t>& scene) {
    if (!has_errors(rows, scene)) return {};
    std::vector<size_t> places, front;
    std::vector<std::pair<double, double>> points;
    for (const size_t place : scene)
        if (rows[place].is_timed() && !rows[place].error.unit.empty()) {
            places.push_back(place);
            points.emplace_back(rows[place].times.median, rows[place].error.mean);
        }
    const std::vector<bool> is_front = pareto_front(points);
    for (size_t i = 0; i < places.size(); ++i)
        if (is_front[i]) front.push_back(places[i]);
    return front;
}

std::string point_label(const BenchRow& row, size_t place, const PlotStyle& style) {
    const auto found = std::find(style.numbered.begin(), style.numbered.end(), place);
    return found == style.numbered.end() ? short_name(row) : std::to_string(found - style.numbered.begin() + 1);
}

std::vector<size_t> numbered_rows(const BenchTopic& topic, std::span<const BenchRow> rows,
                                  const std::vector<size_t>& scene) {
    std::vector<size_t> numbered;
    if (topic.sweeps) {
        std::copy_if(scene.begin(), scene.end(), std::back_inserter(numbered),
                     [&](size_t place) { return rows[place].sweep && !rows[place].sweep->places.empty(); });
        return numbered;
    }
    if (!has_errors(rows, scene)) return {};
    numbered = front_of(rows, scene);
    for (const size_t place : scene)
        if (rows[place].peer && rows[place].is_timed() && !rows[place].error.unit.empty() &&
            std::find(numbered.begin(), numbered.end(), place) == numbered.end())
            numbered.push_back(place);
    std::stable_sort(numbered.begin(), numbered.end(),
                     [&](size_t a, size_t b) { return rows[a].times.median < rows[b].times.median; });
    return numbered;
}

std::optional<std::string> slide_plot(const BenchTopic& topic, std::span<const BenchRow> rows, bool is_quick) {
    const std::vector<size_t> scene = chief_scene(rows);
    const PlotStyle style{.size = topic.sweeps ? glm::ivec2(740, 536) : glm::ivec2(1136, 460),
                          .title = 24,
                          .axes = 24,
                          .names = 24,
                          .all_names = !topic.sweeps,
                          .note = is_quick ? "quick run" : ""};
    return scene_plot(topic, rows, scene, style, topic.name);
}

std::optional<std::string> scene_plot(const BenchTopic& topic, std::span<const BenchRow> rows,
                                      const std::vector<size_t>& scene, const PlotStyle& style,
                                      const std::string& name) {
    const std::string script = topic.sweeps ? sweep_script(rows, scene, style) : ScenePlot(rows, scene, style).script();
    return script.empty() ? "" : run_gnuplot(script, name, topic.question);
}

}  // namespace relief::measure
