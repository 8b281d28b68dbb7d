#include "framework/course/window/menu.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <utility>

#include "framework/core/base/error.h"
#include "framework/core/base/log.h"
#include "framework/core/base/own_file.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/process.h"
#include "framework/core/context/glfw_window.h"
#include "framework/core/gl/counters.h"
#include "framework/core/gl/missing_tasks.h"
#include "framework/core/image/file.h"
#include "framework/course/window/editor.h"
#include "framework/course/window/menu_brush.h"
#include "framework/course/window/menu_check_view.h"
#include "framework/course/window/menu_checks.h"
#include "framework/course/window/menu_error.h"
#include "framework/course/window/menu_error_map.h"
#include "framework/course/window/menu_explain.h"
#include "framework/course/window/menu_handout.h"
#include "framework/course/window/menu_header.h"
#include "framework/course/window/menu_help.h"
#include "framework/course/window/menu_history.h"
#include "framework/course/window/menu_imgui.h"
#include "framework/course/window/menu_layout.h"
#include "framework/course/window/menu_motion.h"
#include "framework/course/window/menu_panel.h"
#include "framework/course/window/menu_pixel.h"
#include "framework/course/window/menu_search.h"
#include "framework/course/window/menu_stage.h"
#include "framework/course/window/menu_start.h"
#include "framework/course/window/menu_status.h"
#include "framework/course/window/menu_style.h"
#include "framework/course/window/menu_wipe.h"
#include "framework/course/window/menu_words.h"
#include "framework/library/kit/made_map.h"

namespace relief::window {
namespace {

/// Owns Dear ImGui for the lifetime of the window.
class ImGuiSession {
public:
    ImGuiSession(GLFWwindow* window, float scale) {
        ImGui::CreateContext();
        ImGui::GetIO().IniFilename = nullptr;  // the menu writes no files
        style_menu(scale);
        ImGui_ImplGlfw_InitForOpenGL(window, true);
        ImGui_ImplOpenGL3_Init("#version 410 core");
    }
    ~ImGuiSession() {
        ImGui_ImplOpenGL3_Shutdown();
        ImGui_ImplGlfw_Shutdown();
        ImGui::DestroyContext();
    }
    ImGuiSession(const ImGuiSession&) = delete;
    ImGuiSession& operator=(const ImGuiSession&) = delete;

    /// Changes the scale; call it between frames.
    void scale(float scale) {
        style_menu(scale);
        upload_fonts();
    }
};

/// Returns the desktop's scale if it is above 1. Otherwise derives it from the display's pixel density, limited so that
/// about 1080 scaled rows remain. Rounded to quarters, at least 1.
float scale_of(GLFWwindow* window) {
    float x = 1, y = 1;
    glfwGetWindowContentScale(window, &x, &y);
    if (x > 1) return x;
    GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* const mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    if (!mode) return 1;
    int width = 0, height = 0;  // in millimetres; 0 if unknown
    glfwGetMonitorPhysicalSize(monitor, &width, &height);
    if (height <= 0) return 1;
    const float density = float(mode->height) * 25.4f / float(height) / 96;
    return std::max(1.0f, std::round(4 * std::min(density, float(mode->height) / 1080)) / 4);
}

/// Scales the window's size, clamped to the display's work area.
void fit_to_display(GLFWwindow* window, float scale) {
    glm::ivec2 size{0, 0}, room{0, 0};
    glfwGetWindowSize(window, &size.x, &size.y);
    int x = 0, y = 0;
    if (GLFWmonitor* const monitor = glfwGetPrimaryMonitor()) glfwGetMonitorWorkarea(monitor, &x, &y, &room.x, &room.y);
    const auto wanted = glm::ivec2(glm::vec2(size) * scale);
    if (room.x > 0 && room.y > 0) glfwSetWindowSize(window, std::min(wanted.x, room.x), std::min(wanted.y, room.y));
}

class Menu {
public:
    explicit Menu(const MenuStart& start) {
        const auto& labs = registry();
        const auto found =
            std::find_if(labs.begin(), labs.end(), [&](const LabEntry& lab) { return lab.folder == start.lab_folder; });
        fit_to_display(window_.handle(), display_scale_);
        const LabEntry* const edited = found == labs.end() ? StartPage::last_edited() : nullptr;
        open(found != labs.end() ? *found : edited ? *edited : labs.front(), start.shot ? &*start.shot : nullptr);
        if (found == labs.end()) show_labs();
        if (start.error_map) error_map_.toggle();
        if (!start.check.empty()) show_check(start.check);
    }

