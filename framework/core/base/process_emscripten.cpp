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
bool open_on_desktop(const std::filesystem::path&) { return false; }
bool start_on_desktop(const std::vector<std::string>&) { return false; }

}  // namespace relief
