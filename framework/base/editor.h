// The command that opens a file at a line in the user's editor.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace relief {

/// `editor` is what VISUAL or EDITOR holds, a program and perhaps arguments; empty: whatever the desktop opens the file
/// with. The line is left out for an editor that is not known to take one, and for line 0. Editors for a terminal get
/// one.
std::vector<std::string> editor_command(const std::string& editor, const std::filesystem::path& file, int line);

/// VISUAL, else EDITOR, else empty.
std::string chosen_editor();

}  // namespace relief
