#include "framework/course/window/menu_lab.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "framework/core/base/log.h"
#include "framework/core/base/own_file.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/process.h"
#include "framework/course/window/editor.h"
#include "framework/course/window/menu_header.h"
#include "framework/course/window/menu_present.h"
#include "framework/course/window/menu_saving.h"
#include "framework/course/window/menu_words.h"

namespace relief::window {
namespace {

constexpr double still_for = 0.3;  // seconds

/// Moves the camera so that the point under the mouse stays there. `rows`: of the picture.
void pan(Orbit& camera, double right, double down, int rows) {
    const double metres = 2 * camera.distance * std::tan(glm::radians(camera.field_of_view) / 2) / std::max(1, rows);
    const glm::dmat3 world_from_view = glm::transpose(glm::dmat3(Camera(camera, 1).view_from_world()));
    camera.target += world_from_view * glm::dvec3(-right * metres, down * metres, 0);
}

/// Opens a place in the user's editor, and returns a message about it.
std::string open_in_editor(const Place& place) {
    const std::filesystem::path file = place.file.is_absolute() ? place.file : course_root() / place.file;
    const std::string editor = chosen_editor();
    const std::vector<std::string> command = editor_command(editor, file, place.line);
    const std::string where = shown(place.file) + (place.line > 0 ? fmt::format(":{}", place.line) : "");
    const bool is_started = editor.empty() ? open_on_desktop(file) : start_on_desktop(command);
    std::string message = is_started
                              ? fmt::format("opening {}", where)
                              : fmt::format("cannot start {}: open {} yourself, or set VISUAL", command.front(), where);
    print_event(message);
    return message;
}

/// Returns whether no task of the lab is written yet; false until all checks have run.
bool is_untouched(const Checks& checks) {
    const auto& tasks = checks.manifest().tasks;
    return !tasks.empty() && std::all_of(tasks.begin(), tasks.end(), [&](const TaskInfo& task) {
        const std::optional<check::Outcome> worst = checks.worst(task);
        return worst == check::Outcome::unfinished || worst == check::Outcome::waiting;
    });
}

}  // namespace

double Clock::advance(double now) {
    const double seconds = last_ < 0 ? 0 : now - last_;
    last_ = now;
    if (!is_paused_) time_ += seconds;
    return seconds;
}

void LabView::open(const LabEntry& entry, const Shot* start) {
    stage_.open(entry, start);
    checks_.open(entry, stage_.manifest());
    check_view_.close();
    explanation_.close();
    brush_.forget();
    wipe_.let_go();
    history_.begin(stage_);
    error_map_.forget();
    if (handout_.is_open()) handout_.open(entry);
    motion_.stop();
    message_.clear();
    clock_.restart();
    opened_ = glfwGetTime(), drawn_ = HUGE_VAL;
}

bool LabView::moves() const {
    return !check_view_.is_open() && (stage_.manifest().animated || motion_.is_on()) && !stage_.failed() &&
           !clock_.is_paused();
}

bool LabView::look_at_files() {
    bool news = stage_.look();
    if (news) wipe_.changed();  // it uses the same shader files
    news |= handout_.look();
    news |= checks_.look();
    return news;
}

bool LabView::compute(bool is_dragged) {
    bool news = explanation_.wanted();
    if (news) explanation_.compute(stage_);
    // Not during a pause in a drag: exact values take all of the machine's threads.
    if (error_map_.wanted() && !check_view_.is_open() && !is_dragged && !moves() &&
        glfwGetTime() - drawn_ >= still_for && !stage_.is_due(room(), clock_.time()))
        news |= error_map_.begin(stage_);
    news |= error_map_.finish(stage_);
    return news;
}

bool LabView::has_check_to_run() const {
    return checks_.pending() && (check_view_.is_open() || !stage_.is_opening()) && !is_panel_hidden_ &&
           glfwGetTime() - opened_ >= still_for;
}

std::vector<std::string> LabView::parts_with_keys() const {
    std::vector<std::string> parts;
    if (!is_panel_hidden_) parts = {"panel", "header"};
    if (check_view_.is_open())
        parts.emplace_back("check");
    else if (stage_.error())
        parts.emplace_back("error");
    return parts;
}

// Dear ImGui moves through the part only then: at other times its keys are the lab's.
void LabView::take_next_part() {
    const std::vector<std::string> parts = parts_with_keys();
    const auto now = std::find(parts.begin(), parts.end(), part_);
    const auto next = now == parts.end() ? parts.begin() : now + 1;
    if (next == parts.end()) return leave_parts();
    part_ = *next;
    ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    ImGui::SetWindowFocus(part_.c_str());
    print_event("keys: " + part_);
}

void LabView::leave_parts() {
    if (part_.empty()) return;
    let_go_of_keys();
    ImGui::SetWindowFocus(nullptr);
}

void LabView::let_go_of_keys() {
    part_.clear();
    ImGui::GetIO().ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
    print_event("keys: the lab");
}

/// Leaves a part that has gone, or that the mouse has left. Frames the others.
void LabView::draw_part_frame(const Layout& layout, float scale) {
    if (part_.empty()) return;
    const std::vector<std::string> parts = parts_with_keys();
    if (std::find(parts.begin(), parts.end(), part_) == parts.end()) return leave_parts();
    if (ImGui::IsMouseClicked(0)) return let_go_of_keys();  // what was clicked keeps the focus
    const Box& box = part_ == "panel" ? layout.panel : part_ == "header" ? layout.header : layout.picture;
    ImGui::GetForegroundDrawList()->AddRect({float(box.at.x) + scale, float(box.at.y) + scale},
                                            {float(box.right()) - scale, float(box.bottom()) - scale},
                                            ImGui::ColorConvertFloat4ToU32(accent), 0, 0, 2 * scale);
}

void LabView::add_open_parts(OpenParts& open) const {
    open.part = !part_.empty();
    open.explanation = explanation_.is_open();
    open.check = check_view_.is_open();
    open.brush = brush_.is_on();
    open.wipe = wipe_.on();
    open.motion = motion_.is_on();
    open.handout = handout_.is_open();
    open.presents = is_panel_hidden_;
}

void LabView::act(const MenuWish& wish) {
    if (!wish.message.empty()) message_ = wish.message;
    for (const MenuAction& action : wish.actions)
        if (const auto* const mine = std::get_if<LabAction>(&action)) act(*mine);
    handout_.scroll(wish.scroll);
    if (wish.check) show_check(*wish.check);
    if (!wish.probe.empty()) stage_.show({wish.probe});
    if (!wish.value.empty()) set(wish.knob, wish.value);
    if (!wish.edit.file.empty()) message_ = open_in_editor(wish.edit);
    if (!wish.knob.empty()) is_panel_hidden_ = false, panel_.seek(wish.knob);
    if (!wish.document.empty()) handout_.open(wish.document, wish.passage);
}

void LabView::act(LabAction action) {
    switch (action) {
        case LabAction::next_part:
            take_next_part();
            break;
        case LabAction::leave_parts:
            leave_parts();
            break;
        case LabAction::reset_camera:
            stage_.camera() = stage_.manifest().camera, stage_.changed();
            break;
        case LabAction::turn_camera:
            motion_.toggle_camera();
            if (clock_.is_paused()) clock_.toggle();
            break;
        case LabAction::stop_motion:
            motion_.stop();
            break;
        case LabAction::pause:
            clock_.toggle();
            break;
        case LabAction::undo:
        case LabAction::redo:
            undo(action == LabAction::redo);
            break;
        case LabAction::explain_pixel:
            explain_pixel();
            break;
        case LabAction::close_explanation:
            explanation_.close();
            break;
        case LabAction::close_check:
            check_view_.close();
            break;
        case LabAction::show_tasks:
            panel_.show_checks();
            break;
        case LabAction::toggle_panel:
            is_panel_hidden_ = !is_panel_hidden_;
            break;
        case LabAction::toggle_handout:
            handout_.is_open() ? handout_.close() : handout_.open(stage_.entry());
            break;
        case LabAction::toggle_error_map:
            error_map_.toggle();
            break;
        case LabAction::toggle_brush:
            if (!brush_.toggle(stage_)) message_ = "this lab has no heights to paint";
            check_view_.close();
            break;
        case LabAction::toggle_wipe:
            toggle_wipe();
            break;
        case LabAction::swap_wipe:
            wipe_.swap(stage_);
            break;
        case LabAction::save_picture:
            message_ = save_picture(stage_);
            break;
        case LabAction::save_map:
            message_ = save_map(stage_);
            break;
        case LabAction::save_heights:
            message_ = save_heights(stage_);
            break;
        case LabAction::edit_error:
            if (const Error* const error = stage_.error(); error && !error->place().file.empty())
                message_ = open_in_editor(error->place());
            break;
    }
}

void LabView::show_check(const std::string& name) {
    if (name.empty()) return check_view_.close();
    const Shot& shot = stage_.manifest().check(name).shot;
    if (!shot.calls) stage_.apply(shot);  // calls have no view
    check_view_.open(name, stage_.edits());
    panel_.show_checks();
}

void LabView::take(const std::filesystem::path& file) {
    try {
        if (!stage_.lab()) return;
        const std::string knob = set_file(*stage_.lab(), file);
        message_ = knob.empty()
                       ? stage_.manifest().title + (is_named_as_model(file) ? " takes no model" : " takes no picture")
                       : knob + ": " + file.filename().string();
        if (!knob.empty()) stage_.changed();
    } catch (const Error& error) {
        message_ = error.what();
        print_error(message_);
    }
}

int LabView::draw(glm::ivec2 window, float scale, bool is_dragged, MenuWish& wish) {
    const Layout layout = borders_.layout(window, scale,
                                          {.panel = !is_panel_hidden_,
                                           .handout = handout_.is_open(),
                                           .legend = error_map_.on() && !check_view_.is_open()});
    if (layout.picture != picture_)
        print_event(fmt::format("picture: {}x{} at {},{}; panel {}; scale {:.2f}", layout.picture.size.x,
                                layout.picture.size.y, layout.picture.at.x, layout.picture.at.y, layout.panel.size.x,
                                scale));
    picture_ = layout.picture;
    act_mouse();
    const bool moved = moves();
    if (const double seconds = clock_.advance(glfwGetTime()); moved) motion_.advance(stage_, seconds);
    draw_parts(layout, scale, wish);
    if (!moves() && !is_dragged && !ImGui::IsAnyItemActive()) history_.note(stage_);
    const int more = check_view_.is_open() ? 0 : draw_picture(room(), scale);
    error_map_.draw_legend(layout.legend, stage_.probe().name);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, window.x, window.y);
    glClearColor(0.08f, 0.085f, 0.10f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    if (!check_view_.is_open()) present(window, {picture_.at, room()}, stage_, wipe_);
    return more;
}

/// Describes the parts around and over the picture. They may change the stage.
void LabView::draw_parts(const Layout& layout, float scale, MenuWish& wish) {
    draw_header(layout.header, scale, stage_, checks_, wish);
    panel_.draw(layout.panel, stage_, motion_, checks_, check_view_.name(), error_map_.on(), brush_, wish);
    status_.draw(layout.status, scale, stage_, message_);
    handout_.draw(layout.handout, scale,
                  handout_.is_open() && stage_.lab() ? describe_knobs(*stage_.lab()) : std::vector<KnobText>(), wish);
    borders_.drag(layout, scale);
    explanation_.close_after_edits(stage_.edits());
    check_view_.close_after_edits(stage_.edits());
    if (!check_view_.is_open() && !ImGui::GetIO().WantCaptureMouse)
        brush_.draw_ring(stage_, picture_.at, pixel_under_mouse());
    check_view_.draw(picture_, scale, checks_, wish);
    explanation_.draw(picture_, scale);
    error_box_.draw(picture_, scale, stage_, wish);
    draw_part_frame(layout, scale);
}

/// Draws the lab if its picture is out of date, and describes what stands over the picture. Returns how many more
/// frames are needed.
int LabView::draw_picture(glm::ivec2 room, float scale) {
    const bool is_due = stage_.is_due(room, clock_.time());
    // Before a slow frame, one frame shows a note over the old picture.
    if (is_due && stage_.is_slow() && !std::exchange(is_told_, true)) {
        draw_opening(picture_, stage_);
        return 2;
    }
    const bool is_first = !stage_.framebuffer();  // also compiles and loads
    const bool drawn = stage_.draw(room, clock_.time());
    is_told_ = !drawn && stage_.is_due(room, clock_.time());  // it compiles: another frame goes on
    if (is_told_) draw_opening(picture_, stage_);
    if (drawn) error_map_.forget(), drawn_ = glfwGetTime();
    if (drawn && !is_first) status_.note(stage_.milliseconds());
    wipe_.draw(stage_, room, clock_.time(), drawn);
    const Box picture{picture_.at, room};
    const int held = wipe_.shown_columns(room.x);
    if (held > 0) draw_words(wipe_.words(), picture, 0, held);
    if (stage_.framebuffer()) {
        std::vector<PictureWord> words = stage_.words();
        if (is_untouched(checks_))
            words.push_back({.kind = PictureWord::Kind::note,
                             .text = "Magenta: a task that is not written yet. F1 opens the handout."});
        draw_words(std::move(words), picture, held, room.x + 1);
    }
    wipe_.draw_border(picture, scale, stage_);
    const std::vector<Box> means = error_map_.draw({{picture.right(), picture.at.y}, room}, moves());
    pixel_.draw(stage_, error_map_, picture.at, room, means);
    if (drawn && stage_.failed()) return 3;  // ImGui measures the error's box before it shows it
    return is_told_ || wipe_.is_opening() ? 2 : 0;
}

/// Returns the size of the picture, or of one half beside the error map.
glm::ivec2 LabView::room() const {
    const int halves = error_map_.on() ? 2 : 1;
    return glm::clamp(glm::ivec2(picture_.size.x / halves, picture_.size.y), glm::ivec2(1),
                      glm::ivec2(max_picture_side));
}

/// Returns the place of the mouse in the picture, in pixels from its upper left corner.
glm::dvec2 LabView::pixel_under_mouse() const {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    return glm::dvec2(double(mouse.x), double(mouse.y)) - glm::dvec2(picture_.at) + 0.5;
}

void LabView::act_mouse() {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantCaptureMouse) return;
    Orbit& camera = stage_.camera();
    const Orbit before = camera;
    if (brush_.is_on() && !check_view_.is_open()) {
        try {
            brush_.move(stage_, pixel_under_mouse(), io.MouseDown[0]);
        } catch (const Error& error) {
            message_ = error.what();
            print_error(message_);
        }
    } else if (io.MouseDown[0]) {
        camera.yaw -= 0.3 * double(io.MouseDelta.x);
        camera.pitch = std::clamp(camera.pitch + 0.3 * double(io.MouseDelta.y), -89.0, 89.0);
    }
    if (io.MouseDown[1] || io.MouseDown[2])
        pan(camera, double(io.MouseDelta.x), double(io.MouseDelta.y), stage_.size().y);
    camera.distance = std::clamp(camera.distance * std::pow(0.9, double(io.MouseWheel)), 1e-3, 1e6);
    if (!(camera == before)) stage_.changed();
}

