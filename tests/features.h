// The tables of labs/staff/README.md that say which features of a file are read, noted or refused.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "tests/support.h"

namespace relief {

/// Returns the first two columns of the table with this heading: a feature, and what happens to it.
inline std::vector<std::pair<std::string, std::string>> feature_rows(const std::string& heading) {
    std::vector<std::pair<std::string, std::string>> rows;
    bool is_inside = false;
    for (const std::string& line : split(read_file(course_root() / "labs/staff/README.md"), '\n')) {
        if (line.starts_with("| " + heading + " |"))
            is_inside = true;
        else if (is_inside && !line.starts_with("|"))
            break;
        else if (is_inside && !line.starts_with("|---")) {
            const size_t middle = line.find(" | "), end = line.find(" |", middle + 3);
            rows.emplace_back(line.substr(2, middle - 2), line.substr(middle + 3, end - middle - 3));
        }
    }
    return rows;
}

/// Returns what reading does: "refused" if it throws Error, "noted" if it returns notes, else "read".
inline std::string outcome_of(const std::function<std::vector<std::string>()>& read) {
    try {
        return read().empty() ? "read" : "noted";
    } catch (const Error&) {
        return "refused";
    }
}

/// Cases of each row, by the words with which the row begins.
using FeatureCases = std::map<std::string, std::vector<std::function<std::vector<std::string>()>>>;

/// Expects that each row has cases, that each case belongs to a row, and that each has the outcome of its row.
inline void expect_features(const std::string& heading, const FeatureCases& cases) {
    const auto rows = feature_rows(heading);
    EXPECT_EQ(rows.size(), cases.size()) << heading;
    for (const auto& [feature, outcome] : rows) {
        const auto of_row = [&feature = feature](const auto& one) { return feature.starts_with(one.first); };
        ASSERT_EQ(std::count_if(cases.begin(), cases.end(), of_row), 1) << feature;
        const auto& reads = std::find_if(cases.begin(), cases.end(), of_row)->second;
        EXPECT_FALSE(reads.empty()) << feature;
        for (size_t i = 0; i < reads.size(); ++i) EXPECT_EQ(outcome_of(reads[i]), outcome) << feature << ", case " << i;
    }
}

}  // namespace relief
