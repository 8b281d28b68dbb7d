// Watches the time of checks, and calls back when it is used up. Nothing inside a process can stop an endless loop in a
// student's code, so the callback ends the process.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace relief::check {

/// Limits in seconds of processor time, since other programs use up wall time. A process that waits instead of
/// computing has ten times as much wall time.
struct PatienceLimits {
    double check = 10;  ///< for one check
    double lab = 20;    ///< for all checks of a lab
};
/// For a slow machine.
inline constexpr PatienceLimits patient_limits{.check = 300, .lab = 600};

/// Watches this process on a thread of its own, from construction on.
class Watchdog {
public:
    /// `give_up` is called once, on the watching thread, with the limit that was exceeded: "10 seconds".
    Watchdog(std::function<void(const std::string& limit)> give_up, PatienceLimits limits);
    ~Watchdog();
    Watchdog(const Watchdog&) = delete;
    Watchdog& operator=(const Watchdog&) = delete;

    /// Ends the previous check, and begins to time the next one.
    void next();

private:
    /// The time since a moment that counts for a limit: of the processor, or a tenth of the wall time if that is more.
    class Clock {
    public:
        double seconds() const;

    private:
        double cpu_ = now();
        std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
        static double now();
    };
    void watch();

    const std::function<void(const std::string&)> give_up_;
    const PatienceLimits limits_;
    std::mutex mutex_;
    std::condition_variable changed_;
    Clock check_, lab_;
    bool done_ = false;
    std::thread thread_;
};

}  // namespace relief::check
