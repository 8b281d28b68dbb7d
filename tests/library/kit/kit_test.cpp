// The common parts of labs: kept values, measurements, exact values by rays, lights, materials.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "framework/core/image/file.h"
#include "framework/library/kit/choices.h"
#include "framework/library/kit/culling.h"
#include "framework/library/kit/difference_map.h"
#include "framework/library/kit/drawn_numbers.h"
#include "framework/library/kit/kept.h"
#include "framework/library/kit/light.h"
#include "framework/library/kit/relief_material.h"
#include "framework/library/kit/uniforms.h"
#include "framework/library/kit/window_triangle.h"
#include "framework/library/maps/visualize.h"
#include "tests/support.h"

namespace relief {
namespace {

TEST(Choices, HoldNamesAndDefinitionsByValue) {
    enum Method { none, by_size };
    static constexpr auto methods = choices<Method>({{none, "none"}, {by_size, "size", "BY_SIZE 2"}});
    EXPECT_EQ(methods.size(), 2u);
    EXPECT_STREQ(methods.names[by_size], "size");
    EXPECT_EQ(methods.define(by_size).text, "BY_SIZE 2");
    EXPECT_EQ(methods.define(none).text, "") << "defines nothing";
}

TEST(Choices, NamesOfATableWithOtherColumnsAreInItsOrder) {
    struct Format {
        const char* name;
        int bytes;
    };
    static constexpr std::array<Format, 2> formats = {{{"half", 2}, {"float", 4}}};
    static constexpr auto names = names_of(formats);
    EXPECT_STREQ(names[0], "half");
    EXPECT_STREQ(names[1], "float");
}

TEST(Kept, IsRecomputedOnlyWhenAnInputChanges) {
    Kept<std::string, int, std::string> kept;
    int made = 0;
    const auto get = [&](int number, const std::string& word) {
        return kept.get({number, word}, [&] {
            ++made;
            return word + std::to_string(number);
        });
    };
    EXPECT_EQ(get(1, "a"), "a1");
    EXPECT_EQ(get(1, "a"), "a1");
    EXPECT_EQ(made, 1);
    EXPECT_EQ(get(2, "a"), "a2");
    EXPECT_EQ(get(2, "b"), "b2");
    EXPECT_EQ(get(1, "a"), "a1") << "only the last one is kept";
    EXPECT_EQ(made, 4);
    EXPECT_EQ(kept.version(), 4);
}

TEST(Kept, IsRetriedAfterAnError) {
    Kept<int, int> kept;
    kept.get({1}, [] { return 10; });
    for (int i = 0; i < 2; ++i)
        EXPECT_THROW(kept.get({2}, []() -> int { throw std::runtime_error("no file"); }), std::runtime_error);
    EXPECT_EQ(kept.get({2}, [] { return 20; }), 20);
    EXPECT_EQ(kept.get({1}, [] { return 11; }), 11) << "what was kept before the error has gone";
}

TEST(Numbers, AreDrawnIntoATargetOfTheirOwn) {
    const Image drawn = draw_numbers({3, 2}, [] {
        glEnable(GL_SCISSOR_TEST);
        glScissor(2, 1, 1, 1);  // GL's upper right
        const float value[] = {-1e30f, 2, 3, 4};
        glClearBufferfv(GL_COLOR, 0, value);
        glDisable(GL_SCISSOR_TEST);
    });
    EXPECT_EQ(drawn.pixel(2, 0)[0], -1e30f);
    EXPECT_EQ(drawn.pixel(2, 0)[3], 4);
    EXPECT_EQ(drawn.pixel(0, 0)[0], no_surface);
    EXPECT_EQ(drawn.pixel(2, 1)[3], no_surface);
}

TEST(Numbers, LeaveFramebufferAndViewport) {
    const FramebufferName frame;
    glBindFramebuffer(GL_FRAMEBUFFER, frame);
    glViewport(1, 2, 30, 40);
    GLint inside[4] = {};
    draw_numbers({5, 6}, [&] { glGetIntegerv(GL_VIEWPORT, inside); });
    EXPECT_EQ(std::vector<int>(inside, inside + 4), (std::vector<int>{0, 0, 5, 6}));
    GLint viewport[4] = {}, framebuffer = 0;
    glGetIntegerv(GL_VIEWPORT, viewport);
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
    EXPECT_EQ(std::vector<int>(viewport, viewport + 4), (std::vector<int>{1, 2, 30, 40}));
    EXPECT_EQ(GLuint(framebuffer), GLuint(frame));
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

/// Returns a program for a triangle at the far plane, with this body of its fragment shader.
Program far_triangle(const std::string& outputs, const std::string& body) {
    const auto source = [](const char* stage, const std::string& text) {
        ShaderSource made;
        made.stage = stage, made.text = "#version 410 core\n" + text, made.names = {"u_places"};
        return made;
    };
    return Program({source("a.vert",
                           "void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, "
                           "gl_VertexID == 2 ? 3.0 : -1.0, 1.0, 1.0); }\n"),
                    source("a.frag", outputs + "void main() { " + body + " }\n")});
}

TEST(WindowTriangle, CoversEachPixelWhateverTheDepthAndRestoresTheDepthTest) {
    const Program program = far_triangle("out vec4 o_color;\n", "o_color = vec4(7.0);");
    WindowTriangle triangle;
    for (const bool is_on : {true, false}) {
        const Image drawn = draw_numbers({5, 3}, [&] {
            glClearDepth(0);
            glClear(GL_DEPTH_BUFFER_BIT);
            glClearDepth(1);
            (is_on ? glEnable : glDisable)(GL_DEPTH_TEST);
            glUseProgram(program);
            triangle.draw();
            EXPECT_EQ(bool(glIsEnabled(GL_DEPTH_TEST)), is_on);
        });
        for (const float value : drawn.values) EXPECT_EQ(value, 7);
    }
    glEnable(GL_DEPTH_TEST);
}

TEST(WindowTriangle, BehindAllElseCoversThePixelsWithoutADepth) {
    const Program program = far_triangle("out vec4 o_color;\n", "o_color = vec4(7.0);");
    WindowTriangle triangle;
    const Image drawn = draw_numbers({4, 2}, [&] {
        glEnable(GL_SCISSOR_TEST);
        glScissor(0, 0, 2, 2);
        glClearDepth(0.5);
        glClear(GL_DEPTH_BUFFER_BIT);  // something stands on the left
        glClearDepth(1);
        glDisable(GL_SCISSOR_TEST);
        glUseProgram(program);
        triangle.draw_behind();
    });
    for (int x = 0; x < 4; ++x) EXPECT_EQ(*drawn.pixel(x, 0), x < 2 ? no_surface : 7) << x;
    GLint compare = 0;
    glGetIntegerv(GL_DEPTH_FUNC, &compare);
    EXPECT_EQ(compare, GL_LESS);
}

TEST(DifferenceMap, ShowsAnglesAndDistancesOnItsPartOfATile) {
    const auto filled = [](float x, float y) {
        return [=] {
            const float value[] = {x, y, 0, 0};
            glEnable(GL_SCISSOR_TEST);
            glScissor(0, 0, 8, 1);  // a surface in the lowest row only
            glClearBufferfv(GL_COLOR, 0, value);
            glDisable(GL_SCISSOR_TEST);
        };
    };
    const auto drawn = [&](ErrorMetric metric, int low, int high, float x, float y) {
        DifferenceMap map(metric, low, high);
        return draw_numbers({10, 4}, [&] {
            GLint target = 0;
            glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
            const Frame frame{
                .target = GLuint(target), .size = {10, 4}, .time = 0, .camera = Camera({}, 1), .probe = {}};
            map.draw(frame, {{1, 1}, {8, 3}}, 5, filled(1, 0), filled(x, y));
        });
    };
    const auto expect = [](const Image& picture, double share, const char* what) {
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 10; ++x) {
                const bool is_covered = y == 2 && x >= 6 && x < 9;
                for (int c = 0; c < 3; ++c) {
                    const float value = picture.pixel(x, y)[c];
                    if (is_covered)
                        EXPECT_NEAR(value, heat_color(share)[c], 1e-5) << what << " at " << x << ", " << y;
                    else
                        EXPECT_EQ(value, no_surface) << what << " at " << x << ", " << y;
                }
            }
    };
    const double degrees_45 = (std::log10(45) + 1) / 3;  // of the way from 0.1 to 100
    expect(drawn(ErrorMetric::angle, -1, 2, 2, 2), degrees_45, "an angle");
    expect(drawn(ErrorMetric::distance, -2, 2, 1, 10), 0.75, "a distance of 10");
    expect(drawn(ErrorMetric::distance, -2, 2, 1, 0), 0, "no distance");
}

TEST(DrawPixel, ReturnsTheOutputsOfOnePixelOfThePicture) {
    const Program program = far_triangle(
        "layout(location = 0) out vec4 o_place;\nlayout(location = 2) out vec4 o_two;\n"
        "layout(location = 1) out vec4 o_one;\nlayout(location = 3) out vec4 o_three;\n",
        "o_place = vec4(1.0); o_one = vec4(1.5); o_two = vec4(2.5); "
        "o_three = vec4(gl_FragCoord.xy, 0.0, 3.5);");
    WindowTriangle triangle;
    const glm::ivec2 size(6, 4);
    for (const glm::ivec2 pixel : {glm::ivec2(0, 0), {5, 3}, {2, 1}}) {
        const auto outputs = draw_pixel(size, pixel, [&] {
            GLint viewport[4] = {};
            glGetIntegerv(GL_VIEWPORT, viewport);
            // The pixel's place in the viewport is that in the picture, which GL counts from the lower left corner.
            EXPECT_EQ(glm::ivec2(viewport[0], viewport[1]), -glm::ivec2(pixel.x, size.y - 1 - pixel.y));
            EXPECT_EQ(glm::ivec2(viewport[2], viewport[3]), size);
            glUseProgram(program);
            triangle.draw();
        });
        EXPECT_EQ(outputs[0], glm::vec4(1));
        EXPECT_EQ(outputs[1], glm::vec4(1.5f));
        EXPECT_EQ(outputs[2], glm::vec4(2.5f));
        EXPECT_EQ(outputs[3].w, 3.5f);
    }
    EXPECT_EQ(draw_pixel(size, {1, 1}, [] {})[3], glm::vec4(0)) << "nothing is drawn";
}

TEST(SetEach, SetsTheElementsOfAnArray) {
    const Program program = far_triangle("uniform vec2 u_places[3];\nout vec4 o_color;\n",
                                         "o_color = vec4(u_places[0].y, u_places[1].x, u_places[1].y, u_places[2].x);");
    WindowTriangle triangle;
    const Image drawn = draw_numbers({1, 1}, [&] {
        glUseProgram(program);
        set_each<glm::vec2>(program, "u_places", std::array<glm::dvec2, 3>{{{1, 2}, {3, 4}, {5, 6}}});
        triangle.draw();
    });
    EXPECT_EQ(drawn.values, std::vector<float>({2, 3, 4, 5}));
}

TEST(TruthOfRays, IsTheHitOfEachPixelsRayAndInfinityWithoutAHit) {
    const glm::ivec2 size(7, 5);
    const Frame frame{.target = 0, .size = size, .time = 0, .camera = Camera({}, 7.0 / 5), .probe = {}};
    const Image truth = truth_of_rays(frame, [](const Ray& ray) -> std::optional<glm::dvec4> {
        if (ray.direction.y < -0.4) return {};
        return glm::dvec4(ray.direction, 2);
    });
    int empty = 0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const glm::dvec3 along = frame.ray(x, y).direction;
            const bool seen = along.y >= -0.4;
            empty += !seen;
            for (int c = 0; c < 3; ++c) EXPECT_EQ(truth.pixel(x, y)[c], seen ? float(along[c]) : no_surface);
            EXPECT_EQ(truth.pixel(x, y)[3], seen ? 2 : no_surface);
        }
    EXPECT_GT(empty, 0);
    EXPECT_LT(empty, size.x * size.y);
}

TEST(Culling, KeepsEverySphereThatReachesIntoThePicture) {
    const Camera camera({.yaw = 30, .pitch = 20, .distance = 3}, 1.5);
    const glm::dmat4 clip_from_world = camera.clip_from_world();
    std::mt19937 random(1);
    const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    for (int i = 0; i < 2000; ++i) {
        const double left = between(-1, 1), right = between(left, 1);
        const Ray ray = camera.ray({between(left, right), between(-1, 1)});
        const glm::dvec3 seen = ray.at(between(0.1, 20));
        const double radius = between(0.01, 5);
        const glm::dvec3 aside(between(-1, 1), between(-1, 1), between(-1, 1));
        const glm::dvec3 centre = seen + radius * 0.999 / std::max(1.0, glm::length(aside)) * aside;
        EXPECT_TRUE(may_be_seen(clip_from_world, centre, radius, {left, right})) << i;
    }
}

TEST(Culling, DropsSpheresBesideAndBehindThePicture) {
    const Camera camera({.yaw = 30, .pitch = 20, .distance = 3}, 1.5);
    for (const glm::dvec2 beside : {glm::dvec2(-1.2, 0), {1.2, 0}, {0, -1.2}, {0, 1.2}})
        EXPECT_FALSE(may_be_seen(camera.clip_from_world(), camera.ray(beside).at(5), 0.1));
    EXPECT_FALSE(may_be_seen(camera.clip_from_world(), camera.ray({0, 0}).at(-0.2), 0.1));
    EXPECT_FALSE(may_be_seen(camera.clip_from_world(), camera.ray({0.2, 0}).at(5), 0.1, {-1, 0}));
    EXPECT_TRUE(may_be_seen(camera.clip_from_world(), camera.ray({0.2, 0}).at(5), 0.1, {0, 1}));
}

TEST(Culling, DropsAHullOnlyIfTheWholeIsBeyondOneSide) {
    const Camera camera({.yaw = 30, .pitch = 20, .distance = 3}, 1.5);
    const auto outside = [&](std::initializer_list<glm::dvec2> places, double distance) {
        std::vector<glm::dvec3> corners;
        for (const glm::dvec2 place : places) corners.push_back(camera.ray(place).at(distance));
        return is_outside(camera.clip_from_world(), corners);
    };
    for (const glm::dvec2 side : {glm::dvec2(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
        EXPECT_TRUE(outside({1.1 * side, 1.5 * side}, 5));
        EXPECT_FALSE(outside({0.9 * side, 1.5 * side}, 5)) << "one corner is visible";
        EXPECT_FALSE(outside({-1.5 * side, 1.5 * side}, 5)) << "it crosses the picture";
    }
    EXPECT_TRUE(outside({{0, 0}, {0.5, 0.5}}, -0.2)) << "behind the eye";
}

TEST(Light, HasTheDirectionOfItsYawAndPitch) {
    const auto expect_near = [](glm::dvec3 a, glm::dvec3 b) { EXPECT_LT(glm::distance(a, b), 1e-6); };
    expect_near(DistantLight{.yaw = 0, .pitch = 0}.direction(), {0, 0, 1});
    expect_near(DistantLight{.yaw = 90, .pitch = 0}.direction(), {1, 0, 0});
    expect_near(DistantLight{.yaw = 17, .pitch = 90}.direction(), {0, 1, 0});
    expect_near(DistantLight{.yaw = -50, .pitch = 40}.direction<double>(), DistantLight{}.direction());
    expect_near(lamp_at(90, 3, 2), {3, 2, 0});
}

TEST(LightView, HoldsTheWholeBoxFromAnyDirection) {
    const glm::dvec3 low(-3, 0, 1), high(5, 2, 7);
    for (const glm::dvec3& away : {glm::dvec3(0, 1, 0), {0, -1, 0}, {1, 0.3, -2}, {-4, 0.01, 0}, {0, 0, 1}}) {
        const glm::dvec3 to_light = glm::normalize(away);
        const LightView view = light_view(to_light, low, high);
        EXPECT_LT(glm::distance(view.light_from_world * to_light, glm::dvec3(0, 0, 1)), 1e-12);
        glm::dvec3 reach(0);
        for (int i = 0; i < 8; ++i) {
            const glm::dvec3 corner(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
            reach = glm::max(reach, glm::abs(glm::dvec3(view.clip_from_world * glm::dvec4(corner, 1))));
        }
        EXPECT_LT(std::max({reach.x, reach.y, reach.z}), 1);
        EXPECT_GT(std::max(reach.x, reach.y), 0.98) << "fills the map";
        EXPECT_GT(reach.z, 0.98);
        // A metre towards the light is nearer by its share of the depth; a metre aside moves by its share of the width.
        const auto clip = [&](const glm::dvec3& at) { return glm::dvec3(view.clip_from_world * glm::dvec4(at, 1)); };
        const glm::dvec3 aside = glm::dvec3(1, 0, 0) * view.light_from_world;
        EXPECT_LT(glm::distance(clip(low + to_light) - clip(low), glm::dvec3(0, 0, -2 / view.depth)), 1e-12);
        EXPECT_LT(glm::distance(clip(low + aside) - clip(low), glm::dvec3(2 / view.width, 0, 0)), 1e-12);
    }
}

/// A lab that has only a material.
class MaterialLab final : public Lab {
public:
    ReliefMaterial material;
    void draw(const Frame&) override {}
    void knobs(Knobs& knobs) override { material.knobs(knobs); }
};

class OwnMap : public testing::Test {
protected:
    /// Returns the material with this picture as its map, of 256 x 256 texels.
    void use(const Image& image) {
        const auto file = folder_.path() / "map.exr";
        write_image(file, image);
        set_knob(lab_, "size", "256");
        set_knob(lab_, "map", file.string());
    }
    TemporaryFolder folder_;
    MaterialLab lab_;
};

Image grey_ramp(int channels, float low, float high) {
    Image image(256, 256, channels);
    for (size_t i = 0; i < image.pixel_count(); ++i)
        std::fill_n(image.values.data() + i * size_t(channels), channels, low + (high - low) * float(i % 256) / 255);
    return image;
}

TEST_F(OwnMap, TakesItsHeightsFromAGreyPicture) {
    for (const int channels : {1, 3}) {
        use(grey_ramp(channels, 0.25f, 0.75f));
        EXPECT_EQ(lab_.material.heights().channels, 1);
        EXPECT_EQ(lab_.material.heights().values, grey_ramp(1, 0.25f, 0.75f).values) << channels << " channels";
    }
    const int before = lab_.material.version();
    use(grey_ramp(1, 0, 1));
    EXPECT_GT(lab_.material.version(), before) << "what is made of the heights has to be made anew";
}

TEST_F(OwnMap, TakesHeightsAndNormalsFromANormalMapWithAFourthChannel) {
    Image map = grey_ramp(4, 0, 1);
    for (size_t i = 0; i < map.pixel_count(); ++i)
        for (const auto& [c, value] : {std::pair(0, 0.8f), std::pair(1, 0.5f), std::pair(2, 0.9f)})
            map.values[i * 4 + size_t(c)] = value;
    use(map);
    EXPECT_EQ(lab_.material.heights().values, grey_ramp(1, 0, 1).values);
    const Image normals = lab_.material.normals();
    for (const size_t texel : {0, 999}) {
        EXPECT_FLOAT_EQ(normals.values[texel * 3], 0.8f) << "not those of the ramp";
        EXPECT_FLOAT_EQ(normals.values[texel * 3 + 2], 0.9f);
    }
}

}  // namespace
}  // namespace relief
