// Archives that strangers send, through libarchive, which a module of its own brings in: opened when it is needed.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace relief {

/// Bounds that an honest submission keeps even with a build folder in it.
constexpr size_t max_archive_bytes = size_t{256} << 20, max_unpacked_bytes = size_t{512} << 20;
constexpr size_t max_entries = 20000;
/// Of one name, and of all names together: of files, folders and links.
constexpr size_t max_name_bytes = 4096, max_names_bytes = size_t{16} << 20;

struct ArchiveEntry {
    std::string name;      ///< as the archive has it: whatever bytes a stranger wrote
    bool is_file = false;  ///< not a folder, a link or a device
    bool is_link = false;  ///< symbolic or hard
    bool too_large = false;
    std::string content;  ///< of wanted files that are not too large
};

/// The entries of a zip or tar archive (plain or packed by gzip, bzip2, xz or zstd), in order. Nothing is written to
/// disk. The content of a file is kept when `wanted` says so of its name, and when it has at most `largest` bytes.
/// Throws Error without a place for what is no archive, damaged, or beyond the bounds above.
std::vector<ArchiveEntry> read_archive(const std::filesystem::path& path, size_t largest,
                                       const std::function<bool(const std::string&)>& wanted);

}  // namespace relief

/// What the module offers; `read_archive` finds it there.
extern "C" void relief_read_archive(int descriptor, size_t largest,
                                    const std::function<bool(const std::string&)>& wanted,
                                    std::vector<relief::ArchiveEntry>& entries);
