#include "framework/core/image/netpbm.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>

#include "framework/core/base/error.h"
#include "framework/core/base/text.h"
#include "framework/core/image/file.h"

namespace relief {
namespace {

/// The words of a header, separated by white space, with comments from # to the end of the line.
class Header {
public:
    explicit Header(std::string_view bytes) : bytes_(bytes) {}

    std::string_view word(const char* what) {
        while (at_ < bytes_.size() && (is_space(bytes_[at_]) || bytes_[at_] == '#')) {
            if (bytes_[at_] == '#')
                at_ = std::min(bytes_.find('\n', at_), bytes_.size());
            else
                ++at_;
        }
        const size_t begin = at_;
        while (at_ < bytes_.size() && !is_space(bytes_[at_])) ++at_;
        if (begin == at_) throw Error(fmt::format("damaged: it ends before its {}", what));
        return bytes_.substr(begin, std::min<size_t>(at_ - begin, 40));
    }
    int number(const char* what, int largest) {
        const std::string_view text = word(what);
        const auto value = parse_int(text);
        if (!value || *value < 1 || *value > largest)
            throw Error(fmt::format("its {} is '{}': it must be from 1 to {}", what, printable(text), largest));
        return *value;
    }
    /// Returns the bytes after the single white space that ends the last word, of which `needed` hold the pixels.
    /// Throws Error if a second white space follows, as when a program wrote text with CR LF.
    std::string_view rest(size_t needed) const {
        const std::string_view rest = bytes_.substr(std::min(at_ + 1, bytes_.size()));
        const bool is_cr_lf = bytes_.substr(std::min(at_, bytes_.size())).starts_with("\r\n");
        if ((is_cr_lf && rest.size() > needed) || (rest.size() == needed + 1 && is_space(rest[0])))
            throw Error(
                fmt::format("its header ends with {}: one byte too many, so all values would be off by a byte. "
                            "Write it with a line feed alone",
                            is_cr_lf ? "CR LF" : "two white spaces"));
        return rest;
    }

private:
    static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
    static std::string printable(std::string_view text) {
        std::string result(text);
        for (char& c : result)
            if (c < ' ' || c > '~') c = '?';
        return result;
    }

    std::string_view bytes_;
    size_t at_ = 2;
};

void check_size(size_t pixels, size_t channels, size_t bytes_each, size_t there) {
    if (pixels * channels * sizeof(float) > max_image_bytes)
        throw Error(fmt::format("{} pixels with {} channels: at most {} MiB of floats are supported", pixels, channels,
                                max_image_bytes >> 20));
    if (there < pixels * channels * bytes_each)
        throw Error(fmt::format("damaged: {} bytes of {} are missing", pixels * channels * bytes_each - there,
                                pixels * channels * bytes_each));
}

Image decode_integers(Header& header, int width, int height, int channels) {
    const int largest = header.number("largest value", 65535), bytes_each = largest > 255 ? 2 : 1;
    const std::string_view rest = header.rest(size_t(width) * size_t(height) * size_t(channels) * size_t(bytes_each));
    check_size(size_t(width) * size_t(height), size_t(channels), size_t(bytes_each), rest.size());
    Image image(width, height, channels, bytes_each * 8);
    for (size_t i = 0; i < image.values.size(); ++i) {
        const auto byte = [&](size_t at) { return static_cast<unsigned char>(rest[at]); };
        const int value = bytes_each == 1 ? byte(i) : byte(2 * i) << 8 | byte(2 * i + 1);
        image.values[i] = float(std::min(value, largest)) / float(largest);
    }
    return image;
}

// Rows go from the bottom to the top. A negative scale means little-endian.
Image decode_floats(Header& header, int width, int height, int channels) {
    const std::string_view scale_text = header.word("scale");
    const auto scale = parse_number(scale_text);
    if (!scale || *scale == 0) throw Error("its scale must be a number other than 0");
    if (std::abs(*scale) != 1)
        throw Error(fmt::format("its scale is {}: only 1 and -1 are read, since programs differ in what others mean",
                                plain(*scale)));
    const std::string_view rest = header.rest(size_t(width) * size_t(height) * size_t(channels) * sizeof(float));
    check_size(size_t(width) * size_t(height), size_t(channels), sizeof(float), rest.size());
    Image image(width, height, channels);
    const size_t row = size_t(width) * size_t(channels);
    for (int y = 0; y < height; ++y)
        for (size_t i = 0; i < row; ++i) {
            uint32_t bits;
            std::memcpy(&bits, rest.data() + (size_t(height - 1 - y) * row + i) * sizeof bits, sizeof bits);
            if ((*scale < 0) != (std::endian::native == std::endian::little)) bits = __builtin_bswap32(bits);
            image.values[size_t(y) * row + i] = glm::uintBitsToFloat(bits);
        }
    return image;
}

}  // namespace

std::string encode_ppm(const Image& image) {
    std::string bytes = fmt::format("P6\n{} {}\n255\n", image.width, image.height);
    const size_t head = bytes.size();
    bytes.resize(head + image.pixel_count() * 3);
    const size_t step = size_t(image.channels), second = image.channels >= 3 ? 1 : 0;
    const float* from = image.values.data();
    for (char* to = bytes.data() + head; to != bytes.data() + bytes.size(); to += 3, from += step)
        for (size_t c = 0; c < 3; ++c) {
            const float value = from[c * second];
            const float scaled = (value >= 0 ? std::min(value, 1.0f) : 0.0f) * 255;  // NaN >= 0 is false
            to[c] = static_cast<char>(static_cast<int>(double(scaled) + 0.5));
        }
    return bytes;
}

std::string encode_pfm(const Image& image) {
    static_assert(std::endian::native == std::endian::little);
    const int channels = image.channels >= 3 ? 3 : image.channels == 2 ? 3 : 1;
    std::string bytes = fmt::format("{}\n{} {}\n-1.0\n", channels == 3 ? "PF" : "Pf", image.width, image.height);
    bytes.reserve(bytes.size() + image.pixel_count() * channels * sizeof(float));
    for (int y = image.height - 1; y >= 0; --y)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < channels; ++c) {
                const float value = c < image.channels ? image.pixel(x, y)[c] : 0.0f;
                bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
            }
    return bytes;
}

bool is_netpbm(std::string_view bytes) {
    const std::string_view start = bytes.substr(0, 2);
    return start == "P5" || start == "P6" || start == "PF" || start == "Pf";
}

Image decode_netpbm(std::string_view bytes) {
    if (!is_netpbm(bytes)) throw Error("neither PPM, PGM nor PFM");
    const int channels = bytes[1] == '6' || bytes[1] == 'F' ? 3 : 1;
    const bool floats = bytes[1] == 'F' || bytes[1] == 'f';
    Header header(bytes);
    const int width = header.number("width", max_image_side), height = header.number("height", max_image_side);
    return floats ? decode_floats(header, width, height, channels) : decode_integers(header, width, height, channels);
}

}  // namespace relief
