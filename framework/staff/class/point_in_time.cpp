#include "framework/staff/class/point_in_time.h"

#include <fmt/format.h>

#include <algorithm>

#include "framework/core/base/text.h"
#include "framework/staff/grade/strangers_text.h"

namespace relief::grade {
namespace {

using namespace std::chrono;

/// Returns whether `text` has the form: a d stands for a digit, any other character for itself.
bool has_form(std::string_view text, std::string_view form) {
    return text.size() == form.size() && std::equal(text.begin(), text.end(), form.begin(), [](char one, char wanted) {
               return wanted == 'd' ? one >= '0' && one <= '9' : one == wanted;
           });
}

int number(std::string_view text, size_t at, size_t digits) { return *parse_int(text.substr(at, digits)); }

/// Parses and removes "23:59" or "23:59:00", with or without a fraction, at the front of a text.
std::optional<seconds> take_time(std::string_view& text) {
    if (!has_form(text.substr(0, 5), "dd:dd")) return {};
    const int hour = number(text, 0, 2), minute = number(text, 3, 2);
    int second = 0;
    text.remove_prefix(5);
    if (has_form(text.substr(0, 3), ":dd")) {
        second = number(text, 1, 2);
        text.remove_prefix(3);
        if (has_form(text.substr(0, 2), ".d")) {
            text.remove_prefix(1);
            text.remove_prefix(std::min(text.find_first_not_of("0123456789"), text.size()));
        }
    }
    if (hour > 23 || minute > 59 || second > 59) return {};
    return hours(hour) + minutes(minute) + seconds(second);
}

std::optional<sys_days> day_of(std::string_view text) {
    if (!has_form(text, "dddd-dd-dd")) return {};
    const year_month_day date{year(number(text, 0, 4)), month(unsigned(number(text, 5, 2))),
                              day(unsigned(number(text, 8, 2)))};
    if (!date.ok()) return {};
    return sys_days(date);
}

}  // namespace

std::optional<UtcOffset> parse_offset(std::string_view text) {
    if (text == "Z" || text == "z") return UtcOffset(0);
    const bool negative = text.starts_with('-');
    if (!negative && !text.starts_with('+')) return {};
    text.remove_prefix(1);
    const bool has_colon = has_form(text, "dd:dd");
    if (!has_colon && !has_form(text, "dddd")) return {};
    const int hour = number(text, 0, 2), minute = number(text, has_colon ? 3 : 2, 2);
    if (hour > 14 || minute > 59) return {};
    const UtcOffset offset = hours(hour) + minutes(minute);
    return negative ? -offset : offset;
}

Moment parse_moment(std::string_view text, std::optional<UtcOffset> offset, const Place& place) {
    const auto wrong = [&] {
        return Error(place, fmt::format("'{}' is no time: write it as 2027-03-01T23:59:00+01:00", printable(text)));
    };
    const auto date = day_of(text.substr(0, 10));
    if (!date) throw wrong();
    std::string_view rest = text.substr(10);
    seconds time = days(1) - seconds(1);
    if (!rest.empty()) {
        if (rest[0] != 'T' && rest[0] != 't' && rest[0] != ' ') throw wrong();
        rest.remove_prefix(1);
        const auto taken = take_time(rest);
        if (!taken) throw wrong();
        time = *taken;
        if (rest.starts_with(' ')) rest.remove_prefix(1);
        if (!rest.empty()) {
            offset = parse_offset(rest);
            if (!offset) throw wrong();
        }
    }
    if (!offset)
        throw Error(place,
                    fmt::format("'{}' has no offset: write it as in 2027-03-01T23:59:00+01:00, or give the class "
                                "file utc_offset = \"+01:00\"",
                                printable(text)));
    return *date + time - *offset;
}

std::string moment_text(Moment moment, UtcOffset offset) {
    const Moment local = moment + offset;
    const sys_days date = floor<days>(local);
    const year_month_day parts(date);
    const auto minute_of_day = int(duration_cast<minutes>(local - date).count()), away = int(abs(offset).count());
    return fmt::format("{:04}-{:02}-{:02} {:02}:{:02} {}{:02}:{:02}", int(parts.year()), unsigned(parts.month()),
                       unsigned(parts.day()), minute_of_day / 60, minute_of_day % 60, offset < UtcOffset(0) ? '-' : '+',
                       away / 60, away % 60);
}

}  // namespace relief::grade
