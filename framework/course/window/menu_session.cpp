#include "framework/course/window/menu_session.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/course/window/menu_imgui.h"
#include "framework/course/window/menu_style.h"

namespace relief::window {
namespace {

std::filesystem::path zoom_file() { return course_root() / "build" / "window.zoom"; }

}  // namespace

float scale_of(GLFWwindow* window) {
    float x = 1, y = 1;
    glfwGetWindowContentScale(window, &x, &y);
    if (x > 1) return x;
    GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* const mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    return mode ? std::max(1.0f, std::min(float(mode->width) / 1920, float(mode->height) / 1080)) : 1;
}

float kept_zoom() try {
    const std::optional<double> zoom = parse_number(read_file(zoom_file(), 100));
    return zoom ? std::clamp(float(*zoom), 0.5f, 4.0f) : 1;
} catch (const Error&) {
    return 1;
}

void keep_zoom(float zoom) try {
    make_folder(zoom_file().parent_path());
    write_file(zoom_file(), fmt::format("{}", zoom));
} catch (const Error&) {
    // The window of a course that one may only read has its usual size at the next start.
}

void fit_to_display(GLFWwindow* window, float scale) {
    glm::ivec2 size{0, 0}, room{0, 0};
    glfwGetWindowSize(window, &size.x, &size.y);
    int x = 0, y = 0;
    if (GLFWmonitor* const monitor = glfwGetPrimaryMonitor()) glfwGetMonitorWorkarea(monitor, &x, &y, &room.x, &room.y);
    const auto wanted = glm::ivec2(glm::vec2(size) * scale);
    if (room.x > 0 && room.y > 0) glfwSetWindowSize(window, std::min(wanted.x, room.x), std::min(wanted.y, room.y));
}

ImGuiSession::ImGuiSession(GLFWwindow* window, float scale) {
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // the menu writes no files
    style_menu(scale);
    ImGui_ImplGlfw_InitForOpenGL(window, true);
    ImGui_ImplOpenGL3_Init("#version 410 core");
}

ImGuiSession::~ImGuiSession() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void ImGuiSession::scale(float scale) {
    style_menu(scale);
    upload_fonts();
}

void ImGuiSession::begin_frame() {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
}

void ImGuiSession::end_frame() {
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace relief::window
