#include "framework/course/window/menu_error_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/core/base/log.h"
#include "framework/core/base/text.h"
#include "framework/core/image/visualize.h"
#include "framework/course/pages/comparison.h"
#include "framework/course/window/menu_imgui.h"
#include "framework/course/window/menu_stage.h"
#include "framework/course/window/menu_style.h"

namespace relief::window {

void draw_heat(ImDrawList& list, ImVec2 low, ImVec2 high) {
    constexpr int steps = 5;  // visualize_error() interpolates linearly between these colours
    Image values(steps + 1, 1, 1);
    for (int i = 0; i <= steps; ++i) values.values[size_t(i)] = float(i) / steps;
    const Image colors = visualize_error(values, 1);
    const auto color = [&](int i) {
        const float* const c = colors.pixel(i, 0);
        return ImGui::ColorConvertFloat4ToU32({c[0], c[1], c[2], 1});
    };
    const float width = high.x - low.x;
    for (int i = 0; i < steps; ++i)
        list.AddRectFilledMultiColor({low.x + width * float(i) / steps, low.y},
                                     {low.x + width * float(i + 1) / steps, high.y}, color(i), color(i + 1),
                                     color(i + 1), color(i));
}

void draw_heat_scale(const std::vector<std::string>& marks, float width) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetTextLineHeight() * 0.6f;
    draw_heat(*ImGui::GetWindowDrawList(), corner, {corner.x + width, corner.y + height});
    ImGui::Dummy({width, height});
    const float left = ImGui::GetCursorPosX();
    const float last = width - ImGui::CalcTextSize(marks.back().c_str()).x;
    for (size_t i = 0; i < marks.size(); ++i) {
        const float share = float(i) / float(marks.size() - 1), wide = ImGui::CalcTextSize(marks[i].c_str()).x;
        if (i > 0 && i + 1 < marks.size() && width * share + wide > last) continue;  // it would touch the last mark
        if (i > 0) ImGui::SameLine();
        // Centred below its colour, but within the scale.
        ImGui::SetCursorPosX(left + std::clamp(width * share - wide / 2, 0.0f, std::max(0.0f, width - wide)));
        ImGui::TextColored(quiet, "%s", marks[i].c_str());
    }
}

void ErrorMap::forget() {
    done_ = false;
    picture_.reset(), compared_.reset();
    tiles_.clear();
    message_.clear();
}

void ErrorMap::compute(Stage& stage) {
    forget();
    done_ = true;
    try {
        compare(stage);
    } catch (const std::exception& error) {  // includes exceptions from a lab: the window stays open
        message_ = error.what();
        print_event("error map: " + message_);
    }
}

namespace {

/// Returns the words of the stage's picture. A probe has none. Then draws the picture small: only the places matter.
std::vector<PictureWord> words_of(const Stage& stage) {
    if (!stage.probe()) return stage.words();
    Shot shot = stage.shot();
    shot.probe = {};
    shot.size = glm::max(shot.size / 4, glm::ivec2(1));
    const Target target(TargetKind::picture, shot.size);
    const WithoutWords without_words;
    draw_lab(*stage.lab(), frame_of(shot, target));
    return without_words.words();
}

/// Draws the scale of pages::error_map().
void draw_log_scale(double max, const std::string& unit) {
    draw_heat_scale({rounded(max / 1000), rounded(max / 100), rounded(max / 10), amount_of(max, unit) + " and more"},
                    ImGui::GetContentRegionAvail().x);
}

std::string sentence(std::string text) {
    text[0] = char(std::toupper(static_cast<unsigned char>(text[0])));
    return text + ".";
}

}  // namespace

