// Colours, fonts and text functions that the parts of the menu share. In the window module only.
#pragma once

#include <imgui.h>

#include <string>

namespace relief::window {

inline const ImVec4 accent{0.90f, 0.54f, 0.36f, 1}, quiet{0.62f, 0.63f, 0.65f, 1}, alarm{1, 0.45f, 0.38f, 1},
    good{0.47f, 0.80f, 0.45f, 1}, amber{0.93f, 0.76f, 0.35f, 1};

/// For parts with a fixed place: not movable, not saved, and below everything that opens over them.
constexpr ImGuiWindowFlags fixed_window = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

/// For formulas: `formula` is text on the baseline, `script` is sub- and superscripts, `sum` is the large sum sign.
enum class FontRole { text, bold, title, code, formula, script, sum };

/// Sets colours, sizes and fonts. Call it between frames, then upload the font texture again: it has another scale.
void style_menu(float scale);
ImFont* font(FontRole role);

constexpr float header_height(float scale) { return 42 * scale; }
constexpr float status_height(float scale) { return 27 * scale; }

void text(const std::string& line);
/// Returns lines of at most `width` pixels, broken at blanks. Dear ImGui alone also breaks after punctuation, as in
/// "0." and "26". It still breaks a word that is wider.
std::string broken_at_blanks(std::string lines, float width);
/// Shows text in lines that end at `right`, pixels from the window's left border, or at the window's contents if 0.
void wrapped(const std::string& line, float right = 0);
void quiet_text(const std::string& line);
void colored_text(const ImVec4& color, const std::string& line);
/// Shows a tooltip while the mouse rests on the previous item, wrapped at a readable width.
void tooltip(const std::string& text);

}  // namespace relief::window
