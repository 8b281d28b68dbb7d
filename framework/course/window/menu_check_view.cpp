#include "framework/course/window/menu_check_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/core/base/text.h"
#include "framework/course/pages/check_figures.h"
#include "framework/course/window/menu_checks.h"
#include "framework/course/window/menu_error_map.h"
#include "framework/course/window/menu_imgui.h"
#include "framework/course/window/menu_pixel.h"
#include "framework/course/window/menu_style.h"

namespace relief::window {
namespace {

void show_texels(const Texture& texture) {
    bind(0, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);  // show each pixel of the check as a square
    glBindTexture(GL_TEXTURE_2D, 0);
}

/// Draws a word on a dark background at a corner of a picture.
void draw_tag(ImVec2 at, const char* word, bool from_right) {
    const ImVec2 size = ImGui::CalcTextSize(word);
    if (from_right) at.x -= size.x + 12;
    ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + size.x + 12, at.y + size.y + 6}, IM_COL32(16, 17, 20, 255));
    ImGui::GetWindowDrawList()->AddText({at.x + 6, at.y + 3}, IM_COL32(255, 255, 255, 255), word);
}

}  // namespace

void CheckView::close() {
    name_.clear();
    drawn_.reset(), expected_.reset(), difference_.reset();
}

void CheckView::make(const Checks& checks, size_t check) {
    version_ = checks.version();
    drawn_.reset(), expected_.reset(), difference_.reset();
    const auto& result = checks.result(check);
    if (!result) return;
    const CheckInfo& info = checks.manifest().checks[check];
    const ProbeInfo* const probe = info.shot.probe ? &checks.manifest().probe(info.shot.probe.name) : nullptr;
    pages::ComparedImages images =
        pages::compare_images(probe, result->drawn, result->expected, pages::largest_limit(info.limits));
    size_ = info.shot.size;
    differs_ = images.differs, largest_ = images.largest;
    const auto hold = [](std::optional<Texture>& texture, Image& image) {
        if (image.pixel_count() == 0) return;
        texture.emplace(
            "check", [&] { return std::move(image); }, TextureOptions{.wrap = Wrap::clamp, .mips = false});
        show_texels(*texture);
    };
    hold(drawn_, images.drawn);
    hold(expected_, images.expected);
    hold(difference_, images.difference);
}

