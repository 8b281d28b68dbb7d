// Mip chains in OpenGL's layout: their bytes, and files of them that are complete, truncated or of another picture.
#include "framework/core/image/texels.h"

#include <cstring>

#include "framework/core/image/mips.h"
#include "tests/support.h"

namespace relief {
namespace {

Image ramp(int width, int height, int channels, int bits) {
    Image image(width, height, channels, bits);
    const float largest = bits == 32 ? 1.0f : float((1 << bits) - 1);
    for (size_t i = 0; i < image.values.size(); ++i) image.values[i] = float(i * 37 % 256) / largest;
    return image;
}
Texels chain_of(const Image& image) { return pack(mip_chain(image, ColorSpace::linear), ColorSpace::linear); }

template <class Value>
Value value_at(const Texels& texels, size_t level, size_t index) {
    Value value;
    std::memcpy(&value, texels.levels.at(level).rows + index * sizeof value, sizeof value);
    return value;
}

TEST(Texels, RowsRunUpwardsAndIntegersAreRoundedAndClamped) {
    Image image(1, 2, 2, 16);
    image.values = {1.5f, 0.25f, -1, 0.5f};  // the upper texel, then the lower one
    const Texels texels = pack(std::vector{image}, ColorSpace::linear);
    EXPECT_EQ(value_at<uint16_t>(texels, 0, 0), 0);
    EXPECT_EQ(value_at<uint16_t>(texels, 0, 1), 32768);
    EXPECT_EQ(value_at<uint16_t>(texels, 0, 2), 65535);
    EXPECT_EQ(value_at<uint16_t>(texels, 0, 3), 16384);
}

TEST(Texels, GiveThePictureBackBitForBit) {
    for (const int bits : {8, 16, 32})
        for (const int channels : {1, 2, 3, 4}) {
            const Image image = ramp(7, 5, channels, bits);
            const Image back = unpack(chain_of(image));
            EXPECT_TRUE(back.same_shape(image));
            EXPECT_EQ(back.bits, bits);
            EXPECT_EQ(back.values, image.values) << bits << " bits, " << channels << " channels";
        }
}

TEST(TexelsFile, ContainsTheWholeMipChain) {
    const Texels chain = chain_of(ramp(13, 6, 3, 16));
    const TemporaryFolder folder;
    const auto file = folder.write("a.texels", encode_texels(chain, 77));
    const auto mapped = map_texels(file, 77);
    ASSERT_TRUE(mapped);
    EXPECT_EQ(mapped->bits, 16);
    ASSERT_EQ(mapped->levels.size(), 4u) << "13x6, 6x3, 3x1, 1x1";
    for (size_t i = 0; i < 4; ++i)
        EXPECT_EQ(std::memcmp(mapped->levels[i].rows, chain.levels[i].rows, chain.bytes(chain.levels[i])), 0) << i;
    std::filesystem::remove(file);
    EXPECT_EQ(unpack(*mapped).values, unpack(chain).values) << "it is mapped, not read again";
}

TEST(TexelsFile, IsRejectedForAnotherSource) {
    const std::string bytes = encode_texels(chain_of(ramp(4, 4, 1, 8)), 77);
    EXPECT_TRUE(decode_texels(bytes, 77, {}));
    EXPECT_FALSE(decode_texels(bytes, 78, {}));
}

TEST(TexelsFile, IsRejectedForAnotherLength) {
    const std::string bytes = encode_texels(chain_of(ramp(8, 4, 3, 8)), 77);
    for (size_t length = 0; length < bytes.size(); ++length)
        EXPECT_FALSE(decode_texels(std::string_view(bytes).substr(0, length), 77, {})) << length;
    EXPECT_FALSE(decode_texels(bytes + 'x', 77, {}));
}

TEST(TexelsFile, IsRejectedForAnImpossibleHeader) {
    const std::string bytes = encode_texels(chain_of(ramp(8, 4, 3, 8)), 77);
    const auto with = [&](size_t at, int32_t value) {
        std::string changed = bytes;
        std::memcpy(changed.data() + at, &value, sizeof value);
        return decode_texels(changed, 77, {});
    };
    EXPECT_FALSE(with(4, 0)) << "the magic word's end, with the version";
    for (const size_t at : {16, 20, 24, 28})  // offsets of width, height, channels, bits
        for (const int32_t value : {0, -1, 7, 1 << 30}) EXPECT_FALSE(with(at, value)) << at << ", " << value;
}

TEST(TexelsFile, IsRejectedIfMissingEmptyOrAFolder) {
    const TemporaryFolder folder;
    EXPECT_FALSE(map_texels(folder.path() / "none", 77));
    EXPECT_FALSE(map_texels(folder.write("empty", ""), 77));
    EXPECT_FALSE(map_texels(folder.path(), 77));
}

}  // namespace
}  // namespace relief
