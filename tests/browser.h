// A headless browser, Chromium, driven through its debugging pipe: shows pages as readers see them.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "tests/support.h"

namespace relief {

class Browser {
public:
    /// Throws when there is no browser; see framework/cmake/packages.txt. With a display, such as ":77", the browser
    /// opens a window there, and draws WebGL with that display's OpenGL. Else it has no WebGL.
    explicit Browser(const std::string& display = "");
    ~Browser();
    Browser(const Browser&) = delete;
    Browser& operator=(const Browser&) = delete;

    /// Waits until the page is loaded and its scripts have run.
    void open(const std::filesystem::path& page);
    void open_address(const std::string& address);
    /// Returns the value of a JavaScript expression. Throws when the expression throws.
    nlohmann::json eval(const std::string& expression);
    /// Repeats an expression until its value counts as true, for at most two minutes. Returns that value.
    nlohmann::json wait_for(const std::string& expression);
    /// Presses a key `times` times: Tab, Enter, Escape, Space, ArrowLeft, ArrowRight, Home, End.
    void press(const std::string& key, int times = 1);
    /// Presses Tab until the focused element matches a CSS selector. Returns false when no element does.
    bool tab_to(const std::string& selector);
    void type(const std::string& text);
    void dark(bool on);
    /// Switches to print style on a sheet 720 pixels wide, or back.
    void paper(bool on);
    void scripts(bool on);
    /// Emulates a screen of this width; 0 restores the window's own.
    void width(int pixels);
    /// Loads all pictures of the page, including lazy ones. Returns false when one cannot be shown.
    bool load_images();

    struct Control {
        std::string role, name;
    };
    /// Returns all focusable elements, as a screen reader presents them.
    std::vector<Control> controls();
    /// Returns texts whose contrast with their background is below 4.5, the minimum of WCAG AA. The words of a plot are
    /// on the plot's own white background.
    std::vector<std::string> faint_texts();
    /// Returns the faint texts in light, and then those in the dark with a mark. Calls `each` in both, and ends in
    /// light.
    std::vector<std::string> faint_texts_in_both(const std::function<void(bool is_dark)>& each = {}) {
        std::vector<std::string> texts;
        for (const bool is_dark : {false, true}) {
            dark(is_dark);
            for (const std::string& text : faint_texts()) texts.push_back((is_dark ? "in the dark: " : "") + text);
            if (each) each(is_dark);
        }
        dark(false);
        return texts;
    }
    /// Returns the faults that axe-core finds on the page at widths of 1440 and 390 pixels, in light and in dark, with
    /// all details open, and the texts that cover one another there: each fault once. Includes the rule on the size of
    /// targets, which is new in WCAG 2.2. Throws if axe-core is not installed; the script relief installs it for
    /// `test --ci`.
    std::vector<std::string> accessibility_faults();
    /// Returns the browser's complaints since the page was opened: errors of scripts, and violations of the page's
    /// policy.
    std::vector<std::string> complaints();
    /// Returns the addresses that the page has requested since it was opened.
    std::set<std::string> requests();

    /// Calls a command of the DevTools protocol and returns its result. Throws when the command fails.
    nlohmann::json call(const std::string& method, const nlohmann::json& parameters = nlohmann::json::object());

private:
    nlohmann::json next_message();

    TemporaryFolder profile_;
    int pid_ = -1, to_ = -1, from_ = -1, id_ = 0;
    std::string buffer_, session_;
    std::vector<nlohmann::json> events_;
};

/// Returns the browser of all tests of a program, which starts when it is first needed.
inline Browser& browser() {
    static Browser one;
    return one;
}

}  // namespace relief
