#include "framework/course/window/menu_panel.h"

#include <imgui.h>

#include "framework/course/window/menu_brush.h"
#include "framework/course/window/menu_check_list.h"
#include "framework/course/window/menu_imgui.h"
#include "framework/course/window/menu_knobs.h"
#include "framework/course/window/menu_stage.h"
#include "framework/course/window/menu_style.h"
#include "framework/library/kit/made_map.h"

namespace relief::window {
namespace {

void draw_probes(Stage& stage, bool error_map, MenuWish& wish) {
    const auto& probes = stage.manifest().probes;
    if (probes.empty() || !ImGui::CollapsingHeader("Look at", ImGuiTreeNodeFlags_DefaultOpen)) return;
    if (ImGui::RadioButton("picture", !stage.probe())) stage.show({});
    tooltip("The lab's picture.");
    for (const ProbeInfo& probe : probes) {
        ImGui::SameLine();
        const float wanted = ImGui::CalcTextSize(probe.name.c_str()).x + 2 * ImGui::GetFrameHeight();
        if (ImGui::GetContentRegionAvail().x < wanted) ImGui::NewLine();
        if (ImGui::RadioButton(probe.name.c_str(), stage.probe().name == probe.name)) stage.show({probe.name});
        tooltip("This quantity as the shader computes it, in place of the picture" +
                (probe.unit.empty() ? "." : "; its unit is the " + probe.unit + "."));
    }
    if (ImGui::Checkbox("error map beside it", &error_map)) wish.ask(LabAction::toggle_error_map);
    tooltip("How far the probe is from its exact value, at each pixel (E).");
}

}  // namespace

bool Panel::begin_tab(const char* name) {
    const bool wanted = wanted_ == name;
    if (wanted) wanted_.clear();
    return ImGui::BeginTabItem(name, nullptr, wanted ? ImGuiTabItemFlags_SetSelected : 0);
}

void Panel::draw(const Box& box, Stage& stage, Motion& motion, const Checks& checks, const std::string& check,
                 bool error_map, Brush& brush, MenuWish& wish) {
    if (box.size.x == 0) return;
    begin_in(box, "panel", ImGui::GetStyle().WindowPadding, false);
    if (ImGui::BeginTabBar("tabs")) {
        // Each tab scrolls by itself, below the tab bar.
        const auto scrolled = [&](const char* name, auto contents) {
            if (!begin_tab(name)) return;
            begin_reachable_child(name);
            contents();
            ImGui::EndChild();
            ImGui::EndTabItem();
        };
        scrolled("Knobs", [&] {
            if (!stage.lab()) return;
            const bool paints = brush.is_on();  // its settings are then at hand
            if (paints) brush.draw(stage, wish);
            draw_probes(stage, error_map, wish);  // above the knobs, which may be more than the panel holds
            ImGui::Dummy({0, 6});
            draw_knobs(stage, motion, seek_);
            ImGui::Dummy({0, 6});
            if (!paints) brush.draw(stage, wish);
            if (dynamic_cast<MapMaker*>(stage.lab())) {
                if (ImGui::Button("Save map")) wish.ask(LabAction::save_map);
                tooltip("Saves the map that the lab makes, as PNG of 16 bits, under a new name (M).");
            }
        });
        scrolled("Checks", [&] { draw_check_list(checks, check, wish); });
        ImGui::EndTabBar();
    }
    if (ImGui::IsWindowAppearing()) ImGui::SetWindowFocus(nullptr);
    ImGui::End();
}

}  // namespace relief::window
