#include "framework/course/check/watchdog.h"

#include <algorithm>
#include <utility>

#include "framework/core/base/system.h"
#include "framework/core/base/text.h"

namespace relief::check {

double Watchdog::Clock::now() { return os::processor_seconds(); }

double Watchdog::Clock::seconds() const {
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin_;
    return std::max(now() - cpu_, wall.count() / 10);
}

Watchdog::Watchdog(std::function<void(const std::string&)> give_up, PatienceLimits limits)
    : give_up_(std::move(give_up)), limits_(limits), thread_(&Watchdog::watch, this) {}

Watchdog::~Watchdog() {
    {
        const std::lock_guard lock(mutex_);
        done_ = true;
    }
    changed_.notify_one();
    thread_.join();
}

void Watchdog::next() {
    const std::lock_guard lock(mutex_);
    check_ = Clock();
}

void Watchdog::watch() {
    std::unique_lock lock(mutex_);
    while (!changed_.wait_for(lock, std::chrono::milliseconds(50), [&] { return done_; })) {
        const bool is_lab_over = lab_.seconds() > limits_.lab;
        if (!is_lab_over && check_.seconds() <= limits_.check) continue;
        lock.unlock();
        return give_up_(rounded(is_lab_over ? limits_.lab : limits_.check) + " seconds");
    }
}

}  // namespace relief::check
