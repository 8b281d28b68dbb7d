#include "framework/course/window/menu_knobs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "framework/core/base/error.h"
#include "framework/core/base/text.h"
#include "framework/core/lab/lab.h"
#include "framework/course/window/menu_motion.h"
#include "framework/course/window/menu_stage.h"
#include "framework/course/window/menu_style.h"

namespace relief::window {
namespace {

constexpr double mark_for = 2;  // seconds

/// Draws a knob's name, its widget, and an arrow that resets it if it differs from its default.
class DrawKnobs final : public Knobs {
public:
    DrawKnobs(Stage& stage, Motion& motion, std::string& seek)
        : knobs_(describe_knobs(*stage.lab())), defaults_(stage.defaults()), motion_(motion), seek_(seek) {
        for (const KnobText& knob : knobs_) {
            if (knob.name == seek_) open_ = knob.group;
            label_width_ = std::max(label_width_, ImGui::CalcTextSize(knob.help.title_of(knob.name).c_str()).x);
        }
        const float room = ImGui::GetContentRegionAvail().x;
        label_width_ = std::min(label_width_ + ImGui::GetStyle().ItemSpacing.x, room * 0.5f);
        widget_end_ = room - ImGui::GetFrameHeight() - ImGui::GetStyle().ItemInnerSpacing.x;
    }
    bool changed = false;
    std::string to_reset;  ///< name of the knob

    void group(const char* name) override {
        if (open_ == name) ImGui::SetNextItemOpen(true);
        shown_ = ImGui::CollapsingHeader(name, ImGuiTreeNodeFlags_DefaultOpen);
    }
    void slider(const char* name, float& value, float low, float high, const KnobHelp& help) override {
        // Enough digits to distinguish the integers of the range without an exponent.
        const double largest = std::max(std::abs(double(low)), std::abs(double(high)));
        const int digits = std::max(3, int(std::ceil(std::log10(std::max(1.0, largest) + 1))));
        const std::string format = fmt::format("%.{}g{}", digits, help.unit_after_number());
        row(name, help, [&] {
            const bool is_moved = bar((value - low) / (high - low), [&] {
                return ImGui::SliderFloat(id(name), &value, low, high, format.c_str(), ImGuiSliderFlags_AlwaysClamp);
            });
            if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) motion_.toggle_slider(name);
            return is_moved;
        });
    }
    void steps(const char* name, int& value, int low, int high, const KnobHelp& help) override {
        const std::string format = "%d" + help.unit_after_number();
        row(name, help, [&] {
            return bar(float(value - low) / float(high - low), [&] {
                return ImGui::SliderInt(id(name), &value, low, high, format.c_str(), ImGuiSliderFlags_AlwaysClamp);
            });
        });
    }
    void toggle(const char* name, bool& value, const KnobHelp& help) override {
        row(name, help, [&] { return ImGui::Checkbox(id(name), &value); });
    }
    void choice(const char* name, int& value, std::span<const char* const> names, const KnobHelp& help) override {
        row(name, help, [&] { return ImGui::Combo(id(name), &value, names.data(), int(names.size())); });
    }

private:
    /// Draws a slider as a bar from its minimum to its value, because a grab would cover a part of the number.
    template <class Slider>
    static bool bar(float share, Slider slider) {
        const ImVec2 at = ImGui::GetCursorScreenPos(), size{ImGui::CalcItemWidth(), ImGui::GetFrameHeight()};
        const float rounding = ImGui::GetStyle().FrameRounding;
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, ImGui::GetColorU32(ImGuiCol_FrameBg), rounding);
        const float filled = size.x * std::clamp(share, 0.0f, 1.0f);
        if (filled >= 1)
            list.AddRectFilled(at, {at.x + filled, at.y + size.y}, ImGui::GetColorU32(ImGuiCol_SliderGrab),
                               std::min(rounding, filled / 2));
        const std::pair<ImGuiCol, float> shown[] = {{ImGuiCol_FrameBg, 0},
                                                    {ImGuiCol_FrameBgHovered, 0.4f},
                                                    {ImGuiCol_FrameBgActive, 0.4f},
                                                    {ImGuiCol_SliderGrab, 0},
                                                    {ImGuiCol_SliderGrabActive, 0}};
        for (const auto& [color, opacity] : shown) {
            ImVec4 thin = ImGui::GetStyle().Colors[color];
            thin.w = opacity;
            ImGui::PushStyleColor(color, thin);
        }
        const bool is_moved = slider();
        ImGui::PopStyleColor(int(std::size(shown)));
        return is_moved;
    }