    int run() {
        const TellMissingTasks told;
        GLFWwindow* const window = window_.handle();
        while (!glfwWindowShouldClose(window)) {
            // Sleep until an event. An event needs up to three turns: Dear ImGui shows its effect in the second turn.
            // It measures a new window before it shows it in the third. The sleep ends regularly to look at files;
            // unchanged files cause no drawing.
            if (moves() || turns_ > 0 || checking() || start_.waits()) {
                glfwPollEvents();
            } else {
                if (shown_ != told_) print_event(fmt::format("asleep after {} frames of the menu", told_ = shown_));
                glfwWaitEventsTimeout(error_map_.computes() ? look_soon : look_every);
            }
            const bool news = look();
            if (window_.take_event() || news) turns_ = 3;
            if (start_.waits() && !is_dragged()) start_.make_next(), turns_ = std::max(turns_, 1);
            if (checking()) checks_.run_next(check_view_.name()), turns_ = std::max(turns_, 1);
            if (!moves() && turns_ == 0) continue;
            turns_ = std::max(0, turns_ - 1);
            turn();
            glfwSwapBuffers(window);
            ++shown_;
        }
        return 0;
    }

private:
    bool moves() const {
        return !start_.is_open() && !check_view_.is_open() && (stage_.manifest().animated || motion_.is_on()) &&
               !stage_.failed() && !paused_;
    }

    /// Returns whether to run a check now: between two frames, if nothing is being dragged and the panel is visible.
    bool checking() const {
        return checks_.pending() && (check_view_.is_open() || !stage_.is_opening()) && !start_.is_open() &&
               !panel_hidden_ && !is_dragged() && glfwGetTime() - opened_ >= still_for;
    }
    bool is_dragged() const {
        for (int button = 0; button < 3; ++button)
            if (glfwGetMouseButton(window_.handle(), button) == GLFW_PRESS) return true;
        return false;
    }

    /// Looks for saved files, and begins the error map once the picture is still. Returns whether there is anything new
    /// to show.
    bool look() {
        const double now = glfwGetTime();
        bool news = false;
        if (now - looked_ >= look_every) {
            looked_ = now;
            news = stage_.look();
            if (news) wipe_.changed();  // it uses the same shader files
            news |= handout_.look();
            news |= checks_.look();
        }
        if (start_.is_open()) return news;
        if (explanation_.wanted()) {
            explanation_.compute(stage_);
            news = true;
        }
        // Not during a pause in a drag: exact values take all of the machine's threads.
        if (error_map_.wanted() && !check_view_.is_open() && !is_dragged() && !moves() && now - drawn_ >= still_for &&
            !stage_.is_due(room_, time_))
            news |= error_map_.begin(stage_);
        news |= error_map_.finish(stage_);
        return news;
    }

    void open(const LabEntry& entry, const Shot* shot = nullptr) {
        stage_.open(entry, shot);
        start_.close();
        checks_.open(entry, stage_.manifest());
        check_view_.close();
        explanation_.close();
        brush_.forget();
        wipe_.let_go();
        opened_ = glfwGetTime(), edits_ = settled_ = stage_.edits();
        history_.begin(stage_.settings());
        error_map_.forget();
        drawn_ = HUGE_VAL;  // not drawn yet
        if (handout_.is_open()) handout_.open(entry);
        begin_ = glfwGetTime(), time_ = 0;
        motion_.stop();
        message_.clear();
        set_title();
    }

