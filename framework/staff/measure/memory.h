// The memory that a function takes at its peak.
#pragma once

#include <cstddef>
#include <functional>

namespace relief::measure {

/// Runs the function, and returns by how many bytes this process grew at most while it ran: resident pages, to about
/// 1 MiB. Gives free memory back to the system first, so what was freed before hides nothing. Throws Error where Linux
/// does not tell (/proc/self/clear_refs and VmHWM in /proc/self/status).
size_t peak_growth(const std::function<void()>& run);

}  // namespace relief::measure
