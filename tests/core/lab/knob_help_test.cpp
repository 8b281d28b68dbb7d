// A knob's help, unit, and the values of another knob for which it has an effect.
#include "framework/core/lab/knob_help.h"

#include "framework/core/lab/knobs.h"
#include "tests/support.h"

namespace relief {
namespace {

TEST(KnobHelp, IsALineAndASentence) {
    EXPECT_EQ(KnobHelp("depth of a layer").in("metres").line(), "depth of a layer, metres");
    EXPECT_EQ(KnobHelp("depth of a layer").in("metres").sentence(), "Depth of a layer, metres.");
    EXPECT_EQ(KnobHelp("is it on?").sentence(), "Is it on?");
    EXPECT_EQ(KnobHelp("").sentence(), "");
    const auto only = [](std::vector<std::string> values) { return KnobHelp("the cut").only("view", values).line(); };
    EXPECT_EQ(only({"map"}), "for view = map: the cut");
    EXPECT_EQ(only({"map", "one"}), "for view = map and one: the cut");
    EXPECT_EQ(only({"map", "rays", "one"}), "for view = map, rays and one: the cut");
}

TEST(KnobHelp, AUnitFollowsANumberInItsShortForm) {
    EXPECT_EQ(KnobHelp("turn").in("degrees").unit_after_number(), "\u00b0");
    EXPECT_EQ(KnobHelp("side").in("texels").unit_after_number(), " texels");
    EXPECT_EQ(KnobHelp("steps").unit_after_number(), "");
}

TEST(KnobHelp, AKnobIsIgnoredWhileTheOtherKnobHasNoneOfItsValues) {
    const auto knobs = [](const char* view, const KnobHelp& help) {
        return std::vector<KnobText>{{"view", view, "all, map, one", "what is drawn"}, {"cut", "0", "0 to 1", help}};
    };
    const KnobHelp help = KnobHelp("the cut").only("view", {"map", "one"});
    EXPECT_TRUE(is_ignored("cut", knobs("all", help)));
    EXPECT_FALSE(is_ignored("cut", knobs("one", help)));
    EXPECT_FALSE(is_ignored("cut", knobs("all", "the cut")));
    EXPECT_FALSE(is_ignored("none", knobs("all", "the cut")));
}

}  // namespace
}  // namespace relief
