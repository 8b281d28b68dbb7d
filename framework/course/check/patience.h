// Reports which check is running, and calls back when one does not end. The callback ends the program: nothing inside a
// process can stop an endless loop in a student's code.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace relief::check {

/// Limits in seconds. A check is given up when it has used both `wall` and `cpu`: wall time passes while other programs
/// use the processor, and many threads use up processor time quickly. A sleeping check is given up after ten times
/// `wall`.
struct PatienceLimits {
    double remind = 10;
    double wall = 60, cpu = 60;
};

/// Watches the running check on a separate thread, which the first next() starts. Not thread-safe: all calls must come
/// from one thread.
class Patience {
public:
    /// `give_up` is called once, on the watching thread, with "'name' is not finished after 60 seconds".
    Patience(std::function<void(const std::string& why)> give_up, PatienceLimits limits = {});
    ~Patience();
    Patience(const Patience&) = delete;
    Patience& operator=(const Patience&) = delete;

    /// Ends the previous check, and begins to time the check `name`.
    void next(const std::string& name);

private:
    void watch();

    const std::function<void(const std::string&)> give_up_;
    const PatienceLimits limits_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::string name_;
    int count_ = 0;  ///< number of checks that have begun
    bool done_ = false;
    std::thread thread_;
};

}  // namespace relief::check
