// Small pictures of failed checks for the systems that show them: PrairieLearn and Gradescope.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "framework/staff/class/exports.h"
#include "framework/staff/grade/marks.h"

namespace relief::pages {

/// Upper bound of the pictures of a submission together, in bytes of base64. PrairieLearn takes 1 MB in all.
constexpr size_t max_export_bytes = 600'000;

/// Returns three pictures of each check in `pictures`: submitted, expected, and where they differ. Omits hidden checks
/// and hidden views. If the pictures would be too large together, the later checks have none.
std::vector<grade::ExportPicture> export_pictures(const std::vector<grade::CheckPictures>& pictures);

/// Returns the path of a submission's pictures, relative to the folder of all results.
std::filesystem::path pictures_file(const std::string& name);

/// Keep the pictures of a submission in a file, since the exports are written when its images are gone.
void write_pictures(const std::filesystem::path& file, const std::vector<grade::ExportPicture>& pictures);
/// Returns no pictures if there is no file, or not one that write_pictures() has written.
std::vector<grade::ExportPicture> read_pictures(const std::filesystem::path& file);

}  // namespace relief::pages
