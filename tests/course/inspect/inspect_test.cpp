// The findings of inspect() on maps with planted faults, and on maps without faults.
#include "framework/course/inspect/inspect.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <limits>
#include <random>
#include <set>

#include "framework/core/base/paths.h"
#include "framework/core/image/color.h"
#include "framework/core/image/file.h"
#include "framework/course/inspect/slopes.h"
#include "framework/library/maps/test_maps.h"
#include "framework/staff/reference/normals.h"
#include "tests/support.h"

namespace relief::inspect {
namespace {

struct NamedMap {
    std::string name;
    Image map;
};

/// Rounds the values to integers of `bits` bits. 32 leaves them unchanged.
Image stored(Image map, int bits) {
    map.bits = bits;
    if (bits == 32) return map;
    const float largest = bits == 8 ? 255 : 65535;
    for (float& value : map.values) value = std::round(std::clamp(value, 0.0f, 1.0f) * largest) / largest;
    return map;
}

Image normals_of(HeightMap kind, int size, double texels, int bits, SlopeFilter filter = SlopeFilter::central) {
    NormalOptions options{.filter = filter};
    options.texels_u = options.texels_v = texels;
    return stored(normals_from_heights(make_height_map(kind, size), options), bits);
}

Image asset(const char* name) { return read_image(course_root() / "assets" / name); }

/// Tangent-space maps of many kinds without a fault: steep and shallow, smooth and rough.
const std::vector<NamedMap>& good_maps() {
    static const std::vector<NamedMap> maps = [] {
        std::vector<NamedMap> made = {{"assets/bricks", asset("bricks_normal.png")},
                                      {"assets/paving", asset("paving_normal.png")},
                                      {"assets/quilt", asset("quilt_tangent.png")}};
        const struct {
            HeightMap kind;
            double texels;
        } kinds[] = {{HeightMap::smooth, 12}, {HeightMap::fbm, 8},  {HeightMap::bricks, 3},
                     {HeightMap::stones, 16}, {HeightMap::rock, 8}, {HeightMap::posts, 1}};
        for (const auto& [kind, texels] : kinds)
            for (const int bits : {8, 16, 32})
                made.push_back({std::string(height_map_names[size_t(kind)]) + "/" + std::to_string(bits),
                                normals_of(kind, 256, texels, bits)});
        made.push_back({"fbm, odd size", normals_of(HeightMap::fbm, 203, 8, 8)});
        made.push_back({"stones by Sobel", normals_of(HeightMap::stones, 256, 16, 8, SlopeFilter::sobel)});
        made.push_back({"stones by spline", normals_of(HeightMap::stones, 256, 16, 8, SlopeFilter::spline)});
        made.push_back({"stones, forward", normals_of(HeightMap::stones, 256, 16, 8, SlopeFilter::forward)});
        // The border of the pyramid is an edge of its relief, as in a tile.
        Image pyramid(256, 256, 1);
        for (int y = 0; y < 128; ++y)
            for (int x = 0; x < 128; ++x) *pyramid.pixel(x, y) = float(std::min({x, y, 128 - x, 128 - y})) / 64;
        made.push_back({"pyramid", stored(normals_from_heights(pyramid, {.texels_u = 100, .texels_v = 100}), 8)});
        return made;
    }();
    return maps;
}

/// Returns a text such as "green: down" for each finding with this outcome.
std::set<std::string> found(const Inspection& inspection, Outcome outcome) {
    std::set<std::string> names;
    for (const Finding& finding : inspection.findings)
        if (finding.outcome == outcome) names.insert(finding.name + ": " + finding.verdict);
    return names;
}
std::set<std::string> faults_of(const Image& map) { return found(inspect(map), Outcome::fault); }

std::string verdict(const Inspection& inspection, const std::string& name) {
    const Finding* const finding = inspection.find(name);
    return finding ? finding->verdict : "";
}

using Texel = std::function<void(glm::vec3&)>;

/// Changes the stored values of each texel, and rounds the map again.
Image changed(Image map, const Texel& change) {
    for (size_t i = 0; i < map.pixel_count(); ++i) {
        float* const texel = map.values.data() + i * size_t(map.channels);
        glm::vec3 value(texel[0], texel[1], texel[2]);
        change(value);
        texel[0] = value.x, texel[1] = value.y, texel[2] = value.z;
    }
    return stored(std::move(map), map.bits);
}
/// Changes the decoded vectors in the same way.
Image with_vectors(const Image& map, const Texel& change) {
    return changed(map, [&](glm::vec3& c) {
        glm::vec3 n = 2.0f * c - 1.0f;
        change(n);
        c = 0.5f * n + 0.5f;
    });
}

Image cropped(const Image& map, int left, int top, int width, int height) {
    Image result(width, height, map.channels, map.bits);
    for (int y = 0; y < height; ++y)
        std::copy_n(map.pixel(left, top + y), size_t(width) * size_t(map.channels), result.pixel(0, y));
    return result;
}

/// Turns the picture by 90 degrees or mirrors it, but keeps its vectors.
Image transposed(const Image& map) { return laid(map, {false, false, true}); }
Image mirrored(const Image& map) { return laid(map, {true, false, false}); }
Image quarter_turn(const Image& map) { return laid(map, {true, false, true}); }

/// Posts at a spacing of 16 texels stand on a plane, and the sides of the pyramid are planes. Their slopes therefore
/// match at any cut.
bool fits_when_cropped(const std::string& name) { return name.starts_with("posts") || name == "pyramid"; }

void turn_green(glm::vec3& c) { c.y = 1 - c.y; }
void to_srgb(glm::vec3& c) {
    for (int i = 0; i < 3; ++i) c[i] = float(srgb_from_linear(c[i]));
}
void from_srgb(glm::vec3& c) {
    for (int i = 0; i < 3; ++i) c[i] = float(linear_from_srgb(c[i]));
}

TEST(Inspect, ReportsNoFaultOnGoodMaps) {
    for (const auto& [name, map] : good_maps()) {
        const Inspection result = inspect(map);
        EXPECT_EQ(found(result, Outcome::fault), std::set<std::string>{}) << name;
        EXPECT_EQ(verdict(result, "kind"), "tangent space") << name;
        EXPECT_EQ(verdict(result, "stored"), "linear") << name;
        EXPECT_EQ(verdict(result, "length"), "unit") << name;
        EXPECT_EQ(verdict(result, "green"), "up") << name;
        EXPECT_EQ(verdict(result, "seam"), "none") << name;
        if (map.bits == 8) {
            EXPECT_TRUE(verdict(result, "zero") == "127.5" || verdict(result, "zero") == "cannot tell") << name;
        }
        EXPECT_EQ(std::count(result.marks.begin(), result.marks.end(), 0), std::ptrdiff_t(result.marks.size())) << name;
    }
}

TEST(Inspect, FindsEachPlantedFaultAndNoOther) {
    const struct {
        const char* fault;
        std::function<Image(const Image&)> plant;
    } plants[] = {
        {"green: down", [](const Image& map) { return changed(map, turn_green); }},
        {"stored: sRGB", [](const Image& map) { return changed(map, to_srgb); }},
        {"stored: darkened", [](const Image& map) { return changed(map, from_srgb); }},
        {"length: not unit", [](const Image& map) { return with_vectors(map, [](glm::vec3& n) { n *= 0.8f; }); }},
        {"side: blue turned", [](const Image& map) { return with_vectors(map, [](glm::vec3& n) { n.z = -n.z; }); }},
        {"side: into the surface",
         [](const Image& map) {
             Image planted = map;
             for (int i = 0; i < 5; ++i) {
                 float* const texel = planted.pixel(40 + 7 * i, 100);
                 texel[0] = texel[1] = 0.5f + 0.5f * 0.6f, texel[2] = 0.5f - 0.5f * 0.529f;
             }
             return stored(planted, planted.bits);
         }},
        {"length: not unit",
         [](const Image& map) {
             Image planted = map;
             std::fill_n(planted.pixel(60, 60), 3, 0.5f);  // a texel without a direction
             return planted;
         }},
        {"seam: left and right", [](const Image& map) { return cropped(map, 0, 0, map.width * 71 / 100, map.height); }},
        {"seam: top and bottom",
         [](const Image& map) { return cropped(map, 0, map.height * 13 / 100, map.width, map.height * 71 / 100); }},
        {"green: swapped", [](const Image& map) { return changed(map, [](glm::vec3& c) { std::swap(c.x, c.y); }); }},
        {"green: turned by 90 degrees", quarter_turn},
        {"parts: green differs",
         [](const Image& map) {
             Image planted = map;
             const Image turned = changed(map, turn_green);
             const int side = map.width / 3;
             for (int y = 0; y < side; ++y)
                 std::copy_n(turned.pixel(side, side + y), size_t(side) * 3, planted.pixel(side, side + y));
             return planted;
         }},
    };
    // A quilt of diagonal ridges is still a valid quilt after a turn.
    const auto is_none = [](const std::string& name, const std::string& fault) {
        return (fits_when_cropped(name) && fault.starts_with("seam")) ||
               (name == "assets/quilt" && (fault == "green: swapped" || fault == "green: turned by 90 degrees"));
    };
    for (const auto& [name, map] : good_maps())
        for (const auto& [fault, plant] : plants)
            if ((map.bits == 8 || name == "stones/32") && !is_none(name, fault)) {
                EXPECT_EQ(faults_of(plant(map)), std::set<std::string>{fault}) << name;
            }
}

TEST(Inspect, FindsSeveralFaultsAtOnce) {
    for (const auto& [name, map] : good_maps()) {
        if (fits_when_cropped(name) || map.bits != 8) continue;
        const Image crop = cropped(map, 0, 0, map.width * 71 / 100, map.height);
        EXPECT_EQ(faults_of(changed(changed(crop, turn_green), to_srgb)),
                  (std::set<std::string>{"green: down", "stored: sRGB", "seam: left and right"}))
            << name;
    }
}

TEST(Inspect, IdentifiesTheCodeForZero) {
    const struct {
        const char* verdict;
        std::function<float(float)> code;
    } rules[] = {{"127.5", [](float n) { return std::round(127.5f * n + 127.5f); }},
                 {"128", [](float n) { return std::round(127 * n) + 128; }},
                 {"127, cut", [](float n) { return std::floor(127.5f * n + 127.5f); }}};
    for (const auto& [name, map] : good_maps()) {
        if (map.bits != 32) continue;
        for (const auto& rule : rules) {
            const std::string expected = rule.verdict;
            Image coded = with_vectors(map, [&](glm::vec3& n) {
                n = glm::normalize(n);
                for (int c = 0; c < 3; ++c) n[c] = 2 * rule.code(n[c]) / 255 - 1;
            });
            coded.bits = 8;
            const Inspection result = inspect(stored(coded, 8));
            // Shallow slopes, and the slopes of a few posts, have few colours. They may be inconclusive, but not wrong.
            const bool has_few = name == "smooth/32" || name == "posts/32";
            EXPECT_TRUE(verdict(result, "zero") == expected || (has_few && verdict(result, "zero") == "cannot tell"))
                << name << ", " << expected << ": " << verdict(result, "zero");
            EXPECT_EQ(result.faults(), 0) << name << ", " << expected;
        }
    }
}

TEST(Inspect, ReadsFloatsThatStoreTheVectorUnscaled) {
    for (const auto& [name, map] : good_maps()) {
        if (map.bits != 32) continue;
        const Image itself = changed(map, [](glm::vec3& c) { c = 2.0f * c - 1.0f; });
        const Inspection result = inspect(itself);
        EXPECT_EQ(verdict(result, "stored"), "signed") << name;
        EXPECT_EQ(verdict(result, "green"), "up") << name;
        EXPECT_EQ(result.faults(), 0) << name;
        EXPECT_EQ(faults_of(changed(itself, [](glm::vec3& n) { n.y = -n.y; })), std::set<std::string>{"green: down"});
    }
}

TEST(Inspect, RecognisesObjectSpaceMapsAndTheirFaults) {
    for (const char* name : {"quilt_object.png", "quilt_world.png"}) {
        const Image map = asset(name);
        EXPECT_EQ(faults_of(map), std::set<std::string>{}) << name;
        EXPECT_EQ(verdict(inspect(map), "kind"), "object space") << name;
        EXPECT_EQ(verdict(inspect(map), "green"), "cannot tell") << name;
        EXPECT_EQ(faults_of(changed(map, to_srgb)), std::set<std::string>{"stored: sRGB"}) << name;
        EXPECT_EQ(faults_of(changed(map, from_srgb)), std::set<std::string>{"stored: darkened"}) << name;
        EXPECT_EQ(faults_of(cropped(map, 0, 0, 365, map.height)), std::set<std::string>{"seam: left and right"})
            << name;
        // A bake leaves uncovered texels in one colour.
        Image baked = map;
        for (int y = 0; y < 200; ++y) std::fill_n(baked.pixel(100, 100 + y), 300 * 3, 0.0f);
        EXPECT_EQ(faults_of(baked), std::set<std::string>{}) << name;
        EXPECT_EQ(verdict(inspect(baked), "background"), "one color") << name;
    }
}

/// Returns the map with channel order[k] of `map` in channel k.
Image reordered(const Image& map, const std::array<int, 3>& order) {
    return changed(map, [&](glm::vec3& c) { c = {c[order[0]], c[order[1]], c[order[2]]}; });
}

TEST(Inspect, IdentifiesEachChannelOrder) {
    const struct {
        std::array<int, 3> order;
        const char *finding, *verdict;
    } orders[] = {{{0, 2, 1}, "order", "x in red, y in blue, z in green"},
                  {{2, 1, 0}, "order", "x in blue, y in green, z in red"},
                  {{1, 2, 0}, "order", "x in blue, y in red, z in green"},
                  {{2, 0, 1}, "order", "x in green, y in blue, z in red"},
                  {{1, 0, 2}, "green", "swapped"}};
    for (const auto& [name, map] : good_maps()) {
        if (map.bits != 8) continue;
        const Inspection as_it_is = inspect(map);
        EXPECT_EQ(verdict(as_it_is, "order"), "") << name;
        if (verdict(as_it_is, "green") != "up") continue;  // its slopes cannot distinguish orders
        for (const auto& [order, finding, right] : orders) {
            // A stitch of the quilt is nearly its own transpose, so a swap of red and green also gives a height field.
            if (name == "assets/quilt" && order[2] == 2) continue;
            const Inspection told = inspect(reordered(map, order));
            EXPECT_EQ(verdict(told, finding), right) << name;
            EXPECT_EQ(told.faults(), 1) << name << ", " << right;
        }
    }
}

TEST(Inspect, IdentifiesChannelOrdersWithAFlippedAxisExceptFlatObjects) {
    // Negating an axis mirrors an order, or makes a mirrored order a rotation. The map of a rotated floor or wall can
    // have that rotation, so it is no fault.
    const Image map = normals_of(HeightMap::stones, 256, 16, 8);
    std::array<int, 3> order = {0, 1, 2};
    do {
        const bool odd = (order[0] + 1) % 3 != order[1];
        for (int axis = 0; axis < 3; ++axis) {
            const Inspection told =
                inspect(reordered(with_vectors(map, [&](glm::vec3& n) { n[axis] = -n[axis]; }), order));
            const auto where = [&] { return fmt::format("{}{}{}, {} turned", order[0], order[1], order[2], axis); };
            if (order[2] == 2) {
                EXPECT_GE(told.faults(), 1) << where();  // z stays in blue, so other faults are found
            } else if (odd) {
                EXPECT_EQ(told.faults(), 0) << where();
                EXPECT_NE(told.find("kind")->reason.find("flat"), std::string::npos) << where();
            } else {
                EXPECT_NE(verdict(told, "order"), "") << where();
            }
        }
    } while (std::next_permutation(order.begin(), order.end()));
}

TEST(Inspect, CallsNoObjectSpaceMapSwapped) {
    const Image object = asset("quilt_object.png");
    EXPECT_EQ(verdict(inspect(object), "order"), "");
    // A flat object in six directions, with y up and with z up: stones of a floor, a ceiling and four walls.
    const std::vector<std::function<glm::vec3(glm::vec3)>> turns = {
        [](glm::vec3 n) { return glm::vec3(n.x, n.z, -n.y); }, [](glm::vec3 n) { return glm::vec3(n.x, -n.z, n.y); },
        [](glm::vec3 n) { return glm::vec3(n.z, n.y, -n.x); }, [](glm::vec3 n) { return glm::vec3(-n.z, n.y, n.x); },
        [](glm::vec3 n) { return glm::vec3(-n.x, n.z, n.y); }, [](glm::vec3 n) { return glm::vec3(-n.x, -n.z, -n.y); },
        [](glm::vec3 n) { return glm::vec3(-n.z, -n.x, n.y); }};
    const Image map = normals_of(HeightMap::stones, 256, 16, 8);
    for (const auto& turn : turns)
        EXPECT_EQ(verdict(inspect(with_vectors(map, [&](glm::vec3& n) { n = turn(n); })), "order"), "");
}

TEST(Inspect, RecognisesTwoChannelNormals) {
    const auto two = [](const Image& map) {
        Image result(map.width, map.height, 2, map.bits);
        for (size_t i = 0; i < map.pixel_count(); ++i) std::copy_n(&map.values[i * 3], 2, &result.values[i * 2]);
        return result;
    };
    const auto in_alpha = [](const Image& map) {
        Image result(map.width, map.height, 4, map.bits);
        for (size_t i = 0; i < map.pixel_count(); ++i) {
            const float* const n = &map.values[i * 3];
            const float texel[4] = {1, n[1], n[1], n[0]};
            std::copy_n(texel, 4, &result.values[i * 4]);
        }
        return result;
    };
    for (const auto& [name, map] : good_maps()) {
        if (map.bits != 8 || name.starts_with("assets")) continue;
        const Image blue_0 = changed(map, [](glm::vec3&c) { c.z = 0; }),
                    blue_1 = changed(map, [](glm::vec3&c) { c.z = 1; });
        for (const Image& one : {two(map), in_alpha(map), blue_0, blue_1}) {
            const Inspection result = inspect(one);
            EXPECT_EQ(found(result, Outcome::fault), std::set<std::string>{}) << name;
            EXPECT_EQ(verdict(result, "kind"), "tangent space, two channels") << name;
            EXPECT_EQ(verdict(result, "green"), "up") << name;
        }
        EXPECT_EQ(faults_of(changed(blue_0, turn_green)), std::set<std::string>{"green: down"}) << name;
    }
}

TEST(Inspect, RecognisesHeightsAndMapsThatAreNeither) {
    for (const char* name : {"bricks_height.png", "paving_height.png"}) {
        EXPECT_EQ(verdict(inspect(asset(name)), "kind"), "heights") << name;
        EXPECT_EQ(faults_of(asset(name)), std::set<std::string>{}) << name;
        EXPECT_EQ(faults_of(cropped(asset(name), 0, 0, 700, 1024)), std::set<std::string>{"seam: left and right"});
    }
    for (const char* name : {"bricks_albedo.png", "paving_albedo.png"})
        EXPECT_EQ(faults_of(asset(name)), std::set<std::string>{"kind: neither"}) << name;
    const Image heights = make_height_map(HeightMap::stones, 128);
    Image grey(128, 128, 3, 8);
    for (size_t i = 0; i < heights.values.size(); ++i) std::fill_n(&grey.values[i * 3], 3, heights.values[i]);
    EXPECT_EQ(verdict(inspect(stored(grey, 8)), "kind"), "heights");
    const Image normals = normals_of(HeightMap::stones, 128, 8, 8);
    EXPECT_EQ(verdict(inspect(heights, &normals), "heights"), "swapped files");
    EXPECT_EQ(verdict(inspect(heights, &heights), "heights"), "two of heights");
}

TEST(Inspect, RejectsSignsAndIconsAsMaps) {
    const auto drawn = [](glm::vec3 paper, glm::vec3 ink) {
        Image sign(128, 128, 3, 8);
        for (int y = 0; y < 128; ++y)
            for (int x = 0; x < 128; ++x) {
                const float share = float(std::clamp(6 - std::abs(std::hypot(x - 64, y - 64) - 40), 0.0, 1.0));
                for (int c = 0; c < 3; ++c) sign.pixel(x, y)[c] = glm::mix(paper, ink, share)[c] / 255;
            }
        return stored(sign, 8);
    };
    // The first sign has length 1 when decoded as sRGB. The second has length 0.9 and leans.
    EXPECT_EQ(faults_of(drawn({191, 191, 0}, {255, 255, 255})), std::set<std::string>{"kind: neither"});
    EXPECT_EQ(faults_of(drawn({75, 120, 229}, {90, 128, 229})), std::set<std::string>{"kind: neither"});
}

TEST(Inspect, InspectsTheFourthChannel) {
    const Image normals = normals_of(HeightMap::stones, 128, 8, 8), heights = make_height_map(HeightMap::stones, 128);
    Image map(128, 128, 4, 8);
    const auto with_fourth = [&](const std::function<float(size_t)>& fourth) {
        for (size_t i = 0; i < map.pixel_count(); ++i) {
            std::copy_n(&normals.values[i * 3], 3, &map.values[i * 4]);
            map.values[i * 4 + 3] = fourth(i);
        }
        return inspect(stored(map, 8));
    };
    EXPECT_EQ(verdict(with_fourth([](size_t) { return 1.0f; }), "fourth"), "constant");
    const Inspection relief = with_fourth([&](size_t i) { return heights.values[i]; });
    EXPECT_TRUE(contains(relief.find("fourth")->reason, "heights of this relief")) << relief.find("fourth")->reason;
    const Inspection gloss = with_fourth([](size_t i) { return float(i % 97) / 96; });
    EXPECT_TRUE(contains(gloss.find("fourth")->reason, "opacity, gloss")) << gloss.find("fourth")->reason;
    EXPECT_EQ(relief.faults() + gloss.faults(), 0);
}

TEST(Inspect, DetectsEightBitDataInAWiderFormat) {
    Image map = normals_of(HeightMap::stones, 128, 8, 8);
    EXPECT_EQ(verdict(inspect(map), "bits"), "");
    map.bits = 16;
    EXPECT_EQ(verdict(inspect(map), "bits"), "8-bit steps");
    EXPECT_EQ(verdict(inspect(normals_of(HeightMap::stones, 128, 8, 16)), "bits"), "");
}

TEST(Inspect, ExplainsWhyAMapIsInconclusive) {
    const auto reason = [](const Image& map) {
        const Inspection result = inspect(map);
        const Finding* const green = result.find("green");
        return green ? green->verdict + ": " + green->reason : "none";
    };
    Image ridges(128, 128, 1);
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 128; ++x) *ridges.pixel(x, y) = 0.5f + 0.5f * float(std::sin(2 * M_PI * x / 32));
    NormalOptions steep;
    steep.texels_u = steep.texels_v = 4;
    for (const int bits : {8, 32})
        EXPECT_TRUE(contains(reason(stored(normals_from_heights(ridges, steep), bits)), "one direction only"))
            << reason(stored(normals_from_heights(ridges, steep), bits));
    EXPECT_TRUE(contains(reason(normals_of(HeightMap::stones, 128, 0.001, 32)), "flat"));
    EXPECT_TRUE(contains(reason(normals_of(HeightMap::fbm, 6, 8, 8)), "too small"))
        << reason(normals_of(HeightMap::fbm, 6, 8, 8));

