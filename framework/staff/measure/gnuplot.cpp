#include "framework/staff/measure/gnuplot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "framework/core/base/error.h"
#include "framework/core/base/process.h"
#include "framework/core/base/text.h"

namespace relief::measure {
namespace {

constexpr int title_height = 44;

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

std::string gnuplot_panels(const std::string& title, std::span<const std::string> panels, const GnuplotPanel& panel) {
    const int count = int(panels.size());
    const int columns = std::min({count, panel.most_columns, count <= 4 ? 2 : count <= 9 ? 3 : 4});
    const int lines = (count + columns - 1) / columns;
    const int width = std::max(columns, panel.least_columns) * panel.size.x,
              height = lines * panel.size.y + title_height;
    std::string script = fmt::format(
        "set terminal svg size {0},{1} dynamic font 'DejaVu Sans,11' background '#ffffff'\n"
        "set multiplot layout {2},{3} margins screen {4},{5},{6},{7} spacing screen {8},{9} title {10} noenhanced font "
        "',14'\n",
        width, height, lines, columns, 90.0 / width, 1 - 44.0 / width, double(panel.below) / height,
        1 - (title_height + 34.0) / height, 90.0 / width, (panel.below + 40.0) / height, gnuplot_text(title));
    for (const std::string& one : panels) script += one;
    return script + "unset multiplot\n";
}

std::string gnuplot_panel(const std::string& panel, const PanelStyle& style) {
    return fmt::format("set terminal svg size {},{} dynamic font 'DejaVu Sans,{}' background '#ffffff'\n{}",
                       style.size.x, style.size.y, style.axes, panel);
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
