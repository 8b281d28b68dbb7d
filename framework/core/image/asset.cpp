#include "framework/core/image/asset.h"

#include <fmt/format.h>
#include <zlib.h>

#include <array>

#include "framework/core/base/log.h"
#include "framework/core/base/module.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/system.h"
#include "framework/core/image/file.h"
#include "framework/core/image/mips.h"

namespace relief {
namespace {

namespace fs = std::filesystem;

/// Returns the fingerprint of some bytes after those of an earlier fingerprint. It tells whether a file has changed.
uint64_t fingerprint_of(std::string_view bytes, uint64_t before = 0) {
    return crc32_z(uLong(before), reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
}

/// Returns the fingerprint of a file, or nothing when it cannot be read.
std::optional<uint64_t> fingerprint_of_file(const fs::path& path) {
    const Descriptor file = os::open_to_read(path);
    if (file < 0) return {};
    uint64_t fingerprint = 0;
    std::array<char, 1 << 16> piece;
    while (true) {
        const std::optional<size_t> have = read_up_to(file, piece.data(), piece.size());
        if (!have) return {};
        fingerprint = fingerprint_of({piece.data(), *have}, fingerprint);
        if (*have < piece.size()) return fingerprint;
    }
}

ColorSpace space_of(const std::string& name) {
    return fs::path(name).stem().string().ends_with("_albedo") ? ColorSpace::srgb : ColorSpace::linear;
}

/// Returns the texels that the build made of a picture, or nothing when they are missing or of another version of it.
/// A picture outside of the folder has none.
std::optional<Texels> converted(const std::string& name) {
    if (name.starts_with("..")) return {};
    const std::optional<uint64_t> source = fingerprint_of_file(course_root() / "assets" / name);
    std::optional<Texels> texels;
    if (source) texels = map_texels(framework_folder() / "textures" / (name + ".texels"), *source);
    if (source && !texels)
        print_event(fmt::format("assets/{}: changed since the build; read from the picture itself", name));
    return texels;
}

}  // namespace

Image read_asset(const std::string& name) {
    if (const auto ready = converted(name)) return unpack(*ready);
    return read_image(course_root() / "assets" / name);
}

Texels read_asset_chain(const std::string& name, ColorSpace space) {
    std::optional<Texels> ready = converted(name);
    if (ready && ready->space == space) return *std::move(ready);
    Image picture = ready ? unpack(*ready) : read_image(course_root() / "assets" / name);
    return pack(mip_chain(std::move(picture), space), space);
}

std::string convert_asset(const std::string& name, const std::string& bytes) {
    const ColorSpace space = space_of(name);
    return encode_texels(pack(mip_chain(decode_image(bytes), space), space), fingerprint_of(bytes));
}

}  // namespace relief
