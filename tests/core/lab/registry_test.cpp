// Finding labs by number and name.
#include "framework/core/lab/registry.h"

#include "framework/core/lab/lab.h"
#include "tests/support.h"

namespace relief {
namespace {

const LabRegistration one("01_shine", nullptr), three("03_bricks", nullptr), ten("10_far_view", nullptr),
    twelve("12_exact_view", nullptr);

std::vector<int> numbers(const std::string& text) {
    std::vector<int> found;
    for (const LabEntry* lab : find_labs(text)) found.push_back(lab->number);
    return found;
}

TEST(FindLabs, AcceptsNumbersNamesAndRangesAndReturnsEachLabOnceInOrder) {
    using Numbers = std::vector<int>;
    EXPECT_EQ(numbers("1"), Numbers{1});
    EXPECT_EQ(numbers("1-5"), (Numbers{1, 3}));
    EXPECT_EQ(numbers("10-12,1"), (Numbers{1, 10, 12}));
    EXPECT_EQ(numbers("3,bricks,2-3,03_bricks"), Numbers{3});
}

TEST(FindLab, MatchesTheBeginningsOfWordsOnly) {
    EXPECT_EQ(find_lab("bri").number, 3);
    EXPECT_EQ(find_lab("far").number, 10);
    EXPECT_EQ(find_lab("exact_v").number, 12);
    for (const char* text : {"ricks", "ar", "act_view", "_view"})
        EXPECT_TRUE(contains(message_of<UsageError>([&] { find_lab(text); }), "unknown lab")) << text;
}

TEST(FindLab, ReportsATaskNumberAsNoLab) {
    EXPECT_EQ(message_of<UsageError>([] { find_lab("10.2"); }), "'10.2' is a task of lab 10: say 10");
    for (const char* text : {"11.1", "10.", ".1", "10.x", "1.2.3"})
        EXPECT_TRUE(contains(message_of<UsageError>([&] { find_lab(text); }), "unknown lab")) << text;
}

TEST(FindLabs, ReportsThePartThatMatchesNoLab) {
    const auto message = [](const std::string& text) { return message_of<UsageError>([&] { find_labs(text); }); };
    EXPECT_TRUE(contains(message("1,4-9"), "'4-9' contains no lab"));
    EXPECT_TRUE(contains(message("3-1"), "'3-1' contains no lab"));
    EXPECT_TRUE(contains(message("1-x"), "'1-x' contains no lab"));
    EXPECT_TRUE(contains(message("1,briks"), "did you mean '03_bricks'?"));
    for (const char* text : {"", "1,", "2", "-", "1-2-3", "view"}) EXPECT_NE(message(text), "") << text;
}

}  // namespace
}  // namespace relief
