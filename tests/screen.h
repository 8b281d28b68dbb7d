// An X server of a test's own.
#pragma once

#include <chrono>
#include <memory>
#include <sstream>
#include <string>
#include <thread>

#include "tests/process.h"

namespace relief {

/// Waits until a condition holds, for at most ten seconds: a software renderer shares two cores with other tests.
template <class Condition>
bool eventually(Condition condition) {
    for (int i = 0; i < 200; ++i) {
        if (condition()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return condition();
}

/// An X server on the first free display. It lives on without windows: a reset would refuse the next window for a
/// moment.
class Screen {
public:
    explicit Screen(const std::string& size) {
        server_ = std::make_unique<Process>(std::vector<std::string>{
            "bash", "-c", "exec Xvfb -displayfd 2 -screen 0 " + size + " -nolisten tcp -noreset 2>&2"});
        eventually([&] { return !number().empty(); });
    }
    std::string display() const { return ":" + number(); }

private:
    /// Returns the line that is a number. A server may print others before it, and may have begun one.
    std::string number() const {
        const std::string text = server_->err();
        std::istringstream lines(text.substr(0, text.rfind('\n') + 1));
        for (std::string line; std::getline(lines, line);)
            if (!line.empty() && line.find_first_not_of("0123456789") == line.npos) return line;
        return "";
    }
    std::unique_ptr<Process> server_;
};

}  // namespace relief
