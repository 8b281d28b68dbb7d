// Words over a picture: where their letters are.
#include "framework/library/kit/word_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/words.h"

namespace relief {
namespace {

using Kind = PictureWord::Kind;

const Letters letters{.width = [](const std::string& text, float height) { return 0.5f * height * float(text.size()); },
                      .usual = 20,
                      .least = 12,
                      .even = true};

PictureWord caption(const std::string& text, glm::vec2 place, glm::vec2 size, int line = 0) {
    return {.kind = Kind::caption, .place = place, .size = size, .text = text, .line = line};
}

/// Returns the texts of one word, from the top.
std::vector<PlacedWord> texts_of(const WordLayout& layout, size_t word) {
    std::vector<PlacedWord> texts;
    for (const PlacedWord& placed : layout.placed)
        if (placed.kind == PlacedWord::Kind::text && placed.of == word) texts.push_back(placed);
    return texts;
}

TEST(WordLayout, ACaptionShrinksThenBreaksAndIsThenLeftOut) {
    const auto placed = [](float wide) {
        return lay_out({caption("two words", {0, 0}, {wide, 400})}, {800, 400}, letters);
    };
    // Nine letters are 4.5 heights wide; beside them are half a height and two pixels.
    const std::vector<PlacedWord> whole = texts_of(placed(200), 0), small = texts_of(placed(84), 0),
                                  broken = texts_of(placed(60), 0);
    ASSERT_EQ(whole.size(), 1u);
    EXPECT_EQ(whole[0].size, glm::vec2(90, 20));
    EXPECT_EQ(whole[0].place.x, 55);
    ASSERT_EQ(small.size(), 1u);
    EXPECT_LT(small[0].size.y, 20);
    ASSERT_EQ(broken.size(), 2u);
    EXPECT_EQ(broken[0].text + " " + broken[1].text, "two words");
    EXPECT_LT(broken[0].place.y + broken[0].size.y, broken[1].place.y + 1);
    const WordLayout none = placed(20);
    EXPECT_TRUE(none.placed.empty());
    EXPECT_EQ(none.left_out, std::vector<std::string>{"two words"});
}

TEST(WordLayout, TitlesOfAllTilesHaveOneHeight) {
    const WordLayout layout = lay_out(
        {caption("a", {0, 0}, {100, 200}), caption("a longer title", {100, 0}, {100, 200})}, {200, 200}, letters);
    EXPECT_EQ(texts_of(layout, 0).at(0).size.y, texts_of(layout, 1).at(0).size.y);
    EXPECT_LT(texts_of(layout, 0).at(0).size.y, 20);
}

TEST(WordLayout, ALowTileKeepsItsTitle) {
    const WordLayout layout =
        lay_out({caption("last", {0, 0}, {200, 28}, -1), caption("title", {0, 0}, {200, 28})}, {200, 28}, letters);
    EXPECT_EQ(texts_of(layout, 1).size(), 1u);
    EXPECT_EQ(layout.left_out, std::vector<std::string>{"last"});
}

TEST(WordLayout, AFootHasAllCaptionsFromTheTitleToTheLastLineAndNoneIsOverThePicture) {
    for (const float high : {90.0f, 150.0f, 400.0f}) {
        const float foot = foot_height(high, 3, letters);
        std::vector<PictureWord> words = {caption("last line", {0, 0}, {220, high}, -1),
                                          caption("second line", {0, 0}, {220, high}, -2),
                                          caption("title", {0, 0}, {220, high})};
        for (PictureWord& word : words) word.foot = foot;
        const WordLayout layout = lay_out(words, {220, high}, letters);
        EXPECT_TRUE(layout.left_out.empty()) << high << ": " << layout.left_out.front();
        float before = high - foot;  // the picture is above
        for (const size_t i : {2, 1, 0}) {
            const PlacedWord text = texts_of(layout, i).at(0);
            EXPECT_GE(text.place.y, before) << high << ": " << text.text;
            before = text.place.y + text.size.y;
        }
        EXPECT_EQ(faults_of_words(words, {220, high}, letters), "") << high;
    }
}

TEST(WordLayout, ALegendHasAStripBelowTheCaptions) {
    std::vector<PictureWord> words = {caption("last line", {100, 0}, {120, 300}, -1)};
    for (const char* const level : {"1", "2", "4", "8", "16", "32", "64"})
        words.push_back({.kind = Kind::legend, .place = {100, 0}, .size = {120, 300}, .text = level});
    const WordLayout layout = lay_out(words, {220, 300}, letters);
    EXPECT_TRUE(layout.left_out.empty());
    const auto strip = std::find_if(layout.placed.begin(), layout.placed.end(), [](const PlacedWord& word) {
        return word.kind == PlacedWord::Kind::ground && word.size.x == 120;
    });
    ASSERT_NE(strip, layout.placed.end());
    EXPECT_EQ(strip->place.x, 100);
    EXPECT_EQ(strip->place.y + strip->size.y, 300);
    EXPECT_LE(texts_of(layout, 0).at(0).place.y + texts_of(layout, 0).at(0).size.y, strip->place.y);
    for (size_t i = 1; i < words.size(); ++i) {
        const PlacedWord text = texts_of(layout, i).at(0);
        EXPECT_GE(text.place.y, strip->place.y);
        EXPECT_LE(text.place.x + text.size.x, 220);
    }
    EXPECT_EQ(faults_of_words(words, {220, 300}, letters), "");
}

TEST(WordLayout, TheNumbersOfAScaleStayInThePicture) {
    for (const float wide : {120.0f, 200.0f, 800.0f}) {
        const std::vector<PictureWord> words = {{.kind = Kind::scale,
                                                 .place = {0.3f * wide, 282},
                                                 .size = {0.4f * wide, 12},
                                                 .text = "1",
                                                 .end = "256 iterations",
                                                 .parts = 8}};
        EXPECT_EQ(faults_of_words(words, {wide, 300}, letters), wide < 200 ? "left out: 1 to 256 iterations\n" : "");
    }
}

TEST(WordLayout, NotesAreAboveTheScaleAndBelowTheCaptions) {
    std::vector<PictureWord> words = {
        {.kind = Kind::scale, .place = {60, 285}, .size = {80, 10}, .text = "0", .end = "1"},
        caption("above", {0, 0}, {200, 280}, -1)};
    for (const char* const note : {"stones.png: a note of more than one line", "another.png: is also a file"})
        words.push_back({.kind = Kind::note, .text = note});
    EXPECT_EQ(faults_of_words(words, {200, 300}, letters), "");
    for (int i = 0; i < 20; ++i) words.push_back(words.back());
    const WordLayout many = lay_out(words, {200, 300}, letters);
    EXPECT_TRUE(std::any_of(many.placed.begin(), many.placed.end(), [](const PlacedWord& word) {
        return word.text.starts_with("and ") && word.text.ends_with(" more") && word.place.y > 150;
    }));
    // One ground is behind all of them.
    EXPECT_EQ(
        std::count_if(many.placed.begin(), many.placed.end(),
                      [](const PlacedWord& word) { return word.kind == PlacedWord::Kind::ground && word.of >= 2; }),
        1);
}

TEST(WordLayout, NotesAreLegibleAndWholeInAPictureOfAnySize) {
    const std::string note =
        "terrain.exr: 17 texels hold -9999, far from all others (1047.25 to 1270.5): voids, filled from the heights "
        "around them, and " +
        std::string(90, 'x') + " is a word that no line has room for";
    const auto without_blanks = [](std::string text) {
        text.erase(std::remove(text.begin(), text.end(), ' '), text.end());
        return text;
    };
    for (const glm::ivec2 size : {glm::ivec2(343, 571), {512, 512}, {160, 120}}) {
        const std::vector<PictureWord> one = {{.kind = Kind::note, .text = note}};
        std::string all;
        for (const PlacedWord& line : texts_of(lay_out(one, size, letters), 0)) all += line.text;
        EXPECT_TRUE(size.x <= 160 || without_blanks(all) == without_blanks(note)) << all;
        const std::vector<PictureWord> many(20, {.kind = Kind::note, .text = "m.obj:7: 'l' is not read"});
        EXPECT_EQ(faults_of_words(one, size, letters) + faults_of_words(many, size, letters), "") << size.x;
    }
}

// A caption is whole or left out, in its tile, and touches no other, in tiles of any size.
TEST(WordLayout, NoTextIsCutOrOverlapsAnother) {
    std::mt19937 dice(1);
    const auto between = [&](int low, int high) { return low + int(dice() % unsigned(high - low + 1)); };
    for (int i = 0; i < 2000; ++i) {
        const int columns = between(1, 6), rows = between(1, 5);
        const glm::ivec2 size(between(20, 1000), between(20, 1000));
        std::vector<PictureWord> words;
        for (int tile = 0; tile < columns * rows; ++tile) {
            const glm::vec2 extent(float(size.x) / float(columns), float(size.y) / float(rows));
            const glm::vec2 place = extent * glm::vec2(tile % columns, tile / columns);
            for (int line = -2; line <= 1; ++line) {
                std::string text;
                for (int word = between(0, 4); word > 0; --word)
                    text += std::string(size_t(between(1, 9)), 'x') + (word > 1 ? " " : "");
                if (!text.empty()) words.push_back(caption(text, place, extent, line));
            }
            if (between(0, 2) == 0)
                for (int entry = between(1, 7); entry > 0; --entry)
                    words.push_back(
                        {.kind = Kind::legend, .place = place, .size = extent, .text = "entry", .line = entry / 4});
        }
        const std::string faults = faults_of_words(words, size, letters, true);
        ASSERT_EQ(faults, "") << i << ": " << size.x << " x " << size.y << ", " << columns << " x " << rows;
    }
}

}  // namespace
}  // namespace relief
