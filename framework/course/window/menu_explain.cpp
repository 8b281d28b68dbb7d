#include "framework/course/window/menu_explain.h"

#include <fmt/format.h>

#include <algorithm>

#include "framework/core/base/error.h"
#include "framework/core/base/from_staff.h"
#include "framework/core/base/log.h"
#include "framework/core/base/text.h"
#include "framework/course/explain/explain_text.h"
#include "framework/course/window/menu_imgui.h"
#include "framework/course/window/menu_stage.h"
#include "framework/course/window/menu_style.h"

namespace relief::window {

void PixelExplanation::compute(const Stage& stage) {
    Shot shot = stage.settings();
    shot.size = stage.size();
    std::string said;
    conclusion_.clear();
    try {
        open_staff_library();
        const check::Twins twins = check::twins_of(stage.manifest());
        const check::Explanation explanation = check::explain(stage.entry(), stage.manifest(), shot, *pixel_, twins);
        const check::PixelReport report{stage.entry(), stage.manifest(), shot, *pixel_, explanation, {},
                                        !twins.empty()};
        said = check::text_of(report);
        conclusion_ = check::conclusion_of(report);
        for (const check::ExplainedFunction& one : explanation.functions)
            print_event(fmt::format("pixel {}, {}: {}, {} call{}", pixel_->x, pixel_->y, one.function.name, one.calls,
                                    one.calls == 1 ? "" : "s"));
    } catch (const Error& error) {
        said = error.what();
        print_event(fmt::format("pixel {}, {}: {}", pixel_->x, pixel_->y, said));
    }
    lines_ = split(said, '\n');
    if (lines_.size() > 1 && lines_.back().empty()) lines_.pop_back();
}

void PixelExplanation::draw(const Box& picture, float scale) {
    if (!is_open()) return;
    const float margin = 16 * scale, width = std::clamp(float(picture.size.x) - 2 * margin, 100.0f, 760 * scale);
    ImGui::SetNextWindowPos({float(picture.at.x) + margin, float(picture.at.y) + margin});
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, std::max(1.0f, float(picture.size.y) - 2 * margin)});
    ImGui::Begin("explain", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
    if (lines_.empty()) quiet_text(fmt::format("Following pixel {}, {} ...", pixel_->x, pixel_->y));
    if (!lines_.empty() && !conclusion_.empty()) colored_text(accent, conclusion_);
    push_font(font(FontRole::code));
    for (const std::string& line : lines_)
        if (line.starts_with('>'))
            colored_text(alarm, line);
        else
            text(line);
    ImGui::PopFont();
    if (!lines_.empty()) quiet_text("Esc closes this.");
    ImGui::End();
    told_ = true;
}

}  // namespace relief::window