    std::mt19937 random(1);
    std::uniform_real_distribution<float> slope(-0.7f, 0.7f);
    const Image noise = changed(Image(128, 128, 3, 8), [&](glm::vec3& c) {
        c = 0.5f * glm::normalize(glm::vec3(slope(random), slope(random), 1)) + 0.5f;
    });
    EXPECT_TRUE(contains(reason(noise), "not the slopes of one height field")) << reason(noise);
}

TEST(Inspect, AMapOfOneColorIsNamed) {
    const auto reason = [](std::vector<float> color, int width, int height) {
        Image map(width, height, int(color.size()), 8);
        for (size_t i = 0; i < map.values.size(); ++i) map.values[i] = color[i % color.size()] / 255;
        const Inspection result = inspect(map);
        EXPECT_EQ(verdict(result, "kind"), "one color");
        return std::to_string(result.faults()) + ": " + result.find("kind")->reason;
    };
    for (const int side : {1, 2, 64}) {
        EXPECT_TRUE(
            contains(reason({128, 128, 255}, side, 1), "0: one colour (128, 128, 255): a flat normal map, 0.318"));
        EXPECT_TRUE(contains(reason({128, 128, 255, 255}, side, side), "0: "));
        EXPECT_TRUE(contains(reason({77, 77, 77}, side, side), "0: one colour (77, 77, 77): flat heights"));
        EXPECT_TRUE(contains(reason({77}, 1, side), "0: "));
        EXPECT_TRUE(contains(reason({188, 188, 255}, side, side), "1: ")) << "flat, stored as sRGB";
    }
}

TEST(Inspect, AcceptsAnySizeAndAnyValues) {
    constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<float> strange = {nan, inf, -inf, 1e38f, -1e38f, 1e-45f, 0, 0.5f, 1, -1};
    std::mt19937 random(2);
    const Image heights = make_height_map(HeightMap::stones, 16);
    for (const int width : {1, 2, 3, 4, 5, 7, 16, 65})
        for (const int height : {1, 2, 3, 16, 33})
            for (const int channels : {1, 2, 3, 4})
                for (const int bits : {8, 32})
                    for (int round = 0; round < 3; ++round) {
                        Image map(width, height, channels, bits);
                        for (float& value : map.values)
                            value = bits == 8   ? float(random() % 256) / 255
                                    : round > 0 ? strange[random() % strange.size()]
                                                : nan;
                        const Inspection result = inspect(map, round ? &heights : nullptr);
                        EXPECT_NE(verdict(result, "kind"), "");
                        EXPECT_EQ(result.marks.size(), map.pixel_count());
                        if (bits == 32 && round == 0) {
                            EXPECT_EQ(verdict(result, "finite"), "no");
                        }
                        const Image picture = picture_of_marks(map, result);
                        for (const float value : picture.values) ASSERT_TRUE(value >= 0 && value <= 1);
                    }
}

TEST(Inspect, OneBrokenTexelIsFoundAndChangesNoOtherVerdict) {
    for (const float broken : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        Image map = normals_of(HeightMap::stones, 256, 16, 32);
        map.pixel(30, 40)[1] = broken;
        const Inspection result = inspect(map);
        EXPECT_EQ(found(result, Outcome::fault), std::set<std::string>{"finite: no"});
        EXPECT_EQ(result.marks[40 * 256 + 30], mark_not_finite);
        EXPECT_EQ(std::count(result.marks.begin(), result.marks.end(), 0), 256 * 256 - 1);
        map.pixel(30, 40)[1] = 1e30f;
        EXPECT_EQ(faults_of(map), std::set<std::string>{"length: not unit"}) << "huge, and only there";
    }
}

TEST(Inspect, ThePictureShowsTheFaultsPositions) {
    Image map = normals_of(HeightMap::stones, 256, 16, 8);
    const Image turned = changed(map, turn_green);
    for (int y = 64; y < 128; ++y) std::copy_n(turned.pixel(128, y), 64 * 3, map.pixel(128, y));
    std::fill_n(map.pixel(10, 20), 3, 0.5f);
    const Inspection result = inspect(map);
    const Image picture = picture_of_marks(map, result);
    const auto has_color = [&](int x, int y) {
        const float* const c = picture.pixel(x, y);
        return c[0] != c[1] || c[1] != c[2];
    };
    EXPECT_TRUE(has_color(10, 20));
    EXPECT_TRUE(has_color(160, 96)) << "in the middle of what was turned";
    EXPECT_FALSE(has_color(40, 200));
    int colored = 0;
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x) colored += has_color(x, y);
    EXPECT_LE(colored, 4 * 32 * 32 + 1) << "the four squares that were turned, and one texel";
}

