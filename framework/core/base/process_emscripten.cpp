// Implements framework/core/base/process.h for a browser, which has no processes.
#include "framework/core/base/process.h"

#include "framework/core/base/error.h"

namespace relief {

const char* name_of(Ending) { return "failed"; }
void ProcessResult::exit_with(int shell_code) { code = shell_code; }
ProcessResult run_process(const ProcessJob&) {
    return {.ending = Ending::failed, .errors = "a browser has no processes"};
}
Pipe::Pipe() { throw Error("a browser has no pipes"); }
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
bool open_on_desktop(const std::filesystem::path&) { return false; }
bool start_on_desktop(const std::vector<std::string>&) { return false; }

}  // namespace relief
