#include "framework/base/memory.h"

#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>

namespace relief {

void take_large_pages() {
#if defined __GLIBC__ && !defined __SANITIZE_ADDRESS__
    constexpr uintptr_t size = 64 << 20, large = 2 << 20;
    mallopt(M_MMAP_THRESHOLD, 32 << 20);  // the most that it takes
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
    mallopt(M_TOP_PAD, size);
    void* volatile piece = std::malloc(1 << 20);  // more than there is: the heap grows
    std::free(piece);
    mallopt(M_TOP_PAD, 1 << 20);
    const uintptr_t end = reinterpret_cast<uintptr_t>(sbrk(0)), begin = (end - size + large - 1) / large * large;
    madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);  // where there are none, all is as it was
#endif
}

}  // namespace relief
