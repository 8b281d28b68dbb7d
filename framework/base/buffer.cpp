#include "framework/base/buffer.h"

#include <new>

#ifdef __linux__
    #include <sys/mman.h>
#endif

namespace relief {

void* allocate_working_memory(size_t bytes) {
    constexpr size_t line = 64, page = size_t{2} << 20;
    const size_t alignment = bytes >= 2 * page ? page : line;
    const size_t rounded = (bytes / alignment + 1) * alignment;
    if (rounded < bytes) throw std::bad_alloc();
    void* const memory = std::aligned_alloc(alignment, rounded);
    if (!memory) throw std::bad_alloc();
#ifdef __linux__
    if (alignment == page) madvise(memory, rounded, MADV_HUGEPAGE);  // who cannot have them has small ones
#endif
    return memory;
}

}  // namespace relief
