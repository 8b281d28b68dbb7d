// Styled text wrapped to a width, as in handouts. In the window module only.
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>
#include <vector>

#include "framework/course/pages/markdown.h"
#include "framework/course/window/menu_imgui.h"
#include "framework/course/window/menu_style.h"

namespace relief::window {

inline const ImVec4 plain_color{0.88f, 0.88f, 0.86f, 1}, code_color{0.95f, 0.82f, 0.70f, 1};
constexpr ImU32 code_back = IM_COL32(46, 48, 56, 255), line_color = IM_COL32(84, 86, 94, 255);

/// Prefix of the target of a link to a knob.
constexpr std::string_view knob_link = "knob:";

/// How a span looks. Italics have the quiet colour: Debian's small DejaVu package has no slanted faces.
struct Look {
    ImFont* face;
    ImU32 color;
    bool boxed = false;
    std::string knob = {};  ///< knob that a click sets or shows: "method", "method=steep"
};

/// Sets words from left to right in lines of a width. Breaks a word that is wider than a line.
class TextLayout {
public:
    TextLayout(ImVec2 corner, float width, FontRole base, bool visible, const ImVec4& color = plain_color)
        : corner_(corner), width_(width), base_(base), visible_(visible), color_(color), line_(line_height(base)) {}

    void set(const pages::Spans& spans);
    float height() const { return y_ + line_; }
    float widest() const { return widest_; }
    float widest_word() const { return widest_word_; }
    /// The clicked knob, or empty.
    const std::string& clicked() const { return clicked_; }

    static float line_height(FontRole base) { return size_of(*font(base)) * 1.35f; }

private:
    struct Piece {
        std::string text;
        Look look;
        bool goes_on;  ///< drawn in the box of the word before
    };
    static float gap(const Look& look) { return size_of(*look.face) * (look.boxed ? 0.6f : 0.36f); }
    static float width_of(const Piece& piece);
    void flush();
    void put(const Piece& piece);

    ImVec2 corner_;
    float width_;
    FontRole base_;
    bool visible_;
    ImVec4 color_;  ///< of text without a style of its own
    float line_, x_ = 0, y_ = 0, widest_ = 0, widest_word_ = 0;
    std::vector<Piece> word_;
    std::string clicked_;
};

/// Sets spans at the cursor over the remaining width of the window. Moves the cursor below them.
void wrapped(const pages::Spans& spans, const ImVec4& color);

}  // namespace relief::window
