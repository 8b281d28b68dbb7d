// Words over a picture as markup: captions by tile, places in percent, and the scale below.
#include "framework/course/pages/picture_words.h"

#include <gtest/gtest.h>

namespace relief::pages {
namespace {

using Kind = PictureWord::Kind;

TEST(PictureWords, GroupTheCaptionsOfATileAtItsTopAndBottom) {
    const PictureWord tile{.kind = Kind::caption, .place = {0.5f, 0}, .size = {0.5f, 1}, .text = "64 steps"};
    PictureWord last = tile, before_last = tile;
    last.text = "8 taps", last.line = -1, before_last.text = "off 2°", before_last.line = -2;
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

TEST(PictureWords, OfOneHeightAreALineWithItsColor) {
    const PictureWord name{.place = {0.7f, 0.5f}, .size = {0, 0.03f}, .text = "Brick"};
    PictureWord number = name, next = name;
    number.place.x = 0.9f, number.text = "140", next.place.y = 0.55f, next.text = "Stone";
    const PictureWord swatch{.kind = Kind::box, .place = {0.68f, 0.5f}, .size = {0.01f, 0.03f}, .color = {1, 0, 0, 1}};
    const PictureWord plate{.kind = Kind::box, .place = {0.6f, 0.4f}, .size = {0.4f, 0.6f}, .color = {0, 0, 1, 1}};
    const std::string shown = picture_words_markup(std::vector{plate, swatch, name, next, number});
    const size_t line = shown.find("class=\"line\""), red = shown.find("rgb(255 0 0"), brick = shown.find("Brick"),
                 count = shown.find("140"), second = shown.find("class=\"line\"", count), stone = shown.find("Stone");
    ASSERT_NE(stone, std::string::npos) << shown;
    EXPECT_TRUE(line < red && red < brick && brick < count && count < second && second < stone) << shown;
    EXPECT_LT(shown.find("rgb(0 0 255"), line) << "a plate behind all lines is no swatch: " << shown;
    EXPECT_EQ(shown.find("rgb(255 0 0", red + 1), std::string::npos) << shown;
}

TEST(PictureWords, AreApartFromMarksOfPlaces) {
    const PictureWord mark{.kind = Kind::box, .place = {0.1f, 0.1f}, .size = {0.02f, 0.02f}, .color = {1, 0, 0, 1}};
    const PictureWord plate{.kind = Kind::box, .place = {0.4f, 0.4f}, .size = {0.5f, 0.5f}, .color = {0, 0, 1, 1}};
    const PictureWord text{.place = {0.5f, 0.5f}, .size = {0, 0.05f}, .text = "text"};
    const std::string shown = picture_words_markup(std::vector{plate, text, mark});
    const size_t over = shown.find("class=\"over\"");
    EXPECT_LT(shown.find("class=\"mark\" style=\"left:10.00%"), over) << shown;
    EXPECT_LT(shown.find("class=\"behind\" style=\"left:40.00%"), over) << shown;
}

TEST(PictureWords, OfALegendInOneRowAreALineForEachColor) {
    const PictureWord one{.place = {0.1f, 0.9f}, .size = {0, 0.05f}, .text = "one"};
    PictureWord two = one;
    two.place.x = 0.4f, two.text = "two";
    const PictureWord red{.kind = Kind::box, .place = {0.05f, 0.9f}, .size = {0.04f, 0.05f}, .color = {1, 0, 0, 1}};
    PictureWord green = red;
    green.place.x = 0.35f, green.color = {0, 1, 0, 1};
    const std::string shown = picture_words_markup(std::vector{two, one, red, green});
    const size_t first = shown.find("rgb(255 0 0"), second = shown.find("rgb(0 255 0"),
                 line = shown.find("line", first);
    ASSERT_NE(second, std::string::npos) << shown;
    EXPECT_TRUE(first < shown.find("one") && shown.find("one") < line && line < second && second < shown.find("two"))
        << shown;
}

TEST(PictureWords, OfAnErrorMapAreAScaleWithNumbers) {
    const std::string shown = picture_words_markup(std::vector{error_map_scale("2.5 texels")});
    EXPECT_NE(shown.find("class=\"heat\"><span>0</span>"), std::string::npos) << shown;
    EXPECT_NE(shown.find("<span>2.5 texels and more</span>"), std::string::npos) << shown;
}

TEST(PictureWords, OfALegendAreInTheirTileBelowItsCaptions) {
    const PictureWord title{.kind = Kind::caption, .place = {0.5f, 0}, .size = {0.5f, 1}, .text = "above"};
    PictureWord entry = title;
    entry.kind = Kind::legend, entry.text = "64", entry.color = {1, 0, 0, 1};
    const std::string shown = picture_words_markup(std::vector{title, entry});
    const size_t above = shown.find("above"), swatch = shown.find("background:rgb(255 0 0"),
                 name = shown.find("64</span>");
    ASSERT_NE(name, std::string::npos) << shown;
    EXPECT_TRUE(above < swatch && swatch < name) << shown;
    EXPECT_EQ(shown.find("class=\"number\""), std::string::npos) << "one tile needs no number: " << shown;
}

TEST(PictureWords, OfEachOfSeveralTilesHaveItsNumberInThePicture) {
    const PictureWord left{.kind = Kind::caption, .place = {0, 0}, .size = {0.5f, 1}, .text = "one"};
    PictureWord right = left;
    right.place.x = 0.5f, right.text = "two";
    const std::string shown = picture_words_markup(std::vector{left, right});
    EXPECT_NE(shown.find("<i class=\"number\" style=\"left:50.00%;top:0.00%\">2</i>"), std::string::npos) << shown;
}

TEST(PictureWords, OfANoteAreBelowThePicture) {
    const std::string shown =
        picture_words_markup(std::vector{PictureWord{.kind = Kind::note, .text = "m.obj: has no uv"}});
    EXPECT_NE(shown.find("<span class=\"note\">m.obj: has no uv</span>"), std::string::npos) << shown;
}

TEST(PictureWords, AreNothingWithoutWords) { EXPECT_EQ(picture_words_markup({}), ""); }

}  // namespace
}  // namespace relief::pages
