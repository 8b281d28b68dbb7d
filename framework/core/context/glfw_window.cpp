#include "framework/core/context/glfw_window.h"

#include "framework/core/base/error.h"
#include "framework/core/context/backends.h"
#include "framework/core/gl/gl.h"

namespace relief {
namespace {

[[noreturn]] void fail() {
    const char* reason = nullptr;
    glfwGetError(&reason);
    throw NoWindow(std::string("no window: ") + (reason ? reason : "GLFW gives no reason"));
}

/// Throws NoWindow. Explains the missing OpenGL 4.1 core by asking a context of any version.
[[noreturn]] void fail_to_open() {
    const char* reason = nullptr;
    glfwGetError(&reason);
    std::string text = reason ? reason : "GLFW gives no reason";
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    if (GLFWwindow* const window = glfwCreateWindow(64, 64, "", nullptr, nullptr)) {
        glfwMakeContextCurrent(window);
        text = too_little(glfwGetProcAddress) +
               ": update the graphics driver, use Mesa's software renderer (llvmpipe), or another computer";
        glfwDestroyWindow(window);
    } else {
        text += driver_variables();
    }
    throw NoWindow("no window: " + text);
}

}  // namespace

GlfwWindow::GlfwWindow(glm::ivec2 size, const std::string& title, bool visible) {
    // On macOS, a hidden window has no icon in the Dock.
    glfwInitHint(GLFW_COCOA_MENUBAR, visible ? GLFW_TRUE : GLFW_FALSE);
    if (!glfwInit()) fail();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);      // macOS has no other core profile
    glfwWindowHint(GLFW_COCOA_RETINA_FRAMEBUFFER, GLFW_FALSE);  // the menu takes the mouse's units for pixels
    glfwWindowHint(GLFW_VISIBLE, visible ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);  // labs draw into their own targets
    window_ = glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr);
    if (!window_) fail_to_open();
    glfwSetWindowUserPointer(window_, this);
    glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int place, int action, int held) {
        GlfwWindow& self = noted(window);
        const char* const name = glfwGetKeyName(key, place);
        if (action != GLFW_RELEASE)
            self.keys_.push_back({key, name ? name : "", (held & GLFW_MOD_CONTROL) != 0, action == GLFW_REPEAT});
    });
    glfwSetCharCallback(window_,
                        [](GLFWwindow* window, unsigned character) { noted(window).characters_.push_back(character); });
    glfwSetMouseButtonCallback(window_, [](GLFWwindow* window, int, int, int) { noted(window); });
    glfwSetCursorPosCallback(window_, [](GLFWwindow* window, double, double) { noted(window); });
    glfwSetCursorEnterCallback(window_, [](GLFWwindow* window, int) { noted(window); });
    glfwSetScrollCallback(window_, [](GLFWwindow* window, double, double) { noted(window); });
    glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** files) {
        GlfwWindow& self = noted(window);
        self.files_.insert(self.files_.end(), files, files + count);
    });
    glfwSetWindowFocusCallback(window_, [](GLFWwindow* window, int) { noted(window); });
    glfwSetWindowRefreshCallback(window_, [](GLFWwindow* window) { noted(window); });
    glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* window, int, int) { noted(window); });
    GlfwWindow::make_current();
    load_gl(glfwGetProcAddress);
    glfwSwapInterval(1);  // no more frames than the screen shows
}

GlfwWindow& GlfwWindow::noted(GLFWwindow* window) {
    auto& self = *static_cast<GlfwWindow*>(glfwGetWindowUserPointer(window));
    self.event_ = true;
    return self;
}

// GLFW itself stays initialised. glfwTerminate would unload the driver's libraries. The next large library to be opened
// then crashes as it starts (seen with OpenImageIO, Mesa 22.3 and glibc 2.36).
GlfwWindow::~GlfwWindow() {
    if (window_) glfwDestroyWindow(window_);
}

}  // namespace relief

relief::Context* relief_open_hidden_window() { return new relief::GlfwWindow({64, 64}, "Relief", false); }
