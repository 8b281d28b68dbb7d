#include "framework/course/window/menu_words.h"

#include <imgui.h>

#include <algorithm>
#include <cfloat>

#include "framework/course/window/menu_error_map.h"
#include "framework/library/kit/word_layout.h"

namespace relief::window {
namespace {

ImU32 color_of(const glm::vec4& color) { return ImGui::ColorConvertFloat4ToU32({color.x, color.y, color.z, color.w}); }

Letters window_letters() {
    const float size = ImGui::GetFontSize();
    return {.width = [](const std::string& text,
                        float height) { return ImGui::GetFont()->CalcTextSizeA(height, FLT_MAX, 0, text.c_str()).x; },
            .usual = size,
            .least = std::min(size, std::max(11.0f, 0.85f * size)),
            .share = 0.8f};
}

}  // namespace

std::vector<Box> draw_words(std::vector<PictureWord> words, const Box& picture, int begin, int end) {
    const glm::vec2 corner(picture.at), whole(picture.size);
    for (PictureWord& word : words) word = scaled(std::move(word), whole);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    std::vector<Box> grounds;
    for (const PlacedWord& word : lay_out(words, whole, window_letters()).placed) {
        const PictureWord& of = words[word.of];
        if (const float middle = of.place.x + of.size.x / 2; middle < float(begin) || middle >= float(end)) continue;
        const glm::vec2 low = corner + word.place, high = low + word.size;
        const ImVec2 at(low.x, low.y), to(high.x, high.y);
        switch (word.kind) {
            case PlacedWord::Kind::ground:
                list.AddRectFilled(at, to, color_of(word.color), 3);
                grounds.push_back({glm::ivec2(low), glm::ivec2(word.size)});
                break;
            case PlacedWord::Kind::box:
                list.AddRectFilled(at, to, color_of(word.color));
                break;
            case PlacedWord::Kind::heat:
                draw_heat(list, at, to);
                break;
            case PlacedWord::Kind::text:
                list.AddText(ImGui::GetFont(), word.size.y, at, color_of(word.color), word.text.c_str());
                break;
        }
    }
    return grounds;
}

}  // namespace relief::window
