// Dear ImGui in the window, and the scale of the interface. In the window module only.
#pragma once

#include "framework/core/context/glfw_window.h"

namespace relief::window {

/// Returns the desktop's scale if it is above 1. Otherwise derives it from the display's size, so that at least 1080
/// scaled rows and 1920 scaled columns remain; at least 1.
float scale_of(GLFWwindow* window);

/// Returns the factor on the display's scale that the user has chosen last, from the course's build folder; 1 if there
/// is none.
float kept_zoom();
/// Keeps the factor for the next start. Does nothing if the folder is not writable.
void keep_zoom(float zoom);

/// Scales the window's size, clamped to the display's work area.
void fit_to_display(GLFWwindow* window, float scale);

/// Owns Dear ImGui for the lifetime of the window.
class ImGuiSession {
public:
    ImGuiSession(GLFWwindow* window, float scale);
    ~ImGuiSession();
    ImGuiSession(const ImGuiSession&) = delete;
    ImGuiSession& operator=(const ImGuiSession&) = delete;

    /// Changes the scale; call it between frames.
    void scale(float scale);
    void begin_frame();
    /// Draws the interface into the bound framebuffer.
    void end_frame();
};

}  // namespace relief::window
