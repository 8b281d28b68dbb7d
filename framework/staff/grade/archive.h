// Reads untrusted archives with libarchive. The library is in a module of its own, opened when needed.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace relief::grade {

/// Limits. Even an honest submission with a build folder stays below them.
constexpr size_t max_archive_bytes = size_t{256} << 20, max_unpacked_bytes = size_t{512} << 20;
constexpr size_t max_entries = 20000;
/// Limits of one name, and of all names together; files, folders and links count.
constexpr size_t max_name_bytes = 4096, max_names_bytes = size_t{16} << 20;

struct ArchiveEntry {
    std::string name;      ///< as in the archive: can be any bytes
    bool is_file = false;  ///< not a folder, a link or a device
    bool is_link = false;  ///< symbolic or hard
    bool too_large = false;
    std::string content;  ///< empty if the file is not wanted or too large
};

/// Returns the entries of a zip or tar archive (plain, or compressed by gzip, bzip2, xz or zstd), in order. Writes
/// nothing to disk. Keeps the content of a file of at most `largest(name)` bytes; 0: the file is not wanted. Throws
/// Error if the file is not an archive, is damaged, or exceeds the limits above; the error names no file.
std::vector<ArchiveEntry> read_archive(int descriptor, const std::function<size_t(const std::string&)>& largest);

}  // namespace relief::grade

/// The module's function; read_archive() calls it.
extern "C" void relief_read_archive(int descriptor, const std::function<size_t(const std::string&)>& largest,
                                    std::vector<relief::grade::ArchiveEntry>& entries);
