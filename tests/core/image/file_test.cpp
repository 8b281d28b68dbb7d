// Image files: exact where they promise it, and an error with the file's name for every invalid file.
#include "framework/core/image/file.h"

#include <array>
#include <bit>
#include <ctime>
#include <limits>

#include "framework/core/base/file.h"
#include "framework/core/base/module.h"
#include "framework/core/image/exr.h"
#include "framework/core/image/openimageio.h"
#include "tests/core/image/image_bytes.h"
#include "tests/support.h"

namespace relief {
namespace {

namespace fs = std::filesystem;
using namespace std::string_literals;
using namespace std::string_view_literals;

/// Returns an image of the values of `image.bits`, in order and repeated.
Image all_values(int width, int height, int channels, int bits) {
    Image image(width, height, channels, bits);
    const size_t count = size_t{1} << bits;
    for (size_t i = 0; i < image.values.size(); ++i) image.values[i] = float(i % count) / float(count - 1);
    return image;
}

/// Returns a PNG of rows, each with its filter type first. They are stored uncompressed in zlib's format (RFC 1950).
std::string png_of(uint32_t width, uint32_t height, char bits, char kind, const std::string& chunks,
                   const std::string& rows) {
    uint32_t a = 1, b = 0;  // of Adler-32
    for (const unsigned char byte : rows) a = (a + byte) % 65521, b = (b + a) % 65521;
    const auto low = char(rows.size()), high = char(rows.size() >> 8);
    const std::string stored = "\x78\x01\x01"s + low + high + char(~low) + char(~high) + rows + big_endian(b << 16 | a);
    return "\x89PNG\r\n\x1a\n" +
           png_chunk("IHDR", big_endian(width) + big_endian(height) + bits + kind + std::string(3, '\0')) + chunks +
           png_chunk("IDAT", stored) + png_chunk("IEND", "");
}

/// Returns the error of reading a file with these bytes, without the file's name, which it must begin with.
std::string file_refusal(const std::string& name, std::string_view bytes) {
    const TemporaryFolder folder;
    const fs::path file = folder.write(name, bytes);
    const std::string message = message_of([&] { read_image(file); });
    EXPECT_TRUE(message.starts_with(file.string() + ": ")) << message;
    return message.substr(std::min(message.size(), file.string().size() + 2));
}

// Made by OpenImageIO 2.4: 5x19 floats in ZIP blocks with a note, 5x19 halves in tiles, and a grey 16x8.
const fs::path sample_files = fs::path(source_folder) / "tests/core/image/files";

class ImageFiles : public testing::Test {
protected:
    Image back(const Image& image, const std::string& name, const Notes& notes = {}, Notes* read = nullptr) const {
        write_image(folder_.path() / name, image, notes);
        return read_image(folder_.path() / name, read);
    }
    TemporaryFolder folder_;
};

TEST_F(ImageFiles, Png8KeepsAll256ValuesInAnyChannel) {
    for (int channels = 1; channels <= 4; ++channels) {
        const Image image = all_values(32, 24, channels, 8), read = back(image, "a.png");
        EXPECT_TRUE(read.same_shape(image)) << channels << " channels";
        EXPECT_EQ(read.bits, 8) << channels << " channels";
        EXPECT_EQ(read.values, image.values) << channels << " channels";
    }
}

TEST_F(ImageFiles, Png16KeepsAll65536Values) {
    for (const int channels : {1, 3}) {
        const Image image = all_values(256, 256, channels, 16), read = back(image, "a.png");
        EXPECT_EQ(read.bits, 16);
        EXPECT_EQ(read.values, image.values) << channels << " channels";
    }
}

TEST_F(ImageFiles, PngMarksItsColorSpaceAndKeepsItsValues) {
    const Image image = all_values(16, 16, 1, 8);
    for (const ColorSpace space : {ColorSpace::srgb, ColorSpace::linear}) {
        const std::string bytes = encode_image(image, ImageFormat::png, {}, space);
        EXPECT_EQ(contains(bytes, "sRGB"), space == ColorSpace::srgb) << "the chunk of that name";
        EXPECT_EQ(read_image(folder_.write("a.png", bytes)).values, image.values);
    }
}

TEST_F(ImageFiles, PngKeepsColourWhereAlphaIsZero) {
    Image image(2, 1, 4, 8);
    image.values = {1, 0.2f, 0.4f, 0, 0.6f, 0.8f, 1, 0.2f};  // alpha may hold a height
    EXPECT_EQ(back(image, "a.png").values, image.values);
}

TEST_F(ImageFiles, PngPalettesAndLowBitDepthsAreExpandedToEightBits) {
    const std::string palette = png_chunk("PLTE", "\xff\0\0\0\x33\xff"s), see_through = png_chunk("tRNS", "\x33");
    const Image two = decode_image(png_of(2, 1, 1, 3, palette, "\0\x40"s));
    EXPECT_EQ(two.values, (std::vector<float>{1, 0, 0, 0, 0.2f, 1}));
    EXPECT_EQ(decode_image(png_of(2, 1, 1, 3, palette + see_through, "\0\x40"s)).values,
              (std::vector<float>{1, 0, 0, 0.2f, 0, 0.2f, 1, 1}));
    const Image grey = decode_image(png_of(4, 1, 2, 0, "", "\0\x1b"s));
    EXPECT_EQ(grey.values, (std::vector<float>{0, 85 / 255.0f, 170 / 255.0f, 1}));
    EXPECT_EQ(grey.bits, 8);
}

TEST_F(ImageFiles, PngRoundsToTheNearestAndClamps) {
    Image image(6, 1, 1, 8);
    image.values = {-1.0f, 0.49f / 255, 0.51f / 255, 127.49f / 255, 127.51f / 255, 2.0f};
    const Image read = back(image, "a.png");
    const std::array<float, 6> expected = {0, 0, 1, 127, 128, 255};
    for (size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(read.values[i] * 255, expected[i]) << image.values[i];
}

TEST_F(ImageFiles, ExrKeepsFloatsBitForBit) {
    using Limits = std::numeric_limits<float>;
    for (int channels = 1; channels <= 4; ++channels) {
        Image image(6, 2, channels);
        const std::array special = {Limits::infinity(),
                                    -Limits::infinity(),
                                    Limits::quiet_NaN(),
                                    Limits::denorm_min(),
                                    -0.0f,
                                    Limits::max(),
                                    1e-30f,
                                    0.1f,
                                    65505.0f};
        for (size_t i = 0; i < image.values.size(); ++i)
            image.values[i] = i < special.size() ? special[i] : 1.0f / float(i);
        const Image read = back(image, "a.exr");
        ASSERT_TRUE(read.same_shape(image)) << channels << " channels";
        EXPECT_EQ(read.bits, 32);
        for (size_t i = 0; i < image.values.size(); ++i)
            EXPECT_EQ(std::bit_cast<uint32_t>(read.values[i]), std::bit_cast<uint32_t>(image.values[i]))
                << channels << " channels, value " << i << " is " << image.values[i];
    }
}

TEST_F(ImageFiles, AreReproducibleAndContainNoDate) {
    const Image image = all_values(5, 3, 3, 8);
    const std::time_t now = std::time(nullptr);
    const std::string year = std::to_string(std::localtime(&now)->tm_year + 1900) + ":";
    for (const ImageFormat format : {ImageFormat::exr, ImageFormat::png}) {
        const std::string bytes = encode_image(image, format, {{"lab", "07_baking"}});
        EXPECT_EQ(bytes, encode_image(image, format, {{"lab", "07_baking"}}));
        EXPECT_FALSE(contains(bytes, year)) << "the date is in the file";
    }
}

TEST_F(ImageFiles, NotesSurviveARoundTripInPngAndExr) {
    const Notes notes = {{"camera", "30,20,3"}, {"knobs", "steps=32 \xc3\xa4 \"quoted\""}};
    for (const char* name : {"a.png", "a.exr"}) {
        Notes read = {{"old", "gone"}};
        back(all_values(2, 2, 3, 8), name, notes, &read);
        std::sort(read.begin(), read.end());
        EXPECT_EQ(read, notes) << name;
    }
}

TEST_F(ImageFiles, WithoutNotesAreReadWithoutNotes) {
    for (const char* name : {"a.png", "a.exr"}) {
        Notes read = {{"old", "gone"}};
        back(all_values(2, 2, 3, 8), name, {}, &read);
        EXPECT_TRUE(read.empty()) << name << ": the library's own notes are not ours";
    }
}

TEST_F(ImageFiles, PpmIsItsHeaderAndBytesFromTheTop) {
    Image image(2, 2, 3, 8);
    image.values = {0, 0.5f, 1, -1, 2, std::numeric_limits<float>::quiet_NaN(), 1 / 255.0f, 0, 0, 254 / 255.0f, 1, 1};
    EXPECT_EQ(encode_image(image, ImageFormat::ppm),
              "P6\n2 2\n255\n\x00\x80\xff\x00\xff\x00\x01\x00\x00\xfe\xff\xff"sv);
    Image grey(1, 1, 1, 8), with_alpha(1, 1, 4, 8);
    grey.values = {1};
    with_alpha.values = {1, 0, 0.2f, 0};
    EXPECT_EQ(encode_image(grey, ImageFormat::ppm), "P6\n1 1\n255\n\xff\xff\xff");
    EXPECT_EQ(encode_image(with_alpha, ImageFormat::ppm), "P6\n1 1\n255\n\xff\x00\x33"sv);
}

TEST_F(ImageFiles, PfmIsItsHeaderAndLittleEndianFloatsFromTheBottom) {
    Image grey(1, 2, 1);
    grey.values = {1.0f, -2.0f};  // 1 is above -2
    EXPECT_EQ(encode_image(grey, ImageFormat::pfm), "Pf\n1 2\n-1.0\n\x00\x00\x00\xc0\x00\x00\x80\x3f"sv);
    Image probe(1, 1, 4);
    probe.values = {no_surface, 1, -2, 0.5f};
    EXPECT_EQ(encode_image(probe, ImageFormat::pfm),
              "PF\n1 1\n-1.0\n\x00\x00\x80\x7f\x00\x00\x80\x3f\x00\x00\x00\xc0"sv);
    Image uv(1, 1, 2);
    uv.values = {1, -2};
    EXPECT_EQ(encode_image(uv, ImageFormat::pfm), "PF\n1 1\n-1.0\n\x00\x00\x80\x3f\x00\x00\x00\xc0\x00\x00\x00\x00"sv);
}

TEST_F(ImageFiles, AreReadByContentNotByExtension) {
    Image image(1, 1, 1);
    image.values = {1234.5f};
    const fs::path liar = folder_.write("a.png", encode_image(image, ImageFormat::exr));
    EXPECT_EQ(read_image(liar).values, image.values);
    const fs::path photo = folder_.write("photo.txt", read_file(sample_files / "grey.jpg"));
    EXPECT_TRUE(read_image(photo).same_shape(Image(16, 8, 3)));
}

TEST_F(ImageFiles, PlainExrNeedsNoOpenImageIoAndMeansTheSameToIt) {
    const auto by_library = open_own_module("relief-openimageio.so", "").function<DecodeImage>("relief_decode_image");
    for (int channels = 1; channels <= 4; ++channels)
        for (const int height : {1, 16, 40}) {
            const Image image = all_values(7, height, channels, 16);
            const std::string bytes = encode_exr(image, {{"lab", "07_baking"}});
            Notes own, theirs;
            const std::optional<Image> read = decode_plain_exr(bytes, own);
            ASSERT_TRUE(read);
            EXPECT_EQ(read->values, image.values);
            const Image other = by_library(bytes, "openexr", theirs);
            ASSERT_TRUE(other.same_shape(image)) << channels << " channels";
            EXPECT_EQ(other.values, image.values) << channels << " channels, " << height << " rows";
            EXPECT_EQ(own, theirs);
        }
}

TEST_F(ImageFiles, ExrOfOtherProgramsIsReadAsOpenImageIoReadsIt) {
    Notes own, theirs;
    const std::string plain = read_file(sample_files / "plain.exr"), tiles = read_file(sample_files / "tiles.exr");
    const std::optional<Image> read = decode_plain_exr(plain, own);
    ASSERT_TRUE(read);
    const auto by_library = open_own_module("relief-openimageio.so", "").function<DecodeImage>("relief_decode_image");
    EXPECT_EQ(read->values, by_library(plain, "openexr", theirs).values);
    EXPECT_EQ(own, theirs);
    EXPECT_FALSE(decode_plain_exr(tiles, own)) << "tiles of halves are left to OpenImageIO";
    EXPECT_EQ(read_image(sample_files / "tiles.exr").pixel(4, 18)[2], 5 / 8.0f + 18 / 4.0f - 2)
        << "as the file was made";
}

TEST_F(ImageFiles, TheDisplayWindowOfAnExrIsThePicture) {
    const Image stored = all_values(8, 6, 1, 16);
    const std::string exr = encode_image(stored, ImageFormat::exr);
    const auto refusal = [&](const std::array<int32_t, 4>& display) {
        return message_of([&] { decode_image(with_windows(exr, {0, 0, 7, 5}, display)); });
    };
    const Image part = decode_image(with_windows(exr, {0, 0, 7, 5}, {2, 1, 6, 3}));
    ASSERT_TRUE(part.same_shape(Image(5, 3, 1)));
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 5; ++x) EXPECT_EQ(*part.pixel(x, y), *stored.pixel(x + 2, y + 1));
    EXPECT_TRUE(contains(refusal({0, 0, 15, 11}),
                         "its pixels (data window: 8 x 6 from 0, 0) do not fill the picture (display window: 16 x 12 "
                         "from 0, 0)"));
    EXPECT_TRUE(contains(refusal({0, 0, 8, 5}), "do not fill the picture")) << "a column is missing";
    EXPECT_TRUE(contains(refusal({-1, 0, 6, 5}), "do not fill the picture"));
    EXPECT_TRUE(contains(refusal({0, 0, -1, -1}), "it has no pixels"));
}

TEST_F(ImageFiles, AnExrOfIntegersIsRefused) {
    std::string exr = encode_image(Image(2, 2, 1), ImageFormat::exr);
    const std::string channel = "Y\0\x02\0\0\0"s;  // a name, and its type: 2 is floats, 0 integers
    exr[exr.find(channel) + 2] = 0;
    EXPECT_TRUE(contains(message_of([&] { decode_image(exr); }), "integers of 32 bits"));
}

TEST_F(ImageFiles, AreWrittenInTheFormatOfTheirExtension) {
    EXPECT_EQ(format_of("a.png"), ImageFormat::png);
    EXPECT_EQ(format_of("folder.exr/a.PFM"), ImageFormat::pfm);
    EXPECT_EQ(format_of("a.b.ppm"), ImageFormat::ppm);
    EXPECT_EQ(format_of("a.Exr"), ImageFormat::exr);
    for (const char* name : {"a", "a.jpg", "a.png.txt", ".png", "png", "a.png/b", ""})
        EXPECT_TRUE(contains(message_of<UsageError>([&] { format_of(name); }), ".png, .exr, .ppm or .pfm")) << name;
}

/// The error is the only message: libpng must write nothing on standard error.
class NoImages : public testing::Test {
protected:
    void SetUp() override { testing::internal::CaptureStderr(); }
    void TearDown() override { EXPECT_EQ(testing::internal::GetCapturedStderr(), ""); }
};

TEST_F(NoImages, AreRefusedWithTheirName) {
    EXPECT_EQ(file_refusal("a.png", "RIFF\x1a\0\0\0WEBPVP8 "sv),
              "WebP is not read: save the picture as PNG, or floats as OpenEXR");
    EXPECT_TRUE(file_refusal("dem.tif", "II*\0\x08\0\0\0"sv).starts_with("TIFF is not read: "));
    EXPECT_TRUE(file_refusal("a.jpg",
                             "\0\0\0\x1c"
                             "ftypavif"sv)
                    .starts_with("HEIF or AVIF is not read: "));
    EXPECT_EQ(file_refusal("empty.png", ""), "neither PNG, OpenEXR, JPEG, PPM, PFM nor DDS");
    EXPECT_EQ(file_refusal("text.png", "a text\n"), "neither PNG, OpenEXR, JPEG, PPM, PFM nor DDS");
    EXPECT_EQ(file_refusal("a.ppm", "P3\n1 1\n255\n1 2 3"), "neither PNG, OpenEXR, JPEG, PPM, PFM nor DDS")
        << "in letters";
    const TemporaryFolder folder;
    EXPECT_EQ(message_of([&] { read_image(folder.path()); }), folder.path().string() + ": cannot read: not a file");
    EXPECT_TRUE(
        contains(message_of([&] { read_image(folder.path() / "no.png"); }), "no.png: cannot read: No such file"));
}

TEST_F(NoImages, TruncatedFilesAreDamaged) {
    const Image image = all_values(64, 64, 3, 8);
    for (const auto& [name, format] : {std::pair("a.png", ImageFormat::png), {"a.exr", ImageFormat::exr}}) {
        const std::string bytes = encode_image(image, format);
        for (const size_t length :
             {size_t{8}, size_t{20}, size_t{33}, bytes.size() / 4, bytes.size() / 2, bytes.size() * 3 / 4})
            EXPECT_TRUE(file_refusal(name, bytes.substr(0, length)).starts_with("damaged"))
                << name << " after " << length;
    }
}

TEST_F(NoImages, ADamagedByteNeverCrashes) {
    const Image image = all_values(4, 4, 4, 8);
    const TemporaryFolder folder;
    int refused = 0;
    for (const ImageFormat format : {ImageFormat::png, ImageFormat::exr}) {
        const std::string whole = encode_image(image, format);
        for (size_t i = 0; i < whole.size(); ++i) {
            std::string bytes = whole;
            bytes[i] = char(~bytes[i]);
            const fs::path file = folder.write("a", bytes);
            try {
                const Image read = read_image(file);
                EXPECT_EQ(read.values.size(), read.pixel_count() * size_t(read.channels)) << "byte " << i;
            } catch (const Error& error) {
                EXPECT_TRUE(std::string(error.what()).starts_with(file.string()))
                    << "byte " << i << ": " << error.what();
                ++refused;
            }
        }
    }
    EXPECT_GT(refused, 50);
}

TEST_F(NoImages, AHugeHeaderIsRefusedBeforeItsPixelsAreAllocated) {
    const auto header = [](uint32_t width, uint32_t height) {
        const std::string eight_bit_rgb("\x08\x02\x00\x00\x00", 5);
        return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", big_endian(width) + big_endian(height) + eight_bit_rgb) +
               png_chunk("IDAT", "x") + png_chunk("IEND", "");
    };
    for (const auto& [width, height] : {std::pair(100000u, 100000u), {16385u, 1u}, {1u, 16385u}, {16384u, 16384u}})
        EXPECT_TRUE(contains(file_refusal("huge.png", header(width, height)), "at most 16384x16384"))
            << width << "x" << height;
    for (const auto& [width, height] : {std::pair(0u, 5u), {0x7fffffffu, 0x7fffffffu}})
        EXPECT_TRUE(file_refusal("huge.png", header(width, height)).starts_with("damaged")) << width << "x" << height;
    std::string png = header(2, 2);
    png.replace(png.find("IDAT") - 4, 4, "\x70\0\0\0"s);
    EXPECT_TRUE(contains(file_refusal("chunk.png", png), "a chunk has 1879048192 bytes, more than the file"));
    std::string exr = encode_image(Image(2, 2, 1), ImageFormat::exr);
    const std::string window("dataWindow\0box2i\0\x10\0\0\0", 21);
    ASSERT_TRUE(contains(exr, window));
    const std::string small = exr;
    exr.replace(exr.find(window) + window.size() + 8, 8, "\x9f\x86\x01\0\x9f\x86\x01\0"s);  // last column and row 99999
    EXPECT_TRUE(contains(file_refusal("huge.exr", exr), "too large: only one flat image of at most 16384x16384"));
    exr = small;
    exr.replace(exr.find(window) + window.size() - 4, 4, "\xff\xff\xff\x7f"s);  // the size of the value itself
    EXPECT_TRUE(contains(file_refusal("huge.exr", exr), "2147483647 bytes are no box2i"));
    exr = small;
    exr[5] = '\x10';  // the flags in the version
    EXPECT_TRUE(contains(file_refusal("several.exr", exr), "deep, or several images"));
    exr = small;
    const std::string channels("channels\0chlist\0", 16);
    const size_t at = exr.find(channels) + channels.size();
    std::string list;
    for (const char name : {'A', 'B', 'G', 'R', 'Z'}) list += name + std::string(17, '\0');
    list += '\0';
    const unsigned char old_size = static_cast<unsigned char>(exr[at]);
    exr.replace(at, 4 + old_size, std::string(1, char(list.size())) + std::string(3, '\0') + list);
    EXPECT_TRUE(contains(file_refusal("many.exr", exr), "more than 4 channels"));
    EXPECT_TRUE(contains(file_refusal("short.exr", small.substr(0, 40)), "damaged"));
}

}  // namespace
}  // namespace relief
