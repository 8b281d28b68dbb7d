#include "framework/course/window/menu_start.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "framework/core/base/error.h"
#include "framework/core/base/log.h"
#include "framework/core/base/paths.h"
#include "framework/core/image/file.h"
#include "framework/course/check/check.h"
#include "framework/course/pages/lab_groups.h"
#include "framework/course/window/menu_header.h"
#include "framework/course/window/menu_imgui.h"
#include "framework/course/window/menu_style.h"
#include "framework/course/window/menu_tiles.h"

namespace relief::window {
namespace {

namespace fs = std::filesystem;

constexpr float card_width = 250, picture_shape = 10.0f / 16;  // pixels at scale 1; height over width
constexpr float inner = 0.85f;  // share of a picture that its card shows: captions at its edges would be cut

/// Fills a rectangle with the middle of a picture.
void fill(ImDrawList& list, GLuint texture, glm::vec2 picture, ImVec2 at, ImVec2 size) {
    const float wide = picture.x / picture.y * size.y / size.x;  // the picture's shape over the rectangle's
    const glm::vec2 part = inner * (wide > 1 ? glm::vec2(1 / wide, 1) : glm::vec2(1, wide));
    const glm::vec2 low = (1.0f - part) / 2.0f, high = (1.0f + part) / 2.0f;
    // Row 0 of a texture is the bottom.
    list.AddImage(texture_id(texture), at, {at.x + size.x, at.y + size.y}, {low.x, high.y}, {high.x, low.y});
}

}  // namespace

const LabEntry* StartPage::last_edited() {
    const LabEntry* result = nullptr;
    fs::file_time_type newest;
    for (const LabEntry& lab : registry()) try {
            const fs::path manifest = course_root() / "labs" / lab.folder / "lab.toml";
            for (const TaskInfo& task : load_manifest(lab).tasks) {
                std::error_code ignored;
                const fs::file_time_type saved = fs::last_write_time(course_root() / task.file, ignored);
                // Unpacking writes a task and its manifest at nearly the same time.
                if (ignored || saved < fs::last_write_time(manifest) + std::chrono::minutes(1)) continue;
                if (!result || saved > newest) result = &lab, newest = saved;
            }
        } catch (const std::exception&) {
            // Opening that lab shows the error.
        }
    return result;
}

void StartPage::open(const LabEntry& marked) {
    open_ = seek_ = true;
    if (cards_.empty())
        for (const LabEntry& lab : registry()) cards_.push_back({.lab = &lab});
    marked_ = size_t(std::find_if(cards_.begin(), cards_.end(), [&](const Card& card) { return card.lab == &marked; }) -
                     cards_.begin());
    edited_ = last_edited();
    if (edited_) print_event("start page: edited last: " + edited_->folder);
    checked_ = 0;  // files may have changed
}

void StartPage::make_next() {
    if (loaded_ < cards_.size()) {
        load(cards_[loaded_++]);
        if (loaded_ == cards_.size()) print_event("start page: all pictures are loaded");
    } else if (checked_ < cards_.size()) {
        check_next();
    }
}

void StartPage::load(Card& card) try {
    const Manifest manifest = load_manifest(*card.lab);
    card.is_elective = manifest.elective;
    for (const TaskInfo& task : manifest.tasks)
        if (!task.optional) card.tasks.push_back(check::unjudged(task));
    if (manifest.cover.empty()) return;
    const fs::path file = course_root() / "labs" / card.lab->folder / "golden" / (manifest.cover + ".png");
    if (std::error_code ignored; !fs::exists(file, ignored)) return;
    Image image = read_image(file);
    card.size = {image.width, image.height};
    card.picture.emplace(
        card.lab->folder, [image = std::move(image)] { return image; }, TextureOptions{.wrap = Wrap::clamp});
} catch (const Error&) {
    // The card stays without a picture. Opening the lab shows a manifest's error.
}

void StartPage::check_next() {
    Card& card = cards_[checked_];
    try {
        if (!checks_.is_of(*card.lab)) {
            const Manifest manifest = check::manifest_to_check(*card.lab);
            Checks::Files files = Checks::files(*card.lab, manifest);
            if (files == card.files) {
                ++checked_;
                print_event("start page: up to date: " + card.lab->folder);
                return;
            }
            card.files = std::move(files);
            checks_.open(*card.lab, manifest);
        }
        checks_.run_next("");
        if (checks_.pending()) return;
        card.tasks = checks_.tasks();
        std::erase_if(card.tasks, [](const check::TaskVerdict& task) { return task.optional; });
        card.points = card.tasks.empty() ? "no tasks" : check::points_text(card.tasks);
    } catch (const Error&) {
        card.points = "cannot be checked";  // opening that lab shows the error
    }
    print_event(fmt::format("start page: {}: {}", card.lab->folder, card.points));
    checks_.close();
    ++checked_;
}

bool StartPage::Card::is_full() const {
    if (points.empty()) return false;
    const check::PointSum sum = check::sum_of(tasks);
    return sum.points >= sum.of - 1e-6;
}

const LabEntry* StartPage::next() const {
    const auto edited =
        std::find_if(cards_.begin(), cards_.end(), [&](const Card& card) { return card.lab == edited_; });
    const size_t begin = edited == cards_.end() ? 0 : size_t(edited - cards_.begin());
    for (size_t i = 0; i < cards_.size(); ++i)
        if (const Card& card = cards_[(begin + i) % cards_.size()]; !card.is_full() && !card.tasks.empty())
            return card.lab;
    return nullptr;
}

void StartPage::move(int columns, int rows) {
    const size_t last = cards_.size() - 1;
    if (columns != 0) marked_ = size_t(std::clamp(int(marked_) + columns, 0, int(last)));
    size_t row = 0, column = marked_;
    while (row + 1 < rows_.size() && column >= rows_[row]) column -= rows_[row++];
    const size_t wanted = size_t(std::clamp(int(row) + rows, 0, std::max(0, int(rows_.size()) - 1)));
    if (wanted != row) {
        marked_ = std::min(column, rows_[wanted] - 1);
        for (size_t i = 0; i < wanted; ++i) marked_ += rows_[i];
    }
    seek_ = true;
}

void StartPage::draw_sum(float scale, MenuWish& wish) const {
    if (const LabEntry* const lab = next()) {
        const std::string label = (edited_ ? "Continue with lab " : "Start with lab ") + title_of(*lab);
        if (ImGui::Button(label.c_str())) wish.lab = lab;
        ImGui::SameLine(0, 16 * scale);
        ImGui::AlignTextToFramePadding();
    }
    std::vector<check::TaskVerdict> all;
    size_t labs = 0, checked = 0;
    for (const Card& card : cards_) {
        all.insert(all.end(), card.tasks.begin(), card.tasks.end());
        labs += !card.tasks.empty(), checked += !card.tasks.empty() && !card.points.empty();
    }
    if (all.empty()) return;
    push_font(font(FontRole::bold));
    text(check::points_text(all));
    ImGui::PopFont();
    ImGui::SameLine(0, 16 * scale);
    quiet_text(checked < labs ? fmt::format("{} of {} labs checked", checked, labs) : fmt::format("in {} labs", labs));
}

void StartPage::draw_card(size_t index, ImVec2 size, float scale, MenuWish& wish) {
    const Card& card = cards_[index];
    ImGui::PushID(int(index));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (ImGui::InvisibleButton("card", size)) wish.lab = card.lab;
    // A mouse that rests leaves the mark to the keys.
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    if (ImGui::IsItemHovered() && (moved.x != 0 || moved.y != 0)) marked_ = index;
    const bool is_marked = index == marked_;
    if (is_marked && std::exchange(seek_, false)) ImGui::SetScrollHereY();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 picture{size.x, size.x * picture_shape};
    list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, IM_COL32(33, 35, 41, 255), 4 * scale);
    if (card.picture) fill(list, *card.picture, card.size, at, picture);
    // The share of the points, as a bar below the picture.
    const float bar = 3 * scale, y = at.y + picture.y;
    list.AddRectFilled({at.x, y}, {at.x + size.x, y + bar}, IM_COL32(48, 51, 60, 255));
    const check::PointSum sum = check::sum_of(card.tasks);
    if (sum.of > 0)
        list.AddRectFilled({at.x, y}, {at.x + size.x * float(sum.points / sum.of), y + bar},
                           ImGui::ColorConvertFloat4ToU32(good));
    const ImVec2 line{at.x + 10 * scale, y + bar + 7 * scale};
    list.AddText(font(FontRole::bold), size_of(*font(FontRole::bold)), line, IM_COL32_WHITE,
                 title_of(*card.lab).c_str());
    const bool is_good = card.is_full() && sum.of > 0;
    const std::string points = !card.points.empty()        ? card.points
                               : !checks_.is_of(*card.lab) ? "not checked yet"
                                                           : "checking " + checks_.progress();
    list.AddText({line.x, line.y + 21 * scale}, ImGui::ColorConvertFloat4ToU32(is_good ? good : quiet),
                 ((is_good ? "\u2713 " : "") + (card.is_elective ? "elective: " + points : points)).c_str());
    if (card.lab == edited_) {
        const char* const note = "edited last";
        const ImVec2 room = ImGui::CalcTextSize(note), corner{at.x + 8 * scale, at.y + 8 * scale};
        list.AddRectFilled(corner, {corner.x + room.x + 12 * scale, corner.y + room.y + 6 * scale},
                           IM_COL32(16, 17, 20, 235), 4 * scale);
        list.AddText({corner.x + 6 * scale, corner.y + 3 * scale}, ImGui::ColorConvertFloat4ToU32(accent), note);
    }
    if (is_marked)
        list.AddRect({at.x - 2, at.y - 2}, {at.x + size.x + 2, at.y + size.y + 2},
                     ImGui::ColorConvertFloat4ToU32(accent), 5 * scale, 0, 2 * scale);
    ImGui::PopID();
}

