// The functions that depend on the operating system: opening libraries, the program's path, mapped files, and pages of
// the heap. Each system has its own implementation. For processes see framework/core/base/process.h.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace relief::os {

/// Opens a library, which stays open until the process ends. Returns null and sets `reason` on failure.
void* open_library(const char* name, std::string& reason);
/// Returns the address of a function, or null when the library has no such function.
void* function(void* library, const char* name);
/// Returns the path of the library or program that contains this address.
std::filesystem::path library_of(const void* address);

/// Returns the path of the running program, also in a sandbox that hides it.
std::filesystem::path executable();

/// A file's bytes, mapped read-only.
struct MappedFile {
    std::shared_ptr<const void> memory;  ///< owns the mapping; null unless the file is a plain, non-empty one
    std::string_view bytes;
};
MappedFile map_file(const std::filesystem::path& path);

/// Puts the first 64 MiB of the heap into large pages if the system has them, and keeps freed memory until the process
/// ends. Textures and pictures are allocated in pieces of megabytes. With small pages, the system's work for them is a
/// sixth of a shot's time. Call this before all other work.
void take_large_pages();
/// Does the same for a piece of memory that is aligned to large pages. Has no effect if the system has none.
void take_large_pages(void* memory, size_t bytes);

/// Returns the system's name, such as "Linux 6.1.0-18-amd64 x86_64".
std::string name();

}  // namespace relief::os
