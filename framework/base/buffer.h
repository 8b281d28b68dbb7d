// Memory for intermediate results.
#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>

namespace relief {

/// `count` uninitialised values: a vector would write zeros first, which takes as long as computing the result.
template <class Value>
class Buffer {
    static_assert(std::is_trivially_copyable_v<Value>);

public:
    explicit Buffer(size_t count) : values_(std::make_unique_for_overwrite<Value[]>(count)), count_(count) {}

    size_t size() const { return count_; }
    Value& operator[](size_t i) { return values_[i]; }
    const Value& operator[](size_t i) const { return values_[i]; }
    Value* begin() { return values_.get(); }
    Value* end() { return values_.get() + count_; }

private:
    std::unique_ptr<Value[]> values_;
    size_t count_;
};

}  // namespace relief
