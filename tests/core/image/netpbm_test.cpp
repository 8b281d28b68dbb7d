// PPM, PGM and PFM: round trips, and a clear one-line error for invalid files.
#include "framework/core/image/netpbm.h"

#include <cmath>
#include <limits>

#include "tests/support.h"

namespace relief {
namespace {

using namespace std::string_literals;

TEST(Netpbm, PpmKeepsEveryValueOf8Bits) {
    Image image(16, 16, 3, 8);
    for (size_t i = 0; i < image.values.size(); ++i) image.values[i] = float(i % 256) / 255;
    const Image back = decode_netpbm(encode_ppm(image));
    EXPECT_EQ(back.bits, 8);
    EXPECT_TRUE(back.same_shape(image));
    EXPECT_EQ(back.values, image.values);
}

TEST(Netpbm, PfmKeepsEveryFloatOfOneAndOfThreeChannels) {
    for (const int channels : {1, 3}) {
        Image image(3, 2, channels);
        for (size_t i = 0; i < image.values.size(); ++i) image.values[i] = float(i) - 2.5f;
        image.values[0] = std::numeric_limits<float>::infinity(), image.values[1] = 1e-45f;
        const Image back = decode_netpbm(encode_pfm(image));
        EXPECT_TRUE(back.same_shape(image));
        EXPECT_EQ(back.values, image.values);
    }
}

TEST(Netpbm, ReadsCommentsBigEndianAnd16Bits) {
    const Image grey = decode_netpbm("P5 # grey\n# and more\n2\t1\r\n65535\n\xff\xff\x80\x00"s);
    EXPECT_EQ(grey.bits, 16);
    EXPECT_EQ(grey.values, (std::vector<float>{1, 32768 / 65535.0f}));
    const Image big_endian = decode_netpbm("Pf\n1 1\n1.0\n\x3f\x80\x00\x00"s);
    EXPECT_EQ(big_endian.values, std::vector<float>{1});
    EXPECT_EQ(decode_netpbm("P5 1 1 7 \x09"s).values, std::vector<float>{1}) << "no value is above the largest";
}

TEST(Netpbm, ReportsTheReasonOfAnError) {
    const auto refusal = [](const std::string& bytes) { return message_of([&] { decode_netpbm(bytes); }); };
    EXPECT_TRUE(contains(refusal(""), "neither"));
    EXPECT_TRUE(contains(refusal("P3\n1 1\n255\n1 2 3"), "neither"));
    EXPECT_TRUE(contains(refusal("P6\n2"), "before its height"));
    EXPECT_TRUE(contains(refusal("P6\n# no end"), "before its width"));
    EXPECT_TRUE(contains(refusal("P6\n2 x 255\n"), "height is 'x'"));
    EXPECT_TRUE(contains(refusal("P6\n0 1 255\n"), "width is '0'"));
    EXPECT_TRUE(contains(refusal("P6\n99999 1 255\n"), "from 1 to 16384"));
    EXPECT_TRUE(contains(refusal("P6\n16384 16384 255\n"), "at most 1024 MiB"));
    EXPECT_TRUE(contains(refusal("P6\n2 1 255\n12345"), "1 bytes of 6 are missing"));
    EXPECT_TRUE(contains(refusal("P6\n2 1 70000\n123456"), "largest value"));
    EXPECT_TRUE(contains(refusal("PF\n1 1\n0\n123456789012"), "scale"));
    EXPECT_TRUE(contains(refusal("PF\n1 1\n-2\n123456789012"), "its scale is -2: only 1 and -1"));
}

TEST(Netpbm, AHeaderThatEndsWithOneByteTooManyIsRefused) {
    const auto refusal = [](const std::string& bytes) { return message_of([&] { decode_netpbm(bytes); }); };
    for (const std::string header : {"P5\r\n2 1\r\n255\r\n", "P5 2 1 255\r\n"})
        EXPECT_TRUE(contains(refusal(header + "ab"), "its header ends with CR LF: one byte too many")) << header;
    EXPECT_TRUE(contains(refusal("Pf\r\n1 1\r\n-1.0\r\nabcd"), "CR LF"));
    EXPECT_TRUE(contains(refusal("P6\r\n1 1\r\n255\r\nabc"), "CR LF"));
    EXPECT_TRUE(contains(refusal("P5\n2 1\n255 \nab"), "two white spaces"));
    // A carriage return alone is a white space, and the first value may be 10.
    EXPECT_EQ(decode_netpbm("P5 2 1 255\r\n\x01"s).values, (std::vector<float>{10 / 255.0f, 1 / 255.0f}));
    EXPECT_EQ(decode_netpbm("P5\r\n2 1\r\n255\n\x0a\x01"s).values, (std::vector<float>{10 / 255.0f, 1 / 255.0f}));
}

}  // namespace
}  // namespace relief
