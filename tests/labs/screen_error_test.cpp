// How far what lab 14 draws is from where it should be on the screen, and what its culling changes, over a camera path.
#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>

#include "framework/lab/displaced_surface.h"
#include "framework/reference/patches.h"
#include "tests/labs/shots.h"

namespace relief {
namespace {

constexpr glm::ivec2 size{72, 48};
constexpr int frames = 200;

/// Once around and over the ground, from close above it to far away.
Orbit camera_at(int frame) {
    const double share = double(frame) / frames;
    return {.yaw = 360 * share,
            .pitch = 18 + 14 * std::sin(glm::two_pi<double>() * 3 * share),
            .distance = 5.5 + 3.5 * std::sin(glm::two_pi<double>() * 2 * share),
            .target = {2 * std::cos(glm::two_pi<double>() * share), -0.5, 2 * std::sin(glm::two_pi<double>() * share)},
            .field_of_view = 40};
}

std::vector<Knob> ground(std::vector<Knob> more) {
    std::vector<Knob> knobs = {{"view", "eye"}, {"surface", "ground"}, {"corners", "4"}, {"patches", "32"},
                               {"map", "fbm"},  {"size", "512"},       {"depth", "0.1"}, {"repeat", "1"}};
    knobs.insert(knobs.end(), more.begin(), more.end());
    return knobs;
}

Image probed(Lab& lab, const char* name, int frame) {
    Shot shot{.size = size, .time = 0, .camera = camera_at(frame), .probe = {name}, .set = {}};
    const Target target(TargetKind::probe, size);
    draw_lab(lab, frame_of(shot, target));
    return target.read();
}

/// Distances between what each pixel shows and where that place of the bilinear displaced surface should be on the
/// screen, in pixels; of all frames, and sorted.
std::vector<double> screen_errors(const std::vector<Knob>& knobs, int step, int map = 1) {
    DisplacedSurface surface;
    surface.shape = DisplacedSurface::ground, surface.density = 32, surface.material.map = map, surface.material.size = 2;
    surface.depth = 0.1f;
    const HeightField heights(surface.heights(), true);
    const auto lab = make_lab(find_lab("14"), shot_of("14", knobs));
    std::vector<double> errors;
    for (int frame = 0; frame < frames; frame += step) {
        const Image place = probed(*lab, "place", frame);
        const Camera camera(camera_at(frame), double(size.x) / size.y);
        const glm::dmat4 clip_from_world = camera.clip_from_world();
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const float* const at = place.pixel(x, y);
                if (at[0] == no_surface) continue;
                const glm::dvec3 truth =
                    displaced_on(surface.patches(), size_t(std::lround(at[2])), {at[0], at[1], 0}, heights,
                                 double(surface.scale()))
                        .position;
                const glm::dvec4 clip = clip_from_world * glm::dvec4(truth, 1);
                const glm::dvec2 pixel = (glm::dvec2(clip) / clip.w * glm::dvec2(0.5, -0.5) + 0.5) * glm::dvec2(size);
                errors.push_back(glm::distance(pixel, glm::dvec2(x + 0.5, y + 0.5)));
            }
    }
    std::sort(errors.begin(), errors.end());
    return errors;
}

double quantile_of(const std::vector<double>& sorted, double share) {
    return sorted[size_t(share * double(sorted.size() - 1))];
}

TEST(ScreenError, StaysWithinTwiceTheBudgetFor999OfAThousandPixels) {
    for (const char* budget : {"0.5", "1", "2"}) {
        const auto errors = screen_errors(ground({{"method", "error"}, {"budget", budget}}), 1);
        EXPECT_GT(errors.size(), size_t(frames) * 1000);
        EXPECT_LT(quantile_of(errors, 0.999), 2 * std::atof(budget)) << "budget " << budget;
        printf("budget %s: median %.3f p99 %.3f p99.9 %.3f largest %.3f\n", budget, quantile_of(errors, .5), quantile_of(errors, .99), quantile_of(errors, .999), errors.back());
    }
}

TEST(ScreenError, X) {
  for (int map : {0,1,2,3,4,5})
    for (const char* budget : {"0.5", "1", "2"}) {
        const char* names[] = {"smooth", "fbm", "bricks", "stones", "posts", "rock"};
        const auto errors = screen_errors(ground({{"method", "error"}, {"budget", budget}, {"map", names[map]}, {"cull", "none"}}), 8, map);
        printf("%s budget %s: median %.3f p99 %.3f p99.9 %.3f largest %.3f\n", names[map], budget, quantile_of(errors, .5), quantile_of(errors, .99), quantile_of(errors, .999), errors.back());
    }
}

}  // namespace
}  // namespace relief
