#include "framework/course/window/menu_pixel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "framework/core/base/log.h"
#include "framework/core/base/text.h"
#include "framework/course/window/menu_error_map.h"
#include "framework/course/window/menu_stage.h"
#include "framework/course/window/menu_style.h"
#include "framework/course/window/menu_tiles.h"

namespace relief::window {
namespace {

/// Returns the number of channels to show: the last channels of a probe are often unused and 0.
int used_channels(const Image& image, glm::ivec2 pixel, ErrorMetric metric) {
    if (image.pixel(pixel.x, pixel.y)[0] == not_written) return 1;
    int count = metric == ErrorMetric::absolute ? 1 : metric == ErrorMetric::angle ? 3 : image.channels;
    while (metric == ErrorMetric::distance && count > 1 && image.pixel(pixel.x, pixel.y)[count - 1] == 0) --count;
    return count;
}

std::string numbers_at(const Image& image, glm::ivec2 pixel, int channels) {
    const float* const values = image.pixel(pixel.x, pixel.y);
    if (values[0] == not_written) return "a task is not written";
    if (std::isinf(values[0])) return "no surface";
    std::string line;
    for (int c = 0; c < channels; ++c) line += (c ? "  " : "") + rounded(double(values[c]), 5);
    return line;
}

void draw_cross(float x, float y) {
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    for (const auto& [color, width] : {std::pair(IM_COL32(0, 0, 0, 255), 3.0f), std::pair(IM_COL32_WHITE, 1.0f)}) {
        list.AddLine({x - 7, y}, {x + 8, y}, color, width);
        list.AddLine({x, y - 7}, {x, y + 8}, color, width);
    }
}

float width_of_names() { return ImGui::CalcTextSize("exact   ").x; }

/// Returns the size of the box with a title and rows, in pixels.
glm::ivec2 size_of_rows(const std::string& title, const std::vector<PixelRow>& rows) {
    float wide = ImGui::CalcTextSize(title.c_str()).x;
    for (const PixelRow& row : rows)
        wide = std::max(wide, width_of_names() + ImGui::CalcTextSize(row.numbers.c_str()).x);
    const ImGuiStyle& style = ImGui::GetStyle();
    return glm::ivec2(
        std::ceil(wide + 2 * style.WindowPadding.x) + 1,
        std::ceil(float(rows.size() + 1) * ImGui::GetTextLineHeightWithSpacing() + 2 * style.WindowPadding.y));
}

Image pixel_of(const Image& image, glm::ivec2 pixel) {
    Image one(1, 1, image.channels);
    std::copy_n(image.pixel(pixel.x, pixel.y), image.channels, one.values.begin());
    return one;
}

}  // namespace

std::vector<PixelRow> pixel_rows(const ProbeInfo& probe, glm::ivec2 pixel, const Image& values, const Image* exact) {
    int channels = used_channels(values, pixel, probe.error);
    if (exact) channels = std::max(channels, used_channels(*exact, pixel, probe.error));
    std::vector<PixelRow> rows = {{"value", numbers_at(values, pixel, channels)}};
    if (!exact) return rows;
    rows.push_back({"exact", numbers_at(*exact, pixel, channels)});
    const float error = error_image(pixel_of(values, pixel), pixel_of(*exact, pixel), probe.error).values.front();
    if (std::isfinite(error)) rows.push_back({"error", amount_of(double(error), probe.unit)});
    return rows;
}

void draw_rows(const std::vector<PixelRow>& rows) {
    for (const PixelRow& row : rows) {
        quiet_text(row.name);
        ImGui::SameLine(width_of_names() + ImGui::GetStyle().WindowPadding.x);
        text(row.numbers);
    }
}

void PixelValues::draw(const Stage& stage, const ErrorMap& map, glm::ivec2 corner, glm::ivec2 size,
                       const std::vector<Box>& words) {
    const ErrorMap::Compared* const compared = map.compared();
    const Image* const values = compared ? &compared->values : stage.values() ? &*stage.values() : nullptr;
    if (!values || values->width != size.x || values->height != size.y) return;
    const ImGuiIO& io = ImGui::GetIO();
    glm::ivec2 mouse = glm::ivec2(int(io.MousePos.x), int(io.MousePos.y)) - corner;
    const glm::ivec2 half{map.on() && mouse.x >= size.x ? size.x : 0, 0};  // the one under the mouse
    mouse -= half;
    const bool is_over = !io.WantCaptureMouse && mouse.x >= 0 && mouse.y >= 0 && mouse.x < size.x && mouse.y < size.y;
    const float dragged = std::sqrt(io.MouseDragMaxDistanceSqr[0]);
    const bool is_new = is_over && !held_ && ImGui::IsMouseReleased(0) && dragged < 3;
    if (is_new)
        held_ = mouse;
    else if (is_over && ImGui::IsMouseReleased(0) && dragged < 3)
        held_.reset();
    if (!held_ && !is_over) return;
    const glm::ivec2 pixel = glm::clamp(held_.value_or(mouse), glm::ivec2(0), size - 1);
    if (held_)
        for (int copy = 0; copy <= int(map.on()); ++copy)
            draw_cross(float(corner.x + copy * size.x + pixel.x), float(corner.y + pixel.y));

    const ProbeInfo& probe = compared ? compared->probe : stage.manifest().probe(stage.probe().name);
    const std::string title = fmt::format("{} at {}, {}{}", probe.name, pixel.x, pixel.y, held_ ? ", held" : "");
    const std::vector<PixelRow> rows = pixel_rows(probe, pixel, *values, compared ? &compared->exact : nullptr);
    const glm::ivec2 shown = corner + pixel + (held_ ? glm::ivec2(0) : half);
    const glm::ivec2 extent = size_of_rows(title, rows);
    const glm::ivec2 at = beside(shown, extent, {corner, {size.x * (1 + int(map.on())), size.y}}, words);
    ImGui::SetNextWindowPos({float(at.x), float(at.y)});
    ImGui::SetNextWindowSize({float(extent.x), float(extent.y)});
    ImGui::Begin("pixel", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoFocusOnAppearing);
    quiet_text(title);
    draw_rows(rows);
    ImGui::End();
    if (!is_new) return;
    std::string line = fmt::format("pixel {}, {}: {}", pixel.x, pixel.y, probe.name);
    for (const PixelRow& row : rows) line += fmt::format(", {} {}", row.name, row.numbers);
    print_event(line);
}

}  // namespace relief::window
