// Mip chains in the layout that OpenGL takes, in memory and in mapped files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "framework/core/image/image.h"

namespace relief {

/// The levels of a mip chain, from level 0 on. Rows go from the bottom to the top without padding. A value is an
/// unsigned integer of 8 or 16 bits, or a 32-bit float. glTexImage2D takes this layout with an alignment of 1.
struct Texels {
    struct Level {
        int width = 0, height = 0;
        const std::byte* rows = nullptr;
    };
    int channels = 0;
    int bits = 0;  ///< 8, 16 or 32
    ColorSpace space = ColorSpace::linear;
    std::vector<Level> levels = {};
    std::shared_ptr<const void> memory = {};  ///< owns the rows

    size_t bytes(const Level& level) const {
        return size_t(level.width) * size_t(level.height) * size_t(channels) * size_t(bits / 8);
    }
};

/// Packs the levels of one picture, at least one. Integers are clamped to [0, 1] and rounded.
Texels pack(std::span<const Image> levels, ColorSpace space);
/// Returns level 0 as read from a file. Integers give the same floats as decode_image().
Image unpack(const Texels& texels);

/// Returns the file contents of a whole chain, down to 1x1. `source` identifies the picture that the chain was made of.
std::string encode_texels(const Texels& chain, uint64_t source);
/// Returns the chain in such bytes, which `memory` owns. Returns nothing when the format, the source or the length is
/// another, or the chain is incomplete: then the caller makes it again.
std::optional<Texels> decode_texels(std::string_view bytes, uint64_t source, std::shared_ptr<const void> memory);
/// Maps a file and decodes it likewise. Returns nothing also when there is no such file.
std::optional<Texels> map_texels(const std::filesystem::path& path, uint64_t source);

}  // namespace relief
