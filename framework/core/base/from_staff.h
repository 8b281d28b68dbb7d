// A slot for a function that only the staff's library has, such as a lab's exact values.
#pragma once

#include <string>
#include <utility>

namespace relief {

template <class Signature>
class FromStaff;

/// A slot for a function. A call returns an empty result if the slot is empty, as in a student's course.
template <class Result, class... Arguments>
class FromStaff<Result(Arguments...)> {
public:
    using Function = Result(Arguments...);
    explicit operator bool() const { return function_ != nullptr; }
    Result operator()(Arguments... arguments) const {
        return function_ ? function_(std::forward<Arguments>(arguments)...) : Result{};
    }

    /// Fills the slot when the program starts. The staff's files define static objects of this type.
    struct Provided {
        Provided(FromStaff& place, Function* function) { place.function_ = function; }
    };

private:
    Function* function_ = nullptr;
};

/// Returns whether this course has the staff's library.
inline FromStaff<bool()> staff_is_here;
/// Returns the lines that the staff's library adds to `relief info`.
inline FromStaff<std::string()> staff_info;

}  // namespace relief
