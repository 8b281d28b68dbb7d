// Linked with each task.cpp that a page compiles: its heap, its end by an error, and its time. See compiled_task.js.
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

#define FROM_PAGE(name) __attribute__((import_module("page"), import_name(name)))

extern "C" {
FROM_PAGE("allocate") void* page_allocate(size_t bytes, size_t alignment);
FROM_PAGE("reallocate") void* page_reallocate(void* place, size_t bytes);
FROM_PAGE("free") void page_free(void* place);
FROM_PAGE("stop") [[noreturn]] void page_stop(const char* why);
FROM_PAGE("unfinished") [[noreturn]] void page_unfinished(const char* task, const char* file, int line);
/// Stops the task if it runs for too long.
FROM_PAGE("tick") void page_tick();

extern char __stack_low;  // the linker defines it; the stack grows down

// All functions of the C library's heap: if one is missing, the linker takes the library's own heap.
void* malloc(size_t bytes) { return page_allocate(bytes, 1); }
void free(void* place) { page_free(place); }
void* calloc(size_t count, size_t size) {
    size_t bytes = 0;
    void* const place = __builtin_mul_overflow(count, size, &bytes) ? nullptr : page_allocate(bytes, 1);
    return place ? std::memset(place, 0, bytes) : place;
}
void* realloc(void* place, size_t bytes) { return page_reallocate(place, bytes); }
void* aligned_alloc(size_t alignment, size_t bytes) { return page_allocate(bytes, alignment); }
int posix_memalign(void** place, size_t alignment, size_t bytes) {
    *place = page_allocate(bytes, alignment);
    return *place ? 0 : ENOMEM;
}
void abort() { page_stop("abort() was called"); }

// The compiler inserts a call of this function at each edge between blocks of the task, so in each loop and function.
void __sanitizer_cov_trace_pc() {
    static unsigned steps = 0;
    constexpr unsigned steps_between_ticks = 1u << 18, margin = 4096;
    if (static_cast<char*>(__builtin_frame_address(0)) < &__stack_low + margin)
        page_stop("the stack is full: a function calls itself without an end");
    if (++steps % steps_between_ticks == 0) page_tick();
}
}

namespace std {
inline namespace _LIBCPP_ABI_NAMESPACE {
// Failed assertions of the library, such as an index out of range, and what would be an exception.
[[noreturn]] void __libcpp_verbose_abort(const char* format, ...) noexcept {
    static char text[400];
    va_list values;
    va_start(values, format);
    vsnprintf(text, sizeof text, format, values);
    va_end(values);
    page_stop(text);
}
}  // namespace _LIBCPP_ABI_NAMESPACE
}  // namespace std

namespace relief {
void unfinished(const char* task, const char* file, int line) { page_unfinished(task, file, line); }
}  // namespace relief
