// Colours, fonts and lines of text that the parts of the menu share. In the window module only.
#pragma once

#include <imgui.h>

#include <string>

namespace relief {

inline const ImVec4 accent{0.90f, 0.54f, 0.36f, 1}, quiet{0.62f, 0.63f, 0.65f, 1}, alarm{1, 0.45f, 0.38f, 1},
    good{0.47f, 0.80f, 0.45f, 1};

enum class FontRole { text, bold, title, code };

/// Colours, sizes and fonts; call it once, before the first frame.
void style_menu(float scale);
ImFont* font(FontRole role);

void text(const std::string& line);
void wrapped(const std::string& line);
void quiet_text(const std::string& line);

}  // namespace relief
