// Plots by gnuplot, as SVG that a page can embed.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace relief::measure {

constexpr const char *gnuplot_text_color = "#23211d", *gnuplot_grid_color = "#dcd6ca";

/// Returns the text as a quoted gnuplot string.
std::string gnuplot_text(const std::string& text);

/// The size of a plot, and the font sizes of its title, axes and names, in pixels.
struct PlotStyle {
    glm::ivec2 size;
    int title, axes, names;             ///< title 0: the plot has none
    bool all_names = false;             ///< also name the pale points
    std::string note = {};              ///< after the title, or without one below the plot: "quick run"
    std::vector<size_t> numbered = {};  ///< rows whose names are their places in this list, from 1 on
};

/// Distances of a plot's axes from the edges of its picture, in pixels. gnuplot leaves a name of an axis out if it has
/// no room.
struct PlotMargins {
    double left, right, top, bottom;

    /// Returns the size of the plot without its title, axes and numbers, in a picture of `size`.
    glm::dvec2 inside(glm::ivec2 size) const { return glm::dvec2(size) - glm::dvec2(left + right, top + bottom); }
};
/// Returns margins with room for a title and for the names and numbers of the axes. `letters`: of the longest number at
/// the left axis; 0: there is none. `right`: pixels.
PlotMargins plot_margins(const PlotStyle& style, size_t letters, double right);

/// Returns the script for a plot with the look of all plots. `commands` draw it.
std::string gnuplot_script(const PlotStyle& style, const PlotMargins& margins, const std::string& title,
                           const std::string& commands);

/// Returns "('0.1' 0.1, '1' 1, '10⁴' 10000)": labels for at most `most` of the powers of ten from `low` to `high`.
std::string decade_tics(double low, double high, double most);
/// Returns the number of letters of the longest such label.
size_t longest_decade(double low, double high);

/// Runs a script and returns the SVG. Labels with a hypertext "#17 its name" become elements `class="point"
/// data-row="17"` with the name as their title. Names of elements begin with `name`, so that a page can hold several
/// plots. `title` names the whole plot for a screen reader. Returns nothing if gnuplot is not installed; throws Error
/// if it fails.
std::optional<std::string> run_gnuplot(const std::string& script, const std::string& name, const std::string& title);

}  // namespace relief::measure
