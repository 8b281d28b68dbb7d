// Watchdog ends a check, or a lab, that uses more time than it may.
#include "framework/course/check/watchdog.h"

#include <gtest/gtest.h>

#include <future>

namespace relief::check {
namespace {

constexpr double never = 1e6;

std::string limit_that_ends(PatienceLimits limits) {
    std::promise<std::string> limit;
    const Watchdog patience([&](const std::string& said) { limit.set_value(said); }, limits);
    return limit.get_future().get();
}

TEST(Watchdog, EndsACheckAndALabAndNamesTheLimit) {
    EXPECT_EQ(limit_that_ends({.check = 0.001, .lab = never}), "0.001 seconds")
        << "a thread that waits has a limit, too";
    EXPECT_EQ(limit_that_ends({.check = never, .lab = 0.002}), "0.002 seconds");
}

TEST(Watchdog, EndsNothingThatHasTimeLeft) {
    bool gave_up = false;
    {
        Watchdog patience([&](const std::string&) { gave_up = true; }, {.check = never, .lab = never});
        patience.next();
        patience.next();
    }
    EXPECT_FALSE(gave_up);
}

}  // namespace
}  // namespace relief::check
