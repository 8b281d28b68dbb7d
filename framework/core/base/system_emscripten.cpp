// Implements framework/core/base/system.h for a browser, with system_posix.cpp. Files are in memory. An empty one
// stands for a file that the page has not fetched yet: see missing_files().
#include "framework/core/base/system.h"

#include <emscripten.h>
#include <fcntl.h>

#include <cerrno>
#include <cstdlib>
#include <string>

#include "framework/core/base/missing_files.h"

namespace relief {

std::set<std::string>& missing_files() {
    static std::set<std::string> files;
    return files;
}

}  // namespace relief

namespace relief::os {

namespace fs = std::filesystem;

// Nothing is opened at run time: the page has one module.
void* open_library(const char*, std::string& reason) {
    reason = "a browser opens no libraries";
    return nullptr;
}
void* function(void*, const char*) { return nullptr; }
fs::path library_of(const void*) { return executable(); }
fs::path executable() { return "/course/relief"; }

Descriptor open_to_read(const fs::path& path) {
    Descriptor file(open(path.c_str(), O_RDONLY | O_NONBLOCK));
    const FileState state = file < 0 ? FileState{} : state_of(file).value_or(FileState{});
    if (state.is_plain && state.size == 0) {
        missing_files().insert(path.string());
        errno = ENOENT;
        return Descriptor(-1);
    }
    return file;
}

bool flush_to_disk(int) { return true; }
bool flush_folder_to_disk(const fs::path&) { return true; }
bool is_terminal(int) { return false; }
int terminal_columns(int) { return 0; }

void clean_up_when_interrupted(void (*)()) {}  // a page has no signals
double processor_seconds() { return emscripten_get_now() / 1000; }

// A page never leaves the C locale.
double to_double(const char* text) { return std::strtod(text, nullptr); }

MappedFile map_file(const fs::path& path) {
    const Descriptor file = open_to_read(path);
    const FileState state = file < 0 ? FileState{} : state_of(file).value_or(FileState{});
    if (!state.is_plain || state.size == 0) return {};
    const auto bytes = std::make_shared<std::string>(size_t(state.size), '\0');
    if (!read_all(file, bytes->data(), bytes->size())) return {};
    return {bytes, *bytes};
}

// There are no pages of memory to choose from.
void take_large_pages(void*, size_t) {}
void take_large_pages() {}

std::shared_ptr<void> shared_memory(size_t) {
    errno = ENOSYS;
    return nullptr;
}

bool has_display() { return true; }

std::string name() { return "WebAssembly"; }

}  // namespace relief::os
