// Values that are made anew when their inputs change.
#pragma once

#include <optional>
#include <tuple>
#include <utility>

namespace relief {

/// A value and the inputs that it was made from, which are compared by ==.
template <class Value, class... Inputs>
class Kept {
public:
    /// What `make` returns, or has returned if it was made from the same inputs.
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
    /// How many values there have been.
    int version() const { return version_; }

private:
    std::optional<std::tuple<Inputs...>> inputs_;
    std::optional<Value> value_;
    int version_ = 0;
};

}  // namespace relief
