// Implements framework/core/base/system.h and descriptor.h for Windows. Paths are wide. A text is UTF-8, and the C++
// library converts between both, whatever the system's code page.
#include "framework/core/base/system.h"

#ifndef NOMINMAX
    #define NOMINMAX
#endif
#include <windows.h>

#include <fcntl.h>
#include <io.h>
#include <shellapi.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cwchar>
#include <iterator>

namespace relief {

bool Descriptor::close() { return number_ < 0 || _close(release()) == 0; }

namespace {

unsigned at_most_a_gigabyte(size_t bytes) { return unsigned(std::min(bytes, size_t{1} << 30)); }

}  // namespace

bool write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const int written = _write(descriptor, bytes.data(), at_most_a_gigabyte(bytes.size()));
        if (written <= 0) return false;
        bytes.remove_prefix(size_t(written));
    }
    return true;
}

std::optional<size_t> read_up_to(int descriptor, void* bytes, size_t size) {
    size_t have = 0;
    while (have < size) {
        const int got = _read(descriptor, static_cast<char*>(bytes) + have, at_most_a_gigabyte(size - have));
        if (got < 0) return {};
        if (got == 0) break;
        have += size_t(got);
    }
    return have;
}

}  // namespace relief

// GCC's library converts a text to a path by mbrtowc(), which takes each byte for a character, because the C locale has
// no encoding. The linker (--wrap) replaces it by this function, which decodes UTF-8. A character beyond 16 bits takes
// two calls: the first one keeps the second half in `state`.
extern "C" size_t __wrap_mbrtowc(wchar_t* to, const char* from, size_t size, mbstate_t* state) {
    if (*state) {
        *to = wchar_t(*state);
        *state = 0;
        return 1;
    }
    if (size == 0) return size_t(-2);
    const auto byte = [&](size_t i) { return unsigned(static_cast<unsigned char>(from[i])); };
    const unsigned first = byte(0);
    if (first < 0x80) {
        *to = wchar_t(first);
        return first ? 1 : 0;
    }
    const size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    unsigned code = first & (0x7fu >> length);
    bool is_valid = first >= 0xc2 && first < 0xf5 && length <= size;
    for (size_t i = 1; is_valid && i < length; ++i) {
        is_valid = (byte(i) & 0xc0) == 0x80;
        code = code << 6 | (byte(i) & 0x3f);
    }
    if (!is_valid) {
        *to = 0xfffd;  // the replacement character
        return 1;
    }
    if (length < 4) {
        *to = wchar_t(code);
        return length;
    }
    *to = wchar_t(0xd800 + ((code - 0x10000) >> 10));
    *state = mbstate_t(0xdc00 + ((code - 0x10000) & 0x3ff));
    return 3;
}

namespace relief::os {
namespace {

namespace fs = std::filesystem;

void (*clean_up_before_the_end)() = nullptr;

/// Runs in a thread of its own.
BOOL WINAPI end_cleanly(DWORD) {
    clean_up_before_the_end();
    return FALSE;  // the next handler ends the process
}

std::string reason_of(DWORD error) {
    wchar_t text[512];
    const DWORD size = FormatMessageW(FORMAT_MESSAGE_FROM_SYSTEM | FORMAT_MESSAGE_IGNORE_INSERTS, nullptr, error, 0,
                                      text, DWORD(std::size(text)), nullptr);
    std::string reason = fs::path(std::wstring(text, size)).string();
    while (!reason.empty() && (reason.back() == '\n' || reason.back() == '\r' || reason.back() == '.'))
        reason.pop_back();
    return reason;
}

/// Opens a file whose bytes are not translated and that child processes do not inherit.
Descriptor open_plain(const fs::path& path, int how, int rights = 0) {
    return Descriptor(_wopen(path.c_str(), how | _O_BINARY | _O_NOINHERIT, rights));
}

}  // namespace

void* open_library(const char* name, std::string& reason) {
    void* const library = name ? LoadLibraryW(fs::path(name).c_str()) : GetModuleHandleW(nullptr);
    if (!library) reason = reason_of(GetLastError());
    return library;
}

void* function(void* library, const char* name) {
    return reinterpret_cast<void*>(GetProcAddress(static_cast<HMODULE>(library), name));
}

fs::path library_of(const void* address) {
    HMODULE module = nullptr;
    GetModuleHandleExW(GET_MODULE_HANDLE_EX_FLAG_FROM_ADDRESS | GET_MODULE_HANDLE_EX_FLAG_UNCHANGED_REFCOUNT,
                       static_cast<LPCWSTR>(address), &module);
    std::wstring path(size_t{1} << 15, L'\0');  // the longest path that the system has
    path.resize(GetModuleFileNameW(module, path.data(), DWORD(path.size())));
    return path;
}

fs::path executable() { return library_of(nullptr); }

std::vector<std::string> utf8_arguments(int, char**) {
    int count = 0;
    wchar_t** const words = CommandLineToArgvW(GetCommandLineW(), &count);
    std::vector<std::string> arguments;
    for (int i = 0; i < count; ++i) arguments.push_back(fs::path(words[i]).string());
    LocalFree(words);
    return arguments;
}

Descriptor open_to_read(const fs::path& path) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) {  // cannot be opened, with a misleading reason
        errno = EISDIR;
        return Descriptor(-1);
    }
    return open_plain(path, _O_RDONLY);
}

