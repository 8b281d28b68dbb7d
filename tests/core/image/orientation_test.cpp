// The EXIF orientation of pictures: all eight, in JPEG and PNG, with either byte order.
#include "framework/core/image/orientation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "framework/core/image/file.h"
#include "tests/core/image/image_bytes.h"
#include "tests/support.h"

namespace relief {
namespace {

using namespace std::string_literals;

std::string number(uint32_t value, int bytes, bool big_endian) {
    std::string text;
    for (int i = 0; i < bytes; ++i) text += char(value >> 8 * (big_endian ? bytes - 1 - i : i) & 255);
    return text;
}

/// EXIF data with two tags, of which the second is the orientation.
std::string exif(int orientation, bool big_endian) {
    const auto n = [&](uint32_t value, int bytes) { return number(value, bytes, big_endian); };
    return (big_endian ? "MM"s : "II"s) + n(42, 2) + n(8, 4) + n(2, 2) + n(0x100, 2) + n(4, 2) + n(1, 4) + n(3, 4) +
           n(0x112, 2) + n(3, 2) + n(1, 4) + n(uint32_t(orientation), 2) + n(0, 2) + n(0, 4);
}

std::string png_with(const std::string& exif_bytes, const Image& image) {
    return with_png_chunk(encode_image(image, ImageFormat::png), "eXIf", exif_bytes);
}

/// The sides on which an orientation shows the first row and the first column, by the table of EXIF.
struct ShownSides {
    const char *first_row, *first_column;
};
constexpr ShownSides sides_of_orientations[] = {{"top", "left"},     {"top", "right"},  {"bottom", "right"},
                                                {"bottom", "left"},  {"left", "top"},   {"right", "top"},
                                                {"right", "bottom"}, {"left", "bottom"}};

TEST(Orientation, PutsTheFirstRowAndColumnOnTheSidesThatExifNames) {
    Image stored(3, 2, 1, 8);
    for (size_t i = 0; i < 6; ++i) stored.values[i] = float(i) / 255;  // first row 0 1 2, first column 0 3
    for (int orientation = 1; orientation <= 8; ++orientation) {
        const Image shown = oriented(stored, orientation);
        const auto on_side = [&](const std::string& edge, int i) {
            const int x = edge == "left" ? 0 : edge == "right" ? shown.width - 1 : i;
            const int y = edge == "top" ? 0 : edge == "bottom" ? shown.height - 1 : i;
            return int(std::round(*shown.pixel(x, y) * 255));
        };
        const auto [first_row, first_column] = sides_of_orientations[orientation - 1];
        const bool upright = orientation <= 4;
        ASSERT_EQ(shown.width, upright ? 3 : 2);
        ASSERT_EQ(shown.height, upright ? 2 : 3);
        std::set<int> row, column;
        for (int i = 0; i < 3; ++i) row.insert(on_side(first_row, i));
        for (int i = 0; i < 2; ++i) column.insert(on_side(first_column, i));
        EXPECT_EQ(row, (std::set<int>{0, 1, 2})) << orientation;
        EXPECT_EQ(column, (std::set<int>{0, 3})) << orientation;
    }
}

TEST(Orientation, IsAppliedToPngAndJpegInBothByteOrders) {
    Image stored(3, 2, 1, 8);
    for (size_t i = 0; i < 6; ++i) stored.values[i] = float(i) / 255;
    for (const bool big_endian : {false, true})
        for (int orientation = 1; orientation <= 8; ++orientation) {
            const std::string png = png_with(exif(orientation, big_endian), stored);
            EXPECT_EQ(decode_image(png).values, oriented(stored, orientation).values) << orientation;
            const std::string segment = "Exif\0\0"s + exif(orientation, big_endian);
            const std::string marker = "\xff\xe1" + number(uint32_t(segment.size()) + 2, 2, true) + segment;
            const std::string jfif = "\xff\xe0\0\x04hi"s;
            EXPECT_EQ(exif_orientation("\xff\xd8" + jfif + "\xff" + marker), orientation) << "behind another segment";
        }
    EXPECT_EQ(exif_orientation(png_with(exif(9, true), stored)), 1) << "no orientation";
}

TEST(Orientation, OfDamagedExifDataIsAsStored) {
    Image stored(3, 2, 1, 8);
    const std::string whole = exif(6, true);
    for (size_t length = 0; length + 6 < whole.size(); ++length)  // the end behind the value has no meaning
        EXPECT_TRUE(exif_orientation(png_with(whole.substr(0, length), stored)) == 1 || length >= 32) << length;
    EXPECT_EQ(exif_orientation("\xff\xd8\xff"), 1);
    EXPECT_EQ(exif_orientation("\xff\xd8\xff\xe1\0\0Exif"s), 1);
    EXPECT_EQ(exif_orientation("\x89PNG"), 1);
}

}  // namespace
}  // namespace relief
