#include "framework/course/window/menu_present.h"

#include <fmt/format.h>

#include <algorithm>

#include "framework/course/window/menu_header.h"
#include "framework/course/window/menu_stage.h"
#include "framework/course/window/menu_style.h"
#include "framework/course/window/menu_wipe.h"

namespace relief::window {

void draw_note(const Box& picture, const std::string& note, bool is_alone) {
    const float margin = ImGui::GetStyle().WindowPadding.x;
    const ImVec2 size = ImGui::CalcTextSize(note.c_str()), box{size.x + 2 * margin, size.y + margin};
    ImVec2 at{float(picture.at.x) + margin, float(picture.bottom()) - margin - box.y};
    if (is_alone)
        at = {float(picture.at.x) + std::max(margin, (float(picture.size.x) - box.x) / 2),
              float(picture.at.y) + (float(picture.size.y) - box.y) / 2};
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    list.AddRectFilled(at, {at.x + box.x, at.y + box.y}, IM_COL32(16, 17, 20, 255), 4);
    list.AddText({at.x + margin, at.y + margin / 2}, ImGui::ColorConvertFloat4ToU32(accent), note.c_str());
}

void draw_opening(const Box& picture, const Stage& stage) {
    const std::string step = stage.step() + " ...";
    const bool has_backdrop = stage.backdrop().framebuffer != 0;
    if (!stage.is_opening()) return draw_note(picture, step, !stage.framebuffer());
    if (has_backdrop)
        ImGui::GetBackgroundDrawList()->AddRectFilled({float(picture.at.x), float(picture.at.y)},
                                                      {float(picture.right()), float(picture.bottom())},
                                                      IM_COL32(16, 17, 20, 150));
    draw_note(picture, fmt::format("opening {}: {}", title_of(stage.entry()), step), !has_backdrop);
}

void present(glm::ivec2 window, const Box& picture, const Stage& stage, const Wipe& wipe) {
    const int left = picture.at.x, width = picture.size.x;
    const int bottom = window.y - picture.bottom(), top = window.y - picture.at.y;  // rows count from the bottom
    const auto copy = [&](GLuint from, int begin, int end) {
        glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
        glBlitFramebuffer(begin, 0, end, picture.size.y, left + begin, bottom, left + end, top, GL_COLOR_BUFFER_BIT,
                          GL_NEAREST);
    };
    const Stage::Backdrop& backdrop = stage.backdrop();
    if (stage.framebuffer()) {
        const int held = wipe.shown_columns(width);
        if (held > 0) copy(wipe.framebuffer(), 0, held);
        if (held < width) copy(stage.framebuffer(), held, width);
    } else if (backdrop.framebuffer) {
        glBindFramebuffer(GL_READ_FRAMEBUFFER, backdrop.framebuffer);
        glBlitFramebuffer(0, 0, backdrop.size.x, backdrop.size.y, left, bottom, picture.right(), top,
                          GL_COLOR_BUFFER_BIT, GL_LINEAR);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace relief::window
