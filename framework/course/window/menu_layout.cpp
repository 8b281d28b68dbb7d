#include "framework/course/window/menu_layout.h"

#include <algorithm>

#include "framework/course/window/menu_style.h"

namespace relief::window {
namespace {

constexpr float legend_height = 104;  // pixels at scale 1: four lines

}  // namespace

Layout Borders::layout(glm::ivec2 window, float scale, Shown shown) const {
    Layout layout;
    const int header = shown.panel ? int(header_height(scale)) : 0,
              status = shown.panel ? int(status_height(scale)) : 0;
    layout.header.size = {window.x, std::min(header, window.y)};
    layout.status.size = {window.x, std::min(status, window.y)};
    layout.status.at = {0, window.y - layout.status.size.y};
    const int height = std::max(1, window.y - header - status);
    // The picture keeps at least a third of the window's width.
    const int most = window.x * 2 / 3;
    int panel = shown.panel ? std::min(int(panel_ * scale), most) : 0;
    int handout = shown.handout ? std::min(int(handout_ * scale), most) : 0;
    if (panel + handout > most) {
        const float share = float(most) / float(panel + handout);
        panel = int(float(panel) * share), handout = int(float(handout) * share);
    }
    layout.panel = {{0, header}, {panel, height}};
    layout.handout = {{window.x - handout, header}, {handout, height}};
    const int legend = shown.legend ? std::min(int(legend_height * scale), height / 2) : 0;
    layout.picture = {{panel, header}, {std::max(1, window.x - panel - handout), std::max(1, height - legend)}};
    layout.legend = {{panel, layout.picture.bottom()}, {layout.picture.size.x, legend}};
    return layout;
}

void Borders::drag(const Layout& layout, float scale) {
    const auto clamped = [&](float width) { return std::clamp(width / scale, 200.0f, 4000.0f); };
    const auto top = float(layout.picture.at.y), bottom = float(layout.picture.bottom());
    if (layout.panel.size.x > 0) {
        auto x = float(layout.panel.right());
        if (drag_border("panel border", x, top, bottom, scale, false)) panel_ = clamped(x);
    }
    if (layout.handout.size.x > 0) {
        auto x = float(layout.handout.at.x);
        if (drag_border("handout border", x, top, bottom, scale, false))
            handout_ = clamped(float(layout.handout.right()) - x);
    }
}

void begin_in(const Box& box, const char* name, ImVec2 padding, bool scrolls) {
    ImGui::SetNextWindowPos({float(box.at.x), float(box.at.y)});
    ImGui::SetNextWindowSize({float(box.size.x), float(box.size.y)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::Begin(
        name, nullptr,
        scrolls ? fixed_window & ~ImGuiWindowFlags_NoScrollbar : fixed_window | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleVar(2);
}

bool drag_border(const char* name, float& x, float top, float bottom, float scale, bool with_handle) {
    const float reach = 5 * scale;  // how close the mouse must be
    ImGui::SetNextWindowPos({x - reach, top});
    ImGui::SetNextWindowSize({2 * reach, bottom - top});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::Begin(name, nullptr,
                 (fixed_window & ~ImGuiWindowFlags_NoBringToFrontOnFocus) | ImGuiWindowFlags_NoBackground |
                     ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PopStyleVar(2);
    ImGui::InvisibleButton("border", {2 * reach, bottom - top});
    const bool active = ImGui::IsItemActive(), hot = active || ImGui::IsItemHovered();
    if (hot) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (hot || with_handle) {
        const ImU32 color = hot ? ImGui::ColorConvertFloat4ToU32(accent) : IM_COL32(255, 255, 255, 230);
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.AddRectFilled({x - scale, top}, {x + scale, bottom}, color);
        if (with_handle) {
            const float middle = (top + bottom) / 2;
            list.PushClipRectFullScreen();
            list.AddCircleFilled({x, middle}, 2 * reach, color);
            list.AddCircle({x, middle}, 2 * reach, IM_COL32(0, 0, 0, 160));
            list.PopClipRect();
        }
    }
    ImGui::End();
    const float moved = active ? ImGui::GetIO().MousePos.x - x : 0;
    if (moved == 0) return false;
    x += moved;
    return true;
}

}  // namespace relief::window
