// Plots by gnuplot: panels side by side in one SVG that a page can embed.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace relief::measure {

constexpr const char* gnuplot_text_color = "#23211d";

/// Returns the text as a quoted gnuplot string.
std::string gnuplot_text(const std::string& text);

/// The layout of a panel, in pixels.
struct GnuplotPanel {
    glm::ivec2 size;
    int below = 60;         ///< height of the part below the axis
    int least_columns = 2;  ///< minimum number of columns, even for fewer panels
    int most_columns = 4;
};

/// Returns a script of panels under a title. Each panel holds the commands of one plot.
std::string gnuplot_panels(const std::string& title, std::span<const std::string> panels, const GnuplotPanel& panel);

/// The size of a panel, and the font sizes of its title, axes and names.
struct PanelStyle {
    glm::ivec2 size{440, 340};
    int title = 12, axes = 11, names = 9;
    bool all_names = false;             ///< also name the pale points
    bool direct_names = false;          ///< name the curves of a sweep at their ends instead of in a legend
    std::string note = {};              ///< after the title, such as "quick run"
    std::vector<size_t> numbered = {};  ///< rows whose names are their places in this list, from 1 on
    int legend = 0;                     ///< height of a legend below the axis, as part of `size`
};

/// Returns a script of one panel.
std::string gnuplot_panel(const std::string& panel, const PanelStyle& style);

/// Runs a script and returns the SVG. Labels with a hypertext "#17 its name" become elements `class="point"
/// data-row="17"` with the name as their title. Names of elements begin with `name`, so that a page can hold several
/// plots. `title` names the whole plot for a screen reader. Returns nothing if gnuplot is not installed; throws Error
/// if it fails.
std::optional<std::string> run_gnuplot(const std::string& script, const std::string& name, const std::string& title);

}  // namespace relief::measure
