// Parses a knob's line of help: its unit, and the values of another knob for which it has an effect.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "framework/core/lab/knobs.h"

namespace relief {

/// A help is a line such as "for method = steep: depth of a layer, metres". Its parts:
struct KnobHelp {
    std::string sentence;  ///< the whole help as a sentence: "For method = steep: depth of a layer, metres."
    std::string unit;      ///< "metres": the words after the last comma, if they are a unit; else empty
    /// "method" and {"steep"}: the knob has no effect while that other knob has another value. Empty unless the help
    /// begins with `for KNOB = VALUE, VALUE and VALUE:`.
    std::string knob;
    std::vector<std::string> values;
};
KnobHelp read_help(const std::string& help);

/// Returns whether, by its help, the knob `name` has no effect at the current values of `knobs`. False when the help
/// names an unknown knob or value.
bool is_ignored(const std::string& name, std::span<const KnobText> knobs);

/// Returns a unit as it follows a number: "°", " m", " texels"; "" for no unit.
std::string unit_after_number(const std::string& unit);

}  // namespace relief
