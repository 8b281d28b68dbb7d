#include "framework/course/window/menu.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/core/base/error.h"
#include "framework/core/base/log.h"
#include "framework/core/context/glfw_window.h"
#include "framework/course/window/menu_help.h"
#include "framework/course/window/menu_keys.h"
#include "framework/course/window/menu_lab.h"
#include "framework/course/window/menu_search.h"
#include "framework/course/window/menu_session.h"
#include "framework/course/window/menu_start.h"
#include "framework/course/window/menu_style.h"

namespace relief::window {
namespace {

constexpr double look_every = 0.2, look_soon = 0.02;  // seconds

/// An event needs up to three frames: Dear ImGui shows its effect in the second one, and measures a new window before
/// it shows it in the third.
constexpr int frames_of_an_event = 3;

/// The window: it shows the start page or a lab, and draws only after an event or a change.
class Menu {
public:
    explicit Menu(const MenuStart& start) {
        const auto& labs = registry();
        const auto found =
            std::find_if(labs.begin(), labs.end(), [&](const LabEntry& lab) { return lab.folder == start.lab_folder; });
        fit_to_display(window_.handle(), display_scale_);
        const LabEntry* const edited = found == labs.end() ? StartPage::last_edited() : nullptr;
        open(found != labs.end() ? *found : edited ? *edited : labs.front(), start.shot ? &*start.shot : nullptr);
        MenuWish wish;
        if (found == labs.end()) wish.ask(WindowAction::open_labs);
        if (start.error_map) wish.ask(LabAction::toggle_error_map);
        if (!start.check.empty()) wish.check = start.check;
        act(wish);
    }

    int run() {
        int frames = frames_of_an_event;
        while (!glfwWindowShouldClose(window_.handle())) {
            // Sleep until an event. The sleep ends regularly to look at files; unchanged files cause no drawing.
            if (moves() || frames > 0 || has_work()) {
                glfwPollEvents();
            } else {
                if (shown_ != told_) print_event(fmt::format("asleep after {} frames of the menu", told_ = shown_));
                glfwWaitEventsTimeout(lab_.computes() ? look_soon : look_every);
            }
            const bool news = look();
            if (window_.take_event() || news) frames = frames_of_an_event;
            if (has_work()) work(), frames = std::max(frames, 1);
            if (!moves() && frames == 0) continue;
            frames = std::max(frames - 1, draw());
            glfwSwapBuffers(window_.handle());
            ++shown_;
        }
        return 0;
    }

private:
    bool moves() const { return !start_.is_open() && lab_.moves(); }
    bool is_dragged() const {
        for (int button = 0; button < 3; ++button)
            if (glfwGetMouseButton(window_.handle(), button) == GLFW_PRESS) return true;
        return false;
    }

    /// Returns whether there is a picture to load or a check to run between two frames.
    bool has_work() const {
        if (is_dragged()) return false;
        return start_.is_open() ? start_.waits() : lab_.has_check_to_run();
    }
    void work() { start_.is_open() ? start_.make_next() : lab_.run_check(); }

    /// Looks for saved files, and computes what waits for a still picture. Returns whether there is anything new to
    /// show.
    bool look() {
        const double now = glfwGetTime();
        bool news = false;
        if (now - looked_ >= look_every) {
            looked_ = now;
            news = lab_.look_at_files();
        }
        return (!start_.is_open() && lab_.compute(is_dragged())) || news;
    }

    void open(const LabEntry& entry, const Shot* shot = nullptr) {
        lab_.open(entry, shot);
        close_start_page();
    }
    void open_start_page() {
        if (registry().size() < 2) return;
        lab_.leave_parts();
        start_.open(lab_.stage().entry());
        glfwSetWindowTitle(window_.handle(), "Relief: all labs");
    }
    void close_start_page() {
        start_.close();
        const LabEntry& entry = lab_.stage().entry();
        glfwSetWindowTitle(window_.handle(), fmt::format("Relief: {} {}", entry.two_digits(), entry.name).c_str());
    }
    void step(int direction) {
        const auto& labs = registry();
        const auto at = &lab_.stage().entry() - labs.data(), count = std::ptrdiff_t(labs.size());
        open(labs[size_t((at + direction + count) % count)]);
    }

