#include "framework/window/menu.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "framework/base/error.h"
#include "framework/base/log.h"
#include "framework/context/glfw_window.h"
#include "framework/gl/counters.h"
#include "framework/image/file.h"
#include "framework/window/menu_error_map.h"
#include "framework/window/menu_handout.h"
#include "framework/window/menu_panel.h"
#include "framework/window/menu_pixel.h"
#include "framework/window/menu_stage.h"
#include "framework/window/menu_style.h"

namespace relief {
namespace {

/// Dear ImGui, for as long as the window is open.
class ImGuiSession {
public:
    ImGuiSession(GLFWwindow* window, float scale) {
        ImGui::CreateContext();
        ImGui::GetIO().IniFilename = nullptr;  // the menu leaves no files behind
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
};

float scale_of(GLFWwindow* window) {
    float x = 1, y = 1;
    glfwGetWindowContentScale(window, &x, &y);
    return std::max(1.0f, x);
}

class Menu {
public:
    explicit Menu(const MenuStart& start) {
        const auto& labs = registry();
        const auto found =
            std::find_if(labs.begin(), labs.end(), [&](const LabEntry& lab) { return lab.folder == start.lab_folder; });
        open(found == labs.end() ? labs.front() : *found, start.shot ? &*start.shot : nullptr);
        if (start.error_map) error_map_.toggle();
    }

    int run() {
        GLFWwindow* const window = window_.handle();
        while (!glfwWindowShouldClose(window)) {
            // Asleep until something happens. An event wants a second turn, in which Dear ImGui shows what it did, and
            // a third when that was to open a window, which is measured before it is shown. The sleep is broken to look
            // at files, and nothing is drawn when they are as they were.
            if (moves() || turns_ > 0) {
                glfwPollEvents();
            } else {
                if (shown_ != told_) print_event(fmt::format("asleep after {} frames of the menu", told_ = shown_));
                glfwWaitEventsTimeout(look_every);
            }
            const bool news = look();
            if (window_.take_event() || news) turns_ = 3;
            if (!moves() && turns_ == 0) continue;
            turns_ = std::max(0, turns_ - 1);
            turn();
            glfwSwapBuffers(window);
            ++shown_;
        }
        return 0;
    }

private:
    bool moves() const { return stage_.manifest().animated && !stage_.failed() && !paused_; }

    /// What happens without the user: files that were saved, and an error map once the picture stands still. Whether
    /// there is anything new to show.
    bool look() {
        const double now = glfwGetTime();
        bool news = false;
        if (now - looked_ >= look_every) {
            looked_ = now;
            news = stage_.look();
            news |= handout_.look();
        }
        // A drag that pauses is not over, and the truth may take a second.
        bool dragged = false;
        for (int button = 0; button < 3; ++button)
            dragged |= glfwGetMouseButton(window_.handle(), button) == GLFW_PRESS;
        if (error_map_.wanted() && !dragged && !moves() && now - drawn_ >= still_for) {
            error_map_.compute(stage_);
            news = true;
        }
        return news;
    }

    void open(const LabEntry& entry, const Shot* shot = nullptr) {
        stage_.open(entry, shot);
        error_map_.forget();
        if (handout_.is_open()) handout_.open(entry);
        begin_ = glfwGetTime(), time_ = 0;
        message_.clear();
        glfwSetWindowTitle(window_.handle(), fmt::format("Relief: {} {}", entry.two_digits(), entry.name).c_str());
    }

    void step(int direction) {
        const auto& labs = registry();
        const auto at = &stage_.entry() - labs.data(), count = std::ptrdiff_t(labs.size());
        open(labs[size_t((at + direction + count) % count)]);
    }

    void turn() {
        ImGui_ImplOpenGL3_NewFrame();
        ImGui_ImplGlfw_NewFrame();
        ImGui::NewFrame();
        glm::ivec2 window{0, 0};
        glfwGetFramebufferSize(window_.handle(), &window.x, &window.y);
        const int panel = panel_hidden_ ? 0 : std::min(window.x, int(panel_width * scale_));
        keyboard();
        mouse();
        for (const std::filesystem::path& file : window_.take_files()) take(file);
        if (!panel_hidden_) act(draw_panel(stage_, panel, error_map_.on(), message_));
        draw_error(stage_, panel);
        handout_.draw(panel, scale_);
        if (!paused_) time_ = glfwGetTime() - begin_;

        const int half = error_map_.on() ? 2 : 1;
        const glm::ivec2 room =
            glm::clamp(glm::ivec2((window.x - panel) / half, window.y), glm::ivec2(1), glm::ivec2(max_picture_side));
        if (stage_.draw(room, time_)) error_map_.forget(), drawn_ = glfwGetTime();
        error_map_.draw(panel + room.x, room, moves());
        pixel_.draw(stage_, error_map_, panel, room);
        present(window, panel, room);
        ImGui::Render();
        ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    }

