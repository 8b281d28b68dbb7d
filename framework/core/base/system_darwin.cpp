// Implements framework/core/base/system.h for macOS, with system_posix.cpp and system_unix.cpp.
#include "framework/core/base/system.h"

#include <fcntl.h>
#include <mach-o/dyld.h>
#include <sys/mman.h>
#include <unistd.h>
#include <xlocale.h>

#include <cstdint>

namespace relief::os {

namespace fs = std::filesystem;

fs::path executable() {
    uint32_t size = 0;
    _NSGetExecutablePath(nullptr, &size);
    std::string path(size, '\0');
    _NSGetExecutablePath(path.data(), &size);
    return fs::weakly_canonical(path.c_str());
}

// fsync() alone leaves bytes in the drive's own memory. Some file systems have no other call.
bool flush_to_disk(int descriptor) { return fcntl(descriptor, F_FULLFSYNC) == 0 || fsync(descriptor) == 0; }

// No locale is the C locale.
double to_double(const char* text) { return strtod_l(text, nullptr, nullptr); }

MappedFile map_file(const fs::path& path) {
    const Descriptor file = open_to_read(path);
    const FileState state = state_of(file).value_or(FileState{});
    if (!state.is_plain || state.size == 0) return {};
    const size_t size = size_t(state.size);
    void* const mapped = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
    if (mapped == MAP_FAILED) return {};
    return {std::shared_ptr<const void>(mapped, [size](const void* at) { munmap(const_cast<void*>(at), size); }),
            {static_cast<const char*>(mapped), size}};
}

// Programs cannot choose the size of their pages.
void take_large_pages(void*, size_t) {}
void take_large_pages() {}

bool has_display() { return true; }

}  // namespace relief::os
