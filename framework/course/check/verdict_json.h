// Verdicts as JSON, with the same fields in `relief check --json` and in the grader's results.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "framework/course/check/verdict.h"

namespace relief::check {

/// Returns a task's verdict: "id", "title", "file", "points", "of", "waiting" (points of checks that wait), "mistake"
/// (the id of the known mistake, unknown in a student's course), "hint" (its hint), and "checks". A check has "name",
/// "outcome" (see name_of()), "found", "details", "further" (messages that often follow from the first), "waits_for"
/// (tasks), "look_at" (the hint), "view" (a hidden view) and "hidden".
nlohmann::ordered_json as_json(const TaskVerdict& task);

/// Reads a task's verdict. Throws nlohmann::json::exception for other JSON, and Error if the points do not follow from
/// the checks.
TaskVerdict task_from(const nlohmann::ordered_json& json);

}  // namespace relief::check
