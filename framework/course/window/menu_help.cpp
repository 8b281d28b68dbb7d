#include "framework/course/window/menu_help.h"

#include <fmt/format.h>

#include <algorithm>

#include "framework/course/window/menu_imgui.h"
#include "framework/course/window/menu_style.h"

namespace relief::window {
namespace {

struct Line {
    const char *keys, *does;
};
constexpr Line camera[] = {{"drag", "turn the camera"},       {"right drag", "move it sideways"},
                           {"wheel", "nearer, farther"},      {"C", "reset the camera"},
                           {"T", "let it turn; again: stop"}, {"space", "pause what moves"}};
constexpr Line settings[] = {{"Ctrl+Z, Ctrl+Y", "undo, redo"},
                             {"Ctrl+click", "type a slider's number"},
                             {"right click", "let a slider run over its range; again: stop"},
                             {"A", "compare with this setting; again: stop comparing"},
                             {"X", "swap A and the present setting"},
                             {"R", "reset the lab: knobs, camera, probe"}};
constexpr Line looks[] = {{"click", "hold the values of the pixel under the mouse"},
                          {"P", "follow the pixel under the mouse through the task's functions"},
                          {"E", "error map"},
                          {"S, F12", "save the picture"},
                          {"M", "save the map that the lab makes, as PNG of 16 bits"},
                          {"B", "a brush for the heights (lab 03): a drag paints, Ctrl+Z takes a stroke back"},
                          {"N", "save the heights, as PNG of 16 bits"},
                          {"H", "the picture alone, without header, panel and status"}};
constexpr Line places[] = {{"Home", "all labs, with a picture and the points of each"},
                           {"left, right", "the lab before, the next lab"},
                           {"Ctrl+F, /", "search labs, knobs and their values, probes, checks, headings and words"},
                           {"F6", "give the keys to the panel, then to the header: arrows, space, Enter; Esc: back"},
                           {"F1", "handout; up, down, Page Up and Page Down scroll it"},
                           {"Ctrl +, Ctrl -", "larger, smaller, also at the next start; Ctrl+0: the usual size"},
                           {"Ctrl+E", "the line of a shader's error in your editor"},
                           {"?", "these keys"},
                           {"Esc", "close what is open"},
                           {"Ctrl+Q", "quit"}};

template <size_t count>
void draw_lines(const char* title, const Line (&lines)[count], float keys_width) {
    ImGui::TextColored(accent, "%s", title);
    const float left = ImGui::GetCursorPosX();
    for (const Line& line : lines) {
        push_font(font(FontRole::bold));
        ImGui::TextUnformatted(line.keys);
        ImGui::PopFont();
        ImGui::SameLine();
        ImGui::SetCursorPosX(left + keys_width);
        wrapped(line.does);
    }
    ImGui::Dummy({0, 4});
}

}  // namespace

void draw_help(const Box& picture, float scale, bool& open) {
    if (!open) return;
    const float room = ImGui::GetIO().DisplaySize.x - 32 * scale;
    const int columns = room >= 940 * scale ? 2 : 1;
    const float width = std::min(float(columns) * 500 * scale, room);
    const float middle = float(picture.at.x) + float(picture.size.x) / 2;
    // Beside a narrow picture it covers the panel, too. In a low window it scrolls.
    const float x = std::clamp(middle - width / 2, 8.0f, std::max(8.0f, ImGui::GetIO().DisplaySize.x - width - 8));
    ImGui::SetNextWindowPos({x, ImGui::GetIO().DisplaySize.y / 2}, ImGuiCond_Always, {0, 0.5f});
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, ImGui::GetIO().DisplaySize.y - 16});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    ImGui::Begin("keys", &open,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize);
    ImGui::PopStyleVar();
    push_font(font(FontRole::title));
    ImGui::TextUnformatted("Keys and mouse");
    ImGui::PopFont();
    const float keys_width = 125 * scale;
    if (ImGui::BeginTable("columns", columns, ImGuiTableFlags_SizingStretchSame)) {
        ImGui::TableNextColumn();
        draw_lines("Camera", camera, keys_width);
        draw_lines("Pictures and values", looks, keys_width);
        ImGui::TableNextColumn();  // the next row, if there is one column
        draw_lines("Settings", settings, keys_width);
        draw_lines("Labs and the window", places, keys_width);
        ImGui::EndTable();
    }
    quiet_text(
        "A saved shader is reloaded at once, and the checks run again. A picture file dropped on the window becomes "
        "the lab's map, and an OBJ or glTF file its shape.");
    if (ImGui::IsMouseClicked(0) && !ImGui::IsWindowAppearing() && !ImGui::IsWindowHovered()) open = false;
    ImGui::End();
}

}  // namespace relief::window
