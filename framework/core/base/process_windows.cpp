// Implements framework/core/base/process.h for Windows, with process_here.cpp.
#include "framework/core/base/process.h"

#ifndef NOMINMAX
    #define NOMINMAX
#endif
#include <windows.h>

#include <fcntl.h>
#include <io.h>
#include <process.h>
#include <shellapi.h>

#include <cerrno>
#include <cstring>

#include "framework/core/base/error.h"

namespace relief {

Pipe::Pipe() {
    int ends[2];
    if (_pipe(ends, 1 << 16, _O_BINARY | _O_NOINHERIT) != 0)
        throw Error(std::string("no pipe: ") + std::strerror(errno));
    read = Descriptor(ends[0]), write = Descriptor(ends[1]);
}

bool open_on_desktop(const std::filesystem::path& file) {
    const HINSTANCE code =
        ShellExecuteW(nullptr, nullptr, std::filesystem::absolute(file).c_str(), nullptr, nullptr, SW_SHOWNORMAL);
    return reinterpret_cast<intptr_t>(code) > 32;
}

bool start_on_desktop(const std::vector<std::string>& command) {
    if (command.empty()) return false;
    std::vector<std::wstring> words;
    for (const std::string& word : command) words.push_back(L'"' + std::filesystem::path(word).wstring() + L'"');
    std::vector<const wchar_t*> pointers;
    for (const std::wstring& word : words) pointers.push_back(word.c_str());
    pointers.push_back(nullptr);
    return _wspawnvp(_P_NOWAIT, std::filesystem::path(command[0]).c_str(), pointers.data()) != -1;
}

}  // namespace relief
