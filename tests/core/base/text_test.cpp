// Numbers from text, and the nearest word to a mistyped one.
#include "framework/core/base/text.h"

#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <random>

#include "tests/support.h"

namespace relief {
namespace {

using Words = std::vector<std::string>;

TEST(Columns, HaveTheUnitsOfTheirNumbersInOneColumn) {
    const Words cells = {"4.25", "11 + 2", "7", "", "-", "2.5/5", "103"};
    const Words aligned = aligned_at_points(cells, 12);
    for (size_t i = 0; i < cells.size(); ++i) {
        EXPECT_EQ(aligned[i].size(), 12u);
        if (cells[i].empty()) continue;
        const size_t begin = aligned[i].find_first_not_of(' ');
        const size_t whole = std::min(cells[i].find_first_of(". /"), cells[i].size());
        EXPECT_EQ(aligned[i].substr(begin, cells[i].size()), cells[i]);
        EXPECT_EQ(begin + whole, 12u - 4) << cells[i] << ": four letters stand behind the units of 11 + 2 and of 2.5/5";
    }
    EXPECT_EQ(aligned_at_points({"1", "10.5"}), (Words{" 1  ", "10.5"}));
    EXPECT_EQ(aligned_at_points({}, 5), Words());
}

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

/// Whether the standard library reads a double, as GCC's does.
template <class Value = double>
constexpr bool library_reads = requires(Value value) {
    std::from_chars("", "", value);
};

/// Returns the number as std::from_chars reads it.
template <class Value = double>
std::optional<Value> from_chars(std::string_view text) {
    if constexpr (library_reads<Value>) {
        Value value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error == std::errc{} && end == text.data() + text.size() && std::isfinite(value)) return value;
    }
    return {};
}

/// Compares bits, because -0 equals 0.
bool is_same(std::optional<double> a, std::optional<double> b) {
    return a.has_value() == b.has_value() && (!a || std::bit_cast<uint64_t>(*a) == std::bit_cast<uint64_t>(*b));
}

/// Returns numbers of every exponent with random mantissas.
std::vector<double> of_every_size(int count) {
    std::mt19937_64 random(1);
    std::vector<double> values;
    while (int(values.size()) < count)
        if (const auto value = std::bit_cast<double>(random()); std::isfinite(value)) values.push_back(value);
    using Limits = std::numeric_limits<double>;
    for (const double value : {Limits::denorm_min(), Limits::min(), Limits::max(), 0.0, 1.0})
        values.push_back(value), values.push_back(-value);
    return values;
}

TEST(Numbers, AreParsedToTheSameBitsAsByTheStandardLibrary) {
    if (!library_reads<>) GTEST_SKIP() << "this standard library has no function to compare with";
    for (const double value : of_every_size(20'000))
        for (const int digits : {1, 3, 9, 15, 17, 40}) {
            const std::string text = fmt::format("{:.{}e}", value, digits - 1);
            ASSERT_TRUE(is_same(parse_number(text), from_chars(text))) << text;
        }
}

TEST(Numbers, AreAcceptedAndRejectedAsByTheStandardLibrary) {
    if (!library_reads<>) GTEST_SKIP() << "this standard library has no function to compare with";
    std::vector<std::string> texts = split(
        "1e-400;-1e-400;0e-999;0e9999;2.4e-324;2.5e-324;4e-324;1e309;-0;-.0e-5;infinity;nan(1);1e00005;1e-;"
        "0x1p3;1.5f;1e5.0;1 e5;1.7976931348623158e308;\t1;1\n;1.7976931348623159e308",
        ';');
    texts.emplace_back("1\0", 2);
    // Every kind of character that has a meaning in some notation, in random order.
    std::mt19937 random(1);
    const std::string_view characters = "0019.-+eExinfa ";
    for (int i = 0; i < 200'000; ++i) {
        std::string& text = texts.emplace_back(1 + random() % 7, ' ');
        for (char& c : text) c = characters[random() % characters.size()];
    }
    int numbers = 0;
    for (const std::string& text : texts) {
        ASSERT_TRUE(is_same(parse_number(text), from_chars(text))) << "'" << text << "'";
        numbers += parse_number(text).has_value();
    }
    EXPECT_GT(numbers, 1000);
    EXPECT_LT(numbers, int(texts.size()) - 1000);
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

TEST(Text, BeginsWithACapitalLetter) {
    EXPECT_EQ(capitalized("probe x: none"), "Probe x: none");
    EXPECT_EQ(capitalized("No change"), "No change");
    EXPECT_EQ(capitalized("\u00e9tage"), "\u00e9tage");
    EXPECT_EQ(capitalized(""), "");
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
