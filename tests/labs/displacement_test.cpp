// Lab 13: tessellation converges to the exact surface, reads the expected mip level and has the exact normals, at any
// distance from the origin.
#include "framework/library/kit/displaced_surface.h"
#include "framework/staff/reference/degrees.h"
#include "framework/staff/reference/patch_points.h"
#include "tests/labs/feedback.h"
#include "tests/labs/shots.h"

namespace relief {
namespace {

constexpr std::array spacings = {"equal", "fractional-odd", "fractional-even"};
constexpr std::array corner_counts = {"3", "4"};
constexpr double globe_radius = 1;  ///< of the sphere and the globe, metres

Shot one(std::vector<Knob> knobs, const char* probe, glm::ivec2 size = {96, 96}) {
    knobs.emplace(knobs.begin(), "view", "one");
    return shot_of("13", std::move(knobs), probe, size);
}

/// One lab for many shots, so that its programs are compiled once. Knobs keep their values between shots.
class Kept {
public:
    explicit Kept(Shot shot) : shot_(std::move(shot)), lab_(make_lab(find_lab("13"), shot_)) {}
    Image drawn(const std::vector<Knob>& knobs, const char* probe) {
        for (const auto& [name, value] : knobs) set_knob(*lab_, name, value);
        shot_.probe = {probe};
        return render_shot(*lab_, shot_);
    }

private:
    Shot shot_;
    std::unique_ptr<Lab> lab_;
};

/// One metre of wall per tile, a relief 0.1 m deep, and four patches of one tile each.
const std::vector<Knob> smooth_wall = {{"surface", "wall"}, {"patches", "2"}, {"map", "smooth"},
                                       {"size", "256"},     {"depth", "0.1"}, {"mip", "base"}};
const Orbit before_the_wall{.yaw = 25, .pitch = 20, .distance = 1.8};

TEST(Displacement, ApproachesTheExactWallWithTheSquareOfTheLevel) {
    for (const char* corners : corner_counts)
        for (const char* spacing : spacings) {
            double before = 0;
            for (const int level : {16, 32, 64}) {
                Shot shot = one(with(smooth_wall, {{"corners", corners}, {"spacing", spacing}}), "depth");
                shot.set.emplace_back("level", std::to_string(level));
                shot.camera = before_the_wall;
                const ErrorSummary error = error_of("13", shot);
                EXPECT_TRUE(before == 0 || std::abs(before / error.mean - 4) < 0.5)
                    << corners << " " << spacing << ", " << level << ": " << before / error.mean;
                before = error.mean;
            }
            EXPECT_LT(before, 0.0003) << spacing;
        }
}

TEST(Displacement, DrawsTheSameWallFromBehindAndAtItsEdge) {
    for (const double yaw : {155.0, 80.0}) {
        Shot shot = one(with(smooth_wall, {{"level", "64"}}), "depth");
        shot.camera = before_the_wall, shot.camera.yaw = yaw;
        // Where hills overlap in the picture, a pixel may show either of them.
        EXPECT_LT(error_of("13", shot).mean, 0.001) << yaw;
        EXPECT_LT(error_of("13", shot).p99, 0.01) << yaw;
    }
}

/// The share of the wall's pixels whose shadow is wrong, at a level of the picture and of the shadow map.
double wrong_shadows(const char* level, const char* shadow_level, const char* shadow = "on") {
    Shot shot = one(with(smooth_wall, {{"level", level},
                                       {"shadow", shadow},
                                       {"shadow_level", shadow_level},
                                       {"light_yaw", "-75"},
                                       {"light_pitch", "10"}}),
                    "shadow", {128, 128});
    shot.camera = before_the_wall;
    return error_of("13", shot).mean;
}

TEST(Displacement, ShadowsApproachTheExactOnesWithTheLevel) {
    const double coarse = wrong_shadows("8", "0"), middle = wrong_shadows("16", "0"), fine = wrong_shadows("32", "0");
    EXPECT_LT(middle, 0.7 * coarse);
    EXPECT_LT(fine, 0.7 * middle);
    EXPECT_LT(fine, 0.045) << "texels, and the offset against false shadows";
}

TEST(Displacement, AShadowMapOfFewerTrianglesThanThePictureIsWorseThanNone) {
    EXPECT_GT(wrong_shadows("64", "8"), 2 * wrong_shadows("64", "0", "off"));
}

TEST(Displacement, IsMovedByTheHeightOfThePackedMap) {
    for (const char* map : {"wall", "paving"}) {
        Shot shot =
            one(with(smooth_wall, {{"map", map}, {"packed", "on"}, {"level", "64"}, {"patches", "8"}}), "depth");
        shot.camera = before_the_wall;
        EXPECT_LT(error_of("13", shot).mean, 0.002) << map;
    }
}

TEST(Displacement, FractionalSpacingsMoveWithTheLevelAndEqualOnesJump) {
    std::vector<double> largest;
    for (const char* spacing : spacings) {
        Shot shot = one(with(smooth_wall, {{"spacing", spacing}}), "depth", {48, 48});
        shot.camera = before_the_wall;
        const auto lab = make_lab(find_lab("13"), shot);
        std::optional<Image> before;
        double step = 0;
        for (int i = 0; i <= 80; ++i) {
            set_knob(*lab, "level", std::to_string(12 + i * 0.025));
            const Image now = render_shot(*lab, shot);
            double sum = 0, count = 0;
            for (size_t p = 0; before && p < now.values.size(); p += 4)
                if (now.values[p] != no_surface && before->values[p] != no_surface)
                    sum += std::abs(double(now.values[p] - before->values[p])), ++count;
            if (before) step = std::max(step, sum / count);
            before = now;
        }
        largest.push_back(step);
    }
    EXPECT_NEAR(largest[0] * 1000, 2.15, 0.05) << "millimetres";
    EXPECT_LE(largest[1] * 1000, 0.05);
    EXPECT_LE(largest[2] * 1000, 0.05);
}

TEST(Displacement, CutsAPatchIntoTheNumberOfTrianglesOfItsLevel) {
    struct Cut {
        const char *level, *spacing;
        int quads, triangles;  ///< of a patch with four and with three corners
    };
    // A patch of four corners has two triangles per cell. A patch of three corners consists of rings, each with about
    // six triangles fewer than the next outer one.
    for (const Cut& cut : std::vector<Cut>{{"1", "equal", 2, 1},
                                           {"2", "equal", 8, 6},
                                           {"3", "equal", 18, 13},
                                           {"3.5", "equal", 32, 24},
                                           {"3.5", "fractional-odd", 50, 37},
                                           {"3.5", "fractional-even", 32, 24},
                                           {"64", "fractional-odd", 2 * 63 * 63, 5953},
                                           {"64", "equal", 2 * 64 * 64, 6 * 32 * 32}})
        for (const bool is_quad : {true, false}) {
            const int wanted = is_quad ? cut.quads : cut.triangles;
            const Shot shot = one({{"surface", "wall"},
                                   {"patches", "1"},
                                   {"corners", is_quad ? "4" : "3"},
                                   {"level", cut.level},
                                   {"spacing", cut.spacing}},
                                  "depth");
            const size_t triangles = triangles_of(*make_lab(find_lab("13"), shot), shot).size() / 3;
            EXPECT_EQ(triangles, size_t(wanted * (is_quad ? 1 : 2))) << cut.spacing << " " << cut.level;
        }
}

TEST(Displacement, ReadsTheMipLevelWhoseTexelsAreAsWideAsASegment) {
    for (const char* corners : corner_counts) {
        Shot shot =
            one({{"surface", "wall"}, {"corners", corners}, {"map", "smooth"}, {"size", "512"}}, "mip", {32, 32});
        shot.camera = before_the_wall;
        Kept kept(shot);
        for (const int patches : {1, 4, 32})
            for (const double level : {1.0, 3.5, 16.0, 64.0}) {
                if (patches * level > 256) continue;  // too many triangles
                // Two tiles per side. In triangles the diagonals count as well. They are up to sqrt(2) times as long.
                const double wanted = std::log2(2 * 512 / double(patches) / level), slack = *corners == '3' ? 0.5 : 0;
                const Image mip =
                    kept.drawn({{"patches", std::to_string(patches)}, {"level", std::to_string(level)}}, "mip");
                for (size_t i = 0; i < mip.values.size(); i += 4) {
                    if (mip.values[i] == no_surface) continue;
                    ASSERT_GE(double(mip.values[i]), std::max(wanted, 0.0) - 1e-5) << patches << ", level " << level;
                    ASSERT_LE(double(mip.values[i]), std::max(wanted + slack, 0.0) + 1e-5)
                        << patches << ", level " << level;
                }
            }
        // The whole wall has two texels, so there is nothing above level 0.
        EXPECT_EQ(kept.drawn({{"size", "1"}, {"patches", "4"}, {"level", "4"}}, "mip").values[0], 0.0f);
    }
}

/// A displaced surface drawn with the lab's shaders, for settings that the knobs do not offer.
class Rig {
public:
    Rig() {
        surface.shape = DisplacedSurface::torus, surface.density = 6;
        surface.material.map = 3, surface.material.size = 1;
    }
    DisplacedSurface surface;
    float level = 12;
    int normals = 3;  ///< value of the knob: normals of the surface

