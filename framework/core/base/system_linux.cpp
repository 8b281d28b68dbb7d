// Implements framework/core/base/system.h for Linux.
#include <dlfcn.h>
#include <fcntl.h>
#include <malloc.h>
#include <sys/auxv.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>

#include "framework/core/base/descriptor.h"
#include "framework/core/base/system.h"

namespace relief::os {

namespace fs = std::filesystem;

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

MappedFile map_file(const fs::path& path) {
    const Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat status {};
    if (file < 0 || fstat(file, &status) != 0 || !S_ISREG(status.st_mode) || status.st_size == 0) return {};
    const size_t size = size_t(status.st_size);
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

std::string name() {
    utsname system{};
    uname(&system);
    return std::string(system.sysname) + ' ' + system.release + ' ' + system.machine;
}

}  // namespace relief::os
