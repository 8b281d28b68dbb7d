#include "framework/course/window/menu_brush.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "framework/course/window/menu_stage.h"
#include "framework/course/window/menu_style.h"
#include "framework/course/window/menu_wish.h"

namespace relief::window {
namespace {

constexpr size_t most_strokes = 50;  // a quarter of a megabyte each

Paintable* paintable(const Stage& stage) { return dynamic_cast<Paintable*>(stage.lab()); }

}  // namespace

bool Brush::toggle(const Stage& stage) {
    is_on_ = !is_on_ && paintable(stage);
    is_down_ = false;
    return paintable(stage);
}

void Brush::forget() {
    is_on_ = is_down_ = false;
    before_.clear(), after_.clear();
}

void Brush::draw(Stage& stage, MenuWish& wish) {
    if (!paintable(stage) || !ImGui::CollapsingHeader("Brush", ImGuiTreeNodeFlags_DefaultOpen)) return;
    if (bool on = is_on_; ImGui::Checkbox("paint heights", &on)) toggle(stage);
    tooltip("A drag in the picture paints, instead of turning the camera (B).");
    for (const auto& [kind, name] :
         {std::pair(Dab::raise, "raise"), std::pair(Dab::lower, "lower"), std::pair(Dab::smooth, "smooth")}) {
        if (kind != Dab::raise) ImGui::SameLine();
        ImGui::RadioButton(name, &kind_, kind);
    }
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x * 0.5f);
    ImGui::SliderFloat("width", &width_, 4, 128, "%.0f texels");
    tooltip("Width of the brush. The map has 256 texels along each side.");
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x * 0.5f);
    ImGui::SliderFloat("strength", &strength_, 0.01f, 1, "%.2f");
    tooltip("How much a stroke changes a height; 1 is all of the relief's depth.");
    if (ImGui::Button("Undo") && !undo(stage)) wish.message = "no stroke to take back";
    tooltip("Takes the last stroke back (Ctrl+Z, while the brush is on).");
    ImGui::SameLine();
    if (ImGui::Button("Save heights")) wish.ask(LabAction::save_heights);
    tooltip("Saves the heights, as PNG of 16 bits, under a new name (N). --set source=FILE shows them again.");
    ImGui::Dummy({0, 6});
}

void Brush::begin_stroke(PaintLayer& layer) {
    if (before_.size() == most_strokes) before_.erase(before_.begin());
    before_.push_back(layer.values());
    after_.clear();
}

void Brush::move(Stage& stage, glm::dvec2 pixel, bool is_down) {
    Paintable* const lab = paintable(stage);
    const bool begins = is_down && !is_down_;
    is_down_ = is_down && is_on_ && lab;
    if (!is_down_ || (!begins && pixel == last_)) return;
    const Frame frame = stage.frame();
    const auto at = [&](glm::dvec2 place) { return lab->place_on_map(frame, place); };
    const glm::dvec2 from = begins ? pixel : last_;
    last_ = pixel;
    const double radius = double(width_) / 2 / PaintLayer::side;
    // Dabs lie a quarter of the radius apart, and add up to the strength.
    const double pixels = glm::distance(from, pixel);
    const auto first = at(from), last = at(pixel);
    double way = first && last ? glm::length(*last - *first) : radius;
    way = std::min(way, 0.5);  // a stroke across a border of the map is short
    const int dabs = std::clamp(int(std::ceil(4 * way / radius)), 1, 200);
    if (begins) begin_stroke(lab->paint_layer());
    for (int i = 1; i <= dabs; ++i) {
        const auto place = at(pixels > 0 ? glm::mix(from, pixel, double(i) / dabs) : pixel);
        if (!place) continue;
        const double strength = kind_ == Dab::smooth ? double(strength_) : double(strength_) / 4;
        lab->paint({Dab::Kind(kind_), *place, radius, strength});
    }
    stage.redraw();
}

void Brush::draw_ring(Stage& stage, glm::ivec2 at, glm::dvec2 pixel) const {
    const Paintable* const lab = paintable(stage);
    if (!is_on_ || !lab) return;
    const Frame frame = stage.frame();
    const auto here = lab->place_on_map(frame, pixel), beside = lab->place_on_map(frame, pixel + glm::dvec2(1, 0));
    if (!here || !beside) return;
    const double per_pixel = glm::distance(*here, *beside);
    if (per_pixel <= 0 || per_pixel > 0.5) return;
    const float radius = float(double(width_) / 2 / PaintLayer::side / per_pixel);
    ImGui::GetBackgroundDrawList()->AddCircle({float(at.x) + float(pixel.x), float(at.y) + float(pixel.y)}, radius,
                                              ImGui::ColorConvertFloat4ToU32(accent), 0, 1.5f);
}

bool Brush::go(Stage& stage, Steps& from, Steps& to) {
    Paintable* const lab = paintable(stage);
    if (!lab || from.empty()) return false;
    to.push_back(lab->paint_layer().values());
    lab->paint_layer().set(std::move(from.back()));
    from.pop_back();
    stage.redraw();
    return true;
}

}  // namespace relief::window
