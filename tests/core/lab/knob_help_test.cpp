// A knob's help, unit, and the values of another knob for which it has an effect.
#include "framework/core/lab/knob_help.h"

#include "framework/core/lab/knobs.h"
#include "framework/core/lab/lab.h"
#include "tests/support.h"

namespace relief {
namespace {

TEST(KnobHelp, IsALineAndASentence) {
    EXPECT_EQ(KnobHelp("depth of a layer").in("metres").line(), "depth of a layer, metres");
    EXPECT_EQ(KnobHelp("depth of a layer").in("metres").sentence(), "Depth of a layer, metres.");
    EXPECT_EQ(KnobHelp("is it on?").sentence(), "Is it on?");
    EXPECT_EQ(KnobHelp("").sentence(), "");
    const auto only = [](const std::vector<std::string>& values) {
        return KnobHelp("the cut").only("view", values).line();
    };
    EXPECT_EQ(only({"map"}), "for view = map: the cut");
    EXPECT_EQ(only({"map", "one"}), "for view = map and one: the cut");
    EXPECT_EQ(only({"map", "rays", "one"}), "for view = map, rays and one: the cut");
}

TEST(KnobHelp, ATitleIsTheNameInWordsOrAsDeclared) {
    EXPECT_EQ(KnobHelp("").title_of("texels_per_step"), "Texels per step");
    EXPECT_EQ(KnobHelp("bits per stored height").titled("Bits per height").in("bits").title_of("bits"),
              "Bits per height");
}

TEST(KnobHelp, AUnitFollowsANumberInItsShortForm) {
    EXPECT_EQ(KnobHelp("turn").in("degrees").unit_after_number(), "\u00b0");
    EXPECT_EQ(KnobHelp("side").in("texels").unit_after_number(), " texels");
    EXPECT_EQ(KnobHelp("steps").unit_after_number(), "");
}

/// Declares a knob with a condition of its own and one without, both of a part that one view draws.
class TwoKnobs final : public Lab {
public:
    void draw(const Frame&) override {}
    void knobs(Knobs& knobs) override {
        KnobsOnly of_part(knobs, "view", {"one"});
        of_part.toggle("plain", plain_, "a part");
        of_part.toggle("own", own_, KnobHelp("a part of it").only("plain", {"on"}));
    }

private:
    bool plain_ = false, own_ = false;
};

TEST(KnobHelp, KnobsOfAPartGetItsConditionUnlessTheyHaveTheirOwn) {
    TwoKnobs lab;
    const std::vector<KnobText> knobs = describe_knobs(lab);
    EXPECT_EQ(knobs.at(0).help.condition(), "view = one");
    EXPECT_EQ(knobs.at(1).help.condition(), "plain = on");
}

TEST(KnobHelp, AKnobIsIgnoredWhileTheOtherKnobHasNoneOfItsValues) {
    const auto knobs = [](const char* view, const KnobHelp& help) {
        return std::vector<KnobText>{{"view", view, "what is drawn", "", {}}, {"cut", "0", help, "", {}}};
    };
    const KnobHelp help = KnobHelp("the cut").only("view", {"map", "one"});
    EXPECT_TRUE(is_ignored("cut", knobs("all", help)));
    EXPECT_FALSE(is_ignored("cut", knobs("one", help)));
    EXPECT_FALSE(is_ignored("cut", knobs("all", "the cut")));
    EXPECT_FALSE(is_ignored("none", knobs("all", "the cut")));
}

TEST(KnobHelp, AKnobIsIgnoredWhileTheOtherKnobIsIgnored) {
    const auto knobs = [](const char* view, const char* count) {
        return std::vector<KnobText>{{"view", view, "what is drawn", "", {}},
                                     {"count", count, KnobHelp("the rule").only("view", {"one"}), "", {}},
                                     {"least", "8", KnobHelp("the least").only("count", {"angle"}), "", {}}};
    };
    EXPECT_FALSE(is_ignored("least", knobs("one", "angle")));
    EXPECT_TRUE(is_ignored("least", knobs("one", "fixed")));
    EXPECT_TRUE(is_ignored("least", knobs("all", "angle")));
    EXPECT_EQ(unmet_condition("least", knobs("one", "fixed")), "count = angle");
    EXPECT_EQ(unmet_condition("least", knobs("all", "angle")), "view = one");
}

}  // namespace
}  // namespace relief
