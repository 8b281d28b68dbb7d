#include "framework/core/image/png.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <tuple>

#include "framework/core/image/color_profile.h"
#include "framework/core/image/stored.h"

namespace relief {
namespace {

/// The source or the target of libpng, and its error. On failure libpng calls longjmp(), which skips destructors. So
/// every object with a destructor lives in here, outside of the functions that call setjmp().
struct Stream {
    const std::string* from = nullptr;
    size_t at = 0;
    std::string to;
    std::string problem;
};

void fail(png_structp png, png_const_charp message) {
    static_cast<Stream*>(png_get_error_ptr(png))->problem = message;
    png_longjmp(png, 1);
}
void ignore(png_structp, png_const_charp) {}

void take_bytes(png_structp png, png_bytep into, size_t count) {
    Stream& stream = *static_cast<Stream*>(png_get_io_ptr(png));
    if (stream.from->size() - stream.at < count) png_error(png, "it ends too early");
    std::memcpy(into, stream.from->data() + stream.at, count);
    stream.at += count;
}

void put_bytes(png_structp png, png_bytep bytes, size_t count) {
    static_cast<Stream*>(png_get_io_ptr(png))->to.append(reinterpret_cast<const char*>(bytes), count);
}
void flush(png_structp) {}

struct Reader {
    Stream stream;
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::vector<png_byte> bytes;
    std::vector<png_bytep> rows;
    int width = 0, height = 0, channels = 0, bits = 8;

    explicit Reader(const std::string& from) {
        stream.from = &from;
        png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &stream, fail, ignore);
        info = png ? png_create_info_struct(png) : nullptr;
        if (!info) throw Error("cannot read: there is no memory");
    }
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
};

/// Reads the header and sets up the conversion of rows. Returns false when libpng fails.
bool read_header(Reader& reader) {
    png_structp png = reader.png;
    if (setjmp(png_jmpbuf(png))) return false;
    png_set_read_fn(png, &reader.stream, take_bytes);
    png_read_info(png, reader.info);
    // Expands palettes, transparent colours and 1, 2 and 4 bits to 8 bits per channel. Gamma is ignored.
    png_set_expand(png);
    if (png_get_bit_depth(png, reader.info) == 16) {
        reader.bits = 16;
        if constexpr (std::endian::native == std::endian::little) png_set_swap(png);
    }
    png_set_interlace_handling(png);
    png_read_update_info(png, reader.info);
    reader.width = int(png_get_image_width(png, reader.info));
    reader.height = int(png_get_image_height(png, reader.info));
    reader.channels = png_get_channels(png, reader.info);
    return true;
}

template <class Integer>
void load(const png_byte* bytes, float* values, size_t count, float largest) {
    for (size_t i = 0; i < count; ++i) {
        Integer stored;
        std::memcpy(&stored, bytes + i * sizeof stored, sizeof stored);
        values[i] = float(stored) / largest;
    }
}
void load(const Reader& reader, const png_byte* bytes, float* values, size_t count) {
    if (reader.bits == 16)
        load<uint16_t>(bytes, values, count, 65535);
    else
        load<uint8_t>(bytes, values, count, 255);
}

/// Returns the name of the colour profile, by the chunk that counts: sRGB, iCCP, gAMA. Empty for none and for sRGB.
std::string profile_name(png_structp png, png_infop info) {
    int intent = 0, compression = 0;
    if (png_get_sRGB(png, info, &intent)) return {};
    png_charp name = nullptr;
    png_bytep profile = nullptr;
    png_uint_32 length = 0;
    if (png_get_iCCP(png, info, &name, &compression, &profile, &length))
        return icc_profile_name({reinterpret_cast<const char*>(profile), length});
    png_fixed_point gamma = 0;
    constexpr png_fixed_point one = 100'000, of_srgb = 45'455;
    if (!png_get_gAMA_fixed(png, info, &gamma) || gamma <= 0 || std::abs(gamma - of_srgb) < 100) return {};
    return gamma == one ? "gamma 1" : fmt::format("gamma {:.2f}", double(one) / gamma);
}

/// Reads all rows and the chunks after them: an interlaced picture as a whole, else row by row, which takes less
/// memory. Returns false when libpng fails.
bool read_rows(Reader& reader, Image& image) {
    if (setjmp(png_jmpbuf(reader.png))) return false;
    if (!reader.rows.empty()) {
        png_read_image(reader.png, reader.rows.data());
        load(reader, reader.bytes.data(), image.values.data(), image.values.size());
    } else {
        for (int y = 0; y < reader.height; ++y) {
            png_read_row(reader.png, reader.bytes.data(), nullptr);
            load(reader, reader.bytes.data(), image.pixel(0, y), size_t(image.width) * size_t(image.channels));
        }
    }
    png_read_end(reader.png, reader.info);
    return true;
}

struct Writer {
    Stream stream;
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::vector<png_byte> bytes;  ///< of a row
    std::vector<std::string> words;
    std::vector<png_text> texts;

