#include "framework/library/mesh/buffer.h"

#include <new>

#include "framework/core/base/system.h"

namespace relief {
namespace {

constexpr size_t line = 64, page = size_t{2} << 20;

size_t alignment_of(size_t bytes) { return bytes >= 2 * page ? page : line; }

}  // namespace

void* allocate_working_memory(size_t bytes) {
    const size_t alignment = alignment_of(bytes);
    const size_t rounded = (bytes / alignment + 1) * alignment;
    if (rounded < bytes) throw std::bad_alloc();
    void* const memory = ::operator new (rounded, std::align_val_t{alignment});
    if (alignment == page) os::take_large_pages(memory, rounded);
    return memory;
}

void free_working_memory(void* memory, size_t bytes) {
    ::operator delete (memory, std::align_val_t{alignment_of(bytes)});
}

}  // namespace relief
