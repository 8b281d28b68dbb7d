// What a knob's line of help says beside its sentence: the unit, and for which value of another knob it counts.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "framework/lab/knobs.h"

namespace relief {

/// A help is a line such as "for method = steep: depth of a layer, metres". Its parts:
struct KnobHelp {
    std::string sentence;  ///< all of it, for people: "For method = steep: depth of a layer, metres."
    std::string unit;      ///< "metres": its last word after a comma, if that is a unit; else empty
    /// "method" and {"steep"}: the knob changes nothing while that one has another value. Empty where the help does not
    /// begin with `for KNOB = VALUE, VALUE and VALUE:`.
    std::string knob;
    std::vector<std::string> values;
};
KnobHelp read_help(const std::string& help);

/// Whether, by their help, the knob `name` changes nothing as the knobs are now. A help that names a knob or a value
/// that is not there says nothing.
bool is_ignored(const std::string& name, std::span<const KnobText> knobs);

/// As a number is followed by it: "°", " m", " texels"; "" where there is none.
std::string unit_after_number(const std::string& unit);

}  // namespace relief
