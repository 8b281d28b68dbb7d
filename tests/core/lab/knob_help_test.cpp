// The parts of a knob's help.
#include "framework/core/lab/knob_help.h"

#include "tests/support.h"

namespace relief {
namespace {

TEST(KnobHelp, IsASentenceForPeople) {
    EXPECT_EQ(read_help("depth of a layer, metres").sentence, "Depth of a layer, metres.");
    EXPECT_EQ(read_help("is it on?").sentence, "Is it on?");
    EXPECT_EQ(read_help("").sentence, "");
}

TEST(KnobHelp, EndsInAUnitOnlyAfterAComma) {
    EXPECT_EQ(read_help("depth of a layer, metres").unit, "metres");
    EXPECT_EQ(read_help("where the cut is, in turns").unit, "turns");
    EXPECT_EQ(read_help("metres").unit, "");
    EXPECT_EQ(read_help("more than a few metres").unit, "");
    EXPECT_EQ(read_help("the sum, and what is left").unit, "");
    EXPECT_EQ(unit_after_number("degrees"), "\u00b0");
    EXPECT_EQ(unit_after_number("texels"), " texels");
    EXPECT_EQ(unit_after_number(""), "");
}

TEST(KnobHelp, NamesTheKnobAndTheValuesThatEnableIt) {
    const KnobHelp help = read_help("for view = map, rays and one: where the cut is");
    EXPECT_EQ(help.knob, "view");
    EXPECT_EQ(help.values, (std::vector<std::string>{"map", "rays", "one"}));
    EXPECT_EQ(read_help("for one method: thin the relief").knob, "");
    EXPECT_EQ(read_help("for view = one").knob, "") << "a colon ends the condition";
}

TEST(KnobHelp, AKnobIsIgnoredOnlyIfItsHelpNamesAnExistingKnobAndValues) {
    const auto knobs = [](const char* view, const char* help) {
        return std::vector<KnobText>{{"view", view, "all, map, one", "what is drawn"}, {"cut", "0", "0 to 1", help}};
    };
    EXPECT_TRUE(is_ignored("cut", knobs("all", "for view = map and one: the cut")));
    EXPECT_FALSE(is_ignored("cut", knobs("one", "for view = map and one: the cut")));
    EXPECT_FALSE(is_ignored("cut", knobs("all", "the cut")));
    EXPECT_FALSE(is_ignored("cut", knobs("all", "for view = map, and of the sides: the cut"))) << "no such value";
    EXPECT_FALSE(is_ignored("cut", knobs("all", "for side = map: the cut"))) << "no such knob";
    EXPECT_FALSE(is_ignored("none", knobs("all", "the cut")));
}

}  // namespace
}  // namespace relief
