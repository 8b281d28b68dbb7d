// Draws one fragment shader over a whole framebuffer.
#pragma once

#include "framework/core/base/paths.h"
#include "framework/core/gl/program.h"
#include "framework/library/kit/drawn_numbers.h"
#include "framework/library/kit/window_triangle.h"
#include "tests/support.h"

namespace relief {

/// Returns a program whose fragment shader is `text` after the version. Its input v_clip is the position in the
/// viewport, from (-1, -1) to (1, 1).
inline Program window_program(const std::string& text) {
    const TemporaryFolder folder;
    return Program({course_root() / "shaders/common/window.vert", folder.write("a.frag", "#version 410 core\n" + text)},
                   {});
}

/// Returns four floats per pixel of that program. `set` sets its uniforms.
inline Image draw_fragments(const std::string& text, glm::ivec2 size, const std::function<void(const Program&)>& set) {
    const Program program = window_program(text);
    WindowTriangle window;
    return draw_numbers(size, [&] {
        glUseProgram(program);
        set(program);
        window.draw();
    });
}

/// Returns the floats of the one pixel.
inline glm::vec4 draw_fragment(const std::string& text, const std::function<void(const Program&)>& set) {
    const Image image = draw_fragments(text, {1, 1}, set);
    return {image.values[0], image.values[1], image.values[2], image.values[3]};
}

}  // namespace relief
