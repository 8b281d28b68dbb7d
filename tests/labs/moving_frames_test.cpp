// Lab 18: a frame is transformed by the derivative of the motion. Also tests which bodies of a flock are drawn.
#include <glm/gtc/constants.hpp>

#include "framework/core/gl/counters.h"
#include "framework/core/gl/program.h"
#include "labs/18_moving_frames/staff/exact.h"
#include "tests/labs/shots.h"
#include "tests/support.h"

namespace relief {
namespace {

using namespace moving_frames;

/// Returns a shot of the first body's skin, unrolled. It shows every point of the skin, hidden ones included.
Shot skin(std::vector<Knob> knobs, const char* probe, glm::ivec2 size = {96, 96}) {
    knobs.emplace_back("view", "skin");
    return shot_of("18", std::move(knobs), probe, size);
}

Pose random_pose(Dice& dice, bool dual) {
    return {.bend = dice.between(0, 100),
            .twist = dice.between(-150, 150),
            .stretch = dice.between(0.5, 1.5),
            .over = dice.between(1, 6),
            .dual = dual,
            .uneven = dice.random() % 2 == 1};
}

TEST(MovingFrames, TheJacobianIsTheDerivativeOfThePoseAndItsCofactorsKeepTheNormalPerpendicular) {
    Dice dice(18);
    constexpr double step = 1e-6;
    for (int i = 0; i < 400; ++i) {
        const Body& body = i % 2 ? serpent : tube;
        const Pose pose = random_pose(dice, i % 4 > 1);
        const std::vector<Bone> bones = bones_of(body, pose);
        const glm::dvec2 uv(dice.between(0, 1), dice.between(0.02, 0.98));
        const auto at = [&](double u, double v) { return posed(body, pose, bones, uv + glm::dvec2(u, v)); };
        const glm::dvec3 along_u = (at(step, 0) - at(-step, 0)) / (2 * step),
                         along_v = (at(0, step) - at(0, -step)) / (2 * step);
        const glm::dmat3 jacobian = exact_jacobian(body, pose, bones, uv);
        const Rest rest = rest_at(body, uv);
        // The error of differences over 1e-6, for lengths of metres.
        EXPECT_LT(glm::distance(jacobian * rest.along_u, along_u), 1e-6 * body.length * (1 + glm::length(along_u)))
            << i;
        EXPECT_LT(glm::distance(jacobian * rest.along_v, along_v), 1e-6 * body.length * (1 + glm::length(along_v)))
            << i;
        const glm::dvec3 normal = cofactors(jacobian) * rest.normal;
        EXPECT_NEAR(glm::dot(normal, jacobian * rest.along_u), 0, 1e-9 * glm::length(normal)) << i;
        EXPECT_NEAR(glm::dot(normal, jacobian * rest.along_v), 0, 1e-8 * glm::length(normal)) << i;
    }
}

TEST(MovingFrames, VertexWeightsSumTo1AndFollowTheFormula) {
    for (const Body& body : {tube, serpent})
        for (const double over : {0.0, 0.4, 1.2, 99.0}) {
            const Mesh mesh = make_skin(body, 37, 5);
            const std::vector<Bound> bound = bind_skin(body, mesh, over, false);
            for (size_t i = 0; i < mesh.vertices.size(); ++i) {
                const Influence exact =
                    influence_at(body, body.length * (double(mesh.vertices[i].uv.y) - 0.5), over, false);
                double sum = 0, change = 0;
                for (int j = 0; j < 4; ++j) {
                    sum += exact.weights[j], change += exact.slopes[j];
                    EXPECT_GE(exact.weights[j], 0) << j;
                    EXPECT_EQ(bound[i].bones[size_t(j)], exact.first + j);
                    EXPECT_EQ(bound[i].weights[j], float(exact.weights[j]));
                }
                EXPECT_NEAR(sum, 1, 1e-15);
                EXPECT_NEAR(change, 0, 1e-12);
            }
        }
}

/// Mean and largest error in degrees over the tube.
struct WayError {
    const char *bend, *twist;
    double mean, most, transposed_mean;
};

TEST(MovingFrames, TheMethodsOfEnginesHaveTheErrorsOfTheHandout) {
    // Measured in double precision by a separate program. The weights span four radii of a tube of length 20/3.
    for (const auto& [bend, twist, mean, most, transposed] :
         {WayError{"30", "0", 2.24, 11.1, 2.13}, WayError{"60", "0", 4.81, 26.1, 4.19},
          WayError{"90", "0", 7.91, 47.9, 6.14}, WayError{"0", "60", 2.30, 5.9, 2.30},
          WayError{"0", "90", 4.98, 12.7, 4.98}, WayError{"0", "120", 8.33, 21.0, 8.33}}) {
        const auto off = [&, bend = bend, twist = twist](const char* way) {
            return error_of("18",
                            skin({{"shape", "tube"}, {"bend", bend}, {"twist", twist}, {"normal_by", way}}, "normal"));
        };
        // The 96 positions along the tube miss the worst one.
        for (const char* way : {"matrix", "unit-cofactors"}) {
            EXPECT_NEAR(off(way).mean, mean, 0.02) << way << ' ' << bend << ' ' << twist;
            EXPECT_NEAR(off(way).largest, most, 0.2) << way << ' ' << bend << ' ' << twist;
        }
        EXPECT_NEAR(off("inverse-transpose").mean, transposed, 0.02) << bend << ' ' << twist;
        EXPECT_NEAR(off("inverse-transpose").largest, most, 0.2) << bend << ' ' << twist;
        EXPECT_LT(off("gradient").largest, 2e-4) << bend << ' ' << twist;
    }
}

TEST(MovingFrames, NormalsByTheGradientAreExactToRounding) {
    for (const char* shape : {"tube", "serpent"})
        for (const char* blend : {"linear", "dual-quaternion"})
            for (const char* weights : {"even", "uneven"})
                for (const char* twist : {"-40", "70"})
                    // A thousandth of a degree is 2^-16 radians: a few roundings of lengths of metres.
                    EXPECT_LT(error_of("18", skin({{"shape", shape},
                                                   {"blend", blend},
                                                   {"weights", weights},
                                                   {"twist", twist},
                                                   {"bend", "75"},
                                                   {"stretch", "1.3"}},
                                                  "normal", {64, 128}))
                                  .largest,
                              1e-3)
                        << shape << ' ' << blend << ' ' << weights << ' ' << twist;
}

TEST(MovingFrames, ATwistThinsALinearSkinButNotADualQuaternionSkin) {
    const auto thinnest = [](double twist, bool dual) {
        const Pose pose{.bend = 0, .twist = twist, .dual = dual};
        const std::vector<Bone> bones = bones_of(tube, pose);
        const glm::dvec3 place = posed(tube, pose, bones, {0.3, 0.5});
        return glm::length(glm::dvec2(place.y, place.z)) / tube.radius;
    };
    // The middle of a chord is at cos(twist / 2) of the radius.
    EXPECT_NEAR(thinnest(120, false), 0.5, 1e-12);
    EXPECT_NEAR(thinnest(180, false), 0, 1e-12);
    EXPECT_NEAR(thinnest(120, true), 1, 1e-12);
    EXPECT_NEAR(thinnest(170, true), 1, 1e-12);
}

TEST(MovingFrames, DualQuaternionsHaveAGradientToo) {
    // Engines use only the blended rotation.
    const auto off = [](const char* bend, const char* twist, const char* way) {
        return error_of(
            "18",
            skin(
                {{"shape", "tube"}, {"blend", "dual-quaternion"}, {"bend", bend}, {"twist", twist}, {"normal_by", way}},
                "normal"));
    };
    EXPECT_GT(off("90", "0", "matrix").mean, 3);
    EXPECT_LT(off("90", "0", "gradient").largest, 2e-4);
    // A twist turns each ring about the axis and shears the skin within itself, so the normal does not change.
    EXPECT_LT(off("0", "120", "matrix").largest, 1e-3);
}

TEST(MovingFrames, SignsOfDualQuaternionsMakeNoDifference) {
    const auto places = [](const char* signs) {
        return drawn("18", skin({{"blend", "dual-quaternion"}, {"signs", signs}, {"twist", "80"}}, "place", {32, 64}));
    };
    const Image alike = places("alike"), opposite = places("opposite");
    for (size_t i = 0; i < alike.values.size(); ++i) ASSERT_NEAR(alike.values[i], opposite.values[i], 2e-6) << i;
}

TEST(MovingFrames, TheDeterminantDetectsAFoldedSkin) {
    const auto share = [](const char* bend, const char* over) {
        const Shot shot = skin({{"shape", "tube"}, {"bend", bend}, {"weights_over", over}}, "fold", {64, 256});
        const auto lab = make_lab(find_lab("18"), shot);
        const Image found = render_shot(*lab, shot), exact = truth_of(*lab, shot);
        int folded = 0;
        for (size_t i = 0; i < found.values.size(); i += 4) {
            if (std::abs(exact.values[i]) > 1e-5f) {
                EXPECT_EQ(found.values[i] <= 0, exact.values[i] <= 0) << i;
            }
            folded += exact.values[i] <= 0;
        }
        return double(folded) / double(found.pixel_count());
    };
    EXPECT_EQ(share("90", "4"), 0);
    EXPECT_GT(share("90", "2"), 0.01);
    EXPECT_GT(share("120", "4"), 0.001);
    // The skin folds first in the middle of the inner side. There it is scaled along its length by cos(bend / 2) - 3
    // radius / length sin(bend / 2).
    for (const double over : {2.0, 4.0, 6.0})
        for (const double bend : {40.0, 90.0, 130.0}) {
            const Pose pose{.bend = bend, .over = over};
            const double half = glm::radians(bend) / 2, along = std::cos(half) - 3 / over * std::sin(half);
            EXPECT_NEAR(glm::determinant(exact_jacobian(tube, pose, bones_of(tube, pose), {0.5, 0.5})),
                        along * std::cos(half), 1e-12)
                << bend << ' ' << over;
        }
}

TEST(MovingFrames, TheTextureOfEveryBodyGoesThroughBothTransforms) {
    Shot shot = shot_of("18", {{"instances", "30"}, {"material_turn", "20"}}, "uv", {96, 96});
    EXPECT_LT(error_of("18", shot).p99, 1e-3);
    shot.probe = {"material"};
    EXPECT_EQ(error_of("18", shot).largest, 0);
}

/// Returns the number of drawn triangles and of draw calls.
std::pair<int64_t, int64_t> work_of(std::vector<Knob> knobs, const Orbit& camera) {
    Shot shot = shot_of("18", std::move(knobs), "", {48, 48});
    shot.camera = camera;
    const Work work = work_of("18", shot);
    return {work.triangles, work.draws};
}

const Orbit far_away{.yaw = -35, .pitch = 5, .distance = 150, .target = {10, 0, -16}, .field_of_view = 40};

TEST(MovingFrames, TwoHundredBodiesAreOneDraw) {
    // Three draws: the triangle of the mist, the first body, and the flock.
    EXPECT_EQ(work_of({{"instances", "200"}}, far_away), std::pair(int64_t(1 + 6144 + 199 * 288), int64_t(3)));
    EXPECT_EQ(work_of({{"instances", "200"}, {"triangles", "12288"}, {"flock_triangles", "12288"}}, far_away),
              std::pair(int64_t(1 + 200 * 12288), int64_t(3)));
}

TEST(MovingFrames, OnlyBodiesOutsideThePictureAreCulled) {
    const Orbit camera = load_manifest(find_lab("18")).camera;
    const int64_t all = work_of({}, far_away).first;
    Orbit away = camera;
    away.yaw += 180;  // only the nearest bodies of the flock are not behind the eye
    EXPECT_LT(work_of({}, away).first, 1 + 6144 + 5 * 288);
    Orbit beside = camera;
    beside.target = {40, 0, 40};
    EXPECT_LT(work_of({}, beside).first, all / 3);
    Orbit nothing = away;
    nothing.target = {-40, 0, 60};
    EXPECT_EQ(work_of({}, nothing), std::pair(int64_t(1), int64_t(1)));
    // The truth tests every body. Its pixels and the drawn ones differ at most along outlines.
    Dice dice(18);
    for (int i = 0; i < 8; ++i) {
        Shot shot = shot_of("18", {}, "material", {64, 64});
        shot.camera = {.yaw = dice.between(-180, 180),
                       .pitch = dice.between(-40, 40),
                       .distance = dice.between(2, 20),
                       .target = {dice.between(-6, 16), dice.between(-4, 4), dice.between(-30, 4)}};
        const auto lab = make_lab(find_lab("18"), shot);
        const Image found = draw_shot(*lab, shot), exact = truth_of(*lab, shot);
        int apart = 0;
        for (size_t p = 0; p < found.values.size(); p += 4) apart += found.values[p] != exact.values[p];
        EXPECT_LE(apart, 12) << i;
    }
}

TEST(MovingFrames, ASkinAtRestReadsNoBones) {
    const auto active = [](const std::vector<std::string>& defines) {
        const std::filesystem::path folder = std::filesystem::path(source_folder) / "shaders/18_moving_frames";
        const Program program({folder / "serpent.vert", folder / "serpent.frag"}, defines);
        return std::pair(glGetAttribLocation(program, "a_bones") >= 0 || glGetAttribLocation(program, "a_weights") >= 0,
                         glGetUniformLocation(program, "u_bones[0]") >= 0);
    };
    EXPECT_EQ(active({"GRADIENT", "SERPENT", "RIGID"}), std::pair(false, false));
    EXPECT_EQ(active({"GRADIENT", "SERPENT", "NEEDS_JACOBIAN"}), std::pair(true, true));
    // The lab selects the first program if nothing bends, twists or stretches.
    const auto links = [](const char* bend, const char* blend) {
        const int64_t before = counters().links;
        const auto shot = shot_of("18", {{"view", "one"}, {"bend", bend}}, "normal", {16, 16});
        const auto lab = make_lab(find_lab("18"), shot);
        render_shot(*lab, shot);
        set_knob(*lab, "blend", blend);
        render_shot(*lab, shot);
        return counters().links - before;
    };
    EXPECT_EQ(links("0", "dual-quaternion"), links("0", "linear"));
    EXPECT_EQ(links("40", "dual-quaternion"), links("40", "linear") + 1);
}

}  // namespace
}  // namespace relief
