// Text that strangers wrote: file names in any bytes, messages of any length. Shown, and kept in JSON.
#pragma once

#include <string>
#include <string_view>

namespace relief {

/// On one line of a terminal or a page, in UTF-8: control characters and bytes that are not UTF-8 as \xNN, characters
/// that turn the direction of text or cannot be seen as \uNNNN. Cut after `most` bytes of `text`, at a character.
std::string printable(std::string_view text, size_t max_length = 200);

/// The same on as many lines as it has.
std::string printable_lines(std::string_view text, size_t max_length);

/// Any bytes as UTF-8, which JSON asks for, and back. What is UTF-8 already stays as it is; any other byte becomes a
/// character for private use, U+F780 to U+F7FF, and so do the bytes of these characters themselves.
std::string utf8_of_bytes(std::string_view bytes);
std::string bytes_of_utf8(std::string_view text);

}  // namespace relief
