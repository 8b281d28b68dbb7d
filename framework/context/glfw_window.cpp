#include "framework/context/glfw_window.h"

#include "framework/base/error.h"
#include "framework/context/backends.h"
#include "framework/gl/gl.h"

namespace relief {
namespace {

[[noreturn]] void fail() {
    const char* reason = nullptr;
    glfwGetError(&reason);
    throw Error(std::string("no window: ") + (reason ? reason : "GLFW gives no reason"));
}

}  // namespace

GlfwWindow::GlfwWindow(glm::ivec2 size, const std::string& title, bool visible) {
    if (!glfwInit()) fail();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);  // macOS has no other core profile
    glfwWindowHint(GLFW_VISIBLE, visible ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);  // labs draw into targets of their own
    window_ = glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr);
    if (!window_) fail();
    GlfwWindow::make_current();
    load_gl(glfwGetProcAddress);
}

GlfwWindow::~GlfwWindow() {
    if (window_) glfwDestroyWindow(window_);
    glfwTerminate();
}

}  // namespace relief

relief::Context* relief_open_hidden_window() { return new relief::GlfwWindow({64, 64}, "Relief", false); }
