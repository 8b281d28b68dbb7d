// Lab 10: the shaders' hits and errors match their twins'. Every pixel is finite, and some views must show equal
// pictures.
#include <glm/gtc/type_ptr.hpp>
#include <numeric>
#include <set>

#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/course/task/starter.h"
#include "framework/library/kit/relief_surface.h"
#include "framework/staff/grade/overlay.h"
#include "framework/staff/reference/relief_sight.h"
#include "tests/labs/shots.h"
#include "tests/support.h"

namespace relief {
namespace {

constexpr std::array offset_methods = {"offset", "limited", "steep"};
constexpr std::array angles = {0, 30, 60, 75, 85};
constexpr int offset_steps = 24;

/// Returns a shot of a wall through a long lens, so that the angle is almost constant. A texel is about a pixel at 0
/// degrees.
Shot wall_at(double degrees, std::vector<Knob> knobs, const char* probe = "uv", glm::ivec2 size = {96, 96}) {
    knobs.insert(knobs.begin(), {{"view", "one"}, {"steps", std::to_string(offset_steps)}});
    Shot shot = shot_of("10", std::move(knobs), probe, size);
    shot.camera = {.yaw = degrees, .pitch = 0, .distance = 3, .target = {0.1, 0.07, 0}, .field_of_view = 2};
    return shot;
}
Image picture(const std::vector<Knob>& knobs, double degrees = 40) {
    Shot shot = wall_at(degrees, knobs, "");
    shot.camera.target.x = 0, shot.camera.distance = 0.3, shot.camera.field_of_view = 40;
    shot.set.emplace_back("show", "light");
    return drawn("10", shot);
}

struct Figures {
    double mean = 0, wrong = 0;  ///< texels; share of pixels off by more than one texel
};
Figures figures_of(const Image& errors) {
    Figures figures;
    double count = 0;
    for (const float error : errors.values)
        if (error != no_surface) figures.mean += error, figures.wrong += error > 1, ++count;
    return {figures.mean / count, figures.wrong / count};
}

/// Only the lab's surface, with the lab's initial values and with the knobs of a shot.
class Surface final : public Lab {
public:
    explicit Surface(const Shot& shot) {
        surface.extent = 16, surface.depth = 0.06f;
        std::set<std::string> known;
        for (const KnobText& knob : describe_knobs(*this)) known.insert(knob.name);
        for (const auto& [name, value] : shot.set)
            if (known.contains(name)) set_knob(*this, name, value);
    }
    void draw(const Frame&) override {}
    void knobs(Knobs& knobs) override { surface.knobs(knobs); }
    ReliefSurface surface;
};

/// The surface of a shot, and the methods on it in double precision.
struct Twin {
    Surface lab;
    ReliefSurface& surface = lab.surface;
    ReliefSights sights{surface.mesh()};
    HeightField heights{surface.heights(), true};

    explicit Twin(const Shot& shot) : lab(shot) {}

