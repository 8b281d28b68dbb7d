// Points in time: due dates and times of submission. They never depend on the machine's clock or time zone.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

#include "framework/core/base/error.h"

namespace relief::grade {

using Moment = std::chrono::sys_seconds;
using UtcOffset = std::chrono::minutes;

/// Parses "+01:00", "-0530" or "Z". Returns nothing for any other text.
std::optional<UtcOffset> parse_offset(std::string_view text);

/// Parses ISO 8601 (RFC 3339): "2027-03-01T23:59:00+01:00". The T may be a blank, seconds may be missing, and a blank
/// may precede the offset. `offset` applies if the text has none. A date without a time is the last second of the day.
/// Throws Error at `place` for any other text, and if no offset is known.
Moment parse_moment(std::string_view text, std::optional<UtcOffset> offset, const Place& place);

/// Returns the time as "2027-03-01 23:59 +01:00".
std::string moment_text(Moment moment, UtcOffset offset);

}  // namespace relief::grade
