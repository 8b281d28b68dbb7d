// Points in time: due dates, and when something was handed in. The machine's clock and time zone decide nothing.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

#include "framework/base/error.h"

namespace relief {

using Moment = std::chrono::sys_seconds;
using UtcOffset = std::chrono::minutes;

/// "+01:00", "-0530" or "Z"; nothing for any other text.
std::optional<UtcOffset> parse_offset(std::string_view text);

/// ISO 8601 (RFC 3339): "2027-03-01T23:59:00+01:00"; the T may be a blank, seconds may be missing, and a blank may
/// stand before the offset. `offset` counts where the text names none. A date without a time is the last second of the
/// day. Throws Error at `place` for any other text, and if no offset is known.
Moment parse_moment(std::string_view text, std::optional<UtcOffset> offset, const Place& place);

/// "2027-03-01 23:59 +01:00"
std::string moment_text(Moment moment, UtcOffset offset);

}  // namespace relief
