#include "framework/course/window/editor.h"

#include <algorithm>
#include <cstdlib>
#include <initializer_list>

#include "framework/core/base/text.h"

namespace relief {

std::vector<std::string> editor_command(const std::string& editor, const std::filesystem::path& file, int line) {
    std::vector<std::string> command;
    for (const std::string& word : split(editor, ' '))
        if (!word.empty()) command.push_back(word);
    if (command.empty()) return {"xdg-open", file.string()};
    const std::string name = std::filesystem::path(command.front()).filename().string();
    const auto is = [&](std::initializer_list<const char*> names) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    const std::string number = std::to_string(line);
    if (is({"vi", "vim", "nvim", "nano", "mg", "joe", "micro", "hx", "helix"}))
        command.insert(command.begin(), {"x-terminal-emulator", "-e"});
    if (line <= 0)
        command.push_back(file.string());
    else if (is({"code", "code-insiders", "codium", "cursor"}))
        command.insert(command.end(), {"--goto", file.string() + ":" + number});
    else if (is({"subl", "zed", "hx", "helix"}))
        command.push_back(file.string() + ":" + number);
    else if (is({"kate", "kwrite", "mousepad"}))
        command.insert(command.end(), {"-l", number, file.string()});
    else if (is({"vi", "vim", "nvim", "gvim", "nano", "mg", "joe", "micro", "emacs", "emacsclient", "gedit", "pluma",
                 "xed"}))
        command.insert(command.end(), {"+" + number, file.string()});
    else
        command.push_back(file.string());
    return command;
}

std::string chosen_editor() {
    for (const char* name : {"VISUAL", "EDITOR"})
        if (const char* const value = std::getenv(name); value && *value) return value;
    return {};
}

}  // namespace relief
