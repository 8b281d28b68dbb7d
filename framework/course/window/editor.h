// The command that opens a file at a line in the user's editor.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace relief {

/// Returns the command that opens `file` at `line` (from 1) in `editor`: a program, perhaps with arguments, as VISUAL
/// or EDITOR holds it. An empty `editor` means the desktop's default program. The line is left out when it is 0, or
/// when the editor is not known to accept one. Editors for a terminal are started in a new one.
std::vector<std::string> editor_command(const std::string& editor, const std::filesystem::path& file, int line);

/// Returns VISUAL, or EDITOR if VISUAL is not set, or an empty string.
std::string chosen_editor();

}  // namespace relief
