// A real browser without a window, Chromium, driven through its debugging pipe: pages as their readers have them.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support.h"

namespace relief {

class Browser {
public:
    /// Throws where there is none; see framework/cmake/packages.txt.
    Browser();
    ~Browser();
    Browser(const Browser&) = delete;
    Browser& operator=(const Browser&) = delete;

    /// Waits until the page is loaded and its scripts have run.
    void open(const std::filesystem::path& page);
    /// The value of a JavaScript expression. Throws what it throws.
    nlohmann::json eval(const std::string& expression);
    /// A key on a keyboard, as often: Tab, Enter, Escape, Space, ArrowLeft, ArrowRight, Home, End.
    void press(const std::string& key, int times = 1);
    /// Tab until what has the focus matches a CSS selector. False when nothing does.
    bool tab_to(const std::string& selector);
    void type(const std::string& text);
    void dark(bool on);
    /// As it is printed, on a sheet 720 pixels wide.
    void paper(bool on);
    void scripts(bool on);
    /// As on a screen of so many pixels across; 0: the window's own.
    void width(int pixels);
    /// All pictures of the page, also those that are loaded when they are seen. False when one cannot be shown.
    bool load_images();

    struct Control {
        std::string role, name;
    };
    /// Everything that takes the focus, as a screen reader is told of it.
    std::vector<Control> controls();
    /// Texts whose colour is too near to what lies behind: AA asks for 4.5.
    std::vector<std::string> faint_texts();
    /// What the browser complained of since the page was opened: errors of scripts, and what the page's policy forbade.
    std::vector<std::string> complaints();

    /// A command of the DevTools protocol.
    nlohmann::json call(const std::string& method, const nlohmann::json& parameters = nlohmann::json::object());

private:
    nlohmann::json next_message();

    TemporaryFolder profile_;
    int pid_ = -1, to_ = -1, from_ = -1, id_ = 0;
    std::string buffer_, session_;
    std::vector<nlohmann::json> events_;
};

}  // namespace relief
