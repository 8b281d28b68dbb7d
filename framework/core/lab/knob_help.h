// What a knob does: its title, its line of help, its unit, and the values of another knob for which it has an effect.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace relief {

/// For example KnobHelp("depth of a layer").in("metres").only("method", {"steep"}).
struct KnobHelp {
    std::string text;  ///< begins in lower case and has no full stop
    std::string unit;  ///< "metres"; empty if the value has none, or if the text says it
    /// The knob has no effect while the knob `knob` has none of `values`. Empty: it always has an effect.
    std::string knob;
    std::vector<std::string> values;
    std::string title;  ///< see title_of(); empty if the name says enough

    KnobHelp(const char* words) : text(words) {}  // a literal is a help

    KnobHelp&& in(const char* name_of_unit) &&;
    KnobHelp&& only(const char* other_knob, std::vector<std::string> its_values) &&;

    /// Sets the knob's title on screen, where its name in words is a poor one: "Bits per height" for `bits`.
    KnobHelp&& titled(const char* words) &&;

    /// Returns the title of a knob of this name. Default: the name in words, "Light yaw" for `light_yaw`.
    std::string title_of(std::string_view name) const;
    /// Returns "method = steep", or "" if the knob always has an effect.
    std::string condition() const;
    /// Returns "for method = steep: depth of a layer, metres".
    std::string line() const;
    /// Returns the line as a sentence: "For method = steep: depth of a layer, metres."
    std::string sentence() const;
    /// Returns the unit as it follows a number: "°", " m", " texels"; "" for no unit.
    std::string unit_after_number() const;
};

}  // namespace relief
