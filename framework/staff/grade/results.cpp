#include "framework/staff/grade/results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "framework/core/base/error.h"
#include "framework/core/base/sha256.h"
#include "framework/core/base/text.h"
#include "framework/course/check/verdict_json.h"

namespace relief::grade {
namespace {

using nlohmann::ordered_json;

constexpr int schema = 1;

/// Replaces invalid UTF-8, which untrusted text may contain.
std::string dump(const ordered_json& json) {
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

ordered_json as_json(const LabMark& lab) {
    ordered_json json = {
        {"lab", lab.lab},
        {"points", lab.points()},
        {"of", lab.max_points()},
        {"seconds", {{"compile", lab.times.compile}, {"draw", lab.times.draw}, {"compare", lab.times.compare}}},
        {"log", lab.log},
        {"tasks", ordered_json::array()}};
    for (const check::TaskVerdict& task : lab.tasks) json["tasks"].push_back(check::as_json(task));
    if (!lab.kept.empty()) json["kept"] = lab.kept;
    return json;
}
LabMark lab_from(const ordered_json& json) {
    const ordered_json& seconds = json.at("seconds");
    LabMark lab{.lab = json.at("lab"),
                .tasks = {},
                .log = json.at("log"),
                .times = {seconds.at("compile"), seconds.at("draw"), seconds.at("compare")},
                .kept = json.value("kept", "")};
    for (const ordered_json& task : json.at("tasks")) lab.tasks.push_back(check::task_from(task));
    return lab;
}

}  // namespace

double SubmissionMark::points() const {
    double sum = 0;
    for (const LabMark& one : labs) sum += one.points();
    return sum;
}
int SubmissionMark::max_points() const {
    int sum = 0;
    for (const LabMark& one : labs) sum += one.max_points();
    return sum;
}
bool SubmissionMark::graded() const {
    return std::all_of(labs.begin(), labs.end(), [](const LabMark& one) { return one.graded(); });
}
const LabMark* SubmissionMark::lab(const std::string& folder) const {
    for (const LabMark& one : labs)
        if (one.lab == folder) return &one;
    return nullptr;
}

std::string file_name_of(const std::string& name) {
    std::string plain;
    for (const char c : name.substr(0, 80))
        plain += std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' || (c == '.' && !plain.empty())
                     ? c
                     : '-';
    return plain == name && !name.empty() ? plain : plain + "-" + sha256(name).substr(0, 8);
}

std::string found_for_students(const check::Verdict& check) {
    if (check.hidden) return {};
    return check.view.empty() ? check.found : "correct in the view that you know, but not in another one";
}

std::string to_json(const SubmissionMark& mark) {
    ordered_json json = {{"schema", schema},
                         {"name", utf8_of_bytes(mark.name)},
                         {"graded", mark.graded()},
                         {"problem", mark.problem},
                         {"points", mark.points()},
                         {"of", mark.max_points()},
                         {"hash", mark.hash},
                         {"course", mark.course},
                         {"isolation", mark.isolation},
                         {"seconds", mark.seconds},
                         {"ignored", mark.ignored},
                         {"ignored_count", mark.ignored_count},
                         {"remarks", mark.remarks},
                         {"labs", ordered_json::array()}};
    for (const LabMark& lab : mark.labs) json["labs"].push_back(as_json(lab));
    return dump(json);
}

SubmissionMark from_json(const std::string& text) try {
    const ordered_json json = ordered_json::parse(text);
    if (json.at("schema") != schema) throw Error("its schema is not 1");
    SubmissionMark mark;
    mark.name = bytes_of_utf8(json.at("name").get<std::string>());
    mark.hash = json.at("hash");
    mark.course = json.at("course");
    mark.isolation = json.at("isolation");
    mark.problem = json.at("problem");
    mark.seconds = json.at("seconds");
    mark.ignored = json.at("ignored").get<std::vector<std::string>>();
    mark.ignored_count = json.at("ignored_count");
    mark.remarks = json.value("remarks", mark.remarks);
    for (const ordered_json& lab : json.at("labs")) mark.labs.push_back(lab_from(lab));
    return mark;
} catch (const nlohmann::json::exception&) {
    throw Error("is not a whole result of grading");
}

}  // namespace relief::grade
