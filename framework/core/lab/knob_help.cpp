#include "framework/core/lab/knob_help.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "framework/core/base/text.h"

namespace relief {
namespace {

constexpr std::array units = {"degrees", "metres", "texels", "pixels", "turns", "taps", "radii", "tiles", "seconds"};

std::string trimmed(const std::string& text) {
    const size_t begin = text.find_first_not_of(' '), end = text.find_last_not_of(' ');
    return begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
}

/// Splits "map, rays and one" into its three words.
std::vector<std::string> values_of(std::string list) {
    for (size_t at = list.find(" and "); at != std::string::npos; at = list.find(" and ")) list.replace(at, 5, ",");
    std::vector<std::string> values = split(list, ',');
    for (std::string& value : values) value = trimmed(value);
    return values;
}

}  // namespace

KnobHelp read_help(const std::string& help) {
    KnobHelp read;
    read.sentence = help;
    if (!help.empty()) {
        read.sentence[0] = char(std::toupper(static_cast<unsigned char>(help[0])));
        if (std::string_view(".!?").find(help.back()) == std::string_view::npos) read.sentence += '.';
    }
    std::string last = trimmed(help.substr(help.rfind(',') + 1));
    if (last.starts_with("in ")) last = last.substr(3);
    if (help.find(',') != std::string::npos && std::find(units.begin(), units.end(), last) != units.end())
        read.unit = last;
    const size_t equals = help.find(" = "), colon = help.find(": ");
    if (help.starts_with("for ") && equals != std::string::npos && colon != std::string::npos && equals < colon) {
        read.knob = help.substr(4, equals - 4);
        read.values = values_of(help.substr(equals + 3, colon - equals - 3));
    }
    return read;
}

bool is_ignored(const std::string& name, std::span<const KnobText> knobs) {
    const auto find = [&](const std::string& wanted) {
        return std::find_if(knobs.begin(), knobs.end(), [&](const KnobText& knob) { return knob.name == wanted; });
    };
    const auto self = find(name);
    if (self == knobs.end()) return false;
    const KnobHelp help = read_help(self->help);
    const auto other = find(help.knob);
    if (help.knob.empty() || other == knobs.end()) return false;
    const std::vector<std::string> choices = values_of(other->range);
    for (const std::string& value : help.values)
        if (value == other->value || std::find(choices.begin(), choices.end(), value) == choices.end()) return false;
    return true;
}

std::string unit_after_number(const std::string& unit) {
    if (unit == "degrees") return "\u00b0";
    if (unit == "metres") return " m";
    if (unit == "pixels") return " px";
    return unit.empty() ? "" : " " + unit;
}

}  // namespace relief
