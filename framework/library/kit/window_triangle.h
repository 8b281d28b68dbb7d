// A draw over the whole viewport.
#pragma once

#include <optional>

#include "framework/core/lab/lab.h"

namespace relief {

/// One triangle that covers the viewport. It has no attributes: the vertex shader makes its corners from gl_VertexID.
class WindowTriangle {
public:
    /// Draws it without the depth test, whose state it restores. Precondition: a program is in use.
    void draw() {
        const bool tests_depth = glIsEnabled(GL_DEPTH_TEST);
        glDisable(GL_DEPTH_TEST);
        draw_three();
        if (tests_depth) glEnable(GL_DEPTH_TEST);
    }
    /// Draws it where no depth was written, with common/far_window.vert as the vertex shader. Preconditions: the
    /// program is in use, and the depth test is on. Leaves the depth function GL_LESS.
    void draw_behind() {
        glDepthFunc(GL_LEQUAL);  // the triangle is at the far plane
        draw_three();
        glDepthFunc(GL_LESS);
    }

private:
    void draw_three() {
        if (!layout_) layout_.emplace();
        glBindVertexArray(*layout_);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }

    std::optional<VertexArrayName> layout_;
};

}  // namespace relief
