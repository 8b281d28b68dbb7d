#include "framework/core/image/asset.h"

#include <fmt/format.h>

#include <array>
#include <cstring>

#include "framework/core/base/log.h"
#include "framework/core/base/module.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/system.h"
#include "framework/core/image/file.h"
#include "framework/core/image/mips.h"

namespace relief {
namespace {

namespace fs = std::filesystem;

/// Tells whether a file's bytes have changed, at the speed of memory. Not cryptographic. Four sums of 64 bits run in
/// parallel, because each multiplication depends on the one before it.
class Fingerprint {
public:
    /// Appends a piece. The size of every piece but the last is a multiple of 32 bytes.
    void add(std::string_view bytes) {
        size_ += bytes.size();
        for (; bytes.size() >= sizeof sums_; bytes.remove_prefix(sizeof sums_)) add_block(bytes.data());
        if (bytes.empty()) return;
        char last[sizeof sums_] = {};
        std::memcpy(last, bytes.data(), bytes.size());
        add_block(last);
    }
    uint64_t value() const {
        uint64_t all = size_;
        for (const uint64_t sum : sums_) all = mixed(all, sum);
        return all;
    }

private:
    static uint64_t mixed(uint64_t sum, uint64_t word) {
        sum = (sum ^ word) * 0x9e3779b97f4a7c15;  // odd, so multiplication is invertible
        return sum ^ sum >> 32;
    }
    void add_block(const char* block) {
        for (size_t i = 0; i < sums_.size(); ++i) {
            uint64_t word;
            std::memcpy(&word, block + i * sizeof word, sizeof word);
            sums_[i] = mixed(sums_[i], word);
        }
    }
    std::array<uint64_t, 4> sums_{};
    uint64_t size_ = 0;
};

/// Returns the fingerprint of a file, or nothing when it cannot be read.
std::optional<uint64_t> fingerprint_of(const fs::path& path) {
    const Descriptor file = os::open_to_read(path);
    if (file < 0) return {};
    Fingerprint fingerprint;
    std::array<char, 1 << 16> piece;
    while (true) {
        const std::optional<size_t> have = read_up_to(file, piece.data(), piece.size());
        if (!have) return {};
        fingerprint.add({piece.data(), *have});
        if (*have < piece.size()) return fingerprint.value();
    }
}

ColorSpace space_of(const std::string& name) {
    return fs::path(name).stem().string().ends_with("_albedo") ? ColorSpace::srgb : ColorSpace::linear;
}

/// Returns the texels that the build made of a picture, or nothing when they are missing or of another version of it.
/// A picture outside of the folder has none.
std::optional<Texels> converted(const std::string& name) {
    if (name.starts_with("..")) return {};
    const std::optional<uint64_t> source = fingerprint_of(course_root() / "assets" / name);
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
    Fingerprint fingerprint;
    fingerprint.add(bytes);
    const ColorSpace space = space_of(name);
    return encode_texels(pack(mip_chain(decode_image(bytes), space), space), fingerprint.value());
}

}  // namespace relief