void LabView::set(const std::string& knob, const std::string& value) {
    try {
        set_knob(*stage_.lab(), knob, value);
        stage_.changed();
    } catch (const Error& error) {
        message_ = error.what();
    }
}

/// Explains the pixel under the mouse, in the picture or in the error map beside it.
void LabView::explain_pixel() {
    if (check_view_.is_open() || !stage_.framebuffer()) return;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const glm::ivec2 size = stage_.size();
    glm::ivec2 at = glm::ivec2(int(mouse.x), int(mouse.y)) - picture_.at;
    if (error_map_.on() && at.x >= size.x) at.x -= size.x;
    if (at.x < 0 || at.y < 0 || at.x >= size.x || at.y >= size.y)
        message_ = "point at a pixel of the picture, then press P";
    else
        explanation_.ask(at, stage_.edits());
}

/// Takes back the last stroke of the brush, or the last change of a setting; or makes it again.
void LabView::undo(bool again) {
    if (brush_.is_on()) {
        if (again)
            brush_.redo(stage_);
        else if (!brush_.undo(stage_))
            message_ = "no stroke to take back";
    } else {
        again ? history_.redo(stage_) : history_.undo(stage_);
    }
}

void LabView::toggle_wipe() {
    if (wipe_.on())
        wipe_.let_go();
    else if (stage_.lab())
        wipe_.hold(stage_);
    check_view_.close();
}

}  // namespace relief::window
