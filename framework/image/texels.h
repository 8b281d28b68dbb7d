// Mip chains in the bytes that OpenGL takes, in memory and in files that are mapped.
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

#include "framework/image/image.h"

namespace relief {

/// Levels from 0 on. Rows go from the bottom to the top without padding; a value is an unsigned integer of 8 or 16
/// bits, or a 32-bit float: what glTexImage2D takes with an alignment of 1.
struct Texels {
    struct Level {
        int width = 0, height = 0;
        const std::byte* rows = nullptr;
    };
    int channels = 0;
    int bits = 0;  ///< 8, 16 or 32
    ColorSpace space = ColorSpace::linear;
    std::vector<Level> levels = {};
    std::shared_ptr<const void> memory = {};  ///< in which the rows lie

    size_t bytes(const Level& level) const {
        return size_t(level.width) * size_t(level.height) * size_t(channels) * size_t(bits / 8);
    }
};

/// The levels of one picture. Integers are rounded and kept to [0, 1].
Texels pack(std::span<const Image> levels, ColorSpace space);
/// Level 0 as it was read from a file: of integers the same floats that decode_image() gives.
Image unpack(const Texels& texels);

/// A whole chain, down to 1x1, as a file; `source` is whatever tells the picture that it was made of from all others.
std::string encode_texels(const Texels& chain, uint64_t source);
/// The chain in such bytes, which `memory` holds. Nothing when they are of another kind, of another source or length,
/// or no whole chain: then it is to be made anew.
std::optional<Texels> decode_texels(std::string_view bytes, uint64_t source, std::shared_ptr<const void> memory);
/// The same, mapped from a file. Nothing also when there is none.
std::optional<Texels> map_texels(const std::filesystem::path& path, uint64_t source);

}  // namespace relief
