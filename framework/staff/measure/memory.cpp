#include "framework/staff/measure/memory.h"

#include <malloc.h>

#include <fstream>
#include <string>

#include "framework/core/base/error.h"

namespace relief::measure {
namespace {

/// Returns a size in /proc/self/status, in bytes.
size_t own_status(const std::string& key) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with(key + ":")) return size_t{1024} * std::stoul(line.substr(key.size() + 1));
    throw Error("/proc/self/status has no " + key);
}

}  // namespace

size_t peak_growth(const std::function<void()>& run) {
    malloc_trim(0);
    const size_t before = own_status("VmRSS");
    if (!(std::ofstream("/proc/self/clear_refs") << "5" << std::flush))  // 5: forget the peak (proc(5))
        throw Error("/proc/self/clear_refs cannot be written");
    run();
    const size_t peak = own_status("VmHWM");
    return peak > before ? peak - before : 0;
}

}  // namespace relief::measure
