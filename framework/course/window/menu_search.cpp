#include "framework/course/window/menu_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/log.h"
#include "framework/core/base/paths.h"
#include "framework/core/lab/lab.h"
#include "framework/course/pages/markdown.h"
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

/// Returns as much of a text as fits into a width in pixels; an ellipsis stands for the rest.
std::string beginning_of(const std::string& text, float width) {
    if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
    constexpr const char* rest = "\u2026";
    const char* end = text.c_str();
    ImGui::GetFont()->CalcTextSizeA(ImGui::GetFontSize(), std::max(0.0f, width - ImGui::CalcTextSize(rest).x), 0,
                                    text.c_str(), nullptr, &end);
    return text.substr(0, size_t(end - text.c_str())) + rest;
}

}  // namespace

void Search::add(const LabEntry& lab, const Manifest& manifest, const std::vector<KnobText>& knobs,
                 std::vector<Found>& all, const std::string& place) {
    const auto add = [&](const char* kind, const std::string& name, const std::string& note) -> MenuWish& {
        Found& found = all.emplace_back(Found{kind, name, note, place, "", {}});
        if (!place.empty()) found.wish.lab = &lab;
        return found.wish;
    };
    for (const KnobText& knob : knobs) {
        add("knob", knob.help.title_of(knob.name), knob.help.sentence()).knob = knob.name;
        all.back().option = knob.name;
    }
    for (const ProbeInfo& probe : manifest.probes) add("probe", probe.name, probe.unit).probe = probe.name;
    for (const CheckInfo& check : manifest.checks) add("check", check.name, check.task).check = check.name;
    for (const KnobText& knob : knobs) {
        if (knob.is_toggle()) continue;
        for (const std::string& word : knob.choices) {
            MenuWish& found = add("value", knob.help.title_of(knob.name) + " = " + word, knob.help.sentence());
            found.knob = knob.name, found.value = word;
            all.back().option = knob.name + "=" + word;
        }
    }
}

void Search::add_headings(const LabEntry& lab, std::vector<Found>& all, const std::string& place) {
    const std::string document = "labs/" + lab.folder + "/README.md";
    for (const pages::Block& block : pages::parse_markdown(read_file(course_root() / document))) {
        if (block.kind != pages::BlockKind::heading) continue;
        const std::string heading = pages::plain_text(block.spans);
        Found& found = all.emplace_back(Found{"heading", heading, "in the handout", place, "", {}});
        if (!place.empty()) found.wish.lab = &lab;
        found.wish.document = document, found.wish.passage = heading;
    }
}

void Search::add_words(std::vector<Found>& all) {
    const char* const document = "labs/GLOSSARY.md";
    for (const pages::Block& block : pages::parse_markdown(read_file(course_root() / document)))
        for (size_t row = 1; row < block.rows.size(); ++row) {
            const std::string word = pages::plain_text(block.rows[row].front());
            Found& found = all.emplace_back(Found{"word", word, pages::plain_text(block.rows[row].back()), "", "", {}});
            found.wish.document = document, found.wish.passage = word;
        }
}

void Search::learn_of_labs() {
    if (!others_.empty()) return;
    for (const LabEntry& lab : registry()) try {
            add(lab, load_manifest(lab), describe_knobs(*lab.make()), others_, "lab " + lab.two_digits());
            add_headings(lab, others_, "lab " + lab.two_digits());
        } catch (const Error&) {
            // Opening that lab shows the error.
        }
    try {
        add_words(others_);
    } catch (const Error&) {
        // A course without a glossary has no words to find.
    }
}

std::vector<Search::Found> Search::find(const Stage& stage, const Checks& checks) const {
    std::vector<Found> all;
    add(stage.entry(), checks.manifest(), stage.lab() ? describe_knobs(*stage.lab()) : std::vector<KnobText>(), all,
        "");
    try {
        add_headings(stage.entry(), all, "");
    } catch (const Error&) {
        // The handout itself says that it is missing.
    }
    for (const LabEntry& lab : registry()) {
        Found& found = all.emplace_back(Found{"lab", title_of(lab), lab.name, "", "", {}});
        found.wish.lab = &lab;
    }
    const std::string wanted = plain_words(text_);
    std::vector<Found> result;
    // Names before descriptions, and the current lab before the others.
    const auto take = [&](const std::vector<Found>& from, bool by_name) {
        for (const Found& found : from) {
            const bool in_name = plain_words(found.name + "\n" + found.option).find(wanted) != std::string::npos;
            // The note of a value is its knob's.
            const bool in_note = found.kind != "value" && plain_words(found.note).find(wanted) != std::string::npos;
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
        closing_ = taking_ = false;
        print_event("search: open");
    }
    const ImVec2 all = ImGui::GetIO().DisplaySize;
    const float width = std::min(560 * scale, all.x - 32 * scale);
    ImGui::SetNextWindowPos({(all.x - width) / 2, header_height(scale) + 12 * scale});
    ImGui::SetNextWindowSize({width, 0});
    open_ = ImGui::BeginPopup("search", ImGuiWindowFlags_NoMove);
    if (!open_) return;
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1);
    if (ImGui::InputTextWithHint("##text", "a lab, a knob, a value, a probe, a check, a heading or a word", text_,
                                 sizeof text_)) {
        marked_ = 0;
        print_event(fmt::format("search: {}", text_));
    }
    const std::vector<Found> found = find(stage, checks);
    const int count = int(std::min(found.size(), most));
    marked_ = std::clamp(marked_, 0, std::max(0, count - 1));
    const MenuWish* taken = nullptr;
    if (taking_ && is_input_read()) {
        taking_ = false;
        if (count > 0)
            taken = &found[size_t(marked_)].wish;
        else
            ImGui::SetKeyboardFocusHere(-1);  // Enter has ended the text field
    }
    if (count == 0)
        quiet_text("Nothing has that in its name or its help: no lab, knob, value, probe, check, heading or word.");
    for (int i = 0; i < count; ++i) {
        const Found& one = found[size_t(i)];
        ImGui::PushID(i);
        if (ImGui::Selectable("##one", i == marked_)) taken = &one.wish;
        const float left = ImGui::GetStyle().WindowPadding.x;
        ImGui::SameLine(left);
        ImGui::TextColored(quiet, "%s", one.kind.c_str());
        ImGui::SameLine(left + 66 * scale);
        ImGui::TextUnformatted(one.name.c_str());
        ImGui::SameLine();
        if (!one.place.empty()) {
            ImGui::TextColored(accent, "%s", one.place.c_str());
            ImGui::SameLine();
        }
        ImGui::TextColored(quiet, "%s", beginning_of(one.note, ImGui::GetContentRegionAvail().x).c_str());
        ImGui::PopID();
    }
    if (found.size() > most) quiet_text("and " + std::to_string(found.size() - most) + " more");
    if (taken) {
        const std::vector<MenuAction> actions = std::move(wish.actions);  // of this frame's keys
        wish = *taken;
        wish.actions = actions;
    }
    if (std::exchange(closing_, false) || taken) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace relief::window
