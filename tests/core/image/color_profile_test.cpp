// Colour profiles of PNG and JPEG: which are named, and that none changes a value.
#include "framework/core/image/color_profile.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/image/file.h"
#include "framework/library/maps/heights.h"
#include "framework/library/maps/normals.h"
#include "tests/core/image/image_bytes.h"
#include "tests/support.h"

namespace relief {
namespace {

using namespace std::string_literals;

/// An ICC profile of a grey or RGB display with a description: a `desc` of version 2, or a `mluc` of version 4.
std::string icc(const std::string& name, bool is_wide, bool is_grey = false) {
    std::string tag;
    if (is_wide) {
        tag =
            "mluc\0\0\0\0\0\0\0\1\0\0\0\x0c"
            "enUS"s +
            big_endian(uint32_t(2 * name.size())) + big_endian(28);
        for (const char c : name) tag += "\0"s + c;
    } else {
        tag = "desc\0\0\0\0"s + big_endian(uint32_t(name.size() + 1)) + name + std::string(80, '\0');
    }
    tag.resize((tag.size() + 3) / 4 * 4);
    std::string header(128, '\0');
    header.replace(8, 1, is_wide ? "\4" : "\2");
    header.replace(12, 12, is_grey ? "mntrGRAYXYZ " : "mntrRGB XYZ ");
    header.replace(36, 4, "acsp");
    header.replace(68, 12, big_endian(0xf6d6) + big_endian(0x10000) + big_endian(0xd32d));  // D50
    header.replace(0, 4, big_endian(uint32_t(144 + tag.size())));
    return header + big_endian(1) + "desc" + big_endian(144) + big_endian(uint32_t(tag.size())) + tag;
}

/// Returns an `iCCP` chunk's bytes.
std::string packed(const std::string& profile) {
    uLongf size = compressBound(uLong(profile.size()));  // stored: libpng refuses very short streams
    std::string bytes(size, '\0');
    compress2(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(profile.data()),
              uLong(profile.size()), 0);
    return "any name\0\0"s + bytes.substr(0, size);
}

Image slope(int channels) {
    Image image(4, 4, channels, 8);
    for (size_t i = 0; i < image.values.size(); ++i) image.values[i] = float(i % 16) / 255;
    return image;
}

TEST(ColorProfile, OfPngIsNamedAndChangesNoValue) {
    const std::string png = bare_png(slope(3));
    EXPECT_EQ(decode_image(png).profile, "");
    const auto profile_of = [&](const std::string& chunk, const std::string& bytes) {
        const Image read = decode_image(with_png_chunk(png, chunk, bytes));
        EXPECT_EQ(read.values, slope(3).values) << chunk;
        return read.profile;
    };
    for (const bool is_wide : {false, true}) {
        EXPECT_EQ(profile_of("iCCP", packed(icc("Wide Gamut RGB", is_wide))), "Wide Gamut RGB");
        EXPECT_EQ(profile_of("iCCP", packed(icc("sRGB IEC61966-2.1", is_wide))), "");
        EXPECT_EQ(profile_of("iCCP", packed(icc("GIMP built-in Linear sRGB", is_wide))), "GIMP built-in Linear sRGB");
    }
    EXPECT_EQ(profile_of("gAMA", big_endian(45455)), "");
    EXPECT_EQ(profile_of("gAMA", big_endian(100000)), "gamma 1");
    EXPECT_EQ(profile_of("gAMA", big_endian(55556)), "gamma 1.80") << "a file of an old Macintosh";
    const std::string both = with_png_chunk(png, "gAMA", big_endian(55556));
    EXPECT_EQ(decode_image(with_png_chunk(both, "sRGB", "\0"s)).profile, "") << "sRGB counts more than gAMA";
    EXPECT_EQ(decode_image(with_png_chunk(both, "iCCP", packed(icc("P3", true)))).profile, "P3") << "and so does iCCP";
    const Image grey =
        decode_image(with_png_chunk(bare_png(slope(1)), "iCCP", packed(icc("Dot Gain 20%", false, true))));
    EXPECT_EQ(grey.profile, "Dot Gain 20%");
}

TEST(ColorProfile, OfJpegIsNamed) {
    const auto jpeg = [](const std::string& profile) {
        const std::string data = "ICC_PROFILE\0\1\1"s + profile;
        return "\xff\xd8\xff\xe0\0\4hi\xff\xe2"s + big_endian(uint32_t(data.size() + 2)).substr(2) + data;
    };
    EXPECT_EQ(jpeg_profile_name(jpeg(icc("Display P3", true))), "Display P3");
    EXPECT_EQ(jpeg_profile_name(jpeg(icc("sRGB", false))), "");
    EXPECT_EQ(jpeg_profile_name(jpeg("")), "unnamed");
    EXPECT_EQ(jpeg_profile_name("\xff\xd8\xff\xe0\0\4hi\xff\xda"s), "");
    const std::string sample = read_file(course_root() / "tests/core/image/files/grey.jpg");
    const std::string with =
        sample.substr(0, 2) + jpeg(icc("Gray Gamma 2.2", false, true)).substr(2) + sample.substr(2);
    EXPECT_EQ(decode_image(with).profile, "Gray Gamma 2.2");
    EXPECT_EQ(decode_image(with).values, decode_image(sample).values);
}

TEST(ColorProfile, OfADamagedProfileIsNoFault) {
    const std::string whole = icc("Wide Gamut RGB", true);
    for (size_t length = 0; length < whole.size(); ++length) icc_profile_name(whole.substr(0, length));
    std::string far = whole;
    far.replace(136, 8, "\xff\xff\xff\xff\xff\xff\xff\xff");  // the tag's place and size
    EXPECT_EQ(icc_profile_name(far), "unnamed");
    EXPECT_EQ(icc_profile_name(icc("a\nb", false)), "a?b");
}

TEST(ColorProfile, IsNotedWhereItWouldChangeWhatIsRead) {
    Image picture = slope(1);
    EXPECT_EQ(profile_note(picture, true), "");
    picture.profile = "gamma 1";
    EXPECT_EQ(profile_note(picture, true), "") << "`relief map` writes it: numbers as stored";
    EXPECT_EQ(profile_note(picture, false),
              "its colour profile (gamma 1) is not applied: its colours are taken as sRGB");
    picture.profile = "Dot Gain 20%";
    const std::string note = "its colour profile (Dot Gain 20%) is not applied: a map's numbers are taken as stored";
    EXPECT_EQ(profile_note(picture, true), note);
    EXPECT_EQ(heights_in(picture).notes, std::vector<std::string>{note});
    std::vector<std::string> notes;
    Image normals = slope(3);
    normals.profile = picture.profile;
    EXPECT_EQ(normals_in(normals, notes).values, normals.values);
    EXPECT_EQ(notes, std::vector<std::string>{note});
}

}  // namespace
}  // namespace relief
