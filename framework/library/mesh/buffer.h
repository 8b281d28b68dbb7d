// Memory for intermediate results.
#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>

namespace relief {

/// Returns uninitialised memory, aligned to 64 bytes or more, to be freed by
/// free_working_memory(). From 4 MiB on it uses large
/// pages if the system has them: page faults and TLB misses on pages of 4 kB would cost a tenth of the processing time.
/// Throws std::bad_alloc.
void* allocate_working_memory(size_t bytes);
void free_working_memory(void* memory, size_t bytes);

/// An array of `count` uninitialised values. A vector would first write zeros, which takes as long as computing the
/// result.
template <class Value>
class Buffer {
    static_assert(std::is_trivially_copyable_v<Value>);

public:
    explicit Buffer(size_t count)
        : values_(static_cast<Value*>(allocate_working_memory(count * sizeof(Value))), Free{count}) {}

    size_t size() const { return values_.get_deleter().count; }
    Value& operator[](size_t i) { return values_[i]; }
    const Value& operator[](size_t i) const { return values_[i]; }
    Value* begin() { return values_.get(); }
    Value* end() { return values_.get() + size(); }

private:
    struct Free {
        size_t count;
        void operator()(Value* values) const { free_working_memory(values, count * sizeof(Value)); }
    };
    std::unique_ptr<Value[], Free> values_;
};

}  // namespace relief