    /// Draws a probe. The orbit is relative to the surface's origin.
    Image probe(const char* name, Orbit orbit, glm::ivec2 size = {64, 64}) {
        orbit.target += surface.origin;
        const Target target(TargetKind::probe, size);
        glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
        glViewport(0, 0, size.x, size.y);
        glEnable(GL_DEPTH_TEST);
        glClearColor(no_surface, no_surface, no_surface, no_surface);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        const Program& program = programs_.with({std::string("PROBE_") + name, surface.corners_define(),
                                                 "SPACING equal_spacing", "NORMALS " + std::to_string(normals)});
        glUseProgram(program);
        surface.set(program, {target.framebuffer(), size, 0, Camera(orbit, double(size.x) / size.y), {name}});
        program.set("u_level", level);
        program.set("u_inside", level);
        surface.draw();
        const Image image = target.read();
        glDisable(GL_DEPTH_TEST);
        return image;
    }

private:
    Programs programs_{"common/patch.vert", "13_displacement/patch.tesc", "13_displacement/surface.tese",
                       "13_displacement/surface.frag"};
};

TEST(Displacement, IsUnchangedAMillionMetresAway) {
    Rig rig;
    for (const char* probe : {"depth", "normal"}) {
        rig.surface.origin = {};
        const Orbit orbit{.yaw = 30, .pitch = 35, .distance = 4};
        const Image here = rig.probe(probe, orbit);
        rig.surface.origin = {1e6, -1e6, 1e6};
        const Image there = rig.probe(probe, orbit);
        size_t pixels = 0, outline = 0;
        float largest = 0;
        for (size_t i = 0; i < here.values.size(); i += 4) {
            const bool is_here = here.values[i] != no_surface;
            outline += is_here != (there.values[i] != no_surface);
            if (!is_here || there.values[i] == no_surface) continue;
            ++pixels;
            for (size_t c = 0; c < 3; ++c)
                largest = std::max(largest, std::abs(here.values[i + c] - there.values[i + c]));
        }
        EXPECT_GT(pixels, 1000u);
        EXPECT_EQ(outline, 0u);
        // Nine of the camera's sixteen decimal digits are before the point. The float result keeps seven.
        EXPECT_LT(largest, 1e-4f) << probe;
    }
}

/// Returns the normal of the surface to which all levels converge. Uses central differences of four positions at a
/// spacing of one texel, and no derivatives.
glm::dvec3 normal_from_places(const DisplacedSurface& surface, const HeightField& heights, size_t patch,
                              glm::dvec2 place) {
    const double step = 0.5 * surface.density / (double(surface.tiles().x) * heights.size().x);
    const auto at = [&](double x, double y) {
        return displaced_on(surface.patches(), patch, {place + step * glm::dvec2(x, y), 0}, heights,
                            double(surface.scale()))
            .position;
    };
    return glm::normalize(glm::cross(at(1, 0) - at(-1, 0), at(0, 1) - at(0, -1)));
}

/// So close that a pixel is smaller than a texel everywhere. The fragment shader then reads level 0.
Orbit close_up(int shape) {
    return {.yaw = 20,
            .pitch = 15,
            .distance = shape == DisplacedSurface::torus ? 1.9 : 1.7,
            .target = {0, 0, 0},
            .field_of_view = shape == DisplacedSurface::sphere ? 25.0 : 6.0};
}

TEST(Displacement, HasTheNormalsOfTheExactSurface) {
    for (const int shape : {DisplacedSurface::wall, DisplacedSurface::sphere, DisplacedSurface::torus}) {
        Rig rig;
        rig.surface.shape = shape, rig.surface.material.map = 0, rig.level = 64;
        rig.surface.density = shape == DisplacedSurface::torus ? 5 : 4;
        // So close that a pixel is smaller than a texel. The fragment shader then reads level 0.
        const Orbit orbit = close_up(shape);
        const Image normals = rig.probe("normal", orbit), places = rig.probe("place", orbit);
        const HeightField heights(rig.surface.heights(), true);
        double sum = 0, largest = 0, count = 0;
        for (size_t i = 0; i < normals.values.size(); i += 4) {
            const float *const normal = &normals.values[i], *const place = &places.values[i];
            if (normal[0] == no_surface) continue;
            const glm::dvec3 exact = normal_from_places(rig.surface, heights, size_t(std::lround(place[2])),
                                                        {double(place[0]), double(place[1])});
            const double off = degrees_between({normal[0], normal[1], normal[2]}, exact);
            sum += off, largest = std::max(largest, off), ++count;
        }
        EXPECT_GT(count, 1000);
        // The slope of the map is a central difference at the fragment's own level. The positions lie on the bilinear
        // map.
        EXPECT_LT(sum / count, 0.25) << shape;
        EXPECT_LT(largest, 1) << shape;
    }
}

TEST(Displacement, SlopesGrowWhereTheBaseShrinks) {
    // A sphere displaced by d (negative means inwards) scales lengths on it by 1 + d / radius, and each slope by 1 / (1
    // + d / radius). Blinn's normals (1978) ignore that: an error of 1.47 degrees at slope 1 and d = -0.05 radii.
    Rig rig;
    rig.surface.shape = DisplacedSurface::sphere, rig.surface.material.map = 0, rig.surface.density = 32, rig.level = 4;
    const Orbit orbit = close_up(DisplacedSurface::sphere);
    const Image whole = rig.probe("normal", orbit), places = rig.probe("place", orbit);
    rig.normals = 2;
    const Image blinn = rig.probe("normal", orbit);
    const HeightField heights(rig.surface.heights(), true);
    double difference = 0, off = 0, count = 0;
    for (size_t i = 0; i < whole.values.size(); i += 4) {
        const float *const place = &places.values[i], *const a = &whole.values[i], *const b = &blinn.values[i];
        if (place[0] == no_surface) continue;
        const glm::dvec3 at =
            displaced_on(rig.surface.patches(), size_t(std::lround(place[2])), {double(place[0]), double(place[1]), 0},
                         heights, double(rig.surface.scale()))
                .position;
        const auto slope = [&](const float* normal) {
            return glm::radians(degrees_between({normal[0], normal[1], normal[2]}, at));
        };
        const double wanted = std::atan(std::tan(slope(b)) * globe_radius / glm::length(at));
        difference += glm::degrees(slope(a) - slope(b)), off = std::max(off, glm::degrees(std::abs(slope(a) - wanted)));
        ++count;
    }
    EXPECT_NEAR(difference / count, 1.09, 0.01);
    // A patch is flat. It spans 3 degrees of the sphere, and its middle lies 0.0004 radii inside.
    EXPECT_LT(off, 0.1);
}

TEST(Displacement, EqualsTheFlatMeshBitForBitWithoutDepthOrAtFullHeight) {
    struct Relief {
        const char *map, *depth;
    };
    const std::vector<Relief> reliefs = {{"stones", "0"}, {"fbm", "0"}, {"high", "0.5"}, {"stones", "0.2"}};
    const std::vector<const char*> surfaces = {"wall", "sphere", "torus", "column", "box"};
    Kept kept(one({{"level", "3"}, {"normals", "base"}}, "depth", {48, 48}));
    std::vector<Image> flat;
    for (const Relief& relief : reliefs) {
        kept.drawn({{"map", relief.map}, {"depth", relief.depth}}, "depth");
        for (size_t i = 0; i < surfaces.size(); ++i)
            for (const char* probe : {"depth", "normal"}) {
                Image image = kept.drawn({{"surface", surfaces[i]}}, probe);
                if (&relief == &reliefs.front()) {
                    flat.push_back(std::move(image));
                    continue;
                }
                const bool is_same = image.values == flat[2 * i + (*probe == 'n')].values;
                EXPECT_EQ(is_same, &relief != &reliefs.back())
                    << surfaces[i] << ", " << probe << ", " << relief.map << " " << relief.depth;
            }
    }
}

TEST(Displacement, TheNormalMappedHalfIsIndependentOfTessellation) {
    Kept kept(shot_of("13", {{"view", "beside"}, {"show", "light"}, {"patches", "2"}}, "", {160, 100}));
    const auto half = [&](const Knob& knob) {
        const Image picture = kept.drawn({knob}, "");
        Image left(80, 100, 3);
        for (int y = 0; y < left.height; ++y) std::copy_n(picture.pixel(0, y), 80 * 3, left.pixel(0, y));
        return left;
    };
    const Image plain = half({"level", "2"});
    EXPECT_FALSE(is_one_color(plain));
    for (const Knob& knob : std::vector<Knob>{
             {"level", "9"}, {"inside", "5"}, {"spacing", "fractional-odd"}, {"mip", "base"}, {"normals", "base"}})
        EXPECT_EQ(half(knob).values, plain.values) << knob.first;
    EXPECT_NE(half({"depth", "0.3"}).values, plain.values) << "its normals are of a deeper relief";
}

TEST(Displacement, EveryRayThatEntersAClosedSurfaceLeavesIt) {
    for (const char* surface : {"sphere", "globe", "torus", "box"})
        for (const char* corners : corner_counts)
            for (const char* spacing : spacings) {
                Shot shot = one({{"surface", surface}, {"corners", corners}, {"spacing", spacing}, {"patches", "2"}},
                                "winding", {64, 64});
                shot.camera.distance = 5;
                const auto lab = make_lab(find_lab("13"), shot);
                for (const char* level : {"1", "3.3", "10"}) {
                    set_knob(*lab, "level", level);
                    EXPECT_EQ(holes_of(render_shot(*lab, shot)), 0u)
                        << surface << " " << corners << " " << spacing << " " << level;
                }
            }
}

TEST(Displacement, EveryPixelIsFiniteForAnyDepth) {
    Rig rig;
    rig.level = 5;
    for (const int shape : {DisplacedSurface::wall, DisplacedSurface::globe, DisplacedSurface::torus,
                            DisplacedSurface::box, DisplacedSurface::urn})
        for (const float depth : {0.0f, 1e-30f, 1e-6f, 0.5f, 1e6f}) {
            rig.surface.shape = shape, rig.surface.depth = depth;
            for (const char* probe : {"depth", "normal", "place"})
                for (const float value : rig.probe(probe, {.distance = depth > 1 ? 3e6 : 4.0}, {40, 40}).values)
                    ASSERT_TRUE(std::isfinite(value) || value == no_surface)
                        << probe << " of shape " << shape << ", " << depth;
        }
}

}  // namespace
}  // namespace relief
