#include "framework/staff/app/tool.h"

#include <cstdlib>

namespace relief::app {

ProcessResult run_tool(const std::vector<std::string>& command, const std::filesystem::path& folder, double seconds) {
    std::vector<std::string> words = {"/bin/sh", "-c", "cd \"$1\" && shift && exec \"$@\"", "sh", folder.string()};
    words.insert(words.end(), command.begin(), command.end());
    std::map<std::string, std::string> environment;
    for (const char* name : {"PATH", "HOME", "LANG", "TMPDIR", "CHROME_PATH", "LP_NUM_THREADS"})
        if (const char* value = std::getenv(name)) environment[name] = value;
    // The decks are trusted, and a browser started by root does not run in its sandbox.
    environment["CHROME_NO_SANDBOX"] = "1";
    return run_process(
        {.command = words,
         .environment = environment,
         .limits = {.wall = seconds, .cpu = 4 * seconds, .memory = ~size_t{0}, .file = size_t{1} << 32}});
}

}  // namespace relief::app