    void show_labs() {
        if (registry().size() < 2) return;
        start_.open(stage_.entry());
        glfwSetWindowTitle(window_.handle(), "Relief: all labs");
        turns_ = 3;
    }
    void hide_labs() {
        start_.close();
        set_title();
        turns_ = 3;
    }
    void set_title() {
        const LabEntry& entry = stage_.entry();
        glfwSetWindowTitle(window_.handle(), fmt::format("Relief: {} {}", entry.two_digits(), entry.name).c_str());
    }

    void step(int direction) {
        const auto& labs = registry();
        const auto at = &stage_.entry() - labs.data(), count = std::ptrdiff_t(labs.size());
        open(labs[size_t((at + direction + count) % count)]);
    }

    void turn() {
        if (const float wanted = display_scale_ * zoom_; wanted != scale_) imgui_.scale(scale_ = wanted);
        ImGui_ImplOpenGL3_NewFrame();
        ImGui_ImplGlfw_NewFrame();
        ImGui::NewFrame();
        glm::ivec2 window{0, 0};
        glfwGetFramebufferSize(window_.handle(), &window.x, &window.y);
        MenuWish wish;
        keyboard(wish);
        if (start_.is_open()) {
            draw_start_page(window, wish);
            return;
        }
        const Layout layout = borders_.layout(window, scale_,
                                              {.panel = !panel_hidden_,
                                               .handout = handout_.is_open(),
                                               .legend = error_map_.on() && !check_view_.is_open()});
        const Box& picture = layout.picture;
        note(layout);
        mouse();
        const double now = glfwGetTime();
        if (moves()) motion_.advance(stage_, now - moved_);
        moved_ = now;
        for (const std::filesystem::path& file : window_.take_files()) take(file);
        draw_header(layout.header, scale_, stage_, checks_, wish);
        panel_.draw(layout.panel, stage_, motion_, checks_, check_view_.name(), error_map_.on(), brush_, wish);
        status_.draw(layout.status, scale_, stage_, message_);
        handout_.draw(layout.handout, scale_,
                      handout_.is_open() && stage_.lab() ? describe_knobs(*stage_.lab()) : std::vector<KnobText>(),
                      wish);
        borders_.drag(layout, scale_);
        if (stage_.edits() != edits_) explanation_.close();  // it explains another picture
        // A change of a knob is meant for the picture, so leave the check.
        if (stage_.edits() != edits_ && check_view_.is_open() && !wish.check) check_view_.close();
        edits_ = stage_.edits();
        if (!check_view_.is_open() && !ImGui::GetIO().WantCaptureMouse)
            brush_.draw_ring(stage_, picture.at, pixel_under_mouse());
        check_view_.draw(picture, scale_, checks_, wish);
        search_.draw(scale_, stage_, checks_, wish);
        draw_help(picture, scale_, help_);
        explanation_.draw(picture, scale_);
        remember();
        if (!check_view_.is_open()) error_box_.draw(picture, scale_, stage_, wish);
        if (!paused_) time_ = glfwGetTime() - begin_;

        const int half = error_map_.on() ? 2 : 1;
        const glm::ivec2 room = room_ =
            glm::clamp(glm::ivec2(picture.size.x / half, picture.size.y), glm::ivec2(1), glm::ivec2(max_picture_side));
        // Before a slow frame, show a note over the old picture for one turn.
        const bool waits = !check_view_.is_open() && stage_.is_due(room, time_) && stage_.is_slow();
        if (waits && !std::exchange(is_told_, true)) {
            draw_opening(picture);
            turns_ = std::max(turns_, 2);
        } else if (!check_view_.is_open()) {
            const bool is_first = !stage_.framebuffer();  // also compiles and loads
            const bool drawn = stage_.draw(room, time_);
            is_told_ = !drawn && stage_.is_due(room, time_);  // it compiles: another turn goes on
            if (is_told_) draw_opening(picture);
            if (drawn) error_map_.forget(), drawn_ = glfwGetTime();
            if (drawn && stage_.failed()) turns_ = 3;  // ImGui measures the error's box before it shows it
            if (drawn && !is_first) status_.note(stage_.milliseconds());
            wipe_.draw(stage_, room, time_, drawn);
            if (is_told_ || wipe_.is_opening()) turns_ = std::max(turns_, 2);
            const int held = wipe_.shown_columns(room.x);
            if (held > 0) draw_words(wipe_.words(), {picture.at, room}, 0, held);
            if (stage_.framebuffer()) draw_words(stage_.words(), {picture.at, room}, held, room.x + 1);
            wipe_.draw_border({picture.at, room}, scale_, stage_);
            error_map_.draw({picture.at.x + room.x, picture.at.y}, room);
            pixel_.draw(stage_, error_map_, picture.at, room);
        }
        error_map_.draw_legend(layout.legend, stage_.probe().name, moves());
        present(window, picture.at, room);
        ImGui::Render();
        ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
        act(wish);
    }

