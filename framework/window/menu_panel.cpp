#include "framework/window/menu_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <map>

#include "framework/base/error.h"
#include "framework/gl/counters.h"
#include "framework/window/menu_stage.h"
#include "framework/window/menu_style.h"

namespace relief {
namespace {

void heading(const char* line) {
    ImGui::Dummy({0, 6});
    ImGui::TextColored(accent, "%s", line);
    ImGui::Separator();
}

/// A knob's name beside its widget; its help shows while the mouse rests on it.
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

/// One letter that says whether the shaders on screen are those in the files.
void draw_letter(ShaderState state) {
    struct Letter {
        const char *letter, *help;
        ImVec4 color;
    };
    static const std::map<ShaderState, Letter> letters = {
        {ShaderState::unchanged, {"U", "unchanged: the shaders are those that the lab was opened with", quiet}},
        {ShaderState::renewed, {"N", "new: shaders were saved since the lab was opened, and are on screen", good}},
        {ShaderState::failed, {"F", "failed: the last saved shader has an error; the picture is older", alarm}}};
    const Letter& shown = letters.at(state);
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::TextColored(shown.color, "%s", shown.letter);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", shown.help);
}

void draw_labs(const Stage& stage, PanelWish& wish) {
    ImGui::SetNextItemWidth(-ImGui::CalcTextSize("N").x - ImGui::GetStyle().ItemSpacing.x);
    if (ImGui::BeginCombo("##labs", title_of(stage.entry()).c_str(), ImGuiComboFlags_HeightLarge)) {
        for (const LabEntry& lab : registry())
            if (ImGui::Selectable(title_of(lab).c_str(), &lab == &stage.entry())) wish.lab = &lab;
        ImGui::EndCombo();
    }
    draw_letter(stage.shaders());
    const float third = (ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().ItemSpacing.x) / 3;
    if (ImGui::Button("Previous", {third, 0})) wish.step = -1;
    ImGui::SameLine();
    if (ImGui::Button("Next", {third, 0})) wish.step = 1;
    ImGui::SameLine();
    if (ImGui::Button("Restart", {third, 0})) wish.restart = true;
    if (ImGui::Button("Handout (F1)", {-1, 0})) wish.handout = true;
    for (const std::string& line : stage.manifest().learns) {
        ImGui::Bullet();
        ImGui::SameLine();
        wrapped(line);
    }
}

void draw_probes(Stage& stage, bool error_map, PanelWish& wish) {
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
    if (ImGui::Checkbox("error map beside it", &error_map)) wish.error_map = true;
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("how far the probe is from the exact value, at each pixel (E)");
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
    quiet_text("--camera " + camera_text(stage.shot().camera));
    static constexpr std::array<const char*, gl_kinds> kinds = {
        "buffers", "vertex arrays", "textures",  "samplers", "framebuffers",       "renderbuffers",
        "shaders", "programs",      "pipelines", "queries",  "transform feedbacks"};
    std::string list;
    for (size_t i = 0; i < kinds.size(); ++i)
        if (now.live[i] != 0) list += fmt::format("{}{} {}", list.empty() ? "" : ", ", now.live[i], kinds[i]);
    quiet_text(list);
}

}  // namespace

PanelWish draw_panel(Stage& stage, int width, bool error_map, const std::string& message) {
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
        draw_probes(stage, error_map, wish);
    }
    draw_counters(stage);
    heading("Keys");
    quiet_text(
        "drag: orbit   right drag: pan   wheel: zoom\nclick: hold the values of a pixel\nleft, right: labs   R: "
        "restart   C: reset the camera\n"
        "F1: handout   E: error map   S: save a picture\nH: hide this panel   space: pause an animation\n"
        "Esc: quit   Saved shaders are reloaded at once.");
    if (ImGui::Button("Save a picture")) wish.save = true;
    if (!message.empty()) wrapped(message);
    ImGui::End();
    return wish;
}

void draw_error(const Stage& stage, int panel_width) {
    const Error* const error = stage.error();
    if (!error) return;
    const ImVec2 all = ImGui::GetIO().DisplaySize;
    const float width = std::max(100.0f, all.x - float(panel_width) - 40);
    ImGui::SetNextWindowPos({float(panel_width) + 20, 20});
    // A long log is scrolled: the last good picture stays in view below it.
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, all.y * 0.4f});
    ImGui::SetNextWindowBgAlpha(0.92f);
    ImGui::Begin("error", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PushStyleColor(ImGuiCol_Text, alarm);
    wrapped(error->what());
    ImGui::PopStyleColor();
    if (error->details() != std::string(error->what()) + "\n") wrapped(error->details());  // a log of one line
    quiet_text(stage.lab() ? "Fix the shader and save it: it reloads at once. After any other change press R."
                           : "Fix it, then press R.");
    ImGui::End();
}

}  // namespace relief
