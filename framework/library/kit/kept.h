// Values that are computed again when their inputs change.
#pragma once

#include <optional>
#include <tuple>
#include <utility>

namespace relief {

/// A cached value with the inputs that it was made from. Inputs are compared by ==.
template <class Value, class... Inputs>
class Kept {
public:
    /// Returns the result of `make`. Calls it only if `inputs` differ from the inputs of the previous call.
    template <class Make>
    Value& get(const std::tuple<Inputs...>& inputs, Make make) {
        if (inputs_ != inputs) {
            inputs_.reset();
            value_.emplace(make());
            inputs_ = inputs;
            ++version_;
        }
        return *value_;
    }
    /// Returns the number of values made so far.
    int version() const { return version_; }

private:
    std::optional<std::tuple<Inputs...>> inputs_;
    std::optional<Value> value_;
    int version_ = 0;
};

}  // namespace relief
