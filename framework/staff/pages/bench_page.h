// What relief bench found, as a page that has all it needs: plots, tables, and the pictures behind the points.
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

std::string bench_page(std::span<const TopicResult> results);

}  // namespace relief
