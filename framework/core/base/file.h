// Reading and writing of whole files. No half-written file is ever visible.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace relief {

/// Returns the file's contents. Throws Error that names the file and the reason, also when it is larger than `limit`
/// bytes.
std::string read_file(const std::filesystem::path& path, size_t limit = size_t{1} << 30);

/// Says that a file is missing: "brick.png is not there". Adds the name of a file there that differs only in the case
/// of letters.
std::string missing_file(const std::filesystem::path& path);

/// Writes to a temporary file beside the target and renames it. An interrupted or failed write leaves the old file, or
/// none. Follows symbolic links. Writes directly into a pipe or a device. Throws Error that names the file and the
/// reason.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// As write_file(), but returns only when the file is on the disk, so that it survives a power cut.
void write_file_to_disk(const std::filesystem::path& path, std::string_view bytes);

/// As write_file_to_disk(), but the new file is readable and writable by its owner only (mode 0600), even if the old
/// file was readable by others.
void write_private_file(const std::filesystem::path& path, std::string_view bytes);

/// Writes all bytes to standard output. Throws Error if the reader has closed it or the disk is full.
void write_standard_output(std::string_view bytes);

/// Makes a folder and its parents. Throws Error that names it and the reason.
void make_folder(const std::filesystem::path& path);

/// From this call on, SIGINT (Ctrl-C), SIGHUP and SIGTERM also remove the file that is being written.
void clean_up_when_interrupted();

}  // namespace relief
