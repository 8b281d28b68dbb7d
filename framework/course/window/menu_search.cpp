#include "framework/course/window/menu_search.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "framework/core/base/error.h"
#include "framework/core/lab/lab.h"
#include "framework/course/window/menu_checks.h"
#include "framework/course/window/menu_header.h"
#include "framework/course/window/menu_imgui.h"
#include "framework/course/window/menu_stage.h"
#include "framework/course/window/menu_style.h"

namespace relief::window {
namespace {

constexpr size_t most = 12;

/// Lowercases a text and replaces the separators of names by blanks.
std::string plain_words(std::string text) {
    for (char& c : text) c = c == '_' || c == '-' ? ' ' : char(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

}  // namespace

void Search::add(const LabEntry& lab, const Manifest& manifest, const std::vector<KnobText>& knobs,
                 std::vector<Found>& all, const std::string& place) {
    const auto add = [&](const char* kind, const std::string& name, const std::string& note) -> MenuWish& {
        Found& found = all.emplace_back(Found{kind, name, note, place, {}});
        if (!place.empty()) found.wish.lab = &lab;
        return found.wish;
    };
    for (const KnobText& knob : knobs) add("knob", knob.name, knob.help.sentence()).knob = knob.name;
    for (const ProbeInfo& probe : manifest.probes) add("probe", probe.name, probe.unit).probe = probe.name;
    for (const CheckInfo& check : manifest.checks) add("check", check.name, check.task).check = check.name;
}

void Search::learn_of_labs() {
    if (!others_.empty()) return;
    for (const LabEntry& lab : registry()) try {
            add(lab, load_manifest(lab), describe_knobs(*lab.make()), others_, "lab " + lab.two_digits());
        } catch (const Error&) {
            // Opening that lab shows the error.
        }
}

std::vector<Search::Found> Search::find(const Stage& stage, const Checks& checks) const {
    std::vector<Found> all;
    add(stage.entry(), checks.manifest(), stage.lab() ? describe_knobs(*stage.lab()) : std::vector<KnobText>(), all,
        "");
    for (const LabEntry& lab : registry()) {
        Found& found = all.emplace_back(Found{"lab", title_of(lab), lab.name, "", {}});
        found.wish.lab = &lab;
    }
    const std::string wanted = plain_words(text_);
    std::vector<Found> result;
    // Names before descriptions, and the current lab before the others.
    const auto take = [&](const std::vector<Found>& from, bool by_name) {
        for (const Found& found : from) {
            const bool in_name = plain_words(found.name).find(wanted) != std::string::npos;
            const bool in_note = plain_words(found.note).find(wanted) != std::string::npos;
            if (found.wish.lab == &stage.entry() && !found.place.empty()) continue;
            if (by_name ? in_name : in_note && !in_name) result.push_back(found);
        }
    };
    take(all, true);
    if (!wanted.empty()) take(others_, true);
    take(all, false);
    if (!wanted.empty()) take(others_, false);
    return result;
}

void Search::draw(float scale, const Stage& stage, const Checks& checks, MenuWish& wish) {
    if (std::exchange(wanted_, false)) {
        learn_of_labs();
        ImGui::OpenPopup("search");
        text_[0] = 0;
        marked_ = 0;
    }
    const ImVec2 all = ImGui::GetIO().DisplaySize;
    const float width = std::min(560 * scale, all.x - 32 * scale);
    ImGui::SetNextWindowPos({(all.x - width) / 2, header_height(scale) + 12 * scale});
    ImGui::SetNextWindowSize({width, 0});
    open_ = ImGui::BeginPopup("search", ImGuiWindowFlags_NoMove);
    if (!open_) return;
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1);
    if (ImGui::InputTextWithHint("##text", "a lab, a knob, a probe or a check", text_, sizeof text_)) marked_ = 0;
    const std::vector<Found> found = find(stage, checks);
    const int count = int(std::min(found.size(), most));
    if (is_pressed(ImGuiKey_DownArrow)) ++marked_;
    if (is_pressed(ImGuiKey_UpArrow)) --marked_;
    marked_ = std::clamp(marked_, 0, std::max(0, count - 1));
    const MenuWish* taken = nullptr;
    if (count > 0 && (is_pressed(ImGuiKey_Enter) || is_pressed(keypad_enter))) taken = &found[size_t(marked_)].wish;
    if (count == 0) quiet_text("No lab, knob, probe or check has that in its name or its help.");
    for (int i = 0; i < count; ++i) {
        const Found& one = found[size_t(i)];
        ImGui::PushID(i);
        if (ImGui::Selectable("##one", i == marked_)) taken = &one.wish;
        const float left = ImGui::GetStyle().WindowPadding.x;
        ImGui::SameLine(left);
        ImGui::TextColored(quiet, "%s", one.kind.c_str());
        ImGui::SameLine(left + 56 * scale);
        ImGui::TextUnformatted(one.name.c_str());
        ImGui::SameLine();
        if (!one.place.empty()) {
            ImGui::TextColored(accent, "%s", one.place.c_str());
            ImGui::SameLine();
        }
        ImGui::TextColored(quiet, "%s", one.note.c_str());
        ImGui::PopID();
    }
    if (found.size() > most) quiet_text("and " + std::to_string(found.size() - most) + " more");
    if (taken) wish.lab = taken->lab, wish.knob = taken->knob, wish.probe = taken->probe, wish.check = taken->check;
    if (std::exchange(closing_, false) || taken) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace relief::window
