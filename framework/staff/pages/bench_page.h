// The page of `relief bench`: the question, answer and plot of each topic, then all scenes with their plots and
// tables, and pictures of measured points.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "framework/staff/measure/rows.h"

namespace relief::pages {

struct TopicResult {
    const measure::BenchTopic* topic = nullptr;
    std::vector<measure::BenchRow> rows;
    measure::BenchMachine machine;
    std::string plot;  ///< for a slide, as SVG; empty without gnuplot
    /// The plots of a scene for wide and for narrow screens.
    struct ScenePlot {
        std::string broad, narrow;
    };
    std::vector<ScenePlot> scenes;
};

/// Draws the topic's plots. Returns false without gnuplot.
bool draw_plots(TopicResult& result);

/// Returns the page. `before` is the previous page, or empty: its sections of other topics are kept unchanged. `put`
/// writes a picture under the given name beside the page.
std::string bench_page(std::span<const TopicResult> results,
                       const std::function<void(const std::string& name, const Image& picture)>& put,
                       const std::string& before = {});

}  // namespace relief::pages
