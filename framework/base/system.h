// What differs from one operating system to the next, in one file a system: libraries that are opened, the program's
// place, mapped files, the heap's pages. Processes: framework/base/process.h.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace relief::os {

/// Null where it cannot be opened, with the system's reason. It stays open as long as the process.
void* open_library(const char* name, std::string& reason);
/// Null where the library has no such function.
void* function(void* library, const char* name);
/// The library, or the program, that holds this address.
std::filesystem::path library_of(const void* address);

/// The program that runs, also in a sandbox that hides it.
std::filesystem::path executable();

/// A file's bytes, mapped read-only.
struct MappedFile {
    std::shared_ptr<const void> memory;  ///< keeps the bytes; null where there is no plain file with something in it
    std::string_view bytes;
};
MappedFile map_file(const std::filesystem::path& path);

/// Takes the first 64 MiB of the heap in large pages, where the system has them, and gives no memory back before the
/// end. Textures and pictures come and go in pieces of megabytes: in small pages the system's work for them is a sixth
/// of a shot's time. Call it first.
void take_large_pages();
/// The same for a piece of memory that is aligned to large pages. Where there are none, all is as it was.
void take_large_pages(void* memory, size_t bytes);

/// "Linux 6.1.0-18-amd64 x86_64"
std::string name();

}  // namespace relief::os
