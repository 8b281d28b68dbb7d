// Places in a buffer for parts that come and go.
#include "labs/09_planet/slots.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace relief {
namespace {

TEST(Slots, KeepTheirPlacesAsLongAsTheyAreWanted) {
    Slots<std::string, int> slots;
    slots.reset(3);
    EXPECT_EQ(slots.keep({"b", "a"}), (std::vector<std::string>{"a", "b"}));
    slots.at("b").value = 7;
    EXPECT_EQ(slots.keep({"b", "c", "d"}), (std::vector<std::string>{"c", "d"}));
    EXPECT_EQ(slots.at("b").place, 1);
    EXPECT_EQ(slots.at("b").value, 7);
    EXPECT_EQ(slots.at("c").place, 0) << "the place of a, which is free";
    EXPECT_EQ(slots.at("d").place, 2);
    EXPECT_EQ(slots.at("d").value, 0);
    EXPECT_THROW(slots.at("a"), std::out_of_range);
    slots.reset(9);
    EXPECT_EQ(slots.capacity(), 9);
    EXPECT_EQ(slots.keep({"b"}), std::vector<std::string>{"b"});
    EXPECT_EQ(slots.at("b").place, 0);
}

}  // namespace
}  // namespace relief