void ErrorMap::compare(Stage& stage) {
    if (!stage.lab() || stage.failed()) throw Error("There is no picture to compare.");
    Shot shot = stage.shot();
    std::vector<ProbeInfo> probes = stage.manifest().probes;
    if (shot.probe) {
        probes = {stage.manifest().probe(shot.probe.name)};
    } else {
        // For a picture, prefer the probe by which the lab's page compares methods.
        const auto& compare = stage.manifest().compare;
        const std::string chief = compare ? compare->shot.probe.name : "";
        std::stable_partition(probes.begin(), probes.end(), [&](const ProbeInfo& one) { return one.name == chief; });
    }
    const Target target(TargetKind::probe, shot.size);
    for (const ProbeInfo& probe : probes) {
        shot.probe = {probe.name};
        const Frame frame = frame_of(shot, target);
        const std::optional<Image> truth = stage.lab()->truth(frame, shot.probe);
        if (!truth) continue;
        draw_lab(*stage.lab(), frame);
        Image values = target.read();
        const Image error = error_image(values, *truth, probe.error);
        error_ = summarize(error);
        const std::string nothing = nothing_to_compare(values, *truth, error_);
        if (!nothing.empty() && error_.missing + error_.not_finite == 0)  // otherwise these pixels are magenta
            throw Error(sentence(fmt::format("probe {}: {}", probe.name, nothing)));
        one_sided_ = one_sided(values, *truth).count();
        const double scale = pages::error_map_max(error_.p99);
        Image shown = error;
        mark_one_sided(shown, values, *truth, scale);
        compared_ = {probe, std::move(values), *truth, error};
        tiles_ = tile_means(words_of(stage), error);
        picture_.emplace(
            "error map", [&] { return pages::error_map(scale, shown); },
            TextureOptions{.wrap = Wrap::clamp, .mips = false});
        bind(0, *picture_);  // uploads it now, while `error` is in scope
        print_event(fmt::format("error map: {}, mean {}, rms {}, 99 % {}, largest {}, over {} pixels", probe.name,
                                amount_of(error_.mean, probe.unit, 6), plain(error_.rms), plain(error_.p99),
                                plain(error_.largest), error_.count));
        return;
    }
    throw Error(sentence(no_truth(stage.entry(), stage.settings())));
}

void ErrorMap::draw(glm::ivec2 at, glm::ivec2 size) const {
    if (!on_ || !picture_) return;
    const ImVec2 low{float(at.x), float(at.y)}, high{float(at.x + size.x), float(at.y + size.y)};
    // Row 0 of a texture is the bottom.
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddImage(texture_id(*picture_), low, high, {0, 1}, {1, 0});
    for (const TileMean& tile : tiles_) {
        const std::string line = amount_of(tile.mean, compared_->probe.unit);
        const ImVec2 wide = ImGui::CalcTextSize(line.c_str());
        const float x = low.x + float(size.x) * (tile.place.x + tile.size.x / 2) - wide.x / 2,
                    y = low.y + float(size.y) * (tile.place.y + tile.size.y) - 1.5f * wide.y;
        list.AddRectFilled({x - 4, y - 2}, {x + wide.x + 4, y + wide.y + 2}, IM_COL32(16, 17, 20, 255), 3);
        list.AddText({x, y}, IM_COL32_WHITE, line.c_str());
    }
}

void ErrorMap::draw_legend(const Box& box, const std::string& probe, bool moves) const {
    if (box.size.y == 0) return;
    begin_in(box, "error map", ImGui::GetStyle().WindowPadding, true);
    if (ImGui::BeginTable("halves", 2, ImGuiTableFlags_SizingStretchSame)) {
        ImGui::TableNextColumn();
        push_font(font(FontRole::bold));
        wrapped("Left: " + (probe.empty() ? "the picture" : probe));
        ImGui::PopFont();
        if (picture_) draw_notes();
        ImGui::TableNextColumn();
        push_font(font(FontRole::bold));
        wrapped(picture_ ? fmt::format("Right: the error of {}", compared_->probe.name) : "Right: the error map");
        ImGui::PopFont();
        if (!done_)
            quiet_text(moves ? "The error map needs a paused animation: press space."
                             : "computing the exact values ...");
        else if (!picture_)
            wrapped(message_);
        else if (error_.count > 0 && error_.largest == 0)
            wrapped("None: every pixel has the exact value.");
        else if (error_.count > 0)
            draw_log_scale(pages::error_map_max(error_.p99), compared_->probe.unit);
        ImGui::EndTable();
    }
    ImGui::End();
}

void ErrorMap::draw_notes() const {
    if (error_.count > 0)
        wrapped(fmt::format("{}mean {}, 99 % {}, largest {}", tiles_.empty() ? "" : "in all: ", rounded(error_.mean),
                            rounded(error_.p99), amount_of(error_.largest, compared_->probe.unit)));
    if (one_sided_ > 0)
        quiet_text(fmt::format("{} pixels, in the lightest colour: a surface in only one of the two", one_sided_));
    if (error_.missing > 0)
        quiet_text(fmt::format("{} pixels, in magenta: a task that is not written yet", error_.missing));
    if (error_.not_finite > 0)
        colored_text(alarm, fmt::format("{} pixels, in magenta: NaN or infinite", error_.not_finite));
}

}  // namespace relief::window
