#include "framework/course/check/patience.h"

#include <fmt/format.h>

#include <chrono>
#include <ctime>
#include <utility>

#include "framework/core/base/log.h"

namespace relief::check {
namespace {

/// Returns the processor time of all threads of this process.
double seconds_of_processor() { return double(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace

Patience::Patience(std::function<void(const std::string&)> give_up, PatienceLimits limits)
    : give_up_(std::move(give_up)), limits_(limits) {}

Patience::~Patience() {
    {
        const std::lock_guard lock(mutex_);
        done_ = true;
    }
    changed_.notify_one();
    if (thread_.joinable()) thread_.join();
}

void Patience::next(const std::string& name) {
    {
        const std::lock_guard lock(mutex_);
        name_ = name;
        ++count_;
    }
    if (thread_.joinable())
        changed_.notify_one();
    else
        thread_ = std::thread(&Patience::watch, this);
}

void Patience::watch() {
    using Seconds = std::chrono::duration<double>;
    std::unique_lock lock(mutex_);
    while (!done_) {
        const int watched = count_;
        const auto begin = std::chrono::steady_clock::now();
        const double cpu = seconds_of_processor();
        const auto is_over = [&] { return done_ || count_ != watched; };
        while (!changed_.wait_for(lock, Seconds(limits_.remind), is_over)) {
            const double wall = Seconds(std::chrono::steady_clock::now() - begin).count();
            print_note(fmt::format("waiting for '{}', {:.0f} seconds so far", name_, wall));
            const bool is_busy = seconds_of_processor() - cpu >= limits_.cpu;
            if (wall >= (is_busy ? limits_.wall : 10 * limits_.wall)) {
                const std::string why = fmt::format("'{}' is not finished after {:.0f} seconds", name_, wall);
                lock.unlock();
                return give_up_(why);
            }
        }
    }
}

}  // namespace relief::check