void CheckView::draw(const Box& box, float scale, const Checks& checks, MenuWish& wish) {
    if (!is_open()) return;
    const auto& all = checks.manifest().checks;
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const CheckInfo& check) { return check.name == name_; });
    if (found == all.end()) return close();
    const auto index = size_t(found - all.begin());
    if (version_ != checks.version()) make(checks, index);
    const auto& result = checks.result(index);

    ImGui::PushStyleColor(ImGuiCol_WindowBg, {0.08f, 0.085f, 0.10f, 1});
    begin_in(box, "check", ImGui::GetStyle().WindowPadding, true);
    ImGui::PopStyleColor();
    const float padding = ImGui::GetStyle().WindowPadding.x;
    push_font(font(FontRole::bold));
    wrapped(fmt::format("Check {}: {}", found->task, found->name));
    ImGui::PopFont();
    if (!result)
        quiet_text(fmt::format("Checking {} ...", checks.progress()));
    else
        colored_text(result->outcome == check::Outcome::passed ? good
                     : result->outcome <= check::Outcome::waiting || result->outcome == check::Outcome::unfinished
                         ? amber
                         : alarm,
                     pages::outcome_words(result->outcome) + ": " + result->found);
    static constexpr const char* back = "To the picture with these knobs (Esc)";
    const float back_width = ImGui::CalcTextSize(back).x + 2 * ImGui::GetStyle().FramePadding.x;
    if (drawn_ && expected_) {
        if (ImGui::Button("yours")) border_ = 1;
        ImGui::SameLine();
        if (ImGui::Button("half")) border_ = 0.5f;
        ImGui::SameLine();
        if (ImGui::Button("expected")) border_ = 0;
        ImGui::SameLine();
        if (ImGui::GetContentRegionAvail().x < back_width) ImGui::NewLine();
    }
    if (ImGui::Button(back)) wish.check = "";
    tooltip("The picture has the check's knobs, camera and probe. Ctrl+Z brings back what was before.");

    // Side by side or one below the other, at the larger scale. The scale is an integer if it is at least 2.
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 room{float(box.right()) - padding - corner.x,
                      float(box.bottom()) - corner.y - 4 * ImGui::GetTextLineHeightWithSpacing()};
    const int panes = difference_ ? 2 : 1;
    const auto magnified = [&](float columns, float rows) {
        const float share = std::min((room.x - padding * (columns - 1)) / columns / float(size_.x),
                                     (room.y - padding * (rows - 1)) / rows / float(size_.y));
        return std::max(0.1f, share >= 2 ? std::floor(share) : share);
    };
    const bool beside = panes == 1 || magnified(2, 1) >= magnified(1, 2);
    const float factor = panes == 1 ? magnified(1, 1) : beside ? magnified(2, 1) : magnified(1, 2);
    if ((drawn_ || expected_) && room.x > 0) {
        const ImVec2 size{float(size_.x) * factor, float(size_.y) * factor};
        const float edge = !drawn_ ? 0 : !expected_ ? 1 : border_;
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const float middle = corner.x + size.x * edge, bottom = corner.y + size.y;
        // Row 0 of a texture is the bottom.
        if (drawn_ && edge > 0) list.AddImage(texture_id(*drawn_), corner, {middle, bottom}, {0, 1}, {edge, 0});
        if (expected_ && edge < 1)
            list.AddImage(texture_id(*expected_), {middle, corner.y}, {corner.x + size.x, bottom}, {edge, 1}, {1, 0});
        if (edge > 0) draw_tag(corner, "yours", false);
        if (edge < 1) draw_tag({corner.x + size.x, corner.y}, "expected", true);
        ImVec2 other = corner;
        (beside ? other.x : other.y) += (beside ? size.x : size.y) + padding;
        if (difference_) {
            list.AddImage(texture_id(*difference_), other, {other.x + size.x, other.y + size.y}, {0, 1}, {1, 0});
            draw_tag(other, "where they differ", false);
        }
        if (result && drawn_ && expected_)
            for (const ImVec2 pane : {corner, other}) {
                const ImVec2 mouse = ImGui::GetIO().MousePos;
                const glm::ivec2 pixel(std::floor((mouse.x - pane.x) / factor),
                                       std::floor((mouse.y - pane.y) / factor));
                if (ImGui::IsWindowHovered() && found->shot.probe && pixel.x >= 0 && pixel.y >= 0 &&
                    pixel.x < size_.x && pixel.y < size_.y) {
                    ImGui::BeginTooltip();
                    draw_rows(pixel_rows(checks.manifest().probe(found->shot.probe.name), pixel, result->drawn,
                                         &result->expected));
                    ImGui::EndTooltip();
                }
            }
        const bool both = drawn_ && expected_;
        ImGui::Dummy({std::max(1.0f, beside ? other.x + size.x - corner.x : size.x),
                      beside ? size.y : other.y + size.y - corner.y});
        if (difference_) {
            wrapped(differs_ + ".");
            ImGui::SetCursorScreenPos(
                {other.x, ImGui::GetCursorScreenPos().y});  // below the picture of the differences
            ImGui::BeginGroup();
            draw_heat_scale({"0", largest_ + " and more"}, size.x);
            ImGui::EndGroup();
        }
        ImGui::End();
        if (both) {
            float x = middle;
            if (drag_border("check border", x, corner.y, bottom, scale, true))
                border_ = std::clamp((x - corner.x) / size.x, 0.0f, 1.0f);
        }
        return;
    }
    ImGui::End();
}

}  // namespace relief::window
