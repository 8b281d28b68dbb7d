// Implements framework/core/base/system.h for Linux, with system_posix.cpp.
#include "framework/core/base/system.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <locale.h>
#include <malloc.h>
#include <sys/auxv.h>
#include <sys/mman.h>
#include <sys/utsname.h>
#include <time.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>

namespace relief::os {
namespace {

namespace fs = std::filesystem;

void (*clean_up_before_the_end)() = nullptr;

void end_cleanly(int signal) {
    clean_up_before_the_end();
    _exit(128 + signal);
}

locale_t c_locale() {
    static const locale_t locale = newlocale(LC_ALL_MASK, "C", locale_t{});
    return locale;
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

fs::path executable() {
    std::error_code no_proc;  // some sandboxes have no /proc; use the path from the start of the program
    const fs::path link = fs::read_symlink("/proc/self/exe", no_proc);
    return no_proc ? fs::weakly_canonical(reinterpret_cast<const char*>(getauxval(AT_EXECFN))) : link;
}

Descriptor open_to_read(const fs::path& path) {
    return Descriptor(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
}

bool flush_to_disk(int descriptor) { return fsync(descriptor) == 0; }

bool flush_folder_to_disk(const fs::path& path) {
    const Descriptor folder(open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    return folder >= 0 && flush_to_disk(folder);
}

bool is_terminal(int descriptor) { return isatty(descriptor) != 0; }

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

double to_double(const char* text) { return strtod_l(text, nullptr, c_locale()); }
float to_float(const char* text) { return strtof_l(text, nullptr, c_locale()); }

MappedFile map_file(const fs::path& path) {
    const Descriptor file = open_to_read(path);
    const FileState state = state_of(file).value_or(FileState{});
    if (!state.is_plain || state.size == 0) return {};
    const size_t size = size_t(state.size);
    void* const mapped = mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_POPULATE, file, 0);
    if (mapped == MAP_FAILED) return {};
    return {std::shared_ptr<const void>(mapped, [size](const void* at) { munmap(const_cast<void*>(at), size); }),
            {static_cast<const char*>(mapped), size}};
}

void take_large_pages(void* memory, size_t bytes) { madvise(memory, bytes, MADV_HUGEPAGE); }

void take_large_pages() {
#if defined __GLIBC__ && !defined __SANITIZE_ADDRESS__
    constexpr uintptr_t size = 64 << 20, large = 2 << 20;
    mallopt(M_MMAP_THRESHOLD, 32 << 20);  // the maximum that mallopt accepts
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
    mallopt(M_TOP_PAD, size);
    void* volatile piece = std::malloc(1 << 20);  // larger than the free memory, so that the heap grows
    std::free(piece);
    mallopt(M_TOP_PAD, 1 << 20);
    const uintptr_t end = reinterpret_cast<uintptr_t>(sbrk(0)), begin = (end - size + large - 1) / large * large;
    take_large_pages(reinterpret_cast<void*>(begin), end - begin);
#endif
}

std::shared_ptr<void> shared_memory(size_t bytes) {
    void* const memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) return nullptr;
    return {memory, [bytes](void* at) { munmap(at, bytes); }};
}

bool has_display() {
    const auto is_set = [](const char* name) {
        const char* const value = std::getenv(name);
        return value && *value;
    };
    return is_set("DISPLAY") || is_set("WAYLAND_DISPLAY");
}

std::string name() {
    utsname system{};
    uname(&system);
    return std::string(system.sysname) + ' ' + system.release + ' ' + system.machine;
}

}  // namespace relief::os
