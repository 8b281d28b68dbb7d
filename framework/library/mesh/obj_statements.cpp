// The text of OBJ and MTL files: lines, words and numbers.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <utility>

#include "framework/core/base/log.h"
#include "framework/core/base/text.h"
#include "framework/library/mesh/obj_parts.h"

namespace relief::obj {
namespace {

constexpr std::string_view blanks = " \t\v\f";

}  // namespace

void Notes::add(const Place& place, const std::string& message) { add(note_about(place, message)); }

void Notes::add(std::string line) {
    if (lines_.size() < 20) lines_.push_back(std::move(line));
}

std::string_view trimmed(std::string_view text) {
    const size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string_view take_name(std::string_view& rest) {
    rest = trimmed(rest);
    const std::string_view word = rest.substr(0, rest.find_first_of(blanks));
    rest.remove_prefix(word.size());
    return word;
}

std::string_view take_word(std::string_view& rest) {
    rest = trimmed(rest);
    return rest.starts_with('#') ? std::string_view() : take_name(rest);
}

std::optional<double> number_of(std::string_view word) {
    const std::optional<double> value = parse_number(word.substr(word.starts_with('+') ? 1 : 0));
    if (!value || word.starts_with("+-") || std::abs(*value) > double(std::numeric_limits<float>::max())) return {};
    return *value;
}

std::string excerpt(std::string_view word) {
    std::string text(word.substr(0, 40));
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == 127; }, '?');
    return text.size() < word.size() ? text + "..." : text;
}

std::filesystem::path path_in(const std::filesystem::path& folder, std::string name) {
    std::replace(name.begin(), name.end(), '\\', '/');
    if (name.empty()) return {};
    const bool has_drive = name.size() > 2 && name[1] == ':' && std::isalpha(static_cast<unsigned char>(name[0]));
    std::error_code ignored;
    if ((has_drive || name[0] == '/') && !std::filesystem::exists(name, ignored))
        name.erase(0, std::max(name.rfind('/') + 1, size_t(has_drive ? 2 : 0)));
    return (folder / name).lexically_normal();
}

void Statements::fail(const std::string& message) const { throw Error({file_, line_}, message); }

std::string_view Statements::next_line() {
    line_ = next_line_++;
    const size_t length = std::min(text_.find_first_of("\n\r"), text_.size());
    const std::string_view line = text_.substr(0, length);
    text_.remove_prefix(length);
    text_.remove_prefix(text_.starts_with("\r\n") ? 2 : text_.empty() ? 0 : 1);
    return line;
}

bool Statements::next() {
    if (line_ == 0 && text_.starts_with("\xef\xbb\xbf")) text_.remove_prefix(3);  // a byte order mark
    while (!text_.empty()) {
        rest_ = next_line();
        if (line_ == 1 && (rest_.starts_with("\xff\xfe") || rest_.starts_with("\xfe\xff")))
            fail("this is text in UTF-16: save it as UTF-8");
        if (rest_.find('\0') != std::string_view::npos) fail("this is not text: it has a byte 0");
        if (trimmed(rest_).starts_with('#')) continue;  // a backslash does not continue a comment
        if (rest_.ends_with('\\')) {
            const int first_line = line_;
            joined_.clear();
            while (rest_.ends_with('\\') && !text_.empty()) {
                joined_.append(rest_.substr(0, rest_.size() - 1)).append(" ");
                rest_ = next_line();
            }
            joined_.append(rest_.substr(0, rest_.size() - (rest_.ends_with('\\') ? 1 : 0)));
            rest_ = joined_;
            line_ = first_line;
            if (rest_.find('\0') != std::string_view::npos) fail("this is not text: it has a byte 0");
        }
        keyword_ = take_name(rest_);
        rest_ = trimmed(rest_);
        if (!keyword_.empty()) return true;
    }
    return false;
}

}  // namespace relief::obj
