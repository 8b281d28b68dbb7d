#include "framework/staff/measure/gnuplot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "framework/core/base/error.h"
#include "framework/core/base/process.h"
#include "framework/core/base/text.h"

namespace relief::measure {
namespace {

/// Returns "0.01", and "10⁻⁵" where that has fewer letters.
std::string decade_label(int power) {
    if (std::abs(power) < 4) return plain(std::pow(10, power));
    constexpr const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = power < 0 ? "10⁻" : "10";
    for (const char digit : std::to_string(std::abs(power))) text += digits[digit - '0'];
    return text;
}

int first_power(double low) { return int(std::ceil(std::log10(low) - 0.01)); }
int last_power(double high) { return int(std::floor(std::log10(high) + 0.01)); }

/// Removes gnuplot's own script, gives points titles that browsers show, and makes element names unique on a page with
/// several plots.
std::string finished(const std::string& svg, const std::string& topic, const std::string& title) {
    const std::pair<std::string, std::string> names[] = {{"id='gp", "id='" + topic + "-gp"},
                                                         {"href='#gp", "href='#" + topic + "-gp"},
                                                         {"id='textbox", "id='" + topic + "-textbox"},
                                                         {"id='greybox", "id='" + topic + "-greybox"},
                                                         {"id=\"gnuplot", "id=\"" + topic}};
    constexpr std::string_view begin = "<g onmousemove=\"gnuplot_svg.showHypertext(evt,'", middle = "')\"",
                               end = "<title> </title>";
    std::string result;
    for (size_t at = 0; at < svg.size();) {
        const std::string_view rest = std::string_view(svg).substr(at);
        if (rest.starts_with(begin)) {
            const size_t close = rest.find(middle, begin.size()), stop = rest.find(end, close);
            const std::string_view text = rest.substr(begin.size(), close - begin.size());  // "#17 its name"
            const size_t space = text.find(' ');
            result += fmt::format("<g class=\"point\" data-row=\"{}\"><title>{}</title>", text.substr(1, space - 1),
                                  text.substr(space + 1));
            at += stop + end.size();
        } else if (constexpr std::string_view own = "<title>Gnuplot</title>"; rest.starts_with(own)) {
            result += "<title>" + escaped_markup(title) + "</title>";
            at += own.size();
        } else if (rest.starts_with("<title>$")) {  // gnuplot's own name of the plotted data
            at += rest.find("</title>") + 8;
        } else {
            const auto name = std::find_if(std::begin(names), std::end(names),
                                           [&](const auto& one) { return rest.starts_with(one.first); });
            if (name == std::end(names))
                result += svg[at++];
            else
                result += name->second, at += name->first.size();
        }
    }
    return result;
}

}  // namespace

std::string gnuplot_text(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) result += c == '"' || c == '\\' ? '\'' : c == '\n' ? ' ' : c;
    return result + '"';
}

PlotMargins plot_margins(const PlotStyle& style, size_t letters, double right) {
    const double axes = style.axes;
    return {.left = letters > 0 ? (0.7 * double(letters) + 2.8) * axes : axes,
            .right = right,
            .top = style.title > 0 ? 2.8 * style.title : 0.8 * axes,
            .bottom = 4.7 * axes};
}

std::string gnuplot_script(const PlotStyle& style, const PlotMargins& margins, const std::string& title,
                           const std::string& commands) {
    std::string text = fmt::format(
        "set encoding utf8\nset terminal svg size {0},{1} dynamic font 'DejaVu Sans,{2}' background '#ffffff'\n"
        "set lmargin at screen {3:.4f}\nset rmargin at screen {4:.4f}\n"
        "set tmargin at screen {5:.4f}\nset bmargin at screen {6:.4f}\n"
        "set border 3 lc rgb '#8a857b'\nset tics nomirror textcolor rgb '{7}' font ',{2}'\nset key off\n",
        style.size.x, style.size.y, style.axes, margins.left / style.size.x, 1 - margins.right / style.size.x,
        1 - margins.top / style.size.y, margins.bottom / style.size.y, gnuplot_text_color);
    if (style.title > 0) text += fmt::format("set title {} noenhanced font ',{}'\n", gnuplot_text(title), style.title);
    return text + commands;
}

std::string decade_tics(double low, double high, double most) {
    const int first = first_power(low), last = last_power(high);
    const int step = std::max(1, int(std::ceil((last - first) / std::max(1.0, most))));
    std::vector<std::string> all;
    for (int power = first; power <= last; power += step)
        all.push_back(fmt::format("'{}' 1e{}", decade_label(power), power));
    return "(" + join(all, ", ") + ")";
}

size_t longest_decade(double low, double high) {
    size_t longest = 1;
    for (int power = first_power(low); power <= last_power(high); ++power)
        longest = std::max(longest, std::abs(power) < 4 ? decade_label(power).size() : 4);
    return longest;
}

std::optional<std::string> run_gnuplot(const std::string& script, const std::string& name, const std::string& title) {
    const char* const path = std::getenv("PATH");
    const ProcessResult done =
        run_process({.command = {"/usr/bin/env", "gnuplot", "-"},
                     .environment = {{"PATH", path ? path : "/usr/bin:/bin"}, {"LC_ALL", "C.UTF-8"}},
                     .input = script,
                     .limits = {.wall = 120, .cpu = 120}});
    if (done.ending == Ending::exited && done.code == 127) return {};
    if (!done.succeeded())
        throw Error(fmt::format("gnuplot fails ({}): {}", name_of(done.ending), done.errors.substr(0, 300)));
    return finished(done.output, name, title);
}

}  // namespace relief::measure
