#include "framework/course/window/menu_status.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "framework/core/base/text.h"
#include "framework/core/gl/counters.h"
#include "framework/course/window/menu_stage.h"
#include "framework/course/window/menu_style.h"

namespace relief::window {
namespace {

/// Returns "1 draw call", "2 draw calls".
std::string count_of(int64_t count, const std::string& thing) {
    return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

std::string live_objects() {
    static constexpr std::array<const char*, gl_kinds> kinds = {
        "buffers", "vertex arrays", "textures",  "samplers", "framebuffers",       "renderbuffers",
        "shaders", "programs",      "pipelines", "queries",  "transform feedbacks"};
    const Counters& now = counters();
    std::string list;
    for (size_t i = 0; i < kinds.size(); ++i)
        if (now.live[i] != 0) list += fmt::format("{}{} {}", list.empty() ? "" : ", ", now.live[i], kinds[i]);
    return list;
}

/// Draws the last frames as bars, scaled to the slowest of them.
void draw_graph(const std::array<float, 60>& milliseconds, ImVec2 size) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, IM_COL32(30, 32, 37, 255), 2);
    const float slowest = std::max(1e-3f, *std::max_element(milliseconds.begin(), milliseconds.end()));
    const float width = size.x / float(milliseconds.size());
    for (size_t i = 0; i < milliseconds.size(); ++i) {
        const float height = milliseconds[i] / slowest * (size.y - 2);
        const float left = at.x + float(i) * width;
        list.AddRectFilled({left, at.y + size.y - height}, {left + width, at.y + size.y},
                           ImGui::ColorConvertFloat4ToU32(accent));
    }
    ImGui::Dummy(size);
    tooltip(fmt::format("The last {} of the lab; the highest bar took {} ms.",
                        count_of(int64_t(milliseconds.size()), "frame"), rounded(double(slowest))));
}

}  // namespace

void Status::note(double milliseconds) {
    std::rotate(milliseconds_.begin(), milliseconds_.begin() + 1, milliseconds_.end());
    milliseconds_.back() = float(milliseconds);
}

void Status::draw(const Box& box, float scale, const Stage& stage, const std::string& message) const {
    if (box.size.y == 0) return;
    begin_in(box, "status", {14 * scale, 5 * scale}, false);
    draw_graph(milliseconds_, {60 * scale, ImGui::GetTextLineHeight()});

    // The most important items come first. Items that do not fit are left out.
    const std::string camera = "--camera " + camera_text(stage.shot().camera);
    const float gap = 18 * scale, right = float(box.size.x) - 14 * scale - ImGui::CalcTextSize(camera.c_str()).x;
    const auto put = [&](const std::string& line, const ImVec4& color, const std::string& help) {
        ImGui::SameLine(0, gap);
        if (ImGui::GetCursorPosX() + ImGui::CalcTextSize(line.c_str()).x + gap > right) return;
        ImGui::TextColored(color, "%s", line.c_str());
        if (!help.empty()) tooltip(help);
    };
    const ImVec4& plain_text = ImGui::GetStyle().Colors[ImGuiCol_Text];
    put(rounded(stage.milliseconds()) + " ms", plain_text, "The last frame, to its end on the GPU.");
    if (!message.empty()) put(message, accent, message);
    const Counters& now = counters();
    put(count_of(stage.draw_calls(), "draw call"), quiet, "Draw calls in the last frame.");
    put(rounded(double(now.texture_bytes) / (1 << 20)) + " MiB", quiet, "Memory of all textures.");
    put(count_of(now.live_objects(), "GL object"), quiet, live_objects());
    put(count_of(stage.frames(), "frame"), quiet, "Frames of labs since the window opened.");

    ImGui::SameLine(std::max(ImGui::GetCursorPosX(), right));
    ImGui::PushStyleColor(ImGuiCol_Text, quiet);
    ImGui::TextUnformatted(camera.c_str());
    ImGui::PopStyleColor();
    if (ImGui::IsItemClicked()) ImGui::SetClipboardText(camera.c_str());
    tooltip("The camera as relief shot and relief run take it. A click copies it.");
    ImGui::End();
}

}  // namespace relief::window