    void draw_start_page(glm::ivec2 window, MenuWish& wish) {
        window_.take_files();  // no lab is there to take them
        start_.draw(window, scale_, wish);
        search_.draw(scale_, stage_, checks_, wish);
        draw_help({{0, 0}, window}, scale_, help_);
        ImGui::Render();
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glViewport(0, 0, window.x, window.y);
        ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
        act(wish);
    }

    /// Says why the picture is not there yet.
    void draw_opening(const Box& picture) const {
        if (!stage_.is_opening()) return draw_note(picture, "drawing ...");
        const ImVec2 low{float(picture.at.x), float(picture.at.y)},
            high{float(picture.right()), float(picture.bottom())};
        if (stage_.backdrop().framebuffer)
            ImGui::GetBackgroundDrawList()->AddRectFilled(low, high, IM_COL32(16, 17, 20, 150));
        const int pauses = stage_.pauses();
        draw_note(picture, pauses == 0
                               ? fmt::format("opening {} ...", title_of(stage_.entry()))
                               : fmt::format("opening {}: compiling, {} done ...", title_of(stage_.entry()), pauses));
    }

    /// Draws a note in the lower left corner of the picture.
    static void draw_note(const Box& picture, const std::string& note) {
        const float margin = ImGui::GetStyle().WindowPadding.x;
        const ImVec2 size = ImGui::CalcTextSize(note.c_str());
        const ImVec2 at{float(picture.at.x) + margin, float(picture.bottom()) - 2 * margin - size.y};
        ImDrawList& list = *ImGui::GetForegroundDrawList();
        list.AddRectFilled(at, {at.x + size.x + 2 * margin, at.y + size.y + margin}, IM_COL32(16, 17, 20, 255), 4);
        list.AddText({at.x + margin, at.y + margin / 2}, ImGui::ColorConvertFloat4ToU32(accent), note.c_str());
    }

    /// Adds a step of undo for a setting that is complete, not for one in the middle of a drag.
    void remember() {
        if (settled_ == stage_.edits() || moves() || is_dragged() || ImGui::IsAnyItemActive()) return;
        settled_ = stage_.edits();
        history_.note(stage_.settings());
    }

    /// Prints the picture's position for --verbose.
    void note(const Layout& layout) {
        if (layout.picture == noted_) return;
        noted_ = layout.picture;
        print_event(fmt::format("picture: {}x{} at {},{}; panel {}; scale {:.2f}", noted_.size.x, noted_.size.y,
                                noted_.at.x, noted_.at.y, layout.panel.size.x, scale_));
    }

