// A GLFW window with an OpenGL 4.1 core context. In the window module only.
#pragma once

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <utility>
#include <vector>

#include "framework/core/context/context.h"

namespace relief {

/// A pressed key: its position on the keyboard, the text that it types, and whether Control was held.
struct Key {
    int code;          ///< GLFW_KEY_...
    std::string name;  ///< "z", "+"; empty for keys that type nothing
    bool control;
    bool repeated = false;  ///< it is held, and the system repeats it
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
    /// Returns the keys pressed or repeated since the last call, in order. Includes keys that were released in between:
    /// a frame may take longer than a key press.
    std::vector<Key> take_keys() { return std::exchange(keys_, {}); }
    /// Returns the characters typed since the last call. The question mark is read this way, because its key depends on
    /// the keyboard layout.
    std::vector<unsigned> take_characters() { return std::exchange(characters_, {}); }
    /// Returns the files dropped on the window since the last call.
    std::vector<std::filesystem::path> take_files() { return std::exchange(files_, {}); }
    /// Returns whether the user or the screen has sent an event since the last call. A wait with a timeout needs this
    /// to tell an event from the timeout.
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