    Writer() {
        png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &stream, fail, ignore);
        info = png ? png_create_info_struct(png) : nullptr;
        if (!info) throw Error("cannot encode: there is no memory");
    }
    ~Writer() { png_destroy_write_struct(&png, &info); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
};

template <class Integer>
void store(const float* values, size_t count, png_byte* bytes, float largest) {
    for (size_t i = 0; i < count; ++i) {
        const float value = values[i] > 0 ? std::min(values[i], 1.0f) : 0.0f;  // NaN becomes 0
        const auto stored = Integer(value * largest + 0.5f);
        std::memcpy(bytes + i * sizeof(Integer), &stored, sizeof stored);
    }
}

bool write_all(Writer& writer, const Image& image, int bits, ColorSpace space, const PngRow& row) {
    constexpr int types[] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB, PNG_COLOR_TYPE_RGBA};
    png_structp png = writer.png;
    if (setjmp(png_jmpbuf(png))) return false;
    png_set_write_fn(png, &writer.stream, put_bytes, flush);
    png_set_IHDR(png, writer.info, png_uint_32(image.width), png_uint_32(image.height), bits, types[image.channels - 1],
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (space == ColorSpace::srgb)
        png_set_sRGB(png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
    else
        png_set_gAMA(png, writer.info, 1);
    if (!writer.texts.empty()) png_set_text(png, writer.info, writer.texts.data(), int(writer.texts.size()));
    png_write_info(png, writer.info);
    if constexpr (std::endian::native == std::endian::little)
        if (bits == 16) png_set_swap(png);
    const size_t count = size_t(image.width) * size_t(image.channels);
    for (int y = 0; y < image.height; ++y) {
        if (bits == 16)
            store<uint16_t>(row(y), count, writer.bytes.data(), 65535);
        else
            store<uint8_t>(row(y), count, writer.bytes.data(), 255);
        png_write_row(png, writer.bytes.data());
    }
    png_write_end(png, nullptr);
    return true;
}

std::vector<png_bytep> rows_of(std::vector<png_byte>& bytes, int count) {
    std::vector<png_bytep> rows;
    for (int y = 0; y < count; ++y) rows.push_back(bytes.data() + bytes.size() / size_t(count) * size_t(y));
    return rows;
}

}  // namespace

Image decode_png(const std::string& bytes, Notes& notes) {
    Reader reader(bytes);
    const auto damaged = [&] { return Error("damaged: " + reader.stream.problem); };
    if (!read_header(reader)) throw damaged();
    const auto [width, height, channels] = std::tuple(reader.width, reader.height, reader.channels);
    check_image_size(width, height, channels);
    Image image(width, height, channels, reader.bits);
    const size_t row = size_t(width) * size_t(channels) * size_t(reader.bits / 8);
    const bool is_interlaced = png_get_interlace_type(reader.png, reader.info) != PNG_INTERLACE_NONE;
    reader.bytes.resize(is_interlaced ? row * size_t(height) : row);
    if (is_interlaced) reader.rows = rows_of(reader.bytes, height);
    if (!read_rows(reader, image)) throw damaged();
    image.profile = profile_name(reader.png, reader.info);
    png_textp texts = nullptr;
    const int count = png_get_text(reader.png, reader.info, &texts, nullptr);
    for (int i = 0; i < count; ++i)
        if (const std::string_view key = texts[i].key; key.starts_with(note_prefix))
            notes.emplace_back(key.substr(note_prefix.size()), std::string(texts[i].text));
    return image;
}

std::string encode_png(const Image& image, const Notes& notes, ColorSpace space) {
    return encode_png(image, notes, space, [&](int y) { return image.pixel(0, y); });
}

std::string encode_png(const Image& image, const Notes& notes, ColorSpace space, const PngRow& row) {
    if (image.channels < 1 || image.channels > 4)
        throw Error(fmt::format("cannot encode: a PNG has 1 to 4 channels, not {}", image.channels));
    Writer writer;
    const int bits = image.bits == 16 ? 16 : 8;
    writer.bytes.resize(size_t(image.width) * size_t(image.channels) * size_t(bits / 8));
    for (const auto& [name, value] : notes) {
        writer.words.push_back(std::string(note_prefix) + name);
        writer.words.push_back(value);
    }
    for (size_t i = 0; i < writer.words.size(); i += 2) {
        png_text& text = writer.texts.emplace_back();
        text.compression = PNG_TEXT_COMPRESSION_NONE;
        text.key = writer.words[i].data();
        text.text = writer.words[i + 1].data();
        text.text_length = writer.words[i + 1].size();
    }
    if (!write_all(writer, image, bits, space, row)) throw Error("cannot encode: " + writer.stream.problem);
    return std::move(writer.stream.to);
}

}  // namespace relief