    /// Draws one frame, then carries out its wishes. Returns how many more frames are needed.
    int draw() {
        if (const float wanted = display_scale_ * zoom_; wanted != scale_) imgui_.scale(scale_ = wanted);
        imgui_.begin_frame();
        glm::ivec2 window{0, 0};
        glfwGetFramebufferSize(window_.handle(), &window.x, &window.y);
        MenuWish wish = pressed();
        int more = 0;
        const auto files = window_.take_files();
        if (start_.is_open()) {
            start_.draw(window, scale_, wish);
            glBindFramebuffer(GL_FRAMEBUFFER, 0);
            glViewport(0, 0, window.x, window.y);
        } else {
            for (const std::filesystem::path& file : files) lab_.take(file);
            more = lab_.draw(window, scale_, is_dragged(), wish);
        }
        search_.draw(scale_, lab_.stage(), lab_.checks(), wish);
        draw_help(start_.is_open() ? Box{{0, 0}, window} : lab_.picture(), scale_, is_help_open_);
        had_list_ = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
        was_active_ = ImGui::IsAnyItemActive();
        imgui_.end_frame();
        if (wish.is_empty()) return more;
        act(wish);
        return frames_of_an_event;
    }

    /// Returns the wishes of the keys that were pressed since the last frame.
    MenuWish pressed() {
        OpenParts open{.typing = ImGui::GetIO().WantTextInput,
                       .search = search_.is_open(),
                       .list = had_list_,
                       .help = is_help_open_,
                       .labs = start_.is_open(),
                       .active = was_active_};
        lab_.add_open_parts(open);
        MenuWish wish;
        for (const unsigned character : window_.take_characters()) add_character(character, open, wish);
        for (const Key& key : window_.take_keys()) add_key(key, open, wish);
        return wish;
    }

    void act(const MenuWish& wish) {
        if (search_.is_open())
            search_.move(wish.rows);
        else if (start_.is_open())
            start_.move(wish.columns, wish.rows);
        for (const MenuAction& action : wish.actions)
            if (const auto* const mine = std::get_if<WindowAction>(&action)) act(*mine);
        if (wish.lab && !(start_.is_open() && wish.lab == &lab_.stage().entry())) open(*wish.lab);
        // A lab that is open keeps its settings.
        if (start_.is_open() &&
            (wish.lab || wish.check || !wish.probe.empty() || !wish.knob.empty() || !wish.document.empty()))
            close_start_page();
        lab_.act(wish);
    }

    void act(WindowAction action) {
        constexpr float step_of_zoom = 1.125f;
        switch (action) {
            case WindowAction::toggle_help:
                is_help_open_ = !is_help_open_;
                break;
            case WindowAction::open_search:
                lab_.leave_parts();  // the search has a mark of its own
                search_.open();
                break;
            case WindowAction::close_search:
                search_.close();
                break;
            case WindowAction::take_found:
                search_.take();
                break;
            case WindowAction::close_list:
                ImGui::SetWindowFocus(nullptr);  // closes any open list
                break;
            case WindowAction::open_labs:
                open_start_page();
                break;
            case WindowAction::close_labs:
                close_start_page();
                break;
            case WindowAction::choose_lab:
                if (&start_.marked() != &lab_.stage().entry()) open(start_.marked());
                close_start_page();
                break;
            case WindowAction::next_lab:
                step(1);
                break;
            case WindowAction::previous_lab:
                step(-1);
                break;
            case WindowAction::reset_lab:
                open(lab_.stage().entry());
                break;
            case WindowAction::larger:
                zoom(zoom_ * step_of_zoom);
                break;
            case WindowAction::smaller:
                zoom(zoom_ / step_of_zoom);
                break;
            case WindowAction::usual_size:
                zoom(1);
                break;
            case WindowAction::quit:
                glfwSetWindowShouldClose(window_.handle(), GLFW_TRUE);
                break;
        }
    }
    void zoom(float factor) {
        zoom_ = std::clamp(factor, 0.5f, 4.0f);
        if (std::abs(zoom_ - 1) < 0.01f) zoom_ = 1;
        keep_zoom(zoom_);
    }

    GlfwWindow window_{{1280, 800}, "Relief", true};
    const float display_scale_ = scale_of(window_.handle());
    float zoom_ = kept_zoom();  ///< set by Ctrl and +/-
    float scale_ = display_scale_ * zoom_;
    ImGuiSession imgui_{window_.handle(), scale_};
    LabView lab_;
    StartPage start_;
    Search search_;
    bool is_help_open_ = false;
    bool had_list_ = false, was_active_ = false;  ///< in the last frame: Dear ImGui sees Escape before pressed() does
    double looked_ = 0;
    int64_t shown_ = 0, told_ = 0;  ///< frames of the menu so far; at the last --verbose message
};

}  // namespace

int open_menu(const MenuStart& start) {
    if (registry().empty()) throw Error("this executable has no labs");
    return Menu(start).run();
}

}  // namespace relief::window

int relief_run_menu(const relief::window::MenuStart& start) { return relief::window::open_menu(start); }
