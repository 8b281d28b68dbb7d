#include "framework/course/window/menu_error.h"

#include <fmt/format.h>

#include <algorithm>

#include "framework/core/base/folded_text.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/source_text.h"
#include "framework/core/base/text.h"
#include "framework/course/window/menu_imgui.h"
#include "framework/course/window/menu_stage.h"
#include "framework/course/window/menu_style.h"

namespace relief::window {
namespace {

constexpr int around = 2;  // lines before and after the line of the error

/// Returns the absolute path of a file, which may be relative to the course's top folder.
std::filesystem::path whole_path(const std::filesystem::path& file) {
    return file.is_absolute() ? file : course_root() / file;
}

void draw_source(const std::vector<std::string>& lines, int first, int wrong, const std::string& mark) {
    push_font(font(FontRole::code));
    for (size_t i = 0; i < lines.size(); ++i) {
        const int number = first + int(i);
        const std::string line = fmt::format("{:>5}  {}", number, lines[i]);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        if (number == wrong)
            ImGui::GetWindowDrawList()->AddRectFilled(
                at, {at.x + ImGui::GetContentRegionAvail().x, at.y + ImGui::GetTextLineHeight() + 2},
                IM_COL32(255, 115, 97, 60), 2);
        ImGui::PushStyleColor(ImGuiCol_Text, number == wrong ? ImGui::GetStyle().Colors[ImGuiCol_Text] : quiet);
        text(line);
        ImGui::PopStyleColor();
        if (number == wrong && !mark.empty()) text(std::string(7, ' ') + mark);
    }
    ImGui::PopFont();
}

}  // namespace

void ErrorBox::read(const Error& error) {
    const Place& place = error.place();
    const FoldedText parts = unfolded_text(error.details());
    lines_.clear(), mark_.clear(), details_.clear();
    folded_ = parts.folded;
    std::vector<std::string> details = split(parts.shown, '\n');
    const auto is_mark = [](const std::string& line) { return line.find_first_not_of(' ') + 1 == line.size(); };
    if (place.line > 0 && details.size() > 1 && details[1].ends_with('^') && is_mark(details[1]))
        mark_ = details[1].substr(4);
    // The box shows the quoted line among its neighbours, with the mark below it.
    if (place.line > 0 && details[0].starts_with("    "))
        details.erase(details.begin(), details.begin() + (mark_.empty() ? 1 : 2));
    details_ = join(details, "\n");
    while (details_.ends_with('\n')) details_.pop_back();
    if (place.line <= 0) return;
    try {
        const std::vector<std::string> all = split(read_source(whole_path(place.file)), '\n');
        first_ = std::max(1, place.line - around);
        for (int line = first_; line <= std::min(int(all.size()), place.line + around); ++line) {
            const std::string text = marked_line(all[size_t(line - 1)], std::string::npos);
            lines_.push_back(text.substr(4, text.size() - 5));  // without indent and line end
        }
    } catch (const Error&) {  // a missing file: the error itself says so
    }
}

void ErrorBox::draw(const Box& picture, float scale, const Stage& stage, MenuWish& wish) {
    const Error* const error = stage.error();
    if (!error) return shown_.clear();
    if (shown_ != error->what()) read(*error), shown_ = error->what();
    const float margin = 16 * scale;
    const float width = std::max(100.0f, float(picture.size.x) - 2 * margin);
    ImGui::SetNextWindowPos({float(picture.at.x) + margin, float(picture.at.y) + margin});
    // A long log scrolls, so that the last good picture stays in view below it.
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, float(picture.size.y) * 0.45f});
    ImGui::Begin("error", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
    colored_text(alarm, error->what());
    if (!lines_.empty()) draw_source(lines_, first_, error->place().line, mark_);
    if (!details_.empty()) {
        push_font(font(FontRole::code));
        wrapped(details_);
        ImGui::PopFont();
    }
    if (!folded_.empty() && ImGui::TreeNode("folded", "%s", more_messages(folded_.size()).c_str())) {
        for (const std::string& message : folded_) wrapped(message);
        ImGui::TreePop();
    }
    quiet_text(stage.shaders() != ShaderState::failed
                   ? "Change it, close the window, and start the lab again: that compiles C++."
               : stage.lab() ? "Fix the shader and save it: it reloads at once. After any other change press R."
                             : "Fix it, then press R.");
    if (!error->place().file.empty() && ImGui::Button("Open in the editor (Ctrl+E)")) wish.edit = error->place();
    ImGui::End();
}

}  // namespace relief::window
