// A lab's functions in C++ are not part of the module: the page compiles task.cpp, places it in this module's memory,
// and answers the module's calls of these functions. What the compiled task needs of the module is here.
#include <emscripten.h>

#include <cstddef>
#include <cstdlib>

#include "framework/core/base/error.h"
#include "framework/core/base/unfinished.h"

namespace {

/// The compiled task's constants, variables and stack. The page links the task to this address.
constexpr size_t task_bytes = size_t{1} << 20;
alignas(64) char task_memory[task_bytes];

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE void* relief_task_memory() { return task_memory; }
EMSCRIPTEN_KEEPALIVE int relief_task_memory_bytes() { return int(task_bytes); }

// The module frees what the task returns, so both need the same heap.
EMSCRIPTEN_KEEPALIVE void* relief_allocate(size_t bytes, size_t alignment) {
    return alignment > alignof(std::max_align_t) ? ::aligned_alloc(alignment, bytes) : std::malloc(bytes);
}
EMSCRIPTEN_KEEPALIVE void* relief_reallocate(void* place, size_t bytes) { return std::realloc(place, bytes); }
EMSCRIPTEN_KEEPALIVE void relief_free(void* place) { std::free(place); }

// The exceptions of a task. They pass the page's JavaScript and reach the caller of the task in this module.
EMSCRIPTEN_KEEPALIVE void relief_unfinished(const char* task, const char* file, int line) {
    relief::unfinished(task, file, line);
}
EMSCRIPTEN_KEEPALIVE void relief_task_failed(const char* message, const char* file, int line) {
    throw relief::Error({file, line}, message);
}
}
