// An X server of a test's own.
#pragma once

#include <chrono>
#include <memory>
#include <regex>
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
    std::string number() const {
        static const std::regex whole_line("(^|\n)([0-9]+)\n");
        std::smatch found;
        const std::string text = server_->err();
        return std::regex_search(text, found, whole_line) ? found[2].str() : "";
    }
    std::unique_ptr<Process> server_;
};

}  // namespace relief
