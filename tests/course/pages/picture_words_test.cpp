// Words over a picture as markup: captions by tile, places in percent, and the scale below.
#include "framework/course/pages/picture_words.h"

#include <gtest/gtest.h>

namespace relief::pages {
namespace {

using Kind = PictureWord::Kind;

TEST(PictureWords, GroupTheCaptionsOfATileAtItsTopAndBottom) {
    const PictureWord tile{.kind = Kind::caption, .place = {0.5f, 0}, .size = {0.5f, 1}, .text = "64 steps"};
    PictureWord last = tile, before_last = tile;
    last.text = "8 taps", last.line = -1, before_last.text = "off 2~", before_last.line = -2;
    const std::string shown = picture_words_markup(std::vector{last, tile, before_last});
    EXPECT_NE(shown.find("left:50.00%;top:0.00%;width:50.00%;height:100.00%"), std::string::npos) << shown;
    const size_t top = shown.find("64 steps"), second = shown.find("off 2°"), third = shown.find("8 taps");
    ASSERT_NE(third, std::string::npos) << shown;
    EXPECT_TRUE(top < second && second < third) << shown;
    EXPECT_EQ(shown.find("class=\"tile\"", shown.find("class=\"tile\"") + 1), std::string::npos) << shown;
}

TEST(PictureWords, PlaceATextByItsAnchorAndEscapeIt) {
    const std::string shown =
        picture_words_markup(std::vector{PictureWord{.place = {0.25f, 0.1f}, .text = "a < b", .anchor = 0.5f}});
    EXPECT_NE(shown.find("left:25.00%;top:10.00%"), std::string::npos) << shown;
    EXPECT_NE(shown.find("translateX(-50%)"), std::string::npos) << shown;
    EXPECT_NE(shown.find("a &lt; b"), std::string::npos) << shown;
}

TEST(PictureWords, OfAnErrorMapAreAScaleWithNumbers) {
    const std::string shown = picture_words_markup(std::vector{error_map_scale("2.5 texels")});
    EXPECT_NE(shown.find("class=\"heat\"><span>0</span>"), std::string::npos) << shown;
    EXPECT_NE(shown.find("<span>2.5 texels and more</span>"), std::string::npos) << shown;
}

TEST(PictureWords, AreNothingWithoutWords) { EXPECT_EQ(picture_words_markup({}), ""); }

}  // namespace
}  // namespace relief::pages