Descriptor open_to_write(const fs::path& path) { return open_plain(path, _O_WRONLY); }

Descriptor create_file(const fs::path& path, bool) {  // in a user's folder only this user can read
    return open_plain(path, _O_WRONLY | _O_CREAT | _O_EXCL, _S_IREAD | _S_IWRITE);
}

Descriptor open_nowhere() { return open_to_write("NUL"); }

std::optional<FileState> state_of(int descriptor) {
    struct _stat64 status {};
    if (_fstat64(descriptor, &status) != 0) return {};
    return FileState{.is_plain = (status.st_mode & _S_IFMT) == _S_IFREG, .size = uint64_t(status.st_size)};
}

bool flush_to_disk(int descriptor) { return _commit(descriptor) == 0; }

// The system has no such call, and its file system keeps a journal of names.
bool flush_folder_to_disk(const fs::path&) { return true; }

Descriptor copy_of(int descriptor) { return Descriptor(_dup(descriptor)); }

void redirect(int descriptor, int to) { _dup2(to, descriptor); }

bool is_terminal(int descriptor) {
    DWORD mode = 0;
    return GetConsoleMode(reinterpret_cast<HANDLE>(_get_osfhandle(descriptor)), &mode) != 0;
}

int terminal_columns(int descriptor) {
    CONSOLE_SCREEN_BUFFER_INFO info{};
    const auto console = reinterpret_cast<HANDLE>(_get_osfhandle(descriptor));
    return GetConsoleScreenBufferInfo(console, &info) != 0 ? info.dwSize.X : 0;
}

void prepare_standard_streams() {
    for (const int descriptor : {0, 1, 2}) _setmode(descriptor, _O_BINARY);
    SetConsoleOutputCP(CP_UTF8);
    for (const DWORD stream : {STD_OUTPUT_HANDLE, STD_ERROR_HANDLE}) {
        DWORD mode = 0;
        const HANDLE console = GetStdHandle(stream);
        if (GetConsoleMode(console, &mode)) SetConsoleMode(console, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
    }
}

void keep_terminal_open() {
    DWORD processes[2];
    if (GetConsoleProcessList(processes, 2) != 1 || !is_terminal(0) || !is_terminal(standard_error)) return;
    write_all(standard_error, "Press Enter to close this window.");
    char line[64];
    [[maybe_unused]] const int read = _read(0, line, sizeof line);
}

void clean_up_when_interrupted(void (*clean_up)()) {
    clean_up_before_the_end = clean_up;
    SetConsoleCtrlHandler(end_cleanly, TRUE);
}

void remove_file(const char* name) { DeleteFileW(fs::path(name).c_str()); }

void set_environment(const char* name, const std::string& value) {
    _putenv_s(name, value.c_str());
    SetEnvironmentVariableA(name, value.c_str());  // for a driver with a C runtime of its own
}

double processor_seconds() {
    FILETIME begin, end, kernel, user;
    if (!GetProcessTimes(GetCurrentProcess(), &begin, &end, &kernel, &user)) return 0;
    const auto seconds = [](const FILETIME& time) {  // in units of 100 ns
        return 1e-7 * (4294967296.0 * time.dwHighDateTime + time.dwLowDateTime);
    };
    return seconds(kernel) + seconds(user);
}

// The program never leaves the C locale. mingw-w64's own functions round to the nearest value, unlike the system's.
double to_double(const char* text) { return std::strtod(text, nullptr); }

MappedFile map_file(const fs::path& path) {
    const Descriptor file = open_to_read(path);
    const FileState state = file < 0 ? FileState{} : state_of(file).value_or(FileState{});
    if (!state.is_plain || state.size == 0) return {};
    const HANDLE mapping =
        CreateFileMappingW(reinterpret_cast<HANDLE>(_get_osfhandle(file)), nullptr, PAGE_READONLY, 0, 0, nullptr);
    if (!mapping) return {};
    const void* const mapped = MapViewOfFile(mapping, FILE_MAP_READ, 0, 0, 0);
    CloseHandle(mapping);  // the view keeps it open
    if (!mapped) return {};
    return {std::shared_ptr<const void>(mapped, [](const void* at) { UnmapViewOfFile(at); }),
            {static_cast<const char*>(mapped), size_t(state.size)}};
}

// Large pages need a right that users lack.
void take_large_pages(void*, size_t) {}
void take_large_pages() {}

// Nothing can be shared with copies of this process, because there are none: see can_copy_process().
std::shared_ptr<void> shared_memory(size_t) {
    errno = ENOSYS;
    return nullptr;
}

bool has_display() { return true; }

std::string name() {
    // GetVersionEx() hides versions from 8.1 on, and this function of the driver kit does not.
    using GetVersion = LONG WINAPI(OSVERSIONINFOW*);
    OSVERSIONINFOW version{};
    version.dwOSVersionInfoSize = sizeof version;
    if (const HMODULE library = GetModuleHandleW(L"ntdll.dll"))
        if (const auto get = reinterpret_cast<GetVersion*>(function(library, "RtlGetVersion"))) get(&version);
    return "Windows " + std::to_string(version.dwMajorVersion) + "." + std::to_string(version.dwMinorVersion) + "." +
           std::to_string(version.dwBuildNumber) + " x86_64";
}

}  // namespace relief::os
