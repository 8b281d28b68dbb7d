#include "framework/course/window/menu_text.h"

#include <algorithm>
#include <cmath>

#include "framework/course/window/menu_imgui.h"

namespace relief::window {
namespace {

const ImVec4 bold_color{1, 1, 0.98f, 1}, link_color{0.56f, 0.74f, 0.95f, 1};

Look look_of(const pages::Span& span, FontRole base, const ImVec4& plain) {
    const ImVec4 color = span.code              ? code_color
                         : !span.target.empty() ? (span.image ? quiet : link_color)
                         : span.italic          ? quiet
                         : span.bold            ? bold_color
                                                : plain;
    const FontRole role = span.code ? FontRole::code : span.bold && base == FontRole::text ? FontRole::bold : base;
    const bool is_knob = span.code && span.target.starts_with(knob_link);
    return {font(role), ImGui::ColorConvertFloat4ToU32(is_knob ? link_color : color), span.code,
            is_knob ? span.target.substr(knob_link.size()) : ""};
}

}  // namespace

void TextLayout::set(const pages::Spans& spans) {
    for (const pages::Span& span : spans) {
        const Look look = look_of(span, base_, color_);
        const std::string& text = span.image ? "[" + span.text + "]" : span.text;
        for (size_t begin = 0; begin <= text.size();) {
            const size_t end = std::min(text.find_first_of(" \n", begin), text.size());
            if (end > begin) word_.push_back({text.substr(begin, end - begin), look, begin > 0 && look.boxed});
            if (end < text.size()) {
                flush();
                if (text[end] == '\n')
                    x_ = 0, y_ += line_;
                else if (x_ > 0)
                    x_ += gap(look);
            }
            begin = end + 1;
        }
    }
    flush();
}

float TextLayout::width_of(const Piece& piece) {
    const char* const text = piece.text.c_str();
    return piece.look.face->CalcTextSizeA(size_of(*piece.look.face), FLT_MAX, 0, text, text + piece.text.size()).x;
}

void TextLayout::flush() {
    float whole = 0;
    for (const Piece& piece : word_) whole += width_of(piece);
    widest_word_ = std::max(widest_word_, whole);
    if (x_ > 0 && x_ + whole > width_) x_ = 0, y_ += line_;
    for (Piece& piece : word_) {
        while (x_ + width_of(piece) > width_) {
            ImFont* const face = piece.look.face;
            const char* const text = piece.text.c_str();
            const char* rest = nullptr;
            face->CalcTextSizeA(size_of(*face), std::max(1.0f, width_ - x_), 0, text, text + piece.text.size(), &rest);
            size_t count = size_t(rest - text);
            while (count < piece.text.size() && (piece.text[count] & 0xc0) == 0x80) ++count;  // whole UTF-8 characters
            if (count >= piece.text.size() || (count == 0 && x_ == 0)) break;
            put({piece.text.substr(0, count), piece.look, piece.goes_on});
            piece.text.erase(0, count);
            x_ = 0, y_ += line_;
        }
        put(piece);
    }
    word_.clear();
}

void TextLayout::put(const Piece& piece) {
    const float width = width_of(piece), size = size_of(*piece.look.face);
    if (visible_) {
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const ImVec2 at{std::floor(corner_.x + x_), std::floor(corner_.y + y_ + (line_ - size) / 2)};
        if (piece.look.boxed && !piece.text.empty()) {
            const bool goes_on = piece.goes_on && x_ > 0;
            list.AddRectFilled({at.x - (goes_on ? gap(piece.look) : 2), at.y - 1}, {at.x + width + 2, at.y + size + 1},
                               code_back, 3, goes_on ? ImDrawFlags_RoundCornersRight : ImDrawFlags_RoundCornersAll);
        }
        list.AddText(piece.look.face, size, at, piece.look.color, piece.text.c_str(),
                     piece.text.c_str() + piece.text.size());
        if (!piece.look.knob.empty() && ImGui::IsWindowHovered() &&
            ImGui::IsMouseHoveringRect({at.x - 2, at.y - 1}, {at.x + width + 2, at.y + size + 1})) {
            list.AddLine({at.x, at.y + size}, {at.x + width, at.y + size}, piece.look.color);
            ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
            if (ImGui::IsMouseReleased(0)) clicked_ = piece.look.knob;
        }
    }
    x_ += width;
    widest_ = std::max(widest_, x_);
}

void wrapped(const pages::Spans& spans, const ImVec4& color) {
    const float width = ImGui::GetContentRegionAvail().x;
    TextLayout layout(ImGui::GetCursorScreenPos(), width, FontRole::text, true, color);
    layout.set(spans);
    ImGui::Dummy({width, layout.height()});
}

}  // namespace relief::window
