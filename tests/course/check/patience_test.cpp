// Patience reports the check that is running, and gives up a check that does not end.
#include "framework/course/check/patience.h"

#include <gtest/gtest.h>

#include <future>

namespace relief::check {
namespace {

constexpr double never = 1e6;

TEST(Patience, StopsAnEndlessStepAndNamesIt) {
    std::promise<std::string> why;
    Patience patience([&](const std::string& said) { why.set_value(said); }, {.remind = 0.001, .wall = 0, .cpu = 0});
    patience.next("a loop");
    EXPECT_EQ(why.get_future().get(), "'a loop' is not finished after 0 seconds");
}

TEST(Patience, StopsNoStepThatHasTimeLeft) {
    bool gave_up = false;
    {
        Patience patience([&](const std::string&) { gave_up = true; }, {.remind = 0.001, .wall = never, .cpu = 0});
        patience.next("one");
        patience.next("another");
    }
    EXPECT_FALSE(gave_up);
}

TEST(Patience, ReportsTheStepThatItWaitsFor) {
    testing::internal::CaptureStderr();
    std::promise<void> over;
    Patience patience([&](const std::string&) { over.set_value(); }, {.remind = 0.001, .wall = 0, .cpu = 0});
    patience.next("a loop");
    over.get_future().wait();
    EXPECT_NE(testing::internal::GetCapturedStderr().find("waiting for 'a loop', 0 seconds so far"), std::string::npos);
}

}  // namespace
}  // namespace relief::check