    template <class Widget>
    void row(const char* name, const KnobHelp& help, Widget widget) {
        if (!shown_) return;
        const bool ignored = is_ignored(name, knobs_);
        const std::string note = note_on(name, help, ignored);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        mark(name, at);
        ImGui::BeginDisabled(ignored);
        ImGui::AlignTextToFramePadding();
        ImGui::PushStyleColor(ImGuiCol_Text, motion_.slider() == name ? accent : quiet);
        const float column = ImGui::GetCursorScreenPos().x + label_width_ - ImGui::GetStyle().ItemSpacing.x;
        ImGui::PushClipRect(at, {column, at.y + ImGui::GetFrameHeight()}, true);  // in a narrow panel
        text(help.title_of(name));
        ImGui::PopClipRect();
        ImGui::PopStyleColor();
        tooltip(note);
        const float left = ImGui::GetCursorStartPos().x;
        ImGui::SameLine(left + label_width_);
        ImGui::SetNextItemWidth(std::max(20.0f, widget_end_ - label_width_));
        changed |= widget();
        if (!ImGui::IsItemActive()) tooltip(note);
        ImGui::EndDisabled();
        draw_reset(name, left);
    }

    std::string note_on(const char* name, const KnobHelp& help, bool ignored) const {
        std::string note = help.sentence();
        for (const KnobText& knob : knobs_)
            if (knob.name == name)
                note += fmt::format("\n--set {}: {}; {} at first.", name, knob.range(), default_of(name));
        if (motion_.slider() == name) note += "\nIt runs. A right click stops it.";
        if (ignored) note += "\nIt changes nothing as the knobs are now.";
        return note;
    }

    std::string default_of(const std::string& name) const {
        for (const KnobText& knob : defaults_)
            if (knob.name == name) return knob.value;
        return {};
    }

    void draw_reset(const std::string& name, float left) {
        std::string value;
        for (const KnobText& knob : knobs_)
            if (knob.name == name) value = knob.value;
        if (value == default_of(name)) return;
        ImGui::SameLine(left + widget_end_ + ImGui::GetStyle().ItemInnerSpacing.x);
        ImGui::PushID(name.c_str());
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, ImGui::GetStyle().FramePadding.y});
        if (ImGui::Button("\u21ba", {ImGui::GetFrameHeight(), 0})) to_reset = name;
        ImGui::PopStyleVar();
        tooltip(fmt::format("Back to {}.", default_of(name)));
        ImGui::PopID();
    }

    /// Marks the knob that was searched for, for `mark_for` seconds.
    void mark(const std::string& name, ImVec2 at) {
        static std::string marked;
        static double since = 0;
        if (name == seek_) {
            ImGui::SetScrollHereY(0.4f);
            marked = name, since = ImGui::GetTime();
            seek_.clear();
        }
        if (marked == name && ImGui::GetTime() - since < mark_for)
            ImGui::GetWindowDrawList()->AddRectFilled(
                {at.x - 4, at.y - 2}, {at.x + ImGui::GetContentRegionAvail().x + 4, at.y + ImGui::GetFrameHeight() + 2},
                IM_COL32(230, 138, 92, 70), 4);
    }

    const char* id(const char* name) { return (id_ = std::string("##") + name).c_str(); }

    std::vector<KnobText> knobs_;
    const std::vector<KnobText>& defaults_;
    Motion& motion_;
    std::string& seek_;
    std::string open_, id_;
    float label_width_ = 0, widget_end_ = 0;
    bool shown_ = true;
};

}  // namespace

void draw_knobs(Stage& stage, Motion& motion, std::string& seek) {
    DrawKnobs draw(stage, motion, seek);
    stage.lab()->knobs(draw);
    if (!draw.to_reset.empty()) stage.reset_knob(draw.to_reset);
    if (draw.changed) stage.changed();
}

}  // namespace relief::window
