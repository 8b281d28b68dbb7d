// Whole files: read at once, and written so that no half-written file is ever visible.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace relief {

/// The whole file. Throws Error that names the file and the reason. `limit` bytes at most.
std::string read_file(const std::filesystem::path& path, size_t limit = size_t{1} << 30);

/// Writes beside the target and renames, so that an interrupted or failed write leaves the old file, or none.
/// Throws Error that names the file and the reason.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// The same, and returns only when the file is on the disk: it survives a power cut.
void write_file_to_disk(const std::filesystem::path& path, std::string_view bytes);

/// The same, for its owner alone to read and write (mode 0600), whoever could read the file before.
void write_private_file(const std::filesystem::path& path, std::string_view bytes);

/// Removes what writers that were killed have left in a folder. Nobody may be writing there.
void remove_unfinished_files(const std::filesystem::path& folder);

/// Writes everything to standard output. Throws Error if the reader has closed it or the disk is full.
void write_standard_output(std::string_view bytes);

/// Makes a folder and those above it. Throws Error that names it and the reason.
void make_folder(const std::filesystem::path& path);

/// From here on, Ctrl-C, a hang-up or a termination also removes the file that is just being written.
void clean_up_when_interrupted();

}  // namespace relief
