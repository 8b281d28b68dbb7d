#include "framework/core/image/exr.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <string_view>
#include <vector>

#include "framework/core/image/stored.h"

namespace relief {
namespace {

using namespace std::string_view_literals;

static_assert(std::endian::native == std::endian::little, "OpenEXR stores numbers with the lowest byte first");

constexpr std::string_view magic = "\x76\x2f\x31\x01\x02\0\0\0"sv;  // version 2: one part, in scan lines, short names
constexpr int rows_of_block = 16;                                   // the ZIP compression's
constexpr char zip = 3;
constexpr uint32_t float_samples = 2;
constexpr std::string_view channel_names[] = {"Y", "YA", "RGB", "RGBA"};  // a letter each, by the number of channels

template <class Number>
std::string bytes_of(Number number) {
    return {reinterpret_cast<const char*>(&number), sizeof number};
}
template <class Number>
Number number_at(std::string_view bytes, size_t at) {
    if (at > bytes.size() || bytes.size() - at < sizeof(Number)) throw Error("damaged: it ends too early");
    Number number;
    std::memcpy(&number, bytes.data() + at, sizeof number);
    return number;
}

/// Returns the image's channels in the order of the file, which is alphabetical.
std::vector<int> stored_order(int channels) {
    const std::string_view names = channel_names[channels - 1];
    std::vector<int> order(static_cast<size_t>(channels));
    for (int i = 0; i < channels; ++i) order[size_t(i)] = i;
    std::sort(order.begin(), order.end(), [&](int a, int b) { return names[size_t(a)] < names[size_t(b)]; });
    return order;
}

std::string channel_list(int channels) {
    std::string list;
    for (const int channel : stored_order(channels))
        list += std::string(1, channel_names[channels - 1][size_t(channel)]) + '\0' + bytes_of(float_samples) +
                bytes_of(uint32_t{0}) + bytes_of(1) + bytes_of(1);  // linear; sampled at each pixel
    return list + '\0';
}

std::string attribute(std::string_view name, std::string_view type, const std::string& value) {
    return std::string(name) + '\0' + std::string(type) + '\0' + bytes_of(uint32_t(value.size())) + value;
}

std::string header(const Image& image, const Notes& notes) {
    const std::string window = bytes_of(0) + bytes_of(0) + bytes_of(image.width - 1) + bytes_of(image.height - 1);
    std::string all(magic);
    all += attribute("channels", "chlist", channel_list(image.channels));
    all += attribute("compression", "compression", std::string(1, zip));
    all += attribute("dataWindow", "box2i", window) + attribute("displayWindow", "box2i", window);
    all += attribute("lineOrder", "lineOrder", std::string(1, '\0'));  // from the top
    all += attribute("pixelAspectRatio", "float", bytes_of(1.0f));
    for (const auto& [name, value] : notes) all += attribute(std::string(note_prefix) + name, "string", value);
    all += attribute("screenWindowCenter", "v2f", bytes_of(0.0f) + bytes_of(0.0f));
    return all + attribute("screenWindowWidth", "float", bytes_of(1.0f)) + '\0';
}

/// Moves the bytes of even index to the first half, and replaces each byte by its difference from the last one plus
/// 128.
std::string prepared(const std::string& raw) {
    std::string moved(raw.size(), '\0');
    const size_t half = (raw.size() + 1) / 2;
    for (size_t i = 0; i < raw.size(); ++i) moved[i / 2 + (i % 2) * half] = raw[i];
    for (size_t i = moved.size(); i-- > 1;) moved[i] = char(uint8_t(moved[i]) - uint8_t(moved[i - 1]) + 128);
    return moved;
}
std::string restored(std::string moved) {
    for (size_t i = 1; i < moved.size(); ++i) moved[i] = char(uint8_t(moved[i]) + uint8_t(moved[i - 1]) - 128);
    std::string raw(moved.size(), '\0');
    const size_t half = (raw.size() + 1) / 2;
    for (size_t i = 0; i < raw.size(); ++i) raw[i] = moved[i / 2 + (i % 2) * half];
    return raw;
}

std::string compressed(const std::string& raw) {
    const std::string bytes = prepared(raw);
    uLongf size = compressBound(bytes.size());
    std::string result(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(result.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                  bytes.size(), 4) != Z_OK)
        throw Error("cannot compress");
    result.resize(size);
    return result.size() < raw.size() ? result : raw;  // the size tells a reader which of them it is
}
std::string uncompressed(std::string_view bytes, size_t size) {
    if (bytes.size() == size) return std::string(bytes);
    std::string raw(size, '\0');
    uLongf length = size;
    if (uncompress(reinterpret_cast<Bytef*>(raw.data()), &length, reinterpret_cast<const Bytef*>(bytes.data()),
                   bytes.size()) != Z_OK ||
        length != size)
        throw Error("damaged: a block cannot be uncompressed");
    return restored(std::move(raw));
}

/// The rows of a block, as stored: row by row, channel by channel.
size_t size_of_block(const Image& image, int first) {
    const int rows = std::min(rows_of_block, image.height - first);
    return size_t(rows) * size_t(image.width) * size_t(image.channels) * sizeof(float);
}

/// Calls visit(value of the image, offset in the block) for each value of a block.
template <class Picture, class Visit>
void each_value(Picture& image, int first, const Visit& visit) {
    const std::vector<int> order = stored_order(image.channels);
    size_t offset = 0;
    for (int y = first; y < std::min(first + rows_of_block, image.height); ++y)
        for (const int channel : order)
            for (int x = 0; x < image.width; ++x, offset += sizeof(float)) visit(image.pixel(x, y)[channel], offset);
}

/// The values of a header that decide how pixels are stored. `at` is the offset of the table behind it.
struct PlainHeader {
    int channels = 0;
    std::string data_window, display_window;
    size_t at = 0;
};

/// Returns nothing for a header with another use of the format.
std::optional<PlainHeader> plain_header(std::string_view bytes, Notes& notes) {
    if (!bytes.starts_with(magic)) return {};
    PlainHeader found;
    size_t at = magic.size();
    const auto word = [&] {
        const std::string_view text = bytes.substr(at, bytes.find('\0', at) - at);
        at += text.size() + 1;
        return text;
    };
    for (std::string_view name = word(); !name.empty(); name = word()) {
        const std::string_view type = word();
        const size_t size = number_at<uint32_t>(bytes, at);
        const std::string value(bytes.substr(at += 4, size));
        at += size;
        if (name == "channels")
            for (int channels = 1; channels <= 4; ++channels)
                if (value == channel_list(channels)) found.channels = channels;
        if (name == "compression" && value != std::string(1, zip)) return {};
        if (name == "lineOrder" && value != std::string(1, '\0')) return {};
        if (name == "dataWindow") found.data_window = value;
        if (name == "displayWindow") found.display_window = value;
        if (name.starts_with(note_prefix) && type == "string")
            notes.emplace_back(name.substr(note_prefix.size()), value);
    }
    if (found.channels == 0 || found.data_window.size() != 16 || found.data_window != found.display_window) return {};
    found.at = at;
    return found;
}

}  // namespace

std::string encode_exr(const Image& image, const Notes& notes) {
    std::string table, blocks;
    const std::string start = header(image, notes);
    const int count = (image.height + rows_of_block - 1) / rows_of_block;
    for (int first = 0; first < image.height; first += rows_of_block) {
        std::string raw(size_of_block(image, first), '\0');
        each_value(image, first,
                   [&](const float& value, size_t offset) { std::memcpy(&raw[offset], &value, sizeof value); });
        const std::string packed = compressed(raw);
        table += bytes_of(uint64_t(start.size() + size_t(count) * sizeof(uint64_t) + blocks.size()));
        blocks += bytes_of(first) + bytes_of(uint32_t(packed.size())) + packed;
    }
    return start + table + blocks;
}

std::optional<Image> decode_plain_exr(const std::string& bytes, Notes& notes) {
    Notes found;
    const std::optional<PlainHeader> header = plain_header(bytes, found);
    if (!header) return {};
    const auto side = [&](size_t from) {
        return int64_t(number_at<int32_t>(header->data_window, from + 8)) -
               number_at<int32_t>(header->data_window, from) + 1;
    };
    const int64_t width = side(0), height = side(4);
    if (width < 1 || height < 1) throw Error("damaged: it has no pixels");
    check_image_size(int(width), int(height), header->channels);
    // Before memory is taken for the pixels: zlib compresses by a factor of at most 1032 (its technical details).
    const size_t count = size_t(height + rows_of_block - 1) / rows_of_block;
    if (size_t(width * height) * size_t(header->channels) * sizeof(float) / 1032 > bytes.size() - header->at)
        throw Error("damaged: it ends too early");
    Image image(int(width), int(height), header->channels);
    const int top = number_at<int32_t>(header->data_window, 4);
    for (size_t i = 0; i < count; ++i) {
        const uint64_t at = number_at<uint64_t>(bytes, header->at + i * sizeof(uint64_t));
        const int first = int(i) * rows_of_block;
        if (number_at<int32_t>(bytes, at) != top + first) throw Error("damaged: a block is not where it belongs");
        const uint32_t size = number_at<uint32_t>(bytes, at + 4);
        if (size > bytes.size() - at - 8) throw Error("damaged: it ends too early");
        const std::string raw = uncompressed(std::string_view(bytes).substr(at + 8, size), size_of_block(image, first));
        each_value(image, first, [&](float& value, size_t offset) { std::memcpy(&value, &raw[offset], sizeof value); });
    }
    notes = std::move(found);
    return image;
}

}  // namespace relief
