#include "framework/core/base/text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numeric>

#include "framework/core/base/system.h"

namespace relief {
namespace {

constexpr const char* decimal_digits = "0123456789";

/// Returns whether the whole text is a decimal number, such as -2, .5, 3. or 1e-3. A leading plus sign is none of it.
bool is_decimal(std::string_view text) {
    const auto takes = [&](std::string_view one_of) {
        const bool found = !text.empty() && one_of.find(text[0]) != std::string_view::npos;
        text.remove_prefix(found ? 1 : 0);
        return found;
    };
    const auto takes_digits = [&] {
        const size_t count = std::min(text.find_first_not_of(decimal_digits), text.size());
        text.remove_prefix(count);
        return count > 0;
    };
    takes("-");
    bool has_digits = takes_digits();
    if (takes(".")) has_digits |= takes_digits();
    if (has_digits && takes("eE")) {
        takes("+-");
        has_digits = takes_digits();
    }
    return has_digits && text.empty();
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
    if (!is_decimal(text)) return {};
    const double value = os::to_double(std::string(text).c_str());
    const bool is_zero =
        text.substr(0, text.find_first_of("eE")).find_first_of(decimal_digits + 1) == std::string_view::npos;
    if (!std::isfinite(value) || (value == 0 && !is_zero)) return {};
    return value;
}

std::optional<int> parse_int(std::string_view text) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return {};
    return value;
}

std::vector<std::string> split(std::string_view text, char separator) {
    std::vector<std::string> parts;
    for (size_t begin = 0;;) {
        const size_t end = text.find(separator, begin);
        parts.emplace_back(text.substr(begin, end - begin));
        if (end == std::string_view::npos) return parts;
        begin = end + 1;
    }
}

std::string join(std::span<const std::string> words, std::string_view separator) {
    return fmt::format("{}", fmt::join(words, separator));
}

std::string quoted_for_shell(std::string_view word) {
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

std::string without_backticks(std::string text) {
    std::erase(text, '`');
    return text;
}

std::string escaped_markup(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '"')
            result += "&quot;";
        else
            result += c;
    }
    return result;
}

std::string rounded(double number, int digits) {
    const std::string shortest = fmt::format("{:.{}g}", number, digits);
    const double size = std::abs(number);
    if (shortest.find('e') == std::string::npos || size < 1e-6 || size >= 1e12) return shortest;
    if (size >= 1) return fmt::format("{:.0f}", number);
    std::string text = fmt::format("{:.{}f}", number, digits - 1 - int(std::floor(std::log10(size))));
    text.erase(text.find_last_not_of('0') + 1);
    return text;
}

std::string capitalized(std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = char(text[0] - 'a' + 'A');
    return text;
}

std::string plain(double number) { return rounded(number, 6); }

std::vector<std::string> aligned_at_points(std::vector<std::string> cells, size_t width) {
    const auto units_end = [](const std::string& cell) { return std::min(cell.find_first_of(". /"), cell.size()); };
    size_t before = 0, after = 0;
    for (const std::string& cell : cells) {
        before = std::max(before, units_end(cell));
        after = std::max(after, cell.size() - units_end(cell));
    }
    for (std::string& cell : cells) {
        const size_t left = before - units_end(cell), right = after - (cell.size() - units_end(cell));
        cell = std::string(left, ' ') + cell + std::string(right, ' ');
        if (cell.size() < width) cell.insert(0, width - cell.size(), ' ');
    }
    return cells;
}

std::string plural(std::string_view unit) {
    if (unit.empty()) return "";
    const std::string_view counted = unit.substr(0, unit.find(' '));
    if (counted == "percent") return std::string(unit);
    return fmt::format("{}{}{}", counted, counted.ends_with("ch") ? "es" : "s", unit.substr(counted.size()));
}

std::string amount_of(double number, std::string_view unit, int digits) {
    const std::string text = rounded(number, digits);
    if (unit.empty()) return text;
    return text + " " + (text == "1" ? std::string(unit) : plural(unit));
}

int edit_distance(std::string_view a, std::string_view b) {
    const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
    std::vector<int> before(b.size() + 1), above(b.size() + 1), row(b.size() + 1);
    std::iota(above.begin(), above.end(), 0);
    for (size_t i = 1; i <= a.size(); ++i) {
        row[0] = static_cast<int>(i);
        for (size_t j = 1; j <= b.size(); ++j) {
            const bool same = lower(a[i - 1]) == lower(b[j - 1]);
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (same ? 0 : 1)});
            const bool swapped =
                i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
            if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
        }
        std::swap(before, above);
        std::swap(above, row);
    }
    return above[b.size()];
}

std::optional<std::string> nearest(std::string_view word, std::span<const std::string> known) {
    const std::string* best = nullptr;
    int best_distance = std::max<int>(1, static_cast<int>(word.size()) / 3) + 1;
    for (const std::string& candidate : known) {
        const bool begins = !word.empty() && candidate.starts_with(word);
        const int distance = begins ? 1 : edit_distance(word, candidate);
        if (distance < best_distance) {
            best = &candidate;
            best_distance = distance;
        }
    }
    if (!best) return {};
    return *best;
}

std::string unknown(std::string_view kind, std::string_view word, std::span<const std::string> known) {
    std::string line = fmt::format("unknown {} '{}'", kind, word);
    if (const auto guess = nearest(word, known)) line += fmt::format(": did you mean '{}'?", *guess);
    if (known.empty()) return line + fmt::format("; there is no {} here", kind);
    const bool has_commas = std::any_of(known.begin(), known.end(),
                                        [](const std::string& name) { return name.find(',') != std::string::npos; });
    line += line.back() == '?' ? " There are: " : "; there are: ";
    return line + (has_commas ? "'" + join(known, "', '") + "'" : join(known, ", "));
}

}  // namespace relief
