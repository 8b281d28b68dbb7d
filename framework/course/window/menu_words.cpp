#include "framework/course/window/menu_words.h"

#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "framework/course/window/menu_error_map.h"

namespace relief::window {
namespace {

constexpr ImU32 plate = IM_COL32(13, 14, 17, 210);

ImU32 color_of(const glm::vec4& color) { return ImGui::ColorConvertFloat4ToU32({color.x, color.y, color.z, color.w}); }

float width_of(const std::string& text, float height) {
    return ImGui::GetFont()->CalcTextSizeA(height, FLT_MAX, 0, text.c_str()).x;
}

/// `x` is the place of the text's left end, its middle or its right end, by `anchor`: 0, 0.5 or 1. `right` is the end
/// of the picture: the text does not leave it.
void draw_text(ImDrawList& list, const std::string& text, float x, float anchor, float y, float height, float right,
               ImU32 color) {
    const float width = width_of(text, height), top = std::round(y);
    const float left = std::round(std::min(x - anchor * width, right - width - 5));
    list.AddRectFilled({left - 5, top - 1}, {left + width + 5, top + height + 2}, plate, 3);
    list.AddText(ImGui::GetFont(), height, {left, top}, color, text.c_str());
}

void draw_caption(ImDrawList& list, const PictureWord& word, ImVec2 at, ImVec2 size) {
    // Small tiles have small letters. Long texts are drawn smaller, but keep the distance of the lines.
    const float line = std::min(ImGui::GetFontSize(), std::max(11.0f, 0.1f * size.y));
    const float height = std::min(line, 0.94f * size.x * line / (width_of(word.text, line) + 10));
    const float y =
        word.line >= 0 ? at.y + 5 + float(word.line) * (line + 5) : at.y + size.y - 2 + float(word.line) * (line + 5);
    draw_text(list, word.text, at.x + size.x / 2, 0.5f, y, height, at.x + size.x, color_of(word.color));
}

void draw_scale(ImDrawList& list, const PictureWord& word, ImVec2 at, ImVec2 size, float right) {
    draw_heat(list, at, {at.x + size.x, at.y + size.y});
    for (int tick = 1; tick < word.parts; ++tick) {
        const float x = std::round(at.x + size.x * float(tick) / float(word.parts));
        list.AddLine({x, at.y}, {x, at.y + size.y}, IM_COL32(255, 255, 255, 200));
    }
    const float height = ImGui::GetFontSize(), y = at.y + (size.y - height) / 2;
    draw_text(list, word.text, at.x - 0.7f * height, 1, y, height, right, IM_COL32_WHITE);
    draw_text(list, word.end, at.x + size.x + 0.7f * height, 0, y, height, right, IM_COL32_WHITE);
}

}  // namespace

void draw_words(const std::vector<PictureWord>& words, const Box& picture, int begin, int end) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const glm::vec2 corner(picture.at), whole(picture.size);
    const auto right = float(picture.right());
    for (const PictureWord& word : words) {
        const glm::vec2 place = word.place * whole, size = word.size * whole;
        const float middle = place.x + size.x / 2;
        if (middle < float(begin) || middle >= float(end)) continue;
        const ImVec2 at(corner.x + place.x, corner.y + place.y);
        switch (word.kind) {
            case PictureWord::Kind::caption:
                draw_caption(list, word, at, {size.x, size.y});
                break;
            case PictureWord::Kind::text: {
                const float height = std::clamp(0.8f * size.y, 11.0f, ImGui::GetFontSize());
                if (!word.text.empty())
                    draw_text(list, word.text, at.x, word.anchor, at.y + (size.y - height) / 2, height, right,
                              color_of(word.color));
                break;
            }
            case PictureWord::Kind::box:
                list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, color_of(word.color));
                break;
            case PictureWord::Kind::scale:
                draw_scale(list, word, at, {size.x, size.y}, right);
                break;
        }
    }
}

}  // namespace relief::window