    ParallaxHit guess(const std::string& method, const ReliefRay& ray) const {
        return method == "offset"    ? parallax_offset(heights, ray)
               : method == "limited" ? offset_limited(heights, ray)
                                     : steep_parallax(heights, ray, offset_steps);
    }
    /// Returns the error of the method in double precision, per pixel.
    Image errors(const Shot& shot, const std::string& method) const {
        const Frame frame{0, shot.size, 0, Camera(shot.camera, double(shot.size.x) / shot.size.y), {}};
        Image errors(shot.size.x, shot.size.y, 1);
        for (int y = 0; y < shot.size.y; ++y)
            for (int x = 0; x < shot.size.x; ++x) {
                const auto sight = sights.look(frame.ray(x, y), surface.mapping(), 0);
                const auto exact = sight ? heights.first_hit(sight->ray.in_texels(), 1) : std::nullopt;
                *errors.pixel(x, y) =
                    exact ? float(glm::distance(guess(method, sight->ray).texel, exact->texel)) : no_surface;
            }
        return errors;
    }
};

Image errors_of(const Shot& shot) {
    const auto lab = make_lab(find_lab("10"), shot);
    return error_image(render_shot(*lab, shot), truth_of(*lab, shot), ErrorMetric::distance);
}

TEST(ParallaxOffset, EachMethodHasTheErrorOfItsDoublePrecisionTwin) {
    for (const char* map : {"wall", "fbm"})
        for (const char* method : offset_methods)
            for (const int degrees : angles) {
                const Shot shot = wall_at(degrees, {{"map", map}, {"method", method}});
                const Figures gpu = figures_of(errors_of(shot)), twin = figures_of(Twin(shot).errors(shot, method));
                // The sampler's weights have 8 bits: 0.01 texels if the error itself is that small.
                EXPECT_NEAR(gpu.mean, twin.mean, 0.05 * twin.mean + 0.01) << map << ", " << method << ", " << degrees;
                EXPECT_NEAR(gpu.wrong, twin.wrong, 0.05 * twin.wrong + 0.002)
                    << map << ", " << method << ", " << degrees;
            }
}

TEST(ParallaxOffset, ThePrintedErrorMatchesTheProbe) {
    for (const auto& [surface, degrees] : {std::pair("wall", 30), {"wall", 60}, {"wall", 85}, {"column", 20}}) {
        Shot shot = wall_at(degrees, {{"surface", surface}, {"method", "offset"}});
        if (surface == std::string("column")) shot.camera.target = {0, 1, 0}, shot.camera.distance = 30;
        Twin twin(shot);
        const Programs programs{"common/relief.vert", "10_parallax_offset/surface.frag"};
        const Program& program = programs.with({"METHOD 0", "MEASURE"});
        const Target target(TargetKind::probe, shot.size);
        const Frame frame = frame_of(shot, target);
        glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
        glViewport(0, 0, shot.size.x, shot.size.y);
        glClearBufferfv(GL_COLOR, 0, &glm::vec4(no_surface)[0]);
        glEnable(GL_DEPTH_TEST);
        glClear(GL_DEPTH_BUFFER_BIT);
        glUseProgram(program);
        twin.surface.set(program, frame);
        twin.surface.set_exact_hit(program, 3);
        twin.surface.draw();
        const Image shown = target.read(), errors = errors_of(shot);
        size_t off = 0, count = 0;
        for (size_t i = 0; i < errors.values.size(); ++i) {
            if (errors.values[i] == no_surface) continue;
            ++count, off += std::abs(shown.values[i * 4] - errors.values[i]) > 0.1f + 0.001f * errors.values[i];
        }
        EXPECT_GT(count, errors.values.size() / 4);
        // Rays that only graze an edge may end elsewhere.
        EXPECT_LE(off, count / 200) << surface << " at " << degrees;
    }
}

TEST(ParallaxOffset, WithoutDepthShowsThePlainTexture) {
    for (const double degrees : {0.0, 40.0, 85.0}) {
        const Image plain = picture({{"depth", "0"}, {"method", "offset"}}, degrees);
        for (const char* method : {"limited", "steep"})
            EXPECT_EQ(picture({{"depth", "0"}, {"method", method}}, degrees).values, plain.values) << method;
        const Image rays = drawn("10", wall_at(degrees, {{"depth", "0"}}, "ray"));
        for (size_t i = 0; i < rays.values.size(); i += 4) ASSERT_EQ(glm::length(glm::make_vec2(&rays.values[i])), 0);
    }
}

TEST(ParallaxOffset, EveryPixelIsFiniteAndEveryRayBoundedForAnyAngleMapAndDepth) {
    struct Scene {
        std::vector<Knob> knobs;
        double yaw = 40, pitch = 0;
        glm::dvec3 target{0, 0, 0};
    };
    const std::vector<Scene> scenes = {{{}, 89.9},
                                       {{}, 90},
                                       {{}, 90.1},
                                       {{}, 0},
                                       {{{"surface", "column"}}, 0, 89, {0, 1, 0}},
                                       {{{"map", "low"}}},
                                       {{{"map", "high"}}},
                                       {{{"map", "plateau"}}},
                                       {{{"map", "damaged"}}},
                                       {{{"map", "stones"}, {"size", "1"}}},
                                       {{{"map", "low"}, {"size", "4096"}, {"depth", "1"}}, 89.9},
                                       {{{"depth", "1"}}, 80},
                                       {{{"depth", "1"}, {"stretch", "0.25"}, {"mirror", "on"}}, 89.9},
                                       {{{"shift", "10000"}}},
                                       {{{"steps", "1"}}},
                                       {{}, 210, 0, {0, 0, -0.01}},                 // inside the relief
                                       {{{"surface", "column"}}, 0, 0, {0, 1, 0}},  // inside the column
                                       {{{"surface", "urn"}, {"depth", "1"}}, 20, 60, {0, 0.5, 0}}};
    std::vector<size_t> all(scenes.size());
    std::iota(all.begin(), all.end(), 0);
    for (const size_t i : sample_of(all, 9)) {
        Shot shot = wall_at(0, scenes[i].knobs, "", {48, 48});
        const bool edge_on = std::abs(scenes[i].yaw - 90) < 1;  // a long lens: the horizon covers several pixels
        shot.camera = {scenes[i].yaw, scenes[i].pitch, 0.3, scenes[i].target, edge_on ? 1.0 : 60.0};
        const auto lab = make_lab(find_lab("10"), shot);
        const ReliefMapping mapping = Surface(shot).surface.mapping();
        const double longest = std::max(mapping.depth.x, mapping.depth.y) * mapping.texels / least_slant * 1.001;
        for (const char* method : offset_methods)
            for (const char* probe : {"", "uv", "depth", "ray", "steps"}) {
                set_knob(*lab, "method", method);
                shot.probe = {probe};
                const Target target(*probe ? TargetKind::probe : TargetKind::light, shot.size);
                draw_lab(*lab, frame_of(shot, target));
                const Image image = target.read();
                for (size_t pixel = 0; pixel < image.pixel_count(); ++pixel) {
                    const float* const value = &image.values[pixel * 4];
                    if (*probe && std::all_of(value, value + 4, [](float v) { return v == no_surface; })) continue;
                    ASSERT_TRUE(std::all_of(value, value + 4, [](float v) { return std::isfinite(v); }))
                        << "scene " << i << ", " << method << ", probe '" << probe << "'";
                    if (shot.probe.name == "ray") {
                        ASSERT_LE(glm::length(glm::make_vec2(value)), longest) << "scene " << i;
                    }
                }
            }
    }
}

TEST(ParallaxOffset, AMirroredReliefIsTheMirrorImage) {
    for (const char* method : offset_methods) {
        const Image usual = picture({{"method", method}, {"light_yaw", "-50"}}, 40);
        const Image mirrored = picture({{"method", method}, {"light_yaw", "50"}, {"mirror", "on"}}, -40);
        Image back = mirrored;
        for (int y = 0; y < back.height; ++y)
            for (int x = 0; x < back.width; ++x)
                std::copy_n(mirrored.pixel(back.width - 1 - x, y), 3, back.pixel(x, y));
        // Float rounding may move a hit into the next layer.
        expect_same_picture(back, usual, 4, usual.pixel_count() / 100);
    }
}

TEST(ParallaxOffset, ATapIsCountedForEachLayer) {
    for (const char* map : {"high", "low"})
        for (const char* method : offset_methods) {
            const Image taps = drawn("10", wall_at(40, {{"method", method}, {"map", map}}, "steps"));
            const float expected = method == std::string("steep") && map == std::string("low") ? offset_steps + 1 : 1;
            for (size_t i = 0; i < taps.values.size(); i += 4) ASSERT_EQ(taps.values[i], expected) << map << method;
        }
}

TEST(ParallaxOffset, ATileOfAnUnwrittenTaskShowsNoFigure) {
    const std::string file = "shaders/10_parallax_offset/task.glsl";
    const std::string solution = read_file(course_root() / file);
    std::vector<PictureWord> words;
    Shot shot = shot_of("10", {}, "", {640, 480});
    shot.words = &words;
    const auto figures = [&] {
        words.clear();
        drawn("10", shot);
        return std::count_if(words.begin(), words.end(), [](const PictureWord& word) {
            return word.kind == PictureWord::Kind::caption && word.text.ends_with(" texels");
        });
    };
    EXPECT_EQ(figures(), 15) << "of the solution";
    const grade::CourseOverlay overlay(grade::CourseFiles{{file, check::starter_of(solution, file)}});
    EXPECT_EQ(figures(), 0);
}

/// Returns the rays in the view `eye`, in texels from the top to the ground.
Image rays(const char* eye, const char* turn, const char* away) {
    return drawn("10", shot_of("10", {{"view", "eye"}, {"eye", eye}, {"turn", turn}, {"away", away}}, "ray"));
}

ErrorSummary apart(const Image& a, const Image& b) { return summarize(error_image(a, b, ErrorMetric::distance)); }

TEST(ParallaxOffset, TheEyeByTheInverseMatrixGivesTheRayOfDotProductsButForRounding) {
    EXPECT_EQ(rays("world", "0", "0").values, rays("inverse", "0", "0").values) << "the matrix is the identity";
    const ErrorSummary turned = apart(rays("world", "40", "0"), rays("inverse", "40", "0"));
    EXPECT_GT(turned.mean, 0);
    EXPECT_LT(turned.largest, 0.001) << "rounding of floats";
}

TEST(ParallaxOffset, FarFromTheOriginOnlyAnInverseInDoublesKeepsTheRay) {
    const Image near_by = rays("inverse-in-double", "40", "0");
    EXPECT_GT(apart(rays("world", "40", "10000"), near_by).mean, 0.03);
    EXPECT_GT(apart(rays("inverse", "40", "10000"), near_by).mean, 0.03);
    EXPECT_EQ(apart(rays("inverse-in-double", "40", "10000"), near_by).largest, 0) << "the same floats";
}

}  // namespace
}  // namespace relief
