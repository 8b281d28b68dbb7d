// Implements ChildProcess of framework/core/base/process.h for systems that cannot copy a process.
#include "framework/core/base/process.h"

namespace relief {

bool can_copy_process() { return false; }

// Runs the function here and now.
ChildProcess::ChildProcess(const std::function<void()>& work) : process_(0) {
    try {
        work();
    } catch (...) {
        process_ = 1;
    }
}
ChildProcess::~ChildProcess() = default;
ChildEnd ChildProcess::wait() { return {.code = process_, .crash = {}}; }

void become_program(const std::vector<std::string>&) {}

}  // namespace relief
