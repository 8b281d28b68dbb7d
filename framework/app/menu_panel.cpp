#include "framework/app/menu_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <map>

#include "framework/app/menu_stage.h"
#include "framework/base/error.h"
#include "framework/gl/counters.h"

namespace relief {
namespace {

const ImVec4 accent{0.90f, 0.54f, 0.36f, 1}, quiet{0.62f, 0.63f, 0.65f, 1}, alarm{1, 0.45f, 0.38f, 1};

void text(const std::string& line) { ImGui::TextUnformatted(line.data(), line.data() + line.size()); }
void wrapped(const std::string& line) {
    ImGui::PushTextWrapPos(0);
    text(line);
    ImGui::PopTextWrapPos();
}
void quiet_text(const std::string& line) {
    ImGui::PushStyleColor(ImGuiCol_Text, quiet);
    wrapped(line);
    ImGui::PopStyleColor();
}
void heading(const char* line) {
    ImGui::Dummy({0, 6});
    ImGui::TextColored(accent, "%s", line);
    ImGui::Separator();
}

/// A knob's name beside its widget, its help when the mouse rests on it.
class DrawKnobs final : public Knobs {
public:
    bool changed = false;

    void slider(const char* name, float& value, float low, float high, const char* help) override {
        label(name);
        note(ImGui::SliderFloat(id(name), &value, low, high, "%.3g", ImGuiSliderFlags_AlwaysClamp), help);
    }
    void steps(const char* name, int& value, int low, int high, const char* help) override {
        label(name);
        note(ImGui::SliderInt(id(name), &value, low, high, "%d", ImGuiSliderFlags_AlwaysClamp), help);
    }
    void toggle(const char* name, bool& value, const char* help) override { note(ImGui::Checkbox(name, &value), help); }
    void choice(const char* name, int& value, std::span<const char* const> names, const char* help) override {
        label(name);
        note(ImGui::Combo(id(name), &value, names.data(), int(names.size())), help);
    }

private:
    void label(const char* name) {
        ImGui::AlignTextToFramePadding();
        quiet_text(name);
        ImGui::SameLine(ImGui::GetContentRegionMax().x * 0.38f);
        ImGui::SetNextItemWidth(-1);
    }
    const char* id(const char* name) { return (id_ = std::string("##") + name).c_str(); }
    void note(bool moved, const char* help) {
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", help);
        changed |= moved;
    }
    std::string id_;
};

/// Titles do not change while the window is open, and reading a manifest costs a file.
std::string title_of(const LabEntry& lab) {
    static std::map<const LabEntry*, std::string> titles;
    auto found = titles.find(&lab);
    if (found == titles.end()) {
        std::string title = lab.name;
        try {
            title = load_manifest(lab).title;
        } catch (const Error&) {  // opening that lab says what is wrong with it
        }
        found = titles.emplace(&lab, lab.two_digits() + "  " + title).first;
    }
    return found->second;
}

void draw_labs(const Stage& stage, PanelWish& wish) {
    ImGui::SetNextItemWidth(-1);
    if (ImGui::BeginCombo("##labs", title_of(stage.entry()).c_str(), ImGuiComboFlags_HeightLarge)) {
        for (const LabEntry& lab : registry())
            if (ImGui::Selectable(title_of(lab).c_str(), &lab == &stage.entry())) wish.lab = &lab;
        ImGui::EndCombo();
    }
    const float third = (ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().ItemSpacing.x) / 3;
    if (ImGui::Button("Previous", {third, 0})) wish.step = -1;
    ImGui::SameLine();
    if (ImGui::Button("Next", {third, 0})) wish.step = 1;
    ImGui::SameLine();
    if (ImGui::Button("Restart", {third, 0})) wish.restart = true;
    for (const std::string& line : stage.manifest().learns) {
        ImGui::Bullet();
        ImGui::SameLine();
        wrapped(line);
    }
}

void draw_probes(Stage& stage) {
    const auto& probes = stage.manifest().probes;
    if (probes.empty()) return;
    heading("Look at");
    if (ImGui::RadioButton("picture", !stage.probe())) stage.show({});
    for (const ProbeInfo& probe : probes) {
        ImGui::SameLine();
        const float wanted = ImGui::CalcTextSize(probe.name.c_str()).x + 2 * ImGui::GetFrameHeight();
        if (ImGui::GetContentRegionAvail().x < wanted) ImGui::NewLine();
        if (ImGui::RadioButton(probe.name.c_str(), stage.probe().name == probe.name)) stage.show({probe.name});
    }
}

void draw_counters(const Stage& stage) {
    heading("Counters");
    const Counters& now = counters();
    const auto row = [](const char* name, const std::string& value) {
        ImGui::TableNextColumn();
        quiet_text(name);
        ImGui::TableNextColumn();
        text(value);
    };
    if (!ImGui::BeginTable("counters", 2)) return;
    row("frames drawn", std::to_string(stage.frames()));
    row("last frame", fmt::format("{:.1f} ms", stage.milliseconds()));
    row("draw calls", std::to_string(stage.draw_calls()));
    row("textures", fmt::format("{:.1f} MiB", double(now.texture_bytes) / (1 << 20)));
    row("live GL objects", std::to_string(now.live_objects()));
    ImGui::EndTable();
    static constexpr std::array<const char*, gl_kinds> kinds = {
        "buffers", "vertex arrays", "textures",  "samplers", "framebuffers",       "renderbuffers",
        "shaders", "programs",      "pipelines", "queries",  "transform feedbacks"};
    std::string list;
    for (size_t i = 0; i < kinds.size(); ++i)
        if (now.live[i] != 0) list += fmt::format("{}{} {}", list.empty() ? "" : ", ", now.live[i], kinds[i]);
    quiet_text(list);
}

}  // namespace

void style_panel(float scale) {
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowPadding = {16, 14};
    style.FramePadding = {8, 5};
    style.ItemSpacing = {8, 6};
    style.FrameRounding = style.GrabRounding = style.PopupRounding = 4;
    style.WindowBorderSize = 0;
    style.Colors[ImGuiCol_WindowBg] = {0.09f, 0.095f, 0.11f, 1};
    style.Colors[ImGuiCol_FrameBg] = {0.16f, 0.17f, 0.20f, 1};
    style.Colors[ImGuiCol_Button] = {0.20f, 0.21f, 0.25f, 1};
    for (const int color : {ImGuiCol_FrameBgHovered, ImGuiCol_ButtonHovered, ImGuiCol_HeaderHovered})
        style.Colors[color] = {0.30f, 0.24f, 0.21f, 1};
    for (const int color : {ImGuiCol_FrameBgActive, ImGuiCol_ButtonActive, ImGuiCol_Header, ImGuiCol_HeaderActive})
        style.Colors[color] = {0.42f, 0.28f, 0.21f, 1};
    for (const int color : {ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive, ImGuiCol_CheckMark})
        style.Colors[color] = accent;
    style.ScaleAllSizes(scale);
}

PanelWish draw_panel(Stage& stage, int width, const std::string& message) {
    PanelWish wish;
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({float(width), ImGui::GetIO().DisplaySize.y});
    ImGui::Begin("panel", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus);
    draw_labs(stage, wish);
    if (stage.lab()) {
        DrawKnobs knobs;
        heading("Knobs");
        stage.lab()->knobs(knobs);
        if (knobs.changed) stage.changed();
        draw_probes(stage);
    }
    draw_counters(stage);
    heading("Keys");
    quiet_text(
        "drag: orbit   right drag: pan   wheel: zoom\nleft, right: labs   R: restart   C: camera back\n"
        "S: save a picture   H: hide this   Esc: quit\nspace: hold an animation still");
    if (ImGui::Button("Save a picture")) wish.save = true;
    if (!message.empty()) wrapped(message);
    ImGui::End();
    return wish;
}

void draw_error(const Stage& stage, int panel_width) {
    if (stage.error().empty()) return;
    const ImVec2 all = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({float(panel_width) + 20, 20});
    ImGui::SetNextWindowSize({std::max(100.0f, all.x - float(panel_width) - 40), 0});
    ImGui::Begin("error", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PushStyleColor(ImGuiCol_Text, alarm);
    wrapped(stage.error());
    ImGui::PopStyleColor();
    if (!stage.details().empty()) wrapped(stage.details());
    quiet_text("Mend it, then press R.");
    ImGui::End();
}

}  // namespace relief
