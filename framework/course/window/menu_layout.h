// Positions of the window's parts, and the borders that the mouse can drag. In the window module only.
#pragma once

#include <imgui.h>

#include <glm/glm.hpp>

namespace relief::window {

/// In pixels, from the upper left corner of the window.
struct Box {
    glm::ivec2 at{0, 0}, size{0, 0};
    int right() const { return at.x + size.x; }
    int bottom() const { return at.y + size.y; }
    bool operator==(const Box&) const = default;
};

/// The header at the top and the status at the bottom have the window's width. The panel, the picture and the handout
/// stand between them, and the legend of the error map below the picture. Hidden parts have size 0.
struct Layout {
    Box header, panel, picture, legend, handout, status;
};

/// The visible parts beside the picture.
struct Shown {
    bool panel = true;  ///< also header and status
    bool handout = false;
    bool legend = false;
};

class Borders {
public:
    Layout layout(glm::ivec2 window, float scale, Shown shown) const;
    /// Lets the mouse drag the visible borders.
    void drag(const Layout& layout, float scale);

private:
    float panel_ = 340, handout_ = 480;  ///< preferred widths, pixels at scale 1
};

/// Begins an ImGui window that fills the box. ImGui::End() ends it.
void begin_in(const Box& box, const char* name, ImVec2 padding, bool scrolls);

/// Draws a vertical border from `top` to `bottom` that the mouse can drag along x. Returns whether it moved.
bool drag_border(const char* name, float& x, float top, float bottom, float scale, bool with_handle);

}  // namespace relief::window
