// The comparison of a check's pictures, as a reader sees it.
#include "framework/course/pages/check_figures.h"

#include "framework/library/maps/visualize.h"
#include "tests/support.h"

namespace relief::pages {
namespace {

TEST(CheckFigures, ASurfaceInOneImageOnlyIsTheLargestDifference) {
    const ProbeInfo depth{.name = "depth", .unit = "m", .error = ErrorMetric::absolute};
    Image drawn(4, 1, 4), expected(4, 1, 4);
    const float at[] = {1, no_surface, 1, no_surface}, wanted[] = {1, 1, no_surface, no_surface};
    for (size_t i = 0; i < 16; ++i) drawn.values[i] = at[i / 4], expected.values[i] = wanted[i / 4];
    const ComparedImages shown = compare_images(&depth, drawn, expected, 0.5);
    const auto color = [](const Image& map, int x) { return std::vector(map.pixel(x, 0), map.pixel(x, 0) + 3); };
    Image errors(4, 1, 1);
    errors.values = {0, 0.5f, 0.5f, no_surface};
    const Image as_wanted = visualize_error(errors, 0.5);
    for (int x = 0; x < 4; ++x) EXPECT_EQ(color(shown.difference, x), color(as_wanted, x)) << x;
    EXPECT_TRUE(contains(shown.differs, "0 of 4 pixels are off by more than 0.5 m")) << shown.differs;
    EXPECT_TRUE(contains(shown.differs, "; 2 have a surface in one of the two only")) << shown.differs;
}

TEST(CheckFigures, TheColoursOfEachProbeAreExplainedOnce) {
    std::set<std::string> told;
    std::string shown;
    for (const char* probe : {"ray", "uv", "ray", "", "uv"}) {
        Fields figures = {{"probe", probe}};
        tell_once(figures, told);
        shown += figures["probe"].text + ";";
    }
    EXPECT_EQ(shown, "ray;uv;;;;");
}

}  // namespace
}  // namespace relief::pages
