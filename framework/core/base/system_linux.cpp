// Implements framework/core/base/system.h for Linux, with system_posix.cpp and system_unix.cpp.
#include "framework/core/base/system.h"

#include <locale.h>
#include <malloc.h>
#include <sys/auxv.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>

namespace relief::os {
namespace {

namespace fs = std::filesystem;

locale_t c_locale() {
    static const locale_t locale = newlocale(LC_ALL_MASK, "C", locale_t{});
    return locale;
}

}  // namespace

fs::path executable() {
    std::error_code no_proc;  // some sandboxes have no /proc; use the path from the start of the program
    const fs::path link = fs::read_symlink("/proc/self/exe", no_proc);
    return no_proc ? fs::weakly_canonical(reinterpret_cast<const char*>(getauxval(AT_EXECFN))) : link;
}

bool flush_to_disk(int descriptor) { return fsync(descriptor) == 0; }

double to_double(const char* text) { return strtod_l(text, nullptr, c_locale()); }

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

bool has_display() {
    const auto is_set = [](const char* name) {
        const char* const value = std::getenv(name);
        return value && *value;
    };
    return is_set("DISPLAY") || is_set("WAYLAND_DISPLAY");
}

}  // namespace relief::os
