#include "framework/staff/pages/export_pictures.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/course/pages/check_figures.h"
#include "framework/course/pages/page.h"
#include "framework/library/maps/resample.h"

namespace relief::pages {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr int max_export_width = 192;

/// Returns the picture with at most max_export_width columns.
Image shrunk(const Image& picture) {
    if (picture.width <= max_export_width) return picture;
    Image small = resampled(picture, max_export_width,
                            std::max(1, picture.height * max_export_width / std::max(picture.width, 1)));
    small.bits = picture.bits;
    return small;
}

}  // namespace

std::vector<grade::ExportPicture> export_pictures(const std::vector<grade::CheckPictures>& pictures) {
    std::vector<grade::ExportPicture> result;
    size_t bytes = 0;
    for (const grade::CheckPictures& one : pictures) {
        if (one.hidden_view || one.check.hidden) continue;
        const CheckInfo& check = one.check;
        const ProbeInfo* const probe = check.shot.probe ? &one.manifest->probe(check.shot.probe.name) : nullptr;
        const ComparedImages shown = compare_images(probe, one.drawn, one.expected, largest_limit(check.limits));
        std::vector<grade::ExportPicture> of_check;
        size_t more = 0;
        for (const auto& [image, label] : {std::pair(&shown.drawn, "yours"),
                                           {&shown.expected, "expected"},
                                           {&shown.difference, "where they differ"}}) {
            if (image->pixel_count() == 0) continue;
            of_check.push_back({one.lab, check.task, check.name, label, picture_uri(shrunk(*image))});
            more += of_check.back().uri.size();
        }
        if (bytes + more > max_export_bytes) break;
        bytes += more;
        result.insert(result.end(), of_check.begin(), of_check.end());
    }
    return result;
}

fs::path pictures_file(const std::string& name) { return fs::path("pictures") / (grade::file_name_of(name) + ".json"); }

void write_pictures(const fs::path& file, const std::vector<grade::ExportPicture>& pictures) {
    ordered_json json = ordered_json::array();
    for (const grade::ExportPicture& one : pictures)
        json.push_back(
            {{"lab", one.lab}, {"task", one.task}, {"check", one.check}, {"label", one.label}, {"uri", one.uri}});
    make_folder(file.parent_path());
    write_file(file, json.dump(0, ' ', false, ordered_json::error_handler_t::replace) + "\n");
}

std::vector<grade::ExportPicture> read_pictures(const fs::path& file) {
    if (!fs::exists(file)) return {};
    std::vector<grade::ExportPicture> pictures;
    try {
        const ordered_json json = ordered_json::parse(read_file(file, 2 * max_export_bytes));
        for (const ordered_json& one : json)
            pictures.push_back({one.at("lab"), one.at("task"), one.at("check"), one.at("label"), one.at("uri")});
    } catch (const ordered_json::exception&) {  // another program's file: the marks count without pictures
        return {};
    }
    return pictures;
}

}  // namespace relief::pages
