// A place for a function that only the staff's library has, such as a lab's exact values.
#pragma once

#include <utility>

namespace relief {

template <class Signature>
class FromStaff;

/// Called where nobody has filled it, as in a student's course, it gives an empty result.
template <class Result, class... Arguments>
class FromStaff<Result(Arguments...)> {
public:
    using Function = Result(Arguments...);
    explicit operator bool() const { return function_ != nullptr; }
    Result operator()(Arguments... arguments) const {
        return function_ ? function_(std::forward<Arguments>(arguments)...) : Result{};
    }

    /// A static object of it, in the staff's files, fills the place when the program starts.
    struct Provided {
        Provided(FromStaff& place, Function* function) { place.function_ = function; }
    };

private:
    Function* function_ = nullptr;
};

}  // namespace relief
