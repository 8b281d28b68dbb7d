// The functions that depend on the operating system: libraries, files and their descriptors, memory, signals, the
// environment, and conversions that not every standard library has. Each system has its own implementation. For
// processes see framework/core/base/process.h. No other file outside of staff uses the system's own headers.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "framework/core/base/descriptor.h"

namespace relief::os {

/// Opens a library, which stays open until the process ends, or the running program if `name` is null. Returns null and
/// sets `reason` on failure.
void* open_library(const char* name, std::string& reason);
/// Returns the address of a function, or null when the library has no such function.
void* function(void* library, const char* name);
/// Returns the path of the library or program that contains this address.
std::filesystem::path library_of(const void* address);

/// Returns the path of the running program, also in a sandbox that hides it.
std::filesystem::path executable();

/// Returns the words of the command line in UTF-8, the program first, from the arguments of main().
std::vector<std::string> utf8_arguments(int argc, char** argv);
/// Makes the standard streams carry bytes unchanged, and a terminal take UTF-8 and colours.
void prepare_standard_streams();

/// Waits for Enter if the terminal would close with this process, as after a double click on Windows.
void keep_terminal_open();

/// Opens a file to read it. Does not wait for the writer of a pipe. A negative descriptor means failure; errno has the
/// reason.
Descriptor open_to_read(const std::filesystem::path& path);
/// Opens a device or a pipe to write to it, with errors as above.
Descriptor open_to_write(const std::filesystem::path& path);
/// Creates a file, which must not exist yet, with errors as above. Only the user can read it if it is private.
Descriptor create_file(const std::filesystem::path& path, bool is_private);
/// Opens a device that discards all bytes.
Descriptor open_nowhere();

struct FileState {
    bool is_plain = false;  ///< not a folder, pipe or device
    uint64_t size = 0;      ///< bytes
};
/// Returns nothing on failure; errno has the reason.
std::optional<FileState> state_of(int descriptor);

/// Waits until the file is on the disk. Returns false on failure; errno has the reason.
bool flush_to_disk(int descriptor);
/// Waits until the folder's names are on the disk. Returns false on failure; errno has the reason.
bool flush_folder_to_disk(const std::filesystem::path& folder);

/// Returns a second descriptor of the same file.
Descriptor copy_of(int descriptor);
/// Makes `descriptor` refer to the file of `to`.
void redirect(int descriptor, int to);
/// Returns whether a person reads the output: the descriptor is a terminal.
bool is_terminal(int descriptor);
/// Returns the width of the descriptor's terminal in letters; 0 where it is no terminal, or one of unknown width.
int terminal_columns(int descriptor);

/// From this call on, calls `clean_up` when SIGINT (Ctrl-C), SIGHUP or SIGTERM ends the process, unless it ignores that
/// signal. `clean_up` may access only plain memory and call remove_file(). Writing to a closed pipe then is an error
/// instead of a signal.
void clean_up_when_interrupted(void (*clean_up)());
/// Removes a file, also in a handler of signals. Ignores errors.
void remove_file(const char* name);

/// Sets a variable of this process's environment.
void set_environment(const char* name, const std::string& value);

/// Returns the processor time of this process and its threads, in seconds.
double processor_seconds();

/// Converts a decimal number to the nearest value, in any locale, as std::strtod does in the C locale. std::from_chars
/// would be exact too, but libc++ does not have it for this type.
double to_double(const char* text);

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

/// Returns zeroed memory that all later copies of this process share, or null on failure; errno has the reason.
std::shared_ptr<void> shared_memory(size_t bytes);

/// Returns whether a window can be opened: on Linux, the environment names an X11 or Wayland display.
bool has_display();

/// Returns the system's name, such as "Linux 6.1.0-18-amd64 x86_64".
std::string name();

}  // namespace relief::os
