// Makes untrusted text, such as file names in any bytes and messages of any length, safe to show and to keep in JSON.
#pragma once

#include <string>
#include <string_view>

namespace relief::grade {

/// Returns the text as one line of UTF-8 for a terminal or a page. Control characters and invalid UTF-8 become \xNN;
/// invisible characters and marks of text direction become \uNNNN. Truncates to at most `max_length` bytes of `text`,
/// between two characters.
std::string printable(std::string_view text, size_t max_length = 200);

/// The same, but keeps line breaks and tabs.
std::string printable_lines(std::string_view text, size_t max_length);

/// Returns a person's name in the form in which names are compared: Unicode's normal form C (Unicode Standard Annex
/// 15), in which an accent and its letter are one character. macOS and some spreadsheets write two. Text that is not
/// UTF-8 is unchanged.
std::string composed(std::string text);

/// Returns a name's letters and digits without case, accents, blanks and signs: "zoeodoe" for "Zo\u00eb O'Doe". Systems
/// that rename files drop different signs of a name. Text that is not UTF-8 keeps all its bytes.
std::string folded(std::string text);

/// Convert any bytes to UTF-8, which JSON requires, and back without loss. Valid UTF-8 is unchanged. Any other byte
/// becomes a private-use character, U+F780 to U+F7FF. So do the bytes of these characters themselves, to keep the
/// conversion unique.
std::string utf8_of_bytes(std::string_view bytes);
std::string bytes_of_utf8(std::string_view text);

}  // namespace relief::grade

/// The module's functions; composed() and folded() call them.
extern "C" void relief_compose(std::string& text);
extern "C" void relief_fold(std::string& text);
