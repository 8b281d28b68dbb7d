// Lab 01: its probes at positions with known values, and against their truth.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "framework/core/gl/counters.h"
#include "framework/core/image/compare.h"
#include "framework/course/manifest/manifest.h"
#include "tests/core/gl/glsl_function.h"

namespace relief {
namespace {

/// The lowest row of the picture shows the floor. It is 60 m wide and repeats the texture 24 times: y up, u along x, v
/// along -z.
class SpecularHighlightsFloor : public testing::Test {
protected:
    const LabEntry& lab_ = find_lab("01");
    Shot shot(const char* probe) const {
        Shot wanted;
        wanted.size = {64, 36};
        wanted.camera = load_manifest(lab_).camera;
        wanted.probe = {probe};
        wanted.set = {{"method", "vertex-normal"}};
        return wanted;
    }
    Image probe(const char* name) const { return render_shot(*make_lab(lab_, shot(name)), shot(name)); }
};

TEST_F(SpecularHighlightsFloor, ItsNormalPointsUp) {
    const Image normal = probe("normal");
    for (const int x : {2, 61}) {
        const float* const n = normal.pixel(x, 35);
        EXPECT_NEAR(n[0], 0, 1e-6);
        EXPECT_NEAR(n[1], 1, 1e-6);
        EXPECT_NEAR(n[2], 0, 1e-6);
    }
}

TEST_F(SpecularHighlightsFloor, ItsUvAreTexelsOfTheTexture) {
    const Image uv = probe("uv");
    const Shot wanted = shot("uv");
    const Frame frame{0, wanted.size, 0, Camera(wanted.camera, 64.0 / 36), wanted.probe};
    for (const int x : {2, 61}) {
        const Ray ray = frame.ray(x, 35);
        const glm::dvec3 place = ray.origin - ray.origin.y / ray.direction.y * ray.direction;
        // A float resolves the 12,000 texels of these positions to a thousandth. The rasteriser interpolates with an
        // error of a few thousandths.
        EXPECT_NEAR(uv.pixel(x, 35)[0], (place.x / 60 + 0.5) * 24 * 1024, 0.05);
        EXPECT_NEAR(uv.pixel(x, 35)[1], (-place.z / 60 + 0.5) * 24 * 1024, 0.05);
    }
}

/// So close that a texel covers several pixels, and no filter averages.
ErrorSummary error_near(glm::dvec3 target, Orbit orbit, const char* probe, const char* method) {
    const LabEntry& lab = find_lab("01");
    orbit.target = target, orbit.field_of_view = 20;
    Shot shot{.size = {128, 96}, .time = 0, .camera = orbit, .probe = {probe}, .set = {{"method", method}}};
    const auto made = make_lab(lab, shot);
    return summarize(
        error_image(render_shot(*made, shot), truth_of(*made, shot), load_manifest(lab).probe(probe).error));
}
const glm::dvec3 floor_stones(0.3, 0, 2.4), column_bricks(1.4, 1.3, 1.65);
const Orbit floor_from_above{.yaw = 10, .pitch = 60, .distance = 0.6},
    column_from_before{.yaw = 0, .pitch = 8, .distance = 0.5};

TEST(SpecularHighlightsTruth, ANormalMapIsAccurateTo8BitRoundingOnTheFloor) {
    const ErrorSummary error = error_near(floor_stones, floor_from_above, "normal", "normal-map");
    EXPECT_EQ(error.count, size_t{128 * 96});
    // Rounding to 8 bits tilts a normal by 0.17 degrees on average and 0.39 at most (Cigolle et al. 2014). Between
    // texels the shader interpolates normals and the truth interpolates slopes. They agree on a plane and differ by
    // some degrees at an edge.
    EXPECT_LT(error.mean, 0.5);
    EXPECT_GT(error.mean, 0.1) << "no map of 8 bits is that good: is the truth made from it?";
    EXPECT_LT(error.p99, 4);
}

TEST(SpecularHighlightsTruth, ANormalMapBeatsVertexNormalsTenfoldOnTheBricks) {
    const ErrorSummary map = error_near(column_bricks, column_from_before, "normal", "normal-map");
    const ErrorSummary vertex = error_near(column_bricks, column_from_before, "normal", "vertex-normal");
    EXPECT_EQ(map.count, vertex.count);
    EXPECT_GT(vertex.mean, 10);
    EXPECT_LT(map.mean, vertex.mean / 10);
}

TEST(SpecularHighlightsTruth, TexelsAreExactOnTheFloorAndWithinTheFacetErrorOnAColumn) {
    EXPECT_LT(error_near(floor_stones, floor_from_above, "uv", "normal-map").largest, 0.05);
    // 48 sides: a facet lies up to 1 mm (0.6 texels) below the round column.
    EXPECT_LT(error_near(column_bricks, column_from_before, "uv", "normal-map").largest, 1.5);
}

TEST(SpecularHighlightsTruth, FollowsTheStrengthAndEachHalfOfSideBySide) {
    const LabEntry& lab = find_lab("01");
    Shot shot{.size = {96, 64}, .time = 0, .camera = load_manifest(lab).camera, .probe = {"uv"}, .set = {}};
    shot.set = {{"method", "side-by-side"}};
    auto made = make_lab(lab, shot);
    const ErrorSummary sides =
        summarize(error_image(render_shot(*made, shot), truth_of(*made, shot), ErrorMetric::distance));
    EXPECT_LT(sides.mean, 30) << "a few pixels see another column than the mesh does";
    shot.probe = {"normal"}, shot.set = {{"strength", "0"}, {"method", "normal-map"}};
    made = make_lab(lab, shot);
    const ErrorSummary flat =
        summarize(error_image(render_shot(*made, shot), truth_of(*made, shot), ErrorMetric::angle));
    EXPECT_LT(flat.mean, 0.2) << "without strength only the facets are wrong";
}

/// Returns the share of the pixels of a surface whose normal faces away from the eye.
double share_facing_away(const char* method, const char* strength, double distance) {
    Shot shot;
    shot.size = {512, 512}, shot.probe = {"normal"};
    shot.set = {{"method", method}, {"strength", strength}};
    shot.camera = load_manifest(find_lab("01")).camera, shot.camera.distance = distance;
    const Image normals = render_shot(*make_lab(find_lab("01"), shot), shot);
    const Frame frame{0, shot.size, 0, Camera(shot.camera, 1), shot.probe};
    double away = 0, seen = 0;
    for (int y = 0; y < shot.size.y; ++y)
        for (int x = 0; x < shot.size.x; ++x)
            if (const float* n = normals.pixel(x, y); std::isfinite(n[0]))
                ++seen, away += glm::dot(glm::dvec3(n[0], n[1], n[2]), frame.ray(x, y).direction) >= 0;
    return away / seen;
}

TEST(SpecularHighlights, SomeMappedNormalsOfVisiblePixelsFaceAwayFromTheEye) {
    // In percent, as the handout says. Vertex normals do so at the outline only, because facets are flat. A tolerance
    // of 0.05 is 130 pixels.
    EXPECT_NEAR(100 * share_facing_away("normal-map", "1", 2.6), 1.6, 0.05);
    EXPECT_NEAR(100 * share_facing_away("normal-map", "2", 2.6), 4.4, 0.05);
    EXPECT_LT(100 * share_facing_away("vertex-normal", "1", 2.6), 0.3);
}

/// Returns the picture by a normal map, with the lamp on the floor, near the line where a column turns away from it.
Image lit_from_the_floor(const char* terminator, const char* strength) {
    Shot shot;
    shot.size = {240, 160};
    shot.camera = {.yaw = 20, .pitch = 20, .distance = 3.2, .target = {1, 0.2, 0}};
    shot.set = {{"method", "normal-map"}, {"light_height", "0.1"}, {"strength", strength}, {"terminator", terminator}};
    return render_shot(*make_lab(find_lab("01"), shot), shot);
}

double mean_of(const Image& image) {
    double sum = 0;
    for (const float value : image.values) sum += double(value);
    return sum / double(image.values.size());
}

TEST(SpecularHighlights, EachTerminatorTakesLightAwayAndAddsNone) {
    const Image none = lit_from_the_floor("none", "2");
    double before = mean_of(none);
    for (const char* terminator : {"step", "chiang"}) {
        const Image image = lit_from_the_floor(terminator, "2");
        for (size_t i = 0; i < image.values.size(); ++i)
            ASSERT_LE(image.values[i], none.values[i] + 1e-4f) << terminator;
        EXPECT_LT(mean_of(image), before) << terminator << " takes away more than the one before it";
        before = mean_of(image);
    }
    // It spreads light: faces that turn away from the lamp get what their other facet mirrors.
    EXPECT_LT(mean_of(lit_from_the_floor("schuessler", "2")), mean_of(none));
}

TEST(SpecularHighlights, AFlatMapLooksTheSameWithEachTerminator) {
    const Image none = lit_from_the_floor("none", "0");
    for (const char* terminator : {"step", "chiang", "schuessler"})
        EXPECT_LE(difference(lit_from_the_floor(terminator, "0"), none, 0).largest, 1.0 / 255 + 1e-6) << terminator;
}

/// Returns the light of a shader of lab 01 or of common for a highlight of strength 1 without diffuse light, divided by
/// the cosine. Directions are turned from the normal by `to_light` and `to_eye` degrees, in one plane.
double highlight(const char* file, const char* function, float shininess, double to_light, double to_eye) {
    const auto turned = [](double degrees) {
        return glm::vec4(std::sin(glm::radians(degrees)), 0, std::cos(glm::radians(degrees)), 0);
    };
    const std::string call =
        fmt::format("vec4({}(vec3(0.0), 1.0, {:.1f}, vec3(0.0, 0.0, 1.0), a.xyz, b.xyz), 0.0)", function, shininess);
    const std::vector<GlslInput> inputs = {{turned(to_light), turned(to_eye), glm::vec4(0)}};
    return double(evaluate_glsl(file, call, inputs)[0].x) / std::cos(glm::radians(to_light));
}
constexpr const char* ggx_file = "01_specular_highlights/ggx.glsl";

TEST(SpecularHighlights, GgxIsTheMicrofacetFormulaInDoublePrecision) {
    // pi D V: D by Walter and others, equation 33; V = 1 / (4 l v (1 + lambda(l) + lambda(v))) with the lambda of
    // Heitz 2014, equation 72.
    for (const double shininess : {2.0, 48.0, 256.0})
        for (const auto& [light, eye] :
             {std::pair{0.0, 0.0}, {10.0, -10.0}, {40.0, 20.0}, {-70.0, 75.0}, {3.0, 80.0}}) {
            const double a2 = 2 / (shininess + 2), h = glm::radians((light + eye) / 2), c = std::cos(h);
            const double d = a2 / (std::pow(c, 4) * std::pow(a2 + std::tan(h) * std::tan(h), 2));
            const auto lambda = [&](double degrees) {
                const double tangent = std::tan(glm::radians(degrees));
                return (std::sqrt(1 + a2 * tangent * tangent) - 1) / 2;
            };
            const double v = 1 / (4 * std::cos(glm::radians(light)) * std::cos(glm::radians(eye)) *
                                  (1 + lambda(light) + lambda(eye)));
            EXPECT_NEAR(highlight(ggx_file, "ggx", float(shininess), light, eye) / (d * v), 1, 1e-4)
                << shininess << ' ' << light << ' ' << eye;
        }
    EXPECT_TRUE(std::isfinite(highlight(ggx_file, "ggx", 48, 80, 100))) << "the eye is behind the surface";
}

TEST(SpecularHighlights, GgxFallsAsHandout01Says) {
    // D alone, from its peak, at the angle between normal and half vector: eye and lamp are in one place.
    const auto falls = [](double degrees) {
        const double sine = std::sin(glm::radians(degrees)), a2 = 2.0 / (48 + 2);
        return std::pow(1 + sine * sine * (1 / a2 - 1), -2);
    };
    const auto cosine_power = [](double degrees) { return std::pow(std::cos(glm::radians(degrees)), 48); };
    EXPECT_NEAR(cosine_power(9.7), 0.5, 0.005);
    EXPECT_NEAR(falls(7.5), 0.5, 0.006);
    EXPECT_NEAR(100 * falls(30), 2, 0.05);
    EXPECT_NEAR(100 * cosine_power(30), 0.1, 0.005);
}

TEST(SpecularHighlights, TheWipeDrawsOnlyTheObjectsOfEachHalf) {
    const auto draw = [](const char* method, const char* wipe, double yaw, int64_t* calls = nullptr) {
        Shot shot;
        shot.size = {256, 160};
        shot.camera = load_manifest(find_lab("01")).camera;
        shot.camera.yaw += yaw;
        shot.set = {{"method", method}, {"wipe", wipe}};
        const Target target(TargetKind::picture, shot.size);
        const int64_t before = counters().draw_calls;
        draw_lab(*make_lab(find_lab("01"), shot), frame_of(shot, target));
        if (calls) *calls = counters().draw_calls - before;
        return read_picture(target);
    };
    // 0.5 of 256 pixels: columns 127 and 128 form the line.
    for (const double yaw : {0.0, 35.0, 90.0, -130.0})
        for (const auto& [wipe, split] : {std::pair{"0.5", 128}, {"0.25", 64}, {"0.875", 224}}) {
            const Image left = draw("vertex-normal", wipe, yaw), right = draw("normal-map", wipe, yaw),
                        both = draw("wipe", wipe, yaw);
            for (int y = 0; y < both.height; ++y)
                for (int x = 0; x < both.width; ++x) {
                    if (x == split - 1 || x == split) continue;
                    for (int c = 0; c < 3; ++c)
                        ASSERT_EQ(both.pixel(x, y)[c], (x < split ? left : right).pixel(x, y)[c])
                            << x << ", " << y << " at " << wipe << ", " << yaw << " degrees";
                }
        }
    int64_t whole = 0, halves = 0;
    draw("normal-map", "0.5", 0, &whole), draw("wipe", "0.5", 0, &halves);
    EXPECT_EQ(whole, 14) << "six columns, six balls, the floor and the lamp";
    EXPECT_LE(halves, 20) << "the floor twice, what may reach across the line, and nothing else: all of it were 28";
}

}  // namespace
}  // namespace relief
