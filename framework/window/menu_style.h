// Colours, fonts and lines of text that the parts of the menu share. In the window module only.
#pragma once

#include <imgui.h>

#include <string>

namespace relief {

inline const ImVec4 accent{0.90f, 0.54f, 0.36f, 1}, quiet{0.62f, 0.63f, 0.65f, 1}, alarm{1, 0.45f, 0.38f, 1},
    good{0.47f, 0.80f, 0.45f, 1}, waiting{0.93f, 0.76f, 0.35f, 1};

/// Of the parts that have their place: they are neither moved nor saved, and stay below what opens over them.
constexpr ImGuiWindowFlags fixed_window = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

/// Of formulas: on the line, in scripts, and sums.
enum class FontRole { text, bold, title, code, formula, script, sum };

/// Colours, sizes and fonts, between two frames. The texture of the fonts is then that of another scale.
void style_menu(float scale);
ImFont* font(FontRole role);

constexpr float header_height(float scale) { return 42 * scale; }
constexpr float status_height(float scale) { return 27 * scale; }

void text(const std::string& line);
void wrapped(const std::string& line);
void quiet_text(const std::string& line);
void colored_text(const ImVec4& color, const std::string& line);
/// Below the mouse while it rests on the item before; as wide as sentences are read well.
void tooltip(const std::string& text);

}  // namespace relief
