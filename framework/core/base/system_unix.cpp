// Implements what Linux and macOS have in common of framework/core/base/system.h, beyond system_posix.cpp.
#include "framework/core/base/system.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/utsname.h>
#include <time.h>
#include <unistd.h>

#include <csignal>

namespace relief::os {
namespace {

namespace fs = std::filesystem;

void (*clean_up_before_the_end)() = nullptr;

void end_cleanly(int signal) {
    clean_up_before_the_end();
    _exit(128 + signal);
}

}  // namespace

void* open_library(const char* name, std::string& reason) {
    void* const library = dlopen(name, RTLD_NOW | RTLD_LOCAL);
    if (!library) reason = dlerror();
    return library;
}

void* function(void* library, const char* name) { return dlsym(library, name); }

fs::path library_of(const void* address) {
    Dl_info library{};
    dladdr(address, &library);
    return library.dli_fname;
}

Descriptor open_to_read(const fs::path& path) {
    return Descriptor(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
}

bool flush_folder_to_disk(const fs::path& path) {
    const Descriptor folder(open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    return folder >= 0 && flush_to_disk(folder);
}

bool is_terminal(int descriptor) { return isatty(descriptor) != 0; }

int terminal_columns(int descriptor) {
    winsize size{};
    return ioctl(descriptor, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

void clean_up_when_interrupted(void (*clean_up)()) {
    clean_up_before_the_end = clean_up;
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        if (std::signal(signal, end_cleanly) == SIG_IGN) std::signal(signal, SIG_IGN);  // as under nohup
    std::signal(SIGPIPE, SIG_IGN);
}

double processor_seconds() {
    timespec spent{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &spent);
    return double(spent.tv_sec) + double(spent.tv_nsec) * 1e-9;
}

std::shared_ptr<void> shared_memory(size_t bytes) {
    void* const memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) return nullptr;
    return {memory, [bytes](void* at) { munmap(at, bytes); }};
}

std::string name() {
    utsname system{};
    uname(&system);
    return std::string(system.sysname) + ' ' + system.release + ' ' + system.machine;
}

}  // namespace relief::os