void StartPage::draw(glm::ivec2 window, float scale, MenuWish& wish) {
    const float margin = 32 * scale, gap = 16 * scale;
    begin_in({{0, 0}, window}, "labs", {margin, 20 * scale}, true);
    push_font(font(FontRole::title));
    ImGui::TextUnformatted("Relief");
    ImGui::PopFont();
    quiet_text(
        "Surface detail in OpenGL, in labs: normals, rays in a relief, displaced triangles.  Arrow keys and Enter, or "
        "a click, "
        "open a lab;  /  searches;  ?  shows all keys.");
    draw_sum(scale, wish);
    const float room = ImGui::GetContentRegionAvail().x;
    const int columns = std::max(1, int((room + gap) / (card_width * scale + gap)));
    const float width = (room - gap * float(columns - 1)) / float(columns);
    rows_.clear();
    const ImVec2 size{width, width * picture_shape + 58 * scale};
    for (size_t group = 0, index = 0; group < std::size(pages::lab_groups); ++group) {
        const bool is_last = group + 1 == std::size(pages::lab_groups);
        const size_t end = is_last
                               ? cards_.size()
                               : size_t(std::find_if(cards_.begin(), cards_.end(),
                                                     [&](const Card& card) {
                                                         return card.lab->number >= pages::lab_groups[group + 1].first;
                                                     }) -
                                        cards_.begin());
        if (index == end) continue;
        ImGui::Dummy({0, 8 * scale});
        colored_text(accent, pages::lab_groups[group].title);
        ImGui::SameLine(0, gap);
        quiet_text(pages::lab_groups[group].about);
        ImGui::Dummy({0, 2 * scale});
        for (const size_t count : even_rows(end - index, size_t(columns))) {
            rows_.push_back(count);
            for (size_t column = 0; column < count; ++column) {
                if (column > 0) ImGui::SameLine(0, gap);
                draw_card(index++, size, scale, wish);
            }
            ImGui::Dummy({0, gap - 6 * scale});
        }
    }
    ImGui::End();
}

}  // namespace relief::window
