#include "framework/course/window/menu_check_list.h"

#include <fmt/format.h>

#include "framework/core/base/error.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/source_text.h"
#include "framework/core/base/text.h"
#include "framework/course/pages/check_figures.h"
#include "framework/course/pages/check_page.h"
#include "framework/course/pages/markdown.h"
#include "framework/course/task/task_text.h"
#include "framework/course/window/menu_checks.h"
#include "framework/course/window/menu_imgui.h"
#include "framework/course/window/menu_style.h"
#include "framework/course/window/menu_text.h"

namespace relief::window {

Sign sign_of(const std::optional<check::Outcome>& outcome) {
    if (!outcome) return {"\u25cb", quiet};
    switch (*outcome) {
        case check::Outcome::passed:
            return {"\u2713", good};
        case check::Outcome::unfinished:
        case check::Outcome::unproven:
        case check::Outcome::waiting:
            return {"\u2026", amber};
        case check::Outcome::wrong:
            return {"\u2717", alarm};
        default:
            return {"!", alarm};
    }
}

namespace {

/// Returns the line of the task's first function in its file; 0 if it has none or the file is missing.
int line_of(const TaskInfo& task) {
    try {
        return check::line_of_task(read_source(course_root() / task.file), task);
    } catch (const Error&) {  // the editor reports the missing file
        return 0;
    }
}

/// A selectable that wraps over several lines.
bool wrapped_selectable(const std::string& line, bool is_chosen) {
    const ImVec2 at = ImGui::GetCursorPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const float height = ImGui::CalcTextSize(line.c_str(), nullptr, false, width).y;
    const bool pressed = ImGui::Selectable(("##" + line).c_str(), is_chosen, 0, {0, height});
    const ImVec2 below = ImGui::GetCursorPos();
    ImGui::SetCursorPos(at);
    wrapped(line);
    ImGui::SetCursorPos(below);
    return pressed;
}

void draw_hint(const std::string& hint) {
    pages::Spans spans = pages::line_with_code(hint);
    spans.insert(spans.begin(), {.text = "Look at: "});
    wrapped(spans, accent);
}

void draw_result(const CheckInfo& check, const check::Verdict& result) {
    ImGui::Indent();
    wrapped(pages::outcome_words(result.outcome) + ": " + result.found);
    if (result.outcome == check::Outcome::wrong && !check.reason.empty()) quiet_text("Why this limit: " + check.reason);
    if (const std::string hint = pages::look_at(result); !hint.empty() && result.outcome != check::Outcome::passed)
        draw_hint(hint);
    ImGui::Unindent();
}

/// Draws a check's sign and its name, and below a failing one the reason. A click chooses it.
void draw_check(const CheckInfo& check, const std::optional<check::Verdict>& result, bool waits, bool is_chosen,
                MenuWish& wish) {
    const Sign sign = sign_of(result ? std::optional(result->outcome) : std::nullopt);
    ImGui::TextColored(waits ? quiet : sign.color, "%s", sign.sign);
    ImGui::SameLine(ImGui::CalcTextSize("\u2713").x + ImGui::GetStyle().WindowPadding.x +
                    ImGui::GetStyle().ItemSpacing.x);
    if (wrapped_selectable(check.name, is_chosen)) wish.check = is_chosen ? "" : check.name;
    if (!result) return;
    if (is_chosen) return draw_result(check, *result);
    if (result->outcome < check::Outcome::wrong || result->outcome == check::Outcome::unfinished ||
        !check::reason_to_wait(*result).empty())
        return;
    ImGui::Indent();
    quiet_text(result->found);
    if (ImGui::IsItemClicked()) wish.check = check.name;
    ImGui::Unindent();
}

}  // namespace

void draw_check_list(const Checks& checks, const std::string& chosen, MenuWish& wish) {
    const Manifest& manifest = checks.manifest();
    if (manifest.checks.empty()) {
        quiet_text("This lab has no checks.");
        return;
    }
    quiet_text(checks.pending() ? fmt::format("Checking {} ...", checks.progress())
                                : "Choose a check to see yours, the expected picture and the error.");
    if (!checks.to_build().empty())
        colored_text(amber, fmt::format("{} was saved. C++ needs a build: close the window and use ./relief run {}.",
                                        checks.to_build(), checks.lab().two_digits()));
    for (const TaskInfo& task : manifest.tasks) {
        ImGui::Dummy({0, 4});
        push_font(font(FontRole::bold));
        wrapped(fmt::format("{}  {}{}", task.id, task.title, task.optional ? " (optional)" : ""));
        ImGui::PopFont();
        const bool is_whole = checks.worst(task) == check::Outcome::passed;
        colored_text(is_whole ? good : quiet, check::points_text(checks.of(task)));
        ImGui::SameLine();
        const float edit_width = ImGui::CalcTextSize("edit").x + 2 * ImGui::GetStyle().FramePadding.x;
        if (ImGui::GetContentRegionAvail().x < edit_width) ImGui::NewLine();
        ImGui::PushID(task.id.c_str());
        if (ImGui::SmallButton("edit")) wish.edit = {task.file, line_of(task)};
        ImGui::PopID();
        tooltip("Opens " + task.file + " in your editor: VISUAL, EDITOR, or the desktop's.");
        if (const std::string hint = checks.hint(task); !hint.empty()) draw_hint(hint);
        std::vector<size_t> indices;  // of the results
        std::vector<const check::Verdict*> results;
        for (size_t i = 0; i < manifest.checks.size(); ++i) {
            const CheckInfo& check = manifest.checks[i];
            if (check.task != task.id) continue;
            const auto& result = checks.result(i);
            if (result && check.name != chosen && !check::reason_to_wait(*result).empty())
                indices.push_back(i), results.push_back(&*result);
            else
                draw_check(check, result, checks.waits(i), check.name == chosen, wish);
        }
        for (const auto& [reason, waiting] : check::waiting_checks(results)) {
            quiet_text(check::count_of_checks(waiting.size()) + ": " + reason);
            if (!ImGui::TreeNode((task.id + reason).c_str(), "show them")) continue;
            for (const size_t i : waiting)
                draw_check(manifest.checks[indices[i]], checks.result(indices[i]), checks.waits(indices[i]), false,
                           wish);
            ImGui::TreePop();
        }
    }
}

}  // namespace relief::window
