// The command line of `relief` and of each lab's own executable.
#pragma once

namespace relief::app {

/// Runs one command and returns the exit code: 0 done, 1 a check or a file failed, 2 wrong use. Prints each error as
/// one line on standard error. Does not throw.
int run_command_line(int argc, char** argv);

}  // namespace relief::app
