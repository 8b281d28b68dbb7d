#include "framework/course/check/compiled_shaders.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <system_error>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"

namespace relief::check {
namespace {

namespace fs = std::filesystem;

constexpr const char* entries_folder = "mesa_shader_cache";  // a database has another one
constexpr size_t name_size = 40;                             // SHA-1 in hexadecimal digits
constexpr size_t packed_head = name_size + sizeof(uint32_t);

bool is_entry_name(std::string_view name) {
    return name.size() == name_size && name.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

}  // namespace

CompiledShaders read_compiled(const fs::path& cache) {
    CompiledShaders entries;
    size_t size = 0;
    std::error_code ignored;
    for (const auto& folder : fs::directory_iterator(cache / entries_folder, ignored)) {
        if (!folder.is_directory(ignored)) continue;
        for (const auto& file : fs::directory_iterator(folder, ignored)) {
            // Mesa splits a name after its first two digits. Other names are unfinished files.
            const std::string name = folder.path().filename().string() + file.path().filename().string();
            if (!is_entry_name(name) || !file.is_regular_file(ignored)) continue;
            std::string content = read_file(file);
            size += packed_head + content.size();
            if (size > longest_compiled) return entries;
            entries.emplace(name, std::move(content));
        }
    }
    return entries;
}

void write_compiled(const fs::path& cache, const CompiledShaders& entries) {
    for (const auto& [name, content] : entries) {
        const fs::path folder = cache / entries_folder / name.substr(0, 2);
        std::error_code ignored;
        fs::create_directories(folder, ignored);
        try {
            write_file(folder / name.substr(2), content);
        } catch (const Error&) {  // /tmp is full
            return;
        }
    }
}

std::string packed(const CompiledShaders& entries) {
    std::string text;
    for (const auto& [name, content] : entries) {
        const auto size = uint32_t(content.size());
        text += name;
        text.append(reinterpret_cast<const char*>(&size), sizeof size);
        text += content;
    }
    return text;
}

CompiledShaders unpacked(std::string_view text) {
    CompiledShaders entries;
    while (!text.empty()) {
        uint32_t size = 0;
        if (text.size() < packed_head || !is_entry_name(text.substr(0, name_size))) return {};
        std::memcpy(&size, text.data() + name_size, sizeof size);
        if (size > text.size() - packed_head) return {};
        entries.emplace(text.substr(0, name_size), text.substr(packed_head, size));
        text.remove_prefix(packed_head + size);
    }
    return entries;
}

}  // namespace relief::check
