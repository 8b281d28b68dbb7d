// Implements framework/core/base/system.h and descriptor.h for a browser. Files are in memory. An empty one stands for
// a file that the page has not fetched yet: see missing_files().
#include "framework/core/base/system.h"

#include <emscripten.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string>

#include "framework/core/base/missing_files.h"

namespace relief {

bool Descriptor::close() { return number_ < 0 || ::close(release()) == 0; }

bool write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = write(descriptor, bytes.data(), bytes.size());
        if (written <= 0) return false;
        bytes.remove_prefix(size_t(written));
    }
    return true;
}

std::optional<size_t> read_up_to(int descriptor, void* bytes, size_t size) {
    size_t have = 0;
    while (have < size) {
        const ssize_t got = read(descriptor, static_cast<char*>(bytes) + have, size - have);
        if (got < 0) return {};
        if (got == 0) break;
        have += size_t(got);
    }
    return have;
}

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

std::vector<std::string> utf8_arguments(int, char**) { return {}; }
void prepare_standard_streams() {}
void keep_terminal_open() {}

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
Descriptor open_to_write(const fs::path& path) { return Descriptor(open(path.c_str(), O_WRONLY)); }
Descriptor create_file(const fs::path& path, bool is_private) {
    return Descriptor(open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL, is_private ? 0600 : 0666));
}
Descriptor open_nowhere() { return open_to_write("/dev/null"); }

std::optional<FileState> state_of(int descriptor) {
    struct stat status {};
    if (fstat(descriptor, &status) != 0) return {};
    return FileState{.is_plain = S_ISREG(status.st_mode), .size = uint64_t(status.st_size)};
}

bool flush_to_disk(int) { return true; }
bool flush_folder_to_disk(const fs::path&) { return true; }
Descriptor copy_of(int descriptor) { return Descriptor(dup(descriptor)); }
void redirect(int descriptor, int to) { dup2(to, descriptor); }
bool is_terminal(int) { return false; }

void clean_up_when_interrupted(void (*)()) {}  // a page has no signals
void remove_file(const char* name) { unlink(name); }
void set_environment(const char* name, const std::string& value) { setenv(name, value.c_str(), 1); }
double processor_seconds() { return emscripten_get_now() / 1000; }

// A page never leaves the C locale.
double to_double(const char* text) { return std::strtod(text, nullptr); }
float to_float(const char* text) { return std::strtof(text, nullptr); }

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
