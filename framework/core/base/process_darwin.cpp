// Implements framework/core/base/process.h for macOS, with process_here.cpp. A copy of this process could not draw:
// Apple's libraries end a copy that calls them.
#include "framework/core/base/process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "framework/core/base/error.h"

extern "C" char** environ;

namespace relief {

Pipe::Pipe() {
    int ends[2];
    if (pipe(ends) != 0) throw Error(fmt::format("no pipe: {}", std::strerror(errno)));
    read = Descriptor(ends[0]), write = Descriptor(ends[1]);
    for (const int end : ends) fcntl(end, F_SETFD, FD_CLOEXEC);
}

bool open_on_desktop(const std::filesystem::path& file) {
    return start_on_desktop({"open", std::filesystem::absolute(file).string()});
}

bool start_on_desktop(const std::vector<std::string>& command) {
    if (command.empty()) return false;
    std::vector<char*> words;
    for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    // Silent, in a session of its own, with no other open file.
    posix_spawn_file_actions_t files{};
    posix_spawn_file_actions_init(&files);
    for (const int stream : {0, 1, 2}) posix_spawn_file_actions_addopen(&files, stream, "/dev/null", O_RDWR, 0);
    posix_spawnattr_t how{};
    posix_spawnattr_init(&how);
    posix_spawnattr_setflags(&how, POSIX_SPAWN_SETSID | POSIX_SPAWN_CLOEXEC_DEFAULT);
    pid_t process = 0;
    const bool has_started = posix_spawnp(&process, words[0], &files, &how, words.data(), environ) == 0;
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&how);
    return has_started;
}

}  // namespace relief
