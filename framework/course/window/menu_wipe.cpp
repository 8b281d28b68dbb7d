#include "framework/course/window/menu_wipe.h"

#include <algorithm>
#include <string>

#include "framework/course/window/menu_style.h"

namespace relief::window {
namespace {

/// Returns the knobs of `one` that differ in `other`, such as "steps=8, method=steep".
std::string difference(const Shot& one, const Shot& other) {
    std::string list;
    for (const auto& knob : one.set)
        if (std::find(other.set.begin(), other.set.end(), knob) == other.set.end())
            list += (list.empty() ? "" : ", ") + knob.first + "=" + knob.second;
    return list;
}

void draw_name(const char* name, const std::string& difference, ImVec2 at, float from, float to, bool at_right) {
    const std::string line = std::string(name) + (difference.empty() ? "" : ": " + difference);
    const float width = std::max(40.0f, to - from - 24);
    const ImVec2 size = ImGui::CalcTextSize(line.c_str(), nullptr, false, width);
    if (at_right) at.x -= size.x + 12;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.PushClipRect({from, at.y}, {to, at.y + size.y + 8});
    list.AddRectFilled(at, {at.x + size.x + 12, at.y + size.y + 8}, IM_COL32(16, 17, 20, 255));
    list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {at.x + 6, at.y + 4}, IM_COL32_WHITE, line.c_str(), nullptr,
                 width);
    list.PopClipRect();
}

}  // namespace

void Wipe::hold(const Stage& stage) {
    const Shot shot = stage.settings();
    held_.emplace();
    held_->open(stage.entry(), &shot);
}

void Wipe::swap(Stage& stage) {
    if (!held_) return;
    Shot a = held_->settings();
    const Shot b = stage.settings();
    a.camera = b.camera, a.probe = b.probe;
    held_->apply(b);
    stage.apply(a);
}

void Wipe::draw(Stage& stage, glm::ivec2 size, double time, bool drawn) {
    if (!held_) return;
    if (!(held_->camera() == stage.camera())) held_->camera() = stage.camera(), held_->changed();
    if (!(held_->probe() == stage.probe())) held_->show(stage.probe());
    if (held_->draw(size, time) || drawn) show_alike(*held_, stage);
}

void Wipe::draw_border(const Box& picture, float scale, const Stage& stage) {
    if (!held_) return;
    const auto left = float(picture.at.x), top = float(picture.at.y);
    const auto right = float(picture.right()), bottom = float(picture.bottom());
    float x = left + float(columns(picture.size.x));
    const Shot a = held_->settings(), b = stage.settings();
    if (x - left > 20) draw_name("A", difference(a, b), {left, top}, left, x, false);
    if (right - x > 20) draw_name("B", difference(b, a), {right, top}, x, right, true);
    if (drag_border("wipe", x, top, bottom, scale, true))
        border_ = std::clamp((x - left) / float(std::max(1, picture.size.x)), 0.0f, 1.0f);
}

}  // namespace relief::window
