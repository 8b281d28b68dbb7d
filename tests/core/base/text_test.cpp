// Numbers from text, and the nearest word to a mistyped one.
#include "framework/core/base/text.h"

#include <cmath>
#include <limits>
#include <random>

#include "tests/support.h"

namespace relief {
namespace {

using Words = std::vector<std::string>;

TEST(Numbers, AreParsedInEveryDecimalNotation) {
    for (const auto& [text, value] : std::vector<std::pair<std::string, double>>{
             {"0", 0}, {"32", 32}, {"-1.5", -1.5}, {".5", 0.5}, {"2.", 2}, {"1e3", 1000}, {"-2.5E-1", -0.25}})
        EXPECT_EQ(parse_number(text), value) << text;
}

TEST(Numbers, MustBeFiniteWithoutTrailingText) {
    for (const char* text : {"", " ", "1x", "x1", "1 ", " 1", "1,5", "0x10", "nan", "-nan", "inf", "-inf", "infinity",
                             "1e999", "-1e999", "1e", "--1", "."})
        EXPECT_EQ(parse_number(text), std::nullopt) << "'" << text << "'";
}

TEST(Backticks, AreDroppedWithOrWithoutAPartner) {
    EXPECT_EQ(without_backticks("`along` is *divided*: times `depth`"), "along is *divided*: times depth");
    EXPECT_EQ(without_backticks("a ` b"), "a  b");
    EXPECT_EQ(without_backticks(""), "");
}

TEST(Integers, MustFitAndBeWhole) {
    EXPECT_EQ(parse_int("-7"), -7);
    EXPECT_EQ(parse_int("007"), 7);
    EXPECT_EQ(parse_int("2147483647"), std::numeric_limits<int>::max());
    EXPECT_EQ(parse_int("-2147483648"), std::numeric_limits<int>::min());
    for (const char* text : {"", "1.0", "1e2", "2147483648", "-2147483649", "3 ", "0x3", "three"})
        EXPECT_EQ(parse_int(text), std::nullopt) << "'" << text << "'";
}

TEST(Numbers, ArePrintedAsTyped) {
    EXPECT_EQ(plain(0.5), "0.5");
    EXPECT_EQ(plain(32), "32");
    EXPECT_EQ(plain(0.1f), "0.1");
    EXPECT_EQ(plain(-2.25), "-2.25");
}

TEST(Numbers, InTheUsualRangeHaveNoExponent) {
    EXPECT_EQ(rounded(1000), "1000");
    EXPECT_EQ(rounded(999.6), "1000");
    EXPECT_EQ(rounded(37474.6, 4), "37475");
    EXPECT_EQ(rounded(37.474, 4), "37.47");
    EXPECT_EQ(rounded(-12345), "-12345");
    EXPECT_EQ(rounded(0.00001), "0.00001");
    EXPECT_EQ(rounded(0.0000123456), "0.0000123");
    EXPECT_EQ(rounded(-0.0000999999), "-0.0001");
    EXPECT_EQ(rounded(0), "0");
    EXPECT_EQ(plain(16777216), "16777216");
    EXPECT_EQ(rounded(5.58e-8), "5.58e-08");
    EXPECT_EQ(rounded(2.5e13), "2.5e+13");
    EXPECT_EQ(rounded(INFINITY), "inf");
}

TEST(Numbers, TakePluralUnitsUnlessTheyAre1) {
    EXPECT_EQ(amount_of(37.474, "degree", 4), "37.47 degrees");
    EXPECT_EQ(amount_of(1, "pixel"), "1 pixel");
    EXPECT_EQ(amount_of(0.9999, "pixel"), "1 pixel");
    EXPECT_EQ(amount_of(0, "texel"), "0 texels");
    EXPECT_EQ(amount_of(0.1, "height per tile"), "0.1 heights per tile");
    EXPECT_EQ(amount_of(2, "patch"), "2 patches");
    EXPECT_EQ(amount_of(0.25, ""), "0.25");
}

TEST(Split, KeepsEmptyPartsAndJoinUndoesIt) {
    EXPECT_EQ(split("a,,b", ','), (Words{"a", "", "b"}));
    EXPECT_EQ(split("", ','), Words{""});
    EXPECT_EQ(split(",", ','), (Words{"", ""}));
    for (const char* text : {"", ",", "a,,b,", "no separator"}) EXPECT_EQ(join(split(text, ','), ","), text);
}

TEST(EditDistance, CountsInsertionsDeletionsSubstitutionsAndSwaps) {
    const struct {
        const char *a, *b;
        int distance;
    } cases[] = {
        {"", "", 0},
        {"", "abc", 3},
        {"steps", "steps", 0},
        {"steps", "step", 1},
        {"steps", "stepss", 1},
        {"steps", "stops", 1},
        {"stpes", "steps", 1},
        {"kitten", "sitting", 3},
        {"Scale", "sCALE", 0},
        {"ab", "ba", 1},
        {"abcd", "badc", 2},
        {"ca", "abc", 3},  // optimal string alignment: a swapped pair is not edited again (Boytsov 2011)
    };
    for (const auto& [a, b, distance] : cases) EXPECT_EQ(edit_distance(a, b), distance) << a << ", " << b;
}

TEST(EditDistance, IsSymmetricAndBounded) {
    const unsigned seed = 20240607;
    std::mt19937 random(seed);
    const auto word = [&] {
        std::string text(random() % 8, ' ');
        for (char& c : text) c = char('a' + random() % 3);
        return text;
    };
    for (int i = 0; i < 2000; ++i) {
        const std::string a = word(), b = word();
        const int distance = edit_distance(a, b), longer = int(std::max(a.size(), b.size())),
                  shorter = int(std::min(a.size(), b.size()));
        ASSERT_EQ(distance, edit_distance(b, a)) << a << ", " << b << ", seed " << seed;
        ASSERT_GE(distance, longer - shorter) << a << ", " << b << ", seed " << seed;
        ASSERT_LE(distance, longer) << a << ", " << b << ", seed " << seed;
        ASSERT_EQ(distance == 0, a == b) << a << ", " << b << ", seed " << seed;
    }
}

TEST(Nearest, FindsAMistypedWordAndReturnsNoneForADistantOne) {
    const Words known = {"steps", "scale", "displacement"};
    EXPECT_EQ(nearest("stpes", known), "steps");
    EXPECT_EQ(nearest("SCALE", known), "scale");
    EXPECT_EQ(nearest("displ", known), "displacement") << "a beginning";
    EXPECT_EQ(nearest("st", known), "steps") << "a beginning";
    EXPECT_EQ(nearest("gloss", known), std::nullopt);
    EXPECT_EQ(nearest("", known), std::nullopt);
    EXPECT_EQ(nearest("steps", Words{}), std::nullopt);
    EXPECT_EQ(nearest("us", Words{"uv", "depth"}), "uv") << "one letter, in a short word";
}

TEST(Unknown, NamesTheNearestWordAndAllKnownOnes) {
    const Words known = {"steps", "scale"};
    EXPECT_EQ(unknown("knob", "stpes", known), "unknown knob 'stpes': did you mean 'steps'? There are: steps, scale");
    EXPECT_EQ(unknown("knob", "gloss", known), "unknown knob 'gloss'; there are: steps, scale");
    EXPECT_EQ(unknown("check", "x", Words{"up", "up, left"}), "unknown check 'x'; there are: 'up', 'up, left'");
    EXPECT_EQ(unknown("knob", "gloss", Words{}), "unknown knob 'gloss'; there is no knob here");
}

TEST(ShellWords, SurviveTheShellUnchanged) {
    EXPECT_EQ(quoted_for_shell("a b"), "'a b'");
    EXPECT_EQ(quoted_for_shell("o'd $x"), "'o'\\''d $x'");
    EXPECT_EQ(quoted_for_shell(""), "''");
}

}  // namespace
}  // namespace relief