    void present(glm::ivec2 window, glm::ivec2 at, glm::ivec2 room) const {
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glViewport(0, 0, window.x, window.y);
        glClearColor(0.08f, 0.085f, 0.10f, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        if (check_view_.is_open()) return;
        const Stage::Backdrop& backdrop = stage_.backdrop();
        if (!stage_.framebuffer() && !backdrop.framebuffer) return;
        const int bottom = window.y - at.y - room.y;  // framebuffer rows count from the bottom
        const auto copy = [&](GLuint from, int begin, int end) {
            glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
            glBlitFramebuffer(begin, 0, end, room.y, at.x + begin, bottom, at.x + end, bottom + room.y,
                              GL_COLOR_BUFFER_BIT, GL_NEAREST);
        };
        if (!stage_.framebuffer()) {
            glBindFramebuffer(GL_READ_FRAMEBUFFER, backdrop.framebuffer);
            glBlitFramebuffer(0, 0, backdrop.size.x, backdrop.size.y, at.x, bottom, at.x + room.x, bottom + room.y,
                              GL_COLOR_BUFFER_BIT, GL_LINEAR);
            glBindFramebuffer(GL_FRAMEBUFFER, 0);
            return;
        }
        const int held = wipe_.shown_columns(room.x);
        if (held > 0) copy(wipe_.framebuffer(), 0, held);
        if (held < room.x) copy(stage_.framebuffer(), held, room.x);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
    }

    void act(const MenuWish& wish) {
        if (wish.labs) show_labs();
        if (wish.lab && !(start_.is_open() && wish.lab == &stage_.entry())) open(*wish.lab);
        // A lab that is open keeps its settings.
        if (start_.is_open() && (wish.lab || wish.check || !wish.probe.empty() || !wish.knob.empty())) hide_labs();
        if (wish.step) step(wish.step);
        if (wish.handout) toggle_handout();
        if (wish.error_map) error_map_.toggle(), room_ = {};  // the next turn draws the picture in its new size
        if (wish.save_map) save_map();
        if (wish.save_heights) save_heights();
        if (!wish.message.empty()) message_ = wish.message;
        if (wish.tasks) panel_.show_checks();
        if (wish.check) show_check(*wish.check);
        if (!wish.probe.empty()) stage_.show({wish.probe});
        if (!wish.value.empty()) set(wish.knob, wish.value);
        if (!wish.edit.file.empty()) edit(wish.edit);
        if (!wish.knob.empty()) panel_hidden_ = false, panel_.seek(wish.knob), turns_ = 3;
        if (wish.search) search_.open(), turns_ = 3;
        if (wish.help) help_ = !help_;
    }

    void show_check(const std::string& name) {
        if (name.empty()) return check_view_.close();
        const Shot& shot = stage_.manifest().check(name).shot;
        if (!shot.calls) stage_.apply(shot);  // calls have no view
        edits_ = stage_.edits();
        check_view_.open(name);
        panel_.show_checks();
        turns_ = 3;
    }

    void keyboard(MenuWish& wish) {
        const bool typing = ImGui::GetIO().WantTextInput || search_.is_open();
        for (const unsigned character : window_.take_characters())
            if (!typing && character == '?')
                wish.help = true;
            else if (!typing && character == '/')
                wish.search = true;
        for (const Key& key : window_.take_keys()) {
            if (key.code == GLFW_KEY_ESCAPE && search_.is_open())
                search_.close();
            else if (key.control)
                press_with_control(key, wish);
            else if (!typing)
                press(key.code, wish);
        }
    }

    void press_with_control(const Key& key, MenuWish& wish) {
        static constexpr float step = 1.125f;
        const bool larger = key.name == "+" || key.name == "=" || key.code == GLFW_KEY_KP_ADD;
        const bool smaller = key.name == "-" || key.code == GLFW_KEY_KP_SUBTRACT;
        if (larger) zoom_ = std::min(zoom_ * step, 4.0f);
        if (smaller) zoom_ = std::max(zoom_ / step, 0.5f);
        if (key.name == "0" || key.code == GLFW_KEY_KP_0) zoom_ = 1;
        if (std::abs(zoom_ - 1) < 0.01f) zoom_ = 1;
        if (key.name == "f") wish.search = true;
        if (key.name == "q") glfwSetWindowShouldClose(window_.handle(), GLFW_TRUE);
        if (start_.is_open()) return;
        if (const Error* const error = stage_.error(); error && key.name == "e" && !error->place().file.empty())
            wish.edit = error->place();
        if (ImGui::GetIO().WantTextInput) return;  // a text field has its own undo
        if (brush_.is_on()) {
            if (key.name == "z" && !brush_.undo(stage_)) message_ = "no stroke to take back";
            if (key.name == "y") brush_.redo(stage_);
            return;
        }
        if (key.name == "z") go_to(history_.undo());
        if (key.name == "y") go_to(history_.redo());
    }

    void set(const std::string& knob, const std::string& value) {
        try {
            set_knob(*stage_.lab(), knob, value);
            stage_.changed();
        } catch (const Error& error) {
            message_ = error.what();
        }
    }

    void edit(const Place& place) {
        const std::filesystem::path file = place.file.is_absolute() ? place.file : course_root() / place.file;
        const std::string editor = chosen_editor();
        const std::vector<std::string> command = editor_command(editor, file, place.line);
        const std::string where = shown(place.file) + (place.line > 0 ? fmt::format(":{}", place.line) : "");
        const bool is_started = editor.empty() ? open_on_desktop(file) : start_on_desktop(command);
        message_ = is_started ? fmt::format("opening {}", where)
                              : fmt::format("cannot start {}: open {} yourself, or set VISUAL", command.front(), where);
        print_event(message_);
    }

    void go_to(const std::optional<Shot>& setting) {
        if (!setting) return;
        stage_.apply(*setting);
        // A value that text does not hold exactly must not become a new step.
        settled_ = stage_.edits();
    }

    /// Explains the pixel under the mouse, in the picture or in the error map beside it.
    void follow_pixel() {
        if (check_view_.is_open() || !stage_.framebuffer()) return;
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        const glm::ivec2 size = stage_.size();
        glm::ivec2 at = glm::ivec2(int(mouse.x), int(mouse.y)) - noted_.at;
        if (error_map_.on() && at.x >= size.x) at.x -= size.x;
        if (at.x < 0 || at.y < 0 || at.x >= size.x || at.y >= size.y) {
            message_ = "point at a pixel of the picture, then press P";
            return;
        }
        explanation_.ask(at);
        turns_ = 3;
    }

    void toggle_wipe() {
        if (wipe_.on())
            wipe_.let_go();
        else if (stage_.lab())
            wipe_.hold(stage_);
        check_view_.close();
    }

    void toggle_handout() {
        if (handout_.is_open())
            handout_.close();
        else
            handout_.open(stage_.entry());
    }

    /// Handles keys that scroll or close an open handout. Returns false for all other keys.
    bool press_in_handout(int key) {
        static const std::map<int, float> lines = {{GLFW_KEY_UP, -2.0f},       {GLFW_KEY_DOWN, 2.0f},
                                                   {GLFW_KEY_PAGE_UP, -25.0f}, {GLFW_KEY_PAGE_DOWN, 25.0f},
                                                   {GLFW_KEY_HOME, -1e6f},     {GLFW_KEY_END, 1e6f}};
        const auto found = lines.find(key);
        if (key == GLFW_KEY_ESCAPE)
            handout_.close();
        else if (found != lines.end())
            handout_.scroll(found->second);
        return key == GLFW_KEY_ESCAPE || found != lines.end();
    }

    void press_in_start_page(int key) {
        static const std::map<int, glm::ivec2> steps = {{GLFW_KEY_LEFT, {-1, 0}},    {GLFW_KEY_RIGHT, {1, 0}},
                                                        {GLFW_KEY_UP, {0, -1}},      {GLFW_KEY_DOWN, {0, 1}},
                                                        {GLFW_KEY_PAGE_UP, {0, -3}}, {GLFW_KEY_PAGE_DOWN, {0, 3}}};
        if (const auto found = steps.find(key); found != steps.end()) start_.move(found->second.x, found->second.y);
        const bool is_chosen = key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER;
        if (is_chosen && &start_.marked() != &stage_.entry()) return open(start_.marked());
        if (is_chosen || key == GLFW_KEY_ESCAPE || key == GLFW_KEY_HOME) hide_labs();
    }

    void press(int key, MenuWish& wish) {
        if (key == GLFW_KEY_ESCAPE && ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) {
            ImGui::SetWindowFocus(nullptr);  // closes any open list
            return;
        }
        if (key == GLFW_KEY_ESCAPE && help_) {
            help_ = false;
            return;
        }
        if (start_.is_open()) return press_in_start_page(key);
        if (key == GLFW_KEY_ESCAPE && explanation_.is_open()) return explanation_.close();
        if (key == GLFW_KEY_ESCAPE && check_view_.is_open()) {
            wish.check = "";
            return;
        }
        if (key == GLFW_KEY_ESCAPE && brush_.is_on()) return void(brush_.toggle(stage_));
        if (key == GLFW_KEY_ESCAPE && wipe_.on()) return wipe_.let_go();
        if (key == GLFW_KEY_ESCAPE && motion_.is_on()) return motion_.stop();
        if (handout_.is_open() && press_in_handout(key)) return;
        switch (key) {
            case GLFW_KEY_PAGE_DOWN:
            case GLFW_KEY_RIGHT:
                step(1);
                break;
            case GLFW_KEY_PAGE_UP:
            case GLFW_KEY_LEFT:
                step(-1);
                break;
            case GLFW_KEY_R:
                open(stage_.entry());
                break;
            case GLFW_KEY_S:
            case GLFW_KEY_F12:
                save();
                break;
            case GLFW_KEY_M:
                save_map();
                break;
            case GLFW_KEY_N:
                save_heights();
                break;
            case GLFW_KEY_B:
                if (!brush_.toggle(stage_)) message_ = "this lab has no heights to paint";
                check_view_.close();
                break;
            case GLFW_KEY_F1:
                toggle_handout();
                break;
            case GLFW_KEY_E:
                error_map_.toggle();
                break;
            case GLFW_KEY_A:
                toggle_wipe();
                break;
            case GLFW_KEY_X:
                wipe_.swap(stage_);
                break;
            case GLFW_KEY_P:
                follow_pixel();
                break;
            case GLFW_KEY_C:
                stage_.camera() = stage_.manifest().camera, stage_.changed();
                break;
            case GLFW_KEY_T:
                motion_.toggle_camera();
                if (paused_) pause();
                break;
            case GLFW_KEY_H:
                panel_hidden_ = !panel_hidden_;
                break;
            case GLFW_KEY_SPACE:
                pause();
                break;
            case GLFW_KEY_HOME:
                show_labs();
                break;
            default:
                break;
        }
    }

    void pause() {
        paused_ = !paused_;
        if (!paused_) begin_ = glfwGetTime() - time_;
    }

    void mouse() {
        const ImGuiIO& io = ImGui::GetIO();
        if (io.WantCaptureMouse) return;
        Orbit& camera = stage_.camera();
        const Orbit before = camera;
        if (brush_.is_on() && !check_view_.is_open()) {
            paint();
        } else if (io.MouseDown[0]) {
            camera.yaw -= 0.3 * double(io.MouseDelta.x);
            camera.pitch = std::clamp(camera.pitch + 0.3 * double(io.MouseDelta.y), -89.0, 89.0);
        }
        if (io.MouseDown[1] || io.MouseDown[2]) pan(camera, io.MouseDelta.x, io.MouseDelta.y);
        camera.distance = std::clamp(camera.distance * std::pow(0.9, double(io.MouseWheel)), 1e-3, 1e6);
        if (!(camera == before)) stage_.changed();
    }

    /// Returns the place of the mouse in the picture, in pixels from its upper left corner.
    glm::dvec2 pixel_under_mouse() const {
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        return glm::dvec2(double(mouse.x), double(mouse.y)) - glm::dvec2(noted_.at) + 0.5;
    }
    void paint() {
        try {
            brush_.move(stage_, pixel_under_mouse(), ImGui::GetIO().MouseDown[0]);
        } catch (const Error& error) {
            message_ = error.what();
            print_error(message_);
        }
    }

    // Keeps the point under the mouse in place.
    void pan(Orbit& camera, double right, double down) const {
        const double metres =
            2 * camera.distance * std::tan(glm::radians(camera.field_of_view) / 2) / std::max(1, stage_.size().y);
        const glm::dmat3 world_from_view = glm::transpose(glm::dmat3(Camera(camera, 1).view_from_world()));
        camera.target += world_from_view * glm::dvec3(-right * metres, down * metres, 0);
    }

    /// Loads a picture or a model that was dropped on the window.
    void take(const std::filesystem::path& file) {
        try {
            if (!stage_.lab()) return;
            const std::string knob = set_file(*stage_.lab(), file);
            message_ = knob.empty() ? stage_.manifest().title +
                                          (is_named_as_model(file) ? " takes no model" : " takes no picture")
                                    : knob + ": " + file.filename().string();
            if (!knob.empty()) stage_.changed();
        } catch (const Error& error) {
            message_ = error.what();
            print_error(message_);
        }
    }

    void save() {
        save_as("", ColorSpace::srgb, [this] { return stage_.picture(); });
    }
    /// Saves the map that the lab makes, with 16 bits.
    void save_map() {
        save_as("-map", ColorSpace::linear, [this] {
            if (!stage_.lab() || !stage_.framebuffer()) throw Error("there is no map to save");
            return map_of(*stage_.lab());
        });
    }
    /// Saves the heights that the lab shows, painted or not, with 16 bits.
    void save_heights() {
        save_as("-heights", ColorSpace::linear, [this] {
            auto* const lab = dynamic_cast<Paintable*>(stage_.lab());
            if (!lab || !stage_.framebuffer()) throw Error("this lab has no heights to save");
            Image heights = lab->painted_heights();
            for (float& height : heights.values) height = std::clamp(height, 0.0f, 1.0f);
            heights.bits = 16;
            return heights;
        });
    }
    /// Saves a picture under the next free name, and says which.
    template <class Make>
    void save_as(const char* what, ColorSpace space, Make make) {
        try {
            int number = 1;
            const auto name = [&] { return fmt::format("{}{}-{}.png", stage_.entry().folder, what, number); };
            while (std::filesystem::exists(name())) ++number;
            write_image(name(), make(), {}, space);
            message_ = "saved " + name();
            fmt::print("{}\n", name());
            std::fflush(stdout);
        } catch (const Error& error) {
            message_ = error.what();
            print_error(message_);
        }
    }

    static constexpr double look_every = 0.2, look_soon = 0.02, still_for = 0.3;  // seconds
    GlfwWindow window_{{1280, 800}, "Relief", true};
    const float display_scale_ = scale_of(window_.handle());
    float zoom_ = 1, scale_ = display_scale_;  ///< `zoom_`: set by Ctrl and +/-; `scale_`: zoom times display scale
    ImGuiSession imgui_{window_.handle(), scale_};
    Stage stage_;
    Checks checks_;
    CheckView check_view_;
    Panel panel_;
    Status status_;
    Borders borders_;
    ErrorBox error_box_;
    Search search_;
    StartPage start_;
    Motion motion_;
    History history_;
    Wipe wipe_;
    Brush brush_;
    bool help_ = false, is_told_ = false;  ///< help is open; the "drawing ..." note has been shown
    Box noted_;
    glm::ivec2 room_{0};               ///< the picture's size in the last turn; 0 if the next turn will change it
    int64_t edits_ = 0, settled_ = 0;  ///< stage.edits() seen so far; stage.edits() at the last step of undo
    Handout handout_;
    ErrorMap error_map_;
    PixelValues pixel_;
    PixelExplanation explanation_;
    double looked_ = 0, drawn_ = 0, opened_ = 0;
    double begin_ = 0, time_ = 0, moved_ = 0;
    bool paused_ = false, panel_hidden_ = false;
    int turns_ = 3;
    int64_t shown_ = 0, told_ = 0;  ///< frames of the menu so far; at the last --verbose message
    std::string message_;
};

}  // namespace

int open_menu(const MenuStart& start) {
    if (registry().empty()) throw Error("this executable has no labs");
    return Menu(start).run();
}

}  // namespace relief::window

int relief_run_menu(const relief::window::MenuStart& start) { return relief::window::open_menu(start); }
