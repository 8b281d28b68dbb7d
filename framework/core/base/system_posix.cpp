// Implements framework/core/base/descriptor.h, and of system.h what is the same on all systems with POSIX's files.
#include "framework/core/base/system.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>

namespace relief {

bool Descriptor::close() { return number_ < 0 || ::close(release()) == 0; }

bool write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        bytes.remove_prefix(size_t(written));
    }
    return true;
}

std::optional<size_t> read_up_to(int descriptor, void* bytes, size_t size) {
    size_t have = 0;
    while (have < size) {
        const ssize_t got = read(descriptor, static_cast<char*>(bytes) + have, size - have);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return {};
        if (got == 0) break;
        have += size_t(got);
    }
    return have;
}

}  // namespace relief

namespace relief::os {

namespace fs = std::filesystem;

std::vector<std::string> utf8_arguments(int argc, char** argv) { return {argv, argv + argc}; }

void prepare_standard_streams() {}
void keep_terminal_open() {}

Descriptor open_to_write(const fs::path& path) { return Descriptor(open(path.c_str(), O_WRONLY | O_CLOEXEC)); }

Descriptor create_file(const fs::path& path, bool is_private) {
    return Descriptor(open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, is_private ? 0600 : 0666));
}

Descriptor open_nowhere() { return open_to_write("/dev/null"); }

std::optional<FileState> state_of(int descriptor) {
    struct stat status {};
    if (fstat(descriptor, &status) != 0) return {};
    return FileState{.is_plain = S_ISREG(status.st_mode), .size = uint64_t(status.st_size)};
}

Descriptor copy_of(int descriptor) { return Descriptor(dup(descriptor)); }

void redirect(int descriptor, int to) { dup2(to, descriptor); }

void remove_file(const char* name) { unlink(name); }

void set_environment(const char* name, const std::string& value) { setenv(name, value.c_str(), 1); }

}  // namespace relief::os
