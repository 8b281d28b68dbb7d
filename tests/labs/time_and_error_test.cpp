// Lab 17: every method keeps the error budget, and so does the change between frames. Also tests the saved work.
#include <cmath>
#include <map>
#include <set>

#include "framework/library/kit/relief_material.h"
#include "framework/staff/reference/least_move.h"
#include "labs/17_time_and_error/wall.h"
#include "tests/labs/shots.h"

namespace relief {
namespace {

constexpr double texels = 512, depth = 0.03;  // texels per metre; metres
const glm::ivec2 pixels{96, 96};

struct View {
    const char* name;
    Orbit camera;
};
const View four_views[] = {
    {"along the wall", {.yaw = -80, .pitch = 3, .distance = 9, .target = {9, 2, 0}, .field_of_view = 50}},
    {"from a metre away", {.yaw = -62, .pitch = -20, .distance = 2.4, .target = {30, 5, 0}, .field_of_view = 65}},
    {"straight at it", {.yaw = 5, .pitch = 10, .distance = 2, .target = {100, 4, 0}, .field_of_view = 50}},
};

/// The lab with one map, and the exact relief.
class Wall {
public:
    explicit Wall(const char* map)
        : shot_(shot_of("17", {{"view", "picture"}, {"map", map}, {"size", "512"}, {"depth", "0.03"}}, "", pixels)),
          lab_(make_lab(find_lab("17"), shot_)),
          field_([map] {
              ReliefMaterial material;
              material.asset_texels = int(texels), material.size = 2;
              material.map = std::map<std::string, int>{{"fbm", 1}, {"stones", 3}, {"posts", 4}, {"wall", 6}}[map];
              return HeightField(material.heights(), true);
          }()) {}

    void set(const char* knob, const std::string& value) { set_knob(*lab_, knob, value); }
    Image drawn(const Orbit& camera, const char* probe, glm::ivec2 size = pixels) {
        return render_shot(*lab_, shot(camera, probe, size));
    }
    Image truth(const Orbit& camera, const char* probe) { return truth_of(*lab_, shot(camera, probe, pixels)); }
    std::vector<ShownError> errors(const Orbit& camera) {
        return wall_errors(drawn(camera, "uv"), field_, texels, depth, Camera(camera, 1).clip_from_world());
    }
    double work(const Orbit& camera, glm::ivec2 size) {
        const Image read = drawn(camera, "work", size);
        double sum = 0, count = 0;
        for (size_t i = 0; i < read.values.size(); i += 4)
            if (std::isfinite(read.values[i])) sum += double(read.values[i]), ++count;
        return sum / count;
    }
    const HeightField& field() const { return field_; }

private:
    Shot shot(const Orbit& camera, const char* probe, glm::ivec2 size) const {
        Shot shot = shot_;
        shot.camera = camera, shot.probe = {probe}, shot.size = size;
        return shot;
    }

