#include "framework/course/window/menu_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "framework/core/base/error.h"
#include "framework/course/pages/check_figures.h"
#include "framework/course/window/menu_check_list.h"
#include "framework/course/window/menu_checks.h"
#include "framework/course/window/menu_stage.h"
#include "framework/course/window/menu_style.h"

namespace relief::window {
namespace {

struct StateSign {
    const char* sign;
    const char* help;
    ImVec4 color;
};

/// Returns a sign that shows whether the picture uses the shaders that were saved since the lab was opened; nothing if
/// none was saved.
std::optional<StateSign> shader_sign(ShaderState state) {
    switch (state) {
        case ShaderState::renewed:
            return StateSign{"new", "Shaders were saved since the lab was opened, and are on screen.", good};
        case ShaderState::failed:
            return StateSign{"failed", "The last saved shader has an error; the picture is older.", alarm};
        case ShaderState::unchanged:
            break;
    }
    return {};
}

float button_width(const char* label) { return ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x; }

void draw_tasks(const Checks& checks, float right, MenuWish& wish) {
    const auto& tasks = checks.manifest().tasks;
    if (tasks.empty()) return;
    const std::string points = checks.pending() ? "checking " + checks.progress() : checks.points();
    float width = ImGui::CalcTextSize(points.c_str()).x + ImGui::GetStyle().ItemSpacing.x * 2;
    std::vector<std::string> lines;
    for (const TaskInfo& task : tasks) {
        lines.push_back(fmt::format("{} {}", task.id, sign_of(checks.worst(task)).sign));
        width += ImGui::CalcTextSize(lines.back().c_str()).x + ImGui::GetStyle().ItemSpacing.x * 1.5f;
    }
    // Without room for all tasks, show only the points; the panel lists all tasks.
    const bool all = ImGui::GetCursorPosX() + width < right;
    for (size_t i = 0; all && i < tasks.size(); ++i) {
        const std::optional<check::Outcome> worst = checks.worst(tasks[i]);
        ImGui::TextColored(sign_of(worst).color, "%s", lines[i].c_str());
        tooltip(fmt::format("Task {}, {}, {}: {}. A click opens its checks.", tasks[i].id, tasks[i].title,
                            worst ? pages::outcome_words(*worst) : "being checked",
                            check::points_text(checks.of(tasks[i]))));
        if (ImGui::IsItemClicked()) wish.ask(LabAction::show_tasks);
        ImGui::SameLine(0, ImGui::GetStyle().ItemSpacing.x * 1.5f);
    }
    if (ImGui::GetCursorPosX() + ImGui::CalcTextSize(points.c_str()).x < right) {
        ImGui::TextColored(checks.pending() ? quiet : ImGui::GetStyle().Colors[ImGuiCol_Text], "%s", points.c_str());
        tooltip(
            "The points of this lab's public checks, as relief check gives them. They run again when a file is "
            "saved.");
        if (ImGui::IsItemClicked()) wish.ask(LabAction::show_tasks);
        ImGui::SameLine();
    }
}

}  // namespace

const std::string& title_of(const LabEntry& lab) {
    static std::map<const LabEntry*, std::string> titles;  // cached: reading a manifest reads a file
    auto found = titles.find(&lab);
    if (found == titles.end()) {
        std::string title = lab.name;
        try {
            title = load_manifest(lab).title;
        } catch (const Error&) {  // opening that lab reports the error
        }
        found = titles.emplace(&lab, lab.two_digits() + "  " + title).first;
    }
    return found->second;
}

void draw_header(const Box& box, float scale, const Stage& stage, const Checks& checks, MenuWish& wish) {
    if (box.size.y == 0) return;
    begin_in(box, "header", {14 * scale, 8 * scale}, false);

    if (registry().size() > 1) {
        if (ImGui::Button("Labs")) wish.ask(WindowAction::open_labs);
        tooltip("All labs, with a picture and the points of each (Home).");
        ImGui::SameLine();
    }
    if (ImGui::ArrowButton("before", ImGuiDir_Left)) wish.ask(WindowAction::previous_lab);
    tooltip("The lab before (left, Page Up).");
    ImGui::SameLine(0, 4 * scale);
    ImGui::SetNextItemWidth(std::min(260 * scale, float(box.size.x) * 0.3f));
    if (ImGui::BeginCombo("##labs", title_of(stage.entry()).c_str(), ImGuiComboFlags_HeightLarge)) {
        for (const LabEntry& lab : registry())
            if (ImGui::Selectable(title_of(lab).c_str(), &lab == &stage.entry())) wish.lab = &lab;
        ImGui::EndCombo();
    }
    std::string learns = "What this lab is for:";
    for (const std::string& line : stage.manifest().learns) learns += "\n\u2022 " + line;
    if (!stage.manifest().learns.empty() && !ImGui::IsItemActive()) tooltip(learns);
    ImGui::SameLine(0, 4 * scale);
    if (ImGui::ArrowButton("next", ImGuiDir_Right)) wish.ask(WindowAction::next_lab);
    tooltip("The next lab (right, Page Down).");

    const float spacing = ImGui::GetStyle().ItemSpacing.x;
    const std::optional<StateSign> shaders = shader_sign(stage.shaders());
    const bool narrow = float(box.size.x) < 1000 * scale;
    const std::string state = shaders ? fmt::format("{}{}", narrow ? "" : "shaders: ", shaders->sign) : "";
    float right = float(box.size.x) - 14 * scale;
    for (const char* label : {"?", "Search", "Handout"}) right -= button_width(label) + spacing;
    const float state_at = right - ImGui::CalcTextSize(state.c_str()).x - spacing;

    ImGui::SameLine(0, 2 * spacing);
    ImGui::AlignTextToFramePadding();
    draw_tasks(checks, state_at - spacing, wish);
    if (shaders) {
        ImGui::SameLine(state_at);
        ImGui::AlignTextToFramePadding();
        ImGui::TextColored(shaders->color, "%s", state.c_str());
        tooltip(shaders->help);
    }
    ImGui::SameLine(right + spacing / 2);
    if (ImGui::Button("Handout")) wish.ask(LabAction::toggle_handout);
    tooltip("The lab's handout, beside the picture (F1).");
    ImGui::SameLine();
    if (ImGui::Button("Search")) wish.ask(WindowAction::open_search);
    tooltip(
        "Finds a lab, a knob or one of its values, a probe, a check, a heading of a handout or a word of the glossary "
        "(Ctrl+F, /).");
    ImGui::SameLine();
    if (ImGui::Button("?")) wish.ask(WindowAction::toggle_help);
    tooltip("All keys (?).");
    ImGui::End();
}

}  // namespace relief::window
