// Lab 05: which method comes nearest to dP/du. Hidden parts cost no work.
#include <cmath>

#include "framework/core/image/compare.h"
#include "framework/core/lab/words.h"
#include "framework/library/maps/visualize.h"
#include "tests/labs/shots.h"

namespace relief {
namespace {

double mean_error(const char* shape, const char* method, const char* probe = "tangent") {
    return error_of("05", shot_of("05", {{"view", "one"}, {"shape", shape}, {"method", method}}, probe)).mean;
}

TEST(TangentBasis, WeighingByAnglesIsNearestToTheSurface) {
    const double angle = mean_error("torus", "angle");
    EXPECT_LT(angle, 0.9 * mean_error("torus", "uniform"));
    EXPECT_LT(mean_error("torus", "uniform"), mean_error("torus", "area"));
    EXPECT_LT(mean_error("torus", "area"), 0.5 * mean_error("torus", "derivatives"));
    EXPECT_LT(mean_error("torus", "derivatives"), mean_error("torus", "per-face"));
    EXPECT_NEAR(mean_error("torus", "mikktspace"), angle, 0.01) << "it weighs by angles, too";
}

TEST(TangentBasis, EveryMethodIsExactOnFlatShapes) {
    for (const char* method : {"uniform", "area", "angle", "mikktspace", "derivatives"})
        EXPECT_LT(mean_error("quad", method), 0.01) << method;
    EXPECT_LT(mean_error("box", "angle"), 0.05) << "but for a pixel on an edge";
}

TEST(TangentBasis, AMirroredMeshHasTheSameError) {
    for (const char* method : {"uniform", "angle", "mikktspace"})
        EXPECT_NEAR(mean_error("mirrored", method, "bitangent"), mean_error("sphere", method, "bitangent"), 0.15)
            << method;
}

TEST(TangentBasis, BOfAFaceFollowsVWhereItIsShearedAndTheFrameDoesNot) {
    const auto off = [](const char* method) {
        return error_of("05", shot_of("05", {{"view", "one"}, {"shape", "quad"}, {"shear", "0.6"}, {"method", method}},
                                      "dp_dv"))
            .mean;
    };
    EXPECT_LT(off("per-face"), 0.01) << "single precision";
    EXPECT_NEAR(off("angle"), glm::degrees(std::atan(0.6)), 0.01) << "across T, which is turned by the shear";
}

Shot frame_shot(const char* shape, const char* frame, const char* probe) {
    return shot_of("05", {{"view", "frames"}, {"frame", frame}, {"shape", shape}, {"shear", "0.6"}}, probe);
}

TEST(TangentBasis, OnlyAnAveragedBFollowsVOnAShearedQuad) {
    const double shear = glm::degrees(std::atan(0.6));
    EXPECT_LT(error_of("05", frame_shot("quad", "averaged", "dp_dv")).mean, 0.01) << "single precision";
    EXPECT_NEAR(error_of("05", frame_shot("quad", "w", "dp_dv")).mean, shear, 0.01);
    EXPECT_NEAR(error_of("05", frame_shot("quad", "orthogonal", "dp_dv")).mean, shear, 0.01);
}

TEST(TangentBasis, ThreeVectorsMadeOrthogonalGiveTheBOfACrossProduct) {
    for (const char* shape : {"torus", "mirrored"}) {
        const auto b = [&](const char* frame) { return drawn("05", frame_shot(shape, frame, "bitangent")); };
        const auto off = [&](const char* frame) {
            return summarize(error_image(b(frame), b("w"), ErrorMetric::angle));
        };
        EXPECT_LT(off("orthogonal").largest, 0.05) << shape << ": single precision";
        EXPECT_GT(off("averaged").mean, 0.3) << shape;
    }
}

TEST(TangentBasis, OnATorusAnAveragedBIsFartherOffThanACrossProduct) {
    const auto off = [](const char* frame) { return error_of("05", frame_shot("torus", frame, "dp_dv")).mean; };
    EXPECT_GT(off("averaged"), 1.3 * off("w"));
}

TEST(TangentBasis, AFrameByTheNormalAloneIsOrthonormalAndIgnoresTheTexture) {
    for (const char* shape : {"quad", "box", "cylinder", "sphere", "torus", "mirrored"}) {
        const Image frame = drawn("05", frame_shot(shape, "normal-alone", "frame"));
        for (size_t i = 0; i < frame.pixel_count(); ++i) {
            const float* const values = &frame.values[i * 4];  // length of T, cosine of T and N, w
            if (values[0] == no_surface) continue;
            ASSERT_NEAR(values[0], 1, 1e-5) << shape;
            ASSERT_NEAR(values[1], 0, 1e-5) << shape;
        }
        EXPECT_GT(error_of("05", frame_shot(shape, "normal-alone", "tangent")).mean, 45) << shape;
    }
}

TEST(TangentBasis, TheColoursOfTheViewFramesAreTheAnglesToDPdV) {
    for (const char* shape : {"quad", "box", "cylinder", "sphere", "torus", "mirrored"}) {
        Shot shot = frame_shot(shape, "averaged", "dp_dv");
        const auto lab = make_lab(find_lab("05"), shot);
        const Image error = error_image(render_shot(*lab, shot), truth_of(*lab, shot), ErrorMetric::angle);
        shot.probe = {};
        shot.set.insert(shot.set.end(), {{"show", "error"}});
        std::vector<PictureWord> left_out;
        shot.words = &left_out;
        const Image picture = drawn("05", shot);
        size_t seen = 0, equal = 0;
        for (size_t i = 0; i < picture.pixel_count(); ++i) {
            if (!std::isfinite(error.values[i])) continue;
            const float* const p = &picture.values[i * 3];
            const glm::dvec3 expected = heat_color((std::log10(std::max(double(error.values[i]), 1e-6)) + 2) / 4);
            ++seen;
            equal += glm::length(glm::dvec3(p[0], p[1], p[2]) - expected) < 0.04;
        }
        EXPECT_GT(double(equal), 0.85 * double(seen)) << shape << ": the rest is on edges";
    }
}

TEST(TangentBasis, AnAveragedBIsThatOfTheMeshAfterAViewThatNeedsNone) {
    const Shot averaged = frame_shot("torus", "averaged", "dp_dv");
    const auto lab = make_lab(find_lab("05"), averaged);
    const Image before = render_shot(*lab, averaged);
    set_knob(*lab, "view", "one"), set_knob(*lab, "columns", "3");
    render_shot(*lab, averaged);
    set_knob(*lab, "view", "frames"), set_knob(*lab, "columns", "24");
    EXPECT_EQ(render_shot(*lab, averaged).values == before.values, true);
}

TEST(TangentBasis, DisabledLinesCostNoDrawAndNoProgram) {
    const Work off = work_of("05", shot_of("05", {{"lines", "off"}})),
               on = work_of("05", shot_of("05", {{"lines", "on"}}));
    EXPECT_EQ(on.draws - off.draws, 5) << "once for each method that has tangents at its vertices";
    EXPECT_EQ(on.links - off.links, 1);
}

TEST(TangentBasis, CollapsedUvStillGiveAFrame) {
    for (const char* method : {"per-face", "uniform", "area", "angle", "mikktspace", "derivatives"})
        for (const char* shape : {"quad", "sphere", "urn"}) {
            const Shot shot =
                shot_of("05", {{"view", "one"}, {"shape", shape}, {"method", method}, {"collapsed", "on"}}, "tangent",
                        {64, 64});
            const Image tangent = drawn("05", shot);  // throws when it is not a number anywhere
            for (size_t i = 0; i < tangent.pixel_count(); ++i) {
                const float* const t = &tangent.values[i * 4];
                // Between vertices whose directions are any at all the sum may be short, but it is there.
                ASSERT_GT(t[0] * t[0] + t[1] * t[1] + t[2] * t[2], 1e-4) << shape << ", " << method;  // or infinite
            }
        }
}

TEST(TangentBasis, TheCoarsestAndTheMostJitteredMeshesAreFinite) {
    for (const char* shape : {"quad", "box", "cylinder", "sphere", "torus", "mirrored"})
        for (const char* method : {"per-face", "uniform", "area", "angle", "mikktspace", "derivatives", "analytic"}) {
            const std::vector<Knob> knobs = {{"view", "one"}, {"shape", shape}, {"method", method}, {"columns", "3"},
                                             {"rows", "2"},   {"jitter", "1"},  {"shear", "-1"}};
            EXPECT_NO_THROW(drawn("05", shot_of("05", knobs, "bitangent", {64, 64}))) << shape << ", " << method;
        }
}

}  // namespace
}  // namespace relief
