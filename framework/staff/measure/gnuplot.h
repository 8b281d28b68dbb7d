// Plots by gnuplot: panels side by side in one SVG that a page can hold.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>

namespace relief {

constexpr const char* gnuplot_text_color = "#23211d";

/// The text as a string of gnuplot's.
std::string gnuplot_text(const std::string& text);

/// Where a panel's plot lies: pixels.
struct GnuplotPanel {
    glm::ivec2 size;
    int below = 60;        ///< what of it lies under the axis
    int least_columns = 2;  ///< room for so many panels beside each other, also where there are fewer
    int most_columns = 4;
};

/// A script of panels under a title, each panel the commands of one plot.
std::string gnuplot_panels(const std::string& title, std::span<const std::string> panels, const GnuplotPanel& panel);

/// How large a panel is, and the letters of its title, its axes and its names.
struct PanelStyle {
    glm::ivec2 size{440, 340};
    int title = 12, axes = 11, names = 9;
    bool all_names = false;  ///< also of the pale points
};

/// A script of one panel.
std::string gnuplot_panel(const std::string& panel, const PanelStyle& style);

/// Runs a script. Labels with a hypertext "#17 its name" become elements `class="point" data-row="17"` with the name as
/// their title; names of elements begin with `name`, so that a page can hold several plots. Nothing if gnuplot is not
/// installed; throws Error if it fails.
std::optional<std::string> run_gnuplot(const std::string& script, const std::string& name);

}  // namespace relief
