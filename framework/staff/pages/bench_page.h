// The results of relief bench as a page: a question, its answer and its plot for each topic, and behind it all scenes,
// tables, and the pictures of the points.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "framework/staff/measure/rows.h"

namespace relief {

struct TopicResult {
    const BenchTopic* topic = nullptr;
    std::vector<BenchRow> rows;
    BenchMachine machine;
    std::string plot;                 ///< all scenes, small, as SVG; empty where there is no gnuplot
    std::string chief, chief_narrow;  ///< the scene that answers the topic's question, for a screen and for a phone
};

/// Draws the topic's plots. False without gnuplot.
bool draw_plots(TopicResult& result);

/// `before` is the page that stands there, or nothing: what it has of other topics stays, as it was drawn then. `put`
/// writes a picture under that name beside the page.
std::string bench_page(std::span<const TopicResult> results,
                       const std::function<void(const std::string& name, const Image& picture)>& put,
                       const std::string& before = {});

}  // namespace relief
