// Untrusted text, such as file names in any bytes and messages of any length: made safe to show and to keep in JSON.
#pragma once

#include <string>
#include <string_view>

namespace relief {

/// The text as one line of UTF-8 for a terminal or a page. Control characters and bytes that are not UTF-8 become \xNN;
/// invisible characters, and those that change the direction of text, become \uNNNN. Cut after at most `max_length`
/// bytes of `text`, between two characters.
std::string printable(std::string_view text, size_t max_length = 200);

/// The same, but line breaks and tabs stay.
std::string printable_lines(std::string_view text, size_t max_length);

/// A person's name as it is compared: in Unicode's normal form C (Unicode Standard Annex 15), in which an accent and
/// its letter are one character. macOS and some spreadsheets write two. Bytes that are not UTF-8 stay as they are.
std::string composed(std::string text);

/// Any bytes as UTF-8, which JSON requires, and back without loss. Valid UTF-8 stays as it is. Any other byte becomes a
/// private-use character, U+F780 to U+F7FF; so do the bytes of those characters themselves.
std::string utf8_of_bytes(std::string_view bytes);
std::string bytes_of_utf8(std::string_view text);

}  // namespace relief

/// The module's function; composed() calls it.
extern "C" void relief_compose(std::string& text);
