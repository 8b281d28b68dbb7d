// Where the parts of the window stand, and the borders that can be dragged. In the window module only.
#pragma once

#include <imgui.h>

#include <glm/glm.hpp>

namespace relief {

/// Pixels, from the upper left corner of the window.
struct Box {
    glm::ivec2 at{0, 0}, size{0, 0};
    int right() const { return at.x + size.x; }
    int bottom() const { return at.y + size.y; }
    bool operator==(const Box&) const = default;
};

/// The header at the top and the status at the bottom are as wide as the window; between them stand the panel, the
/// picture and the handout. What is not shown has no size.
struct Layout {
    Box header, panel, picture, handout, status;
};

/// What is shown beside the picture.
struct Shown {
    bool panel = true;  ///< with header and status
    bool handout = false;
};

class Borders {
public:
    Layout layout(glm::ivec2 window, float scale, Shown shown) const;
    /// The borders of what is shown follow the mouse.
    void drag(const Layout& layout, float scale);

private:
    float panel_ = 340, handout_ = 480;  ///< wanted widths, pixels at scale 1
};

/// Begins a part of the window that fills the box. ImGui::End() ends it.
void begin_in(const Box& box, const char* name, ImVec2 padding, bool scrolls);

/// A vertical line that can be dragged, from `top` to `bottom`; `x` follows the mouse. Returns whether it moved.
bool drag_border(const char* name, float& x, float top, float bottom, float scale, bool with_handle);

}  // namespace relief