    Shot shot_;
    std::unique_ptr<Lab> lab_;
    HeightField field_;
};

double largest(const std::vector<ShownError>& shown) {
    double largest = 0;
    for (const ShownError& one : shown) largest = std::max(largest, one.pixels);
    return largest;
}

TEST(TimeAndError, EveryPixelKeepsTheBudget) {
    struct Setting {
        std::vector<const char*> maps;
        std::vector<Knob> knobs;
        std::vector<View> views;
        std::vector<double> budgets;
        int method = -1;  ///< one that many pixels must use
    };
    const std::vector<View> all(std::begin(four_views), std::end(four_views)), two = {four_views[0], four_views[1]};
    const Setting settings[] = {
        {{"wall", "fbm"}, {}, all, {0.25, 0.5, 1, 4}},
        {{"smooth"}, {{"exact_taps", "1000"}}, all, {0.25}, 2},
        {{"smooth"}, {{"exact_taps", "1000"}, {"triangle_taps", "0"}}, all, {0.25}, 4},
        {{"posts", "stones", "wall", "fbm"}, {{"method", "parallax"}, {"spend", "on"}}, two, {0.25, 1}}};
    for (const auto& [maps, knobs, views, budgets, method] : settings)
        for (const char* map : maps) {
            Wall wall(map);
            for (const auto& [knob, value] : knobs) wall.set(knob.c_str(), value);
            for (const View& view : views)
                for (const double budget : budgets) {
                    SCOPED_TRACE(testing::Message() << map << ", " << view.name << ", " << budget << ", " << method);
                    wall.set("budget", std::to_string(budget));
                    const auto shown = wall.errors(view.camera);
                    ASSERT_GT(shown.size(), 2000u);
                    // Distances are measured from the front, which is up to 3 cm nearer.
                    EXPECT_LE(largest(shown), budget * 1.01 + 0.001);
                    if (method < 0) continue;
                    const Image methods = wall.drawn(view.camera, "method");
                    EXPECT_GT(std::count(methods.values.begin(), methods.values.end(), float(method)), 1000);
                }
        }
}

TEST(TimeAndError, SearchesAloneKeepTheBudgetAndAPlaneDoesNot) {
    Wall wall("wall");
    const auto off = [&](const char* method) {
        wall.set("method", method);
        return largest(wall.errors(four_views[0].camera));
    };
    EXPECT_LT(off("exact"), 0.002);
    EXPECT_LT(off("parallax"), 0.1);
    EXPECT_GT(off("normal-map"), 0.5);
}

TEST(TimeAndError, ALargerBudgetNeverPicksACostlierMethod) {
    for (const char* map : {"wall", "smooth"}) {
        Wall wall(map);
        for (const View& view : {four_views[0], four_views[1]}) {
            std::optional<Image> before;
            std::set<float> seen;
            for (const char* budget : {"0.25", "0.35", "0.5", "0.7", "1", "2", "4", "16"}) {
                wall.set("budget", budget);
                const Image now = wall.drawn(view.camera, "method");
                for (size_t i = 0; i < now.values.size(); i += 4) {
                    if (!std::isfinite(now.values[i])) continue;
                    seen.insert(now.values[i]);
                    ASSERT_LE(now.values[i], before ? before->values[i] : 4)
                        << map << ", " << view.name << ", " << budget;
                }
                before = now;
            }
            EXPECT_GE(seen.size(), 3u) << map << ", " << view.name;
        }
    }
}

TEST(TimeAndError, APatchOmitsOnlyMethodsThatNoneOfItsPixelsNeeds) {
    using namespace budget;
    ReliefMaterial material;
    material.asset_texels = int(texels);
    const MapErrors maps(material.heights(), material.normals());
    Wall wall("wall");
    size_t decided = 0, all = 0;
    for (const View& view : four_views)
        for (const double pixels_off : {0.25, 0.5, 1.0, 4.0}) {
            wall.set("budget", std::to_string(pixels_off));
            const Frame frame{0, pixels, 0, Camera(view.camera, 1), {}};
            const auto patches = patches_for({frame, pixels_off, depth, 0.875, 0.125, 5, 1000}, maps);
            const Image methods = wall.drawn(view.camera, "method");
            for (int y = 0; y < pixels.y; ++y)
                for (int x = 0; x < pixels.x; ++x) {
                    const float method = *methods.pixel(x, y);
                    if (!std::isfinite(method)) continue;
                    const Ray ray = frame.ray(x, y);
                    const double place = ray.at(-ray.origin.z / ray.direction.z).x;
                    const auto patch = std::find_if(patches.begin(), patches.end(), [&](const Patch& one) {
                        return place >= one.low.x && place <= one.high.x;
                    });
                    ASSERT_NE(patch, patches.end()) << view.name << " " << x << " " << y;
                    ASSERT_TRUE(patch->methods & bit(Method(int(method))))
                        << view.name << ", " << pixels_off << ": " << method;
                    ++all, decided += (patch->methods & (patch->methods - 1)) == 0;
                }
        }
    EXPECT_GT(decided, all / 2) << "of half of the pixels the patch has decided";
}

TEST(TimeAndError, DrawsOncePerMethodAndSkipsUnusedMethods) {
    Shot shot = shot_of("17", {{"view", "picture"}, {"map", "posts"}}, "", pixels);
    shot.camera = four_views[0].camera;
    const auto lab = make_lab(find_lab("17"), shot);
    const auto draws = [&](const char* method, const char* budget) {
        set_knob(*lab, "method", method), set_knob(*lab, "budget", budget);
        return work_of(*lab, shot).draws;
    };
    const int64_t one = draws("plain", "1");
    EXPECT_LE(draws("auto", "0.25"), one + 1) << "near the wall's end rays may leave it, which is another program";
    EXPECT_LE(draws("auto", "2"), one + 3) << "a search near the eye, the normal map, then a colour";
    EXPECT_EQ(draws("auto", "16"), one);
}

TEST(TimeAndError, NoPixelJumpsWhileTheEyeMovesSlowly) {
    // All methods show the same thinned relief within an eighth of the budget, and that relief hardly moves. So a point
    // that two frames show moves by at most the budget beyond its exact motion.
    const double budget = 0.5;
    const auto step = [](int frame) {
        Orbit camera = four_views[0].camera;
        camera.target.x += 0.01 * frame;
        return camera;
    };
    const auto pixel_of = [](const Camera& camera, glm::dvec2 texel, double height) {
        const glm::dvec4 clip = camera.clip_from_world() * glm::dvec4(texel / texels, depth * (height - 1), 1);
        return glm::dvec2(clip.x / clip.w + 1, 1 - clip.y / clip.w) * glm::dvec2(pixels) / 2.0;
    };
    const auto within = [](const Image& left, glm::ivec2 pixel, double height) {
        const float* const between = left.pixel(pixel.x, pixel.y);
        return std::clamp(height, double(between[0]), double(between[1]));
    };
    for (const char* map : {"wall", "smooth"}) {
        Wall wall(map);
        wall.set("budget", std::to_string(budget));
        double largest = 0;
        std::optional<Image> left = wall.truth(step(0), "left");
        for (int frame = 0; frame < 8; ++frame) {
            const Camera here(step(frame), 1), next(step(frame + 1), 1);
            const Image left_next = wall.truth(step(frame + 1), "left");
            for (const ShownError& one : wall.errors(step(frame))) {
                const double truth = wall.field().height(one.texel), thinned = within(*left, one.pixel, truth);
                const double apart =
                    glm::distance(pixel_of(here, one.texel, one.height), pixel_of(here, one.texel, thinned));
                ASSERT_LE(apart, budget / 8 + 0.01) << map << " frame " << frame;
                const glm::ivec2 there(glm::floor(pixel_of(next, one.texel, one.height)));
                if (there.x < 0 || there.y < 0 || there.x >= pixels.x || there.y >= pixels.y ||
                    !std::isfinite(*left_next.pixel(there.x, there.y)))
                    continue;
                const double moved = glm::distance(pixel_of(next, one.texel, thinned),
                                                   pixel_of(next, one.texel, within(left_next, there, truth)));
                largest = std::max(largest, apart + moved + budget / 8);
            }
            left = left_next;
        }
        EXPECT_LE(largest, budget) << map;
        EXPECT_GT(largest, budget / 8) << map << ": nothing has moved at all";
    }
}

TEST(TimeAndError, TheWallHasNoHole) {
    Wall wall("smooth");
    wall.set("budget", "0.5");
    for (const char* triangle_taps : {"1000", "0"}) {
        wall.set("triangle_taps", triangle_taps);
        for (const View& view : four_views) {
            const Image shown = wall.drawn(view.camera, "uv"), truth = wall.truth(view.camera, "uv");
            // At the border of the wall, the outline may differ by a pixel.
            const auto has = [](const Image& image, int x, int y) { return std::isfinite(*image.pixel(x, y)); };
            for (int y = 1; y + 1 < pixels.y; ++y)
                for (int x = 1; x + 1 < pixels.x; ++x) {
                    bool all = true, any = false;
                    for (int i = -1; i <= 1; ++i)
                        for (int j = -1; j <= 1; ++j) all &= has(truth, x + i, y + j), any |= has(truth, x + i, y + j);
                    ASSERT_TRUE(has(shown, x, y) ? any : !all)
                        << view.name << ", " << triangle_taps << ", " << x << " " << y;
                }
        }
    }
}

TEST(TimeAndError, DoesLessWorkThanAnySingleSearch) {
    Wall wall("wall");
    const auto work = [&](const char* method, const char* budget) {
        wall.set("method", method), wall.set("budget", budget);
        return wall.work(four_views[0].camera, {256, 256});
    };
    // Half as many pixels per side: half a pixel then equals one pixel before.
    const double all = work("auto", "0.5");
    EXPECT_LT(all, 0.4 * work("exact", "0.5"));
    EXPECT_LT(all, 0.15 * work("parallax", "0.5"));
    EXPECT_GT(all, 0.5) << "something is searched";
    EXPECT_LT(work("auto", "1"), 0.5 * all);
}

}  // namespace
}  // namespace relief
