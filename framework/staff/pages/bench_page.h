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

std::string bench_page(std::span<const TopicResult> results);

}  // namespace relief
