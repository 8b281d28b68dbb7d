#include "framework/course/window/menu_picture.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/image/file.h"
#include "framework/course/pages/svg.h"
#include "framework/course/window/menu_imgui.h"
#include "framework/course/window/menu_style.h"

namespace relief::window {
namespace {

/// Width of diagrams including margins, in font sizes, as on the handout's web page.
constexpr float diagram_width = 36;
/// Margin around a diagram, in the same unit.
constexpr float paper_margin = 0.8f;

void put(GLuint texture, ImVec2 at, ImVec2 size) {
    ImGui::GetWindowDrawList()->AddImage(texture_id(texture), at, {at.x + size.x, at.y + size.y}, {0, 1},
                                         {1, 0});  // row 0 of a texture is the bottom
}

}  // namespace

HandoutPicture::HandoutPicture(const std::filesystem::path& file) : name_(file.filename().string()) {
    if (file.extension() == ".svg") {
        svg_ = read_file(file, size_t{1} << 20);
        size_ = svg_size(svg_);
        return;
    }
    const auto read = [this, file] {
        Image image = read_image(file);
        size_ = {image.width, image.height};
        return image;
    };
    texture_.emplace(name_, read, TextureOptions{.wrap = Wrap::clamp, .anisotropy = 1});
}

void HandoutPicture::draw(float width) {
    if (svg_.empty())
        draw_image(width);
    else
        draw_diagram(width);
}

void HandoutPicture::draw_image(float width) const {
    const GLuint texture = *texture_;  // loads it and sets size_
    const float share = std::min(1.0f, width / float(size_.x));
    const ImVec2 size(float(size_.x) * share, float(size_.y) * share);
    put(texture, ImGui::GetCursorScreenPos(), size);
    ImGui::Dummy(size);
}

// Rounds to whole pixels, so that texels match the screen's pixels.
void HandoutPicture::draw_diagram(float width) {
    const float letter = size_of(*font(FontRole::text)), margin = std::round(paper_margin * letter);
    const int columns = std::max(1, int(std::min(width, diagram_width * letter) - 2 * margin));
    const int rows = std::max(1, int(std::lround(double(columns) * size_.y / size_.x)));
    if (drawn_ != glm::ivec2(columns, rows)) {
        drawn_ = {columns, rows};
        texture_.emplace(
            name_, [this] { return draw_svg(svg_, drawn_); }, TextureOptions{.wrap = Wrap::clamp, .mips = false});
    }
    const GLuint texture = *texture_;  // before drawing its background: creating it may throw
    const ImVec2 cursor = ImGui::GetCursorScreenPos(), at(std::floor(cursor.x), std::floor(cursor.y));
    const ImVec2 size{float(columns), float(rows)}, whole{size.x + 2 * margin, size.y + 2 * margin};
    ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + whole.x, at.y + whole.y}, IM_COL32_WHITE, letter / 2);
    put(texture, {at.x + margin, at.y + margin}, size);
    ImGui::Dummy(whole);
}

}  // namespace relief::window
