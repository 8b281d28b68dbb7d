#include "framework/staff/grade/strangers_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "framework/core/base/module.h"

namespace relief::grade {
namespace {

struct Character {
    char32_t code = 0;
    size_t size = 0;  ///< in bytes; 0: invalid UTF-8
};

/// Returns the first character of a non-empty text. Overlong encodings and lone surrogates are invalid UTF-8.
Character first_of(std::string_view text) {
    const auto byte = [&](size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
    const unsigned first = byte(0);
    if (first < 0x80) return {first, 1};
    const size_t size = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    if (first < 0xc2 || first > 0xf4) return {};
    char32_t code = first & (0x7fu >> size);
    for (size_t i = 1; i < size; ++i) {
        if ((byte(i) & 0xc0) != 0x80) return {};
        code = code << 6 | (byte(i) & 0x3f);
    }
    const bool is_good = code >= (size == 4   ? 0x10000u
                                  : size == 3 ? 0x800u
                                              : 0x80u) &&
                         code <= 0x10ffff && (code < 0xd800 || code > 0xdfff);
    return is_good ? Character{code, size} : Character{};
}

bool is_control(char32_t code) { return code < 0x20 || (code >= 0x7f && code < 0xa0); }

/// Returns whether a character is invisible: direction marks and overrides, line separators, zero-width characters.
bool is_unseen(char32_t code) {
    const auto is_in = [&](char32_t low, char32_t high) { return code >= low && code <= high; };
    return code == 0xad || code == 0x61c || code == 0x180e || is_in(0x200b, 0x200f) || is_in(0x2028, 0x202e) ||
           is_in(0x2060, 0x206f) || code == 0xfeff || is_in(0xfff9, 0xfffb) || is_in(0xe0000, 0xe007f);
}

std::string shown(std::string_view text, size_t max_length, bool lines) {
    std::string result;
    for (size_t at = 0; at < text.size();) {
        const Character one = first_of(text.substr(at));
        const std::string_view bytes = text.substr(at, std::max<size_t>(one.size, 1));
        if (at + bytes.size() > max_length) return result + "...";
        at += bytes.size();
        if (lines && (bytes == "\n" || bytes == "\t"))
            result += bytes;
        else if (one.size == 0 || is_control(one.code))
            for (const char byte : bytes) result += fmt::format("\\x{:02x}", static_cast<unsigned char>(byte));
        else if (is_unseen(one.code))
            result += fmt::format("\\u{:04x}", uint32_t(one.code));
        else
            result += bytes;
    }
    return result;
}

bool is_ascii(const std::string& text) {
    return std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

const Module& unicode() {
    static const Module module = open_own_module("relief-unicode.so", "libglib2.0-dev");
    return module;
}

constexpr char32_t first_private = 0xf780, last_private = 0xf7ff;

}  // namespace

std::string printable(std::string_view text, size_t max_length) { return shown(text, max_length, false); }

std::string printable_lines(std::string_view text, size_t max_length) { return shown(text, max_length, true); }

std::string composed(std::string text) {
    if (!is_ascii(text) && text.find('\0') == std::string::npos)
        unicode().function<decltype(relief_compose)>("relief_compose")(text);
    return text;
}

std::string folded(std::string text) {
    if (!is_ascii(text) && text.find('\0') == std::string::npos) {
        unicode().function<decltype(relief_fold)>("relief_fold")(text);
        return text;
    }
    std::string plain;
    for (const char c : text)
        if (c >= 'A' && c <= 'Z')
            plain += char(c - 'A' + 'a');
        else if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'))
            plain += c;
    return plain;
}

std::string utf8_of_bytes(std::string_view bytes) {
    std::string result;
    for (size_t at = 0; at < bytes.size();) {
        const Character one = first_of(bytes.substr(at));
        const bool stays = one.size > 0 && (one.code < first_private || one.code > last_private);
        const std::string_view part = bytes.substr(at, stays ? one.size : 1);
        if (stays)
            result += part;
        else  // U+F700 plus the byte, which is at least 0x80
            result += {'\xef', char(0x9c | (part[0] >> 6 & 3)), char(0x80 | (part[0] & 0x3f))};
        at += part.size();
    }
    return result;
}

std::string bytes_of_utf8(std::string_view text) {
    std::string result;
    for (size_t at = 0; at < text.size();) {
        const Character one = first_of(text.substr(at));
        const size_t size = std::max<size_t>(one.size, 1);
        if (one.code >= first_private && one.code <= last_private)
            result += char(one.code & 0xff);
        else
            result += text.substr(at, size);
        at += size;
    }
    return result;
}

}  // namespace relief::grade
