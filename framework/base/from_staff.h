// A slot for a function that only the staff's library has, such as a lab's exact values.
#pragma once

#include <string>
#include <utility>

namespace relief {

template <class Signature>
class FromStaff;

/// If the slot is empty, as in a student's course, a call returns an empty result.
template <class Result, class... Arguments>
class FromStaff<Result(Arguments...)> {
public:
    using Function = Result(Arguments...);
    explicit operator bool() const { return function_ != nullptr; }
    Result operator()(Arguments... arguments) const {
        return function_ ? function_(std::forward<Arguments>(arguments)...) : Result{};
    }

    /// A static object of this type, in the staff's files, fills the slot when the program starts.
    struct Provided {
        Provided(FromStaff& place, Function* function) { place.function_ = function; }
    };

private:
    Function* function_ = nullptr;
};

/// Whether the staff's library is in this course.
inline FromStaff<bool()> staff_is_here;
/// What the staff's library adds to `relief info`: whole lines.
inline FromStaff<std::string()> staff_info;

}  // namespace relief
