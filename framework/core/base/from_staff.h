// Slots for functions that only the staff's libraries have. The exact values (librelief-truth) are linked to every
// program of the staff's course. All other code of the staff (librelief-staff) is opened when a command needs it.
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

    /// Fills the slot when its library is loaded. The staff's files define static objects of this type.
    struct Provided {
        Provided(FromStaff& place, Function* function) { place.function_ = function; }
    };

private:
    Function* function_ = nullptr;
};

/// Returns whether this course has the staff's half, and so the exact values.
inline FromStaff<bool()> staff_is_here;
/// Returns the lines that the staff's library adds to `relief info`.
inline FromStaff<std::string()> staff_info;

/// Opens the staff's library if it is beside the framework's. It fills its slots and registers its commands. Returns
/// whether it is open. Throws Error if it cannot be opened.
bool open_staff_library();

}  // namespace relief
