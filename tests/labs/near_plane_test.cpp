// Exact values where the camera's near plane cuts off a surface.
#include <cmath>

#include "tests/labs/shots.h"

namespace relief {
namespace {

/// Grazing views from one metre. The near plane is two centimetres away, and the base is nearer in most of its pixels.
const Orbit along_a_wall{.yaw = 89.9, .pitch = 0, .distance = 1, .target = {}};
const Orbit along_a_floor{.yaw = 0, .pitch = 0.1, .distance = 1, .target = {}};

TEST(NearPlane, CutsOffExactValuesAsThePicture) {
    const std::vector<Knob> wall = {{"view", "one"}, {"surface", "wall"}},
                            flat_wall = {{"view", "one"}, {"surface", "wall"}, {"map", "high"}},
                            shape = {{"view", "one"}, {"shape", "wall"}},
                            long_wall = {{"view", "picture"}, {"method", "exact"}}, court = {{"displace", "off"}};
    const struct {
        const char* lab;
        std::vector<Knob> knobs;
        const char* probe;
        Orbit camera;
    } views[] = {{"01", {}, "normal", along_a_floor},      {"06", shape, "normal", along_a_wall},
                 {"10", wall, "uv", along_a_wall},         {"10", wall, "depth", along_a_wall},
                 {"11", wall, "uv", along_a_wall},         {"11", wall, "depth", along_a_wall},
                 {"12", wall, "uv", along_a_wall},         {"12", wall, "depth", along_a_wall},
                 {"13", flat_wall, "depth", along_a_wall}, {"16", court, "normal", along_a_floor},
                 {"17", long_wall, "uv", along_a_wall}};
    for (const auto& [lab_name, knobs, probe, camera] : views) {
        Shot shot = shot_of(lab_name, knobs, probe, {100, 100});
        shot.camera = camera;
        const auto lab = make_lab(find_lab(lab_name), shot);
        const Image drawn = render_shot(*lab, shot), truth = truth_of(*lab, shot);
        size_t pixels = 0;
        for (size_t i = 0; i < drawn.values.size(); i += 4) pixels += std::isfinite(drawn.values[i]);
        EXPECT_LE(one_sided(drawn, truth).count(), pixels / 100)
            << "lab " << lab_name << ", " << probe << ": an outline differs by a rounding";
        EXPECT_LT(pixels, drawn.pixel_count() * 3 / 4) << "lab " << lab_name << ": nothing is cut off";
    }
}

}  // namespace
}  // namespace relief
