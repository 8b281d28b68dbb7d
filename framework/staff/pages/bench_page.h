// The results of relief bench as a self-contained page: plots, tables, and the pictures of the points.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "framework/staff/measure/rows.h"

namespace relief {

struct TopicResult {
    const BenchTopic* topic = nullptr;
    std::vector<BenchRow> rows;
    BenchMachine machine;
    std::string plot;  ///< SVG; empty where there is no gnuplot
};

/// `before` is the page that stands there, or nothing: what it has of other topics stays, as it was drawn then.
std::string bench_page(std::span<const TopicResult> results, const std::string& before = {});

}  // namespace relief
