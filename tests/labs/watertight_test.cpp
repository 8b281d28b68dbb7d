// Closed displaced surfaces stay closed for all levels, spacings, depths and views.
#include <gtest/gtest.h>

#include "tests/labs/feedback.h"
#include "tests/labs/shots.h"

namespace relief {
namespace {

constexpr unsigned seed = 20;

/// A closed shape in one of the two labs. Settings that need a new program are fixed, and the others are random for
/// each view.
struct Scene {
    const char* lab;
    std::string shape;
    std::vector<Knob> fixed;
    std::string text() const {
        std::string all = std::string("lab ") + lab;
        for (const auto& [name, value] : fixed) all += " " + name + "=" + value;
        return all;
    }
};

Scene random_scene(Dice& dice, bool with_cracks) {
    Scene scene{with_cracks || dice.random() % 3 ? "14" : "13", dice.one_of({"sphere", "globe", "torus", "box"}), {}};
    scene.fixed = {{"surface", scene.shape},
                   {"corners", dice.one_of({"3", "4"})},
                   {"spacing", dice.one_of({"equal", "fractional-odd", "fractional-even"})},
                   {"patches", std::to_string(2 + dice.random() % 3)},
                   {"map", dice.one_of({"smooth", "fbm", "bricks", "stones", "posts"})},
                   {"size", "256"},
                   {"bits", dice.one_of({"float", "8"})}};
    if (*scene.lab == '1' && scene.lab[1] == '3') {
        scene.fixed.emplace_back("view", "one");
        scene.fixed.emplace_back("mip", dice.one_of({"base", "level"}));
    } else {
        scene.fixed.emplace_back("view", "eye");
        scene.fixed.emplace_back("method", dice.one_of({"distance", "size", "error"}));
        scene.fixed.emplace_back("levels_of", with_cracks ? "patch" : "edge");
    }
    return scene;
}

std::vector<Knob> random_levels(Dice& dice, const Scene& scene) {
    const auto text = [](double value) { return std::to_string(value); };
    std::vector<Knob> knobs = {{"depth", text(dice.octaves(0.001, 0.2))}};
    if (scene.lab[1] == '3') {
        knobs.emplace_back("level", text(dice.octaves(1, 24)));
        knobs.emplace_back("inside", text(dice.random() % 2 ? dice.octaves(1, 24) : 0));
        return knobs;
    }
    const double nearest = dice.between(0.2, 3);
    knobs.insert(knobs.end(), {{"nearest", text(nearest)},
                               {"farthest", text(nearest + dice.between(0.5, 4))},
                               {"finest", text(dice.between(2, 4.5))},
                               {"coarsest", text(dice.between(0, 3))},
                               {"segment", text(dice.octaves(2, 32))},
                               {"budget", text(dice.octaves(0.25, 8))},
                               {"fade", dice.random() % 2 ? "true" : "false"},
                               {"fade_begin", text(dice.between(0, 3))},
                               {"fade_end", text(dice.between(1, 6))}});
    return knobs;
}

/// Returns a random camera outside the shape, at any distance, or in the middle of a shape that has an inside there.
Orbit random_view(Dice& dice, bool is_inside) {
    Orbit orbit{.yaw = dice.between(0, 360), .pitch = dice.between(-85, 85)};
    orbit.distance = is_inside ? 0.05 : dice.octaves(2, 8);
    for (int i = 0; i < 3; ++i) orbit.target[i] = dice.between(-0.2, 0.2);
    orbit.field_of_view = is_inside ? dice.between(40, 100) : dice.between(5, 60);
    return orbit;
}

struct Holes {
    size_t pixels = 0, edges = 0;
    int views = 0, views_with_holes = 0, captures_with_holes = 0;
};

/// Looks for holes in random scenes, ten views each. Fails the test if a surface is open, unless `with_cracks` is set.
Holes look_for_holes(int views, bool with_cracks) {
    Dice dice(seed);
    Holes all;
    const Target target(TargetKind::probe, {96, 96});
    while (all.views < views) {
        const Scene scene = random_scene(dice, with_cracks);
        Shot shot = shot_of(scene.lab, scene.fixed, "winding", target.size());
        const auto lab = make_lab(find_lab(scene.lab), shot);
        for (int i = 0; i < 10; ++i, ++all.views) {
            const bool is_inside = scene.shape != "torus" && dice.random() % 3 == 0;
            shot.camera = random_view(dice, is_inside);
            std::string thrown;
            for (const auto& [name, value] : random_levels(dice, scene)) {
                set_knob(*lab, name, value);
                thrown += " " + name + "=" + value;
            }
            const auto here = [&] {
                return scene.text() + ", view " + std::to_string(all.views) + " of seed " + std::to_string(seed) + ":" +
                       thrown;
            };
            if (i == 0) {
                // Culled patches would leave open edges at their neighbours.
                Shot whole = shot;
                whole.set.emplace_back("cull", "none");
                if (scene.lab[1] == '3') whole.set.pop_back();
                const auto copy = make_lab(find_lab(scene.lab), whole);
                for (const KnobText& knob : describe_knobs(*lab))
                    if (knob.name != "cull") set_knob(*copy, knob.name, knob.value);
                const std::vector<glm::vec3> triangles = triangles_of(*copy, whole);
                EXPECT_GE(triangles.size(), 3u * 12) << here();
                const size_t open = open_edges(triangles);
                all.edges += open, all.captures_with_holes += open > 0;
                EXPECT_TRUE(with_cracks || open == 0) << open << " open edges: " << here();
            }
            draw_lab(*lab, frame_of(shot, target));
            const size_t open = holes_of(target.read(), is_inside);
            all.pixels += open, all.views_with_holes += open > 0;
            EXPECT_TRUE(with_cracks || open == 0) << open << " pixels: " << here();
            if (testing::Test::HasFailure()) return all;
        }
    }
    return all;
}

TEST(Watertight, ClosedSurfacesHaveNoHoleAndNoOpenEdge) {
    std::printf("%d views, seed %u\n", view_count(), seed);
    look_for_holes(view_count(), false);
}

TEST(Watertight, PatchLevelsInsteadOfEdgeLevelsLeaveHoles) {
    const Holes found = look_for_holes(40, true);
    EXPECT_GT(found.views_with_holes, 4) << found.pixels << " pixels";
    EXPECT_GT(found.captures_with_holes, 1) << found.edges << " edges";
}

}  // namespace
}  // namespace relief
