// Entries of Mesa's cache of compiled shaders, which one drawing process can hand to another.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace relief::check {

/// Entries by name. The name is a hash of all that an entry depends on: the driver, its settings, and the texts of the
/// shaders.
using CompiledShaders = std::map<std::string, std::string>;

/// Maximum size of packed entries, in bytes. The largest lab has 0.6 MiB.
constexpr size_t longest_compiled = size_t{4} << 20;

/// Returns the entries in a folder that MESA_SHADER_CACHE_DIR names, as far as they fit into `longest_compiled` when
/// packed. Mesa writes them in the background, so the last ones may be missing. Returns none for the databases of newer
/// versions of Mesa, whose files are not entries.
CompiledShaders read_compiled(const std::filesystem::path& cache);
/// Adds entries to such a folder. An entry that cannot be written is left out: it costs only time.
void write_compiled(const std::filesystem::path& cache, const CompiledShaders& entries);

std::string packed(const CompiledShaders& entries);
/// Returns the entries of a text of packed(). Returns none for any other text.
CompiledShaders unpacked(std::string_view text);

}  // namespace relief::check