TEST(Inspect, ReportsHowNormalsAndHeightsMatch) {
    const auto inverted = [](Image heights) {
        for (float& h : heights.values) h = 1 - h;
        return heights;
    };
    for (const HeightMap kind : {HeightMap::fbm, HeightMap::stones, HeightMap::rock})
        for (const int bits : {8, 16, 32}) {
            const Image map = normals_of(kind, 256, 8, bits), heights = stored(make_height_map(kind, 256), bits);
            const struct {
                const char* verdict;
                Image map, heights;
            } cases[] = {
                {"agree", map, heights},
                {"agree", map, inverted(inverted(heights))},
                {"inverted", map, inverted(heights)},
                {"green turned", changed(map, turn_green), heights},
                {"red turned", changed(map, [](glm::vec3& c) { c.x = 1 - c.x; }), heights},
                {"red and green swapped", changed(map, [](glm::vec3& c) { std::swap(c.x, c.y); }), heights},
                {"mirrored or turned", map, mirrored(heights)},
                {"mirrored or turned", map, transposed(heights)},
                {"mirrored or turned", map, quarter_turn(heights)},
                {"differ", map, make_height_map(HeightMap::bricks, 256)},
                {"normals", map, map},
                {"cannot tell", map, make_height_map(HeightMap::plateau, 256)},
                {"cannot tell", map, make_height_map(kind, 100)},
            };
            for (const auto& [expected, normals, theirs] : cases) {
                const Inspection result = inspect(normals, &theirs);
                EXPECT_EQ(verdict(result, "heights"), expected) << height_map_names[size_t(kind)] << " " << bits;
            }
            const Inspection result = inspect(map, &heights);
            for (const auto& [name, value] : result.find("heights")->numbers)
                if (name == "strength") {
                    EXPECT_NEAR(value, 8, 0.5) << height_map_names[size_t(kind)] << " " << bits;
                }
        }
}

}  // namespace
}  // namespace relief::inspect
