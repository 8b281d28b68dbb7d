#include "framework/core/image/texels.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "framework/core/base/system.h"
#include "framework/core/image/file.h"

namespace relief {
namespace {

static_assert(std::endian::native == std::endian::little, "as GL takes them, and as files hold them");

/// The beginning of a file; the levels follow, from 0 on. The last character of `magic` is the format's version.
struct FileHeader {
    char magic[8] = {'r', 'e', 'l', 'i', 'e', 'f', 'T', '1'};
    uint64_t source = 0;
    int32_t width = 0, height = 0, channels = 0, bits = 0, srgb = 0, zero = 0;
};
static_assert(sizeof(FileHeader) == 40);

template <class Value>
void pack_level(const Image& image, std::byte* to) {
    const size_t row = size_t(image.width) * size_t(image.channels);
    for (int y = image.height; y-- > 0;) {
        const float* const from = image.pixel(0, y);
        for (size_t i = 0; i < row; ++i, to += sizeof(Value)) {
            Value value;
            if constexpr (std::is_same_v<Value, float>)
                value = from[i];
            else
                value = Value(std::clamp(from[i], 0.0f, 1.0f) * std::numeric_limits<Value>::max() + 0.5f);
            std::memcpy(to, &value, sizeof value);
        }
    }
}

template <class Value>
void unpack_level(const std::byte* from, Image& image, float largest) {
    const size_t row = size_t(image.width) * size_t(image.channels);
    for (int y = image.height; y-- > 0;) {
        float* const to = image.pixel(0, y);
        for (size_t i = 0; i < row; ++i, from += sizeof(Value)) {
            Value value;
            std::memcpy(&value, from, sizeof value);
            to[i] = float(value) / largest;
        }
    }
}

}  // namespace

Texels pack(std::span<const Image> images, ColorSpace space) {
    Texels texels{.channels = images.front().channels, .bits = images.front().bits, .space = space};
    size_t size = 0;
    for (const Image& image : images) {
        texels.levels.push_back({image.width, image.height});
        size += texels.bytes(texels.levels.back());
    }
    const std::shared_ptr<std::byte[]> memory(new std::byte[size]);
    std::byte* to = memory.get();
    for (size_t i = 0; i < images.size(); ++i) {
        texels.levels[i].rows = to;
        if (texels.bits == 8) pack_level<uint8_t>(images[i], to);
        if (texels.bits == 16) pack_level<uint16_t>(images[i], to);
        if (texels.bits == 32) pack_level<float>(images[i], to);
        to += texels.bytes(texels.levels[i]);
    }
    texels.memory = memory;
    return texels;
}

Image unpack(const Texels& texels) {
    const Texels::Level& level = texels.levels.at(0);
    Image image(level.width, level.height, texels.channels, texels.bits);
    if (texels.bits == 8) unpack_level<uint8_t>(level.rows, image, 255);
    if (texels.bits == 16) unpack_level<uint16_t>(level.rows, image, 65535);
    if (texels.bits == 32) unpack_level<float>(level.rows, image, 1);
    return image;
}

std::string encode_texels(const Texels& chain, uint64_t source) {
    FileHeader header;
    header.source = source;
    header.width = chain.levels.at(0).width, header.height = chain.levels[0].height;
    header.channels = chain.channels, header.bits = chain.bits, header.srgb = chain.space == ColorSpace::srgb;
    std::string bytes(reinterpret_cast<const char*>(&header), sizeof header);
    for (const Texels::Level& level : chain.levels)
        bytes.append(reinterpret_cast<const char*>(level.rows), chain.bytes(level));
    return bytes;
}

std::optional<Texels> decode_texels(std::string_view bytes, uint64_t source, std::shared_ptr<const void> memory) {
    FileHeader header;
    if (bytes.size() < sizeof header) return {};
    std::memcpy(&header, bytes.data(), sizeof header);
    const auto within = [](int value, int max) { return value >= 1 && value <= max; };
    if (std::memcmp(header.magic, FileHeader().magic, sizeof header.magic) != 0 || header.source != source ||
        !within(header.width, max_image_side) || !within(header.height, max_image_side) ||
        !within(header.channels, 4) || (header.bits != 8 && header.bits != 16 && header.bits != 32))
        return {};
    Texels chain{.channels = header.channels,
                 .bits = header.bits,
                 .space = header.srgb ? ColorSpace::srgb : ColorSpace::linear,
                 .memory = std::move(memory)};
    size_t at = sizeof header;
    for (int width = header.width, height = header.height;;) {
        chain.levels.push_back({width, height, reinterpret_cast<const std::byte*>(bytes.data()) + at});
        const Texels::Level& level = chain.levels.back();
        at += chain.bytes(level);
        if (at > bytes.size()) return {};
        if (width == 1 && height == 1) break;
        width = std::max(1, width / 2), height = std::max(1, height / 2);
    }
    if (at != bytes.size()) return {};
    return chain;
}

std::optional<Texels> map_texels(const std::filesystem::path& path, uint64_t source) {
    os::MappedFile file = os::map_file(path);
    if (!file.memory) return {};
    return decode_texels(file.bytes, source, std::move(file.memory));
}

}  // namespace relief
