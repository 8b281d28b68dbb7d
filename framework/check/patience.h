// Says which check is being waited for, and ends the program when one does not end: nothing inside a process can stop a
// student's loop.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace relief {

/// Seconds. A check is given up when both have passed: the processor may be someone else's for a while, and a machine
/// with many of them uses up processor time in no time. One that sleeps is given up after ten times `wall`.
struct PatienceLimits {
    double remind = 10;
    double wall = 60, cpu = 60;
};

/// From the first next() on a thread of its own watches. All other calls come from one thread.
class Patience {
public:
    /// `give_up` is called on the watching thread, once, with "'name' is not finished after 60 seconds".
    Patience(std::function<void(const std::string& why)> give_up, PatienceLimits limits = {});
    ~Patience();
    Patience(const Patience&) = delete;
    Patience& operator=(const Patience&) = delete;

    /// What begins now.
    void next(const std::string& name);

private:
    void watch();

    const std::function<void(const std::string&)> give_up_;
    const PatienceLimits limits_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::string name_;
    int count_ = 0;  ///< of what has begun
    bool done_ = false;
    std::thread thread_;
};

}  // namespace relief
