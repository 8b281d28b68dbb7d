// Lab 01: its probes at places that can be worked out by hand.
#include <gtest/gtest.h>

#include "framework/lab/manifest.h"

namespace relief {
namespace {

/// The lowest row of the picture shows the floor, 60 m wide with the texture 24 times across: y up, u along x, v
/// against z.
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
    Image probe(const char* name) const { return take(*make_lab(lab_, shot(name)), shot(name)); }
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
        // A float holds the 12,000 texels of these places to a thousandth; the rasteriser interpolates to a few of
        // those.
        EXPECT_NEAR(uv.pixel(x, 35)[0], (place.x / 60 + 0.5) * 24 * 1024, 0.05);
        EXPECT_NEAR(uv.pixel(x, 35)[1], (-place.z / 60 + 0.5) * 24 * 1024, 0.05);
    }
}

}  // namespace
}  // namespace relief
