// The text of a source file that a person wrote with any editor: shaders and C++ tasks.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "framework/core/base/error.h"

namespace relief {

/// Returns the text with LF at the end of each line, in place of CR LF or CR alone, and without a UTF-8 byte order
/// mark. GLSL allows all three ends of lines (GLSL 4.10, section 3.2); gcc does not read CR alone.
std::string plain_source(std::string bytes);

/// Returns plain_source() of a file of at most 16 MiB. Throws Error as read_file() does.
std::string read_source(const std::filesystem::path& file);

/// A character or a line that a compiler refuses, or for which it would blame another file.
struct SourceFault {
    int line = 0;              ///< from 1; 0 for the whole file
    std::string message = {};  ///< says what to do
    std::string quote = {};    ///< the line with a mark below the character, or empty
};

/// Returns the first fault of a plain_source(), or nothing. `file` gives the language by its ending: GLSL unless it is
/// .cpp or .h.
///
/// Faults of both languages: text in UTF-16 or UTF-32, a byte 0, and a blank or a sign outside of comments that only
/// looks like one of ASCII. In GLSL also: any other character beyond ASCII outside of comments, a comment that is never
/// closed, an #if without its #endif, and a backslash at the end of the last line. The compiler reads an included file
/// and the file behind it as one text, so it finds these too late, or never.
std::optional<SourceFault> fault_of_source(const std::string& text, const std::filesystem::path& file);

/// Throws Error with the place of the text's fault, if there is one.
void refuse_faulty_source(const std::string& text, const std::filesystem::path& file);

/// Returns a line of a source with a mark below the character at this byte, or below the end, both indented by four. No
/// mark for npos. Tabs become blanks, so the
/// mark stands right in every font of one width.
std::string marked_line(const std::string& line, size_t byte);

}  // namespace relief
