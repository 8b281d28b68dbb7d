#include "framework/core/base/buffer.h"

#include <new>

#include "framework/core/base/system.h"

namespace relief {

void* allocate_working_memory(size_t bytes) {
    constexpr size_t line = 64, page = size_t{2} << 20;
    const size_t alignment = bytes >= 2 * page ? page : line;
    const size_t rounded = (bytes / alignment + 1) * alignment;
    if (rounded < bytes) throw std::bad_alloc();
    void* const memory = std::aligned_alloc(alignment, rounded);
    if (!memory) throw std::bad_alloc();
    if (alignment == page) os::take_large_pages(memory, rounded);
    return memory;
}

}  // namespace relief
