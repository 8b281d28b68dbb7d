// Writes zip archives without compression (PKWARE, APPNOTE.TXT 6.3.10).
#pragma once

#include <map>
#include <string>

namespace relief::check {

/// Returns a zip archive of these files, by their paths in it. Equal files give equal bytes: all have the date of
/// 1980-01-01. Precondition: at most 65,535 files, and less than 4 GiB.
std::string stored_zip(const std::map<std::string, std::string>& files);

}  // namespace relief::check
