// Implements framework/core/base/process.h for a browser, which has no processes, with
// process_here.cpp.
#include "framework/core/base/process.h"

#include "framework/core/base/error.h"

namespace relief {

Pipe::Pipe() { throw Error("a browser has no pipes"); }
bool open_on_desktop(const std::filesystem::path&) { return false; }
bool start_on_desktop(const std::vector<std::string>&) { return false; }

}  // namespace relief
