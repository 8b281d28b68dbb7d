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
        if (!layout_) layout_.emplace();
        const bool tests_depth = glIsEnabled(GL_DEPTH_TEST);
        glDisable(GL_DEPTH_TEST);
        glBindVertexArray(*layout_);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        if (tests_depth) glEnable(GL_DEPTH_TEST);
    }

private:
    std::optional<VertexArrayName> layout_;
};

}  // namespace relief
