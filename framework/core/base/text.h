// Small helpers for text: strict parsing of numbers, escaping for XML, the nearest known word for a mistyped one.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace relief {

/// Parses the whole text as a finite decimal number, such as 2, -0.5 or 1e-3, in any locale. Returns nothing for "",
/// "1x", "nan" or "1e999", nor for "1e-999", which would round to 0.
std::optional<double> parse_number(std::string_view text);

/// Parses the whole text as a decimal integer. Returns nothing when it is none or does not fit.
std::optional<int> parse_int(std::string_view text);

std::vector<std::string> split(std::string_view text, char separator);
std::string join(std::span<const std::string> words, std::string_view separator);

/// Returns a text that marks code by backticks, such as a hint, for a terminal.
std::string without_backticks(std::string text);

/// Escapes a text for XML or HTML, between tags or in an attribute with double quotes.
std::string escaped_markup(std::string_view text);

/// Quotes a word for a shell's command line, in single quotes.
std::string quoted_for_shell(std::string_view word);

/// Returns the text with a capital letter at its start, if it begins with a letter of ASCII.
std::string capitalized(std::string text);

/// Formats a number for people, to `digits` digits: "0.00012", "1235". Digits before the point are never rounded away.
/// There is no exponent from 1e-6 to 1e12.
std::string rounded(double number, int digits = 3);

/// Formats a number as a person would type it, to six digits: "0.5", "32".
std::string plain(double number);

/// Pads the cells of a column to one width of at least `width`, so that the units of their first numbers, and with them
/// the decimal points, stand below each other: "4.25", "11 + 2", "2.5/5", "-". Empty cells stay blank.
std::vector<std::string> aligned_at_points(std::vector<std::string> cells, size_t width = 0);

/// Returns the plural of a unit: "degrees", "patches", "heights per tile", "".
std::string plural(std::string_view unit);

/// Formats a number with its unit: "2.5 degrees", "1 texel", "0.1 heights per tile". Without a unit, returns the number
/// alone.
std::string amount_of(double number, std::string_view unit, int digits = 3);

/// Returns the minimum number of insertions, deletions, substitutions and swaps of neighbours that turn one word into
/// the other (optimal string alignment distance), ignoring case.
int edit_distance(std::string_view a, std::string_view b);

/// Returns the known word nearest to a mistyped one, or nothing if none is near.
std::optional<std::string> nearest(std::string_view word, std::span<const std::string> known);

/// Returns "unknown knob 'stpes': did you mean 'steps'? There are: steps, scale".
std::string unknown(std::string_view kind, std::string_view word, std::span<const std::string> known);

}  // namespace relief
