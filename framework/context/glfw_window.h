// A GLFW window with an OpenGL 4.1 core context. In the window module only.
#pragma once

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <utility>
#include <vector>

#include "framework/context/context.h"

namespace relief {

/// A key that was pressed: its place on the keyboard, what it types there, and what was held.
struct Key {
    int code;          ///< GLFW_KEY_...
    std::string name;  ///< "z", "+"; empty for keys that type nothing
    bool control;
};

class GlfwWindow final : public Context {
public:
    /// Throws NoWindow with GLFW's reason when there is no display or no driver.
    GlfwWindow(glm::ivec2 size, const std::string& title, bool visible);
    ~GlfwWindow() override;
    GlfwWindow(const GlfwWindow&) = delete;
    GlfwWindow& operator=(const GlfwWindow&) = delete;

    void make_current() override { glfwMakeContextCurrent(window_); }
    GLFWwindow* handle() const { return window_; }
    /// The keys pressed since the last call, in order: also those that were up again before anyone looked, as happens
    /// when a frame takes longer than a tap.
    std::vector<Key> take_keys() { return std::exchange(keys_, {}); }
    /// The characters typed since the last call: where a keyboard has its question mark is its own affair.
    std::vector<unsigned> take_characters() { return std::exchange(characters_, {}); }
    /// The files dropped on the window since the last call.
    std::vector<std::filesystem::path> take_files() { return std::exchange(files_, {}); }
    /// Whether anything has come from the user or the screen since the last call. What waits with a timeout cannot tell
    /// otherwise why it woke.
    bool take_event() { return std::exchange(event_, false); }

private:
    static GlfwWindow& noted(GLFWwindow* window);

    GLFWwindow* window_ = nullptr;
    bool event_ = false;
    std::vector<Key> keys_;
    std::vector<unsigned> characters_;
    std::vector<std::filesystem::path> files_;
};

}  // namespace relief
