// The staff's page of submissions that share code: pairs side by side, and clusters.
#pragma once

#include <filesystem>
#include <string>

#include "framework/staff/originality/originality.h"

namespace relief::pages {

/// The number of pairs whose texts are on the page. originality.csv lists all.
constexpr size_t pairs_on_page = 200;

std::string originality_page(const grade::OriginalityReport& report);

/// Writes originality.html, originality.csv and originality.json into a folder. Only their owner can read them.
void write_originality(const grade::OriginalityReport& report, const std::filesystem::path& folder);

}  // namespace relief::pages