    void present(glm::ivec2 window, int panel, glm::ivec2 room) const {
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glViewport(0, 0, window.x, window.y);
        glClearColor(0.08f, 0.085f, 0.10f, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        if (!stage_.framebuffer()) return;
        glBindFramebuffer(GL_READ_FRAMEBUFFER, stage_.framebuffer());
        glBlitFramebuffer(0, 0, room.x, room.y, panel, 0, panel + room.x, room.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
    }

    void act(PanelWish wish) {
        if (wish.lab) open(*wish.lab);
        if (wish.step) step(wish.step);
        if (wish.restart) open(stage_.entry());
        if (wish.save) save();
        if (wish.handout) toggle_handout();
        if (wish.error_map) error_map_.toggle();
    }

    void keyboard() {
        for (const int key : window_.take_keys())
            if (!ImGui::GetIO().WantTextInput) press(key);
    }

    void toggle_handout() {
        if (handout_.is_open())
            handout_.close();
        else
            handout_.open(stage_.entry());
    }

    /// Keys that scroll an open handout, and what closes it. Returns false for all others.
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

    void press(int key) {
        if (key == GLFW_KEY_ESCAPE && ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) {
            ImGui::SetWindowFocus(nullptr);  // closes whatever list is open
            return;
        }
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
            case GLFW_KEY_F1:
                toggle_handout();
                break;
            case GLFW_KEY_E:
                error_map_.toggle();
                break;
            case GLFW_KEY_C:
                stage_.camera() = stage_.manifest().camera, stage_.changed();
                break;
            case GLFW_KEY_H:
                panel_hidden_ = !panel_hidden_;
                break;
            case GLFW_KEY_SPACE:
                pause();
                break;
            case GLFW_KEY_ESCAPE:
                glfwSetWindowShouldClose(window_.handle(), GLFW_TRUE);
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
        if (io.MouseDown[0]) {
            camera.yaw -= 0.3 * double(io.MouseDelta.x);
            camera.pitch = std::clamp(camera.pitch + 0.3 * double(io.MouseDelta.y), -89.0, 89.0);
        }
        if (io.MouseDown[1] || io.MouseDown[2]) pan(camera, io.MouseDelta.x, io.MouseDelta.y);
        camera.distance = std::clamp(camera.distance * std::pow(0.9, double(io.MouseWheel)), 1e-3, 1e6);
        if (!(camera == before)) stage_.changed();
    }

    // The point under the mouse stays under it.
    void pan(Orbit& camera, double right, double down) const {
        const double metres =
            2 * camera.distance * std::tan(glm::radians(camera.field_of_view) / 2) / std::max(1, stage_.size().y);
        const glm::dmat3 world_from_view = glm::transpose(glm::dmat3(Camera(camera, 1).view_from_world()));
        camera.target += world_from_view * glm::dvec3(-right * metres, down * metres, 0);
    }

    /// A picture that was dropped on the window.
    void take(const std::filesystem::path& file) {
        try {
            if (!stage_.lab()) return;
            const std::string knob = set_picture(*stage_.lab(), file);
            message_ =
                knob.empty() ? stage_.manifest().title + " takes no picture" : knob + ": " + file.filename().string();
            if (!knob.empty()) stage_.changed();
        } catch (const Error& error) {
            message_ = error.what();
            print_error(message_);
        }
    }

    void save() {
        try {
            int number = 1;
            const auto name = [&] { return fmt::format("{}-{}.png", stage_.entry().folder, number); };
            while (std::filesystem::exists(name())) ++number;
            write_image(name(), stage_.picture());
            message_ = "saved " + name();
            fmt::print("{}\n", name());
            std::fflush(stdout);
        } catch (const Error& error) {
            message_ = error.what();
            print_error(message_);
        }
    }

    static constexpr float panel_width = 340;                   // pixels at scale 1
    static constexpr double look_every = 0.2, still_for = 0.3;  // seconds
    GlfwWindow window_{{1280, 800}, "Relief", true};
    float scale_ = scale_of(window_.handle());
    ImGuiSession imgui_{window_.handle(), scale_};
    Stage stage_;
    Handout handout_;
    ErrorMap error_map_;
    PixelValues pixel_;
    double looked_ = 0, drawn_ = 0;
    double begin_ = 0, time_ = 0;
    bool paused_ = false, panel_hidden_ = false;
    int turns_ = 3;
    int64_t shown_ = 0, told_ = 0;  ///< frames of the menu; those that --verbose knows of
    std::string message_;
};

}  // namespace

int open_menu(const MenuStart& start) {
    if (registry().empty()) throw Error("this executable has no labs");
    return Menu(start).run();
}

}  // namespace relief

int relief_run_menu(const relief::MenuStart& start) { return relief::open_menu(start); }
