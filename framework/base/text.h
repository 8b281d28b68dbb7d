// Small helpers for text: strict parsing of numbers, escaping for XML, the nearest known word for a mistyped one.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace relief {

/// The whole text as a finite decimal number, such as 2, -0.5 or 1e-3, whatever the locale; nothing for "", "1x", "nan"
/// or "1e999".
std::optional<double> parse_number(std::string_view text);

/// The whole text as a decimal integer that fits.
std::optional<int> parse_int(std::string_view text);

std::vector<std::string> split(std::string_view text, char separator);
std::string join(std::span<const std::string> words, std::string_view separator);

/// A text as it may stand in XML or HTML, between tags or in an attribute with double quotes.
std::string escaped_markup(std::string_view text);

/// A word of a shell's command line, in single quotes.
std::string quoted_for_shell(std::string_view word);

/// A number for people, to so many digits: "0.00012", "1235". What stands before the point is never rounded away, and
/// there is no exponent from a millionth to a million millions.
std::string rounded(double number, int digits = 3);

/// The number as a person would type it, to six digits: "0.5", "32".
std::string plain(double number);

/// "degrees", "patches", "heights per tile", "".
std::string plural(std::string_view unit);

/// With a unit: "2.5 degrees", "1 texel", "0.1 heights per tile"; the number alone where there is none.
std::string amount_of(double number, std::string_view unit, int digits = 3);

/// Least number of insertions, deletions, substitutions and swaps of neighbours that turn one word into the
/// other (optimal string alignment distance), ignoring case.
int edit_distance(std::string_view a, std::string_view b);

/// The known word nearest to a mistyped one; nothing if none is near.
std::optional<std::string> nearest(std::string_view word, std::span<const std::string> known);

/// "unknown knob 'stpes': did you mean 'steps'? There are: steps, scale".
std::string unknown(std::string_view kind, std::string_view word, std::span<const std::string> known);

}  // namespace relief
