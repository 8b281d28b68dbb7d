#include "assets/staff/textures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "assets/garden.h"
#include "assets/staff/rope.h"
#include "assets/urn.h"
#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/image/file.h"
#include "framework/library/mesh/gltf.h"

namespace relief {
namespace {

void expect_made_as_kept(const std::string& surface) {
    for (const NamedTexture& made : make_textures(surface)) {
        const Image kept = read_image(course_root() / "assets" / made.file);
        ASSERT_TRUE(kept.same_shape(made.image)) << made.file;
        EXPECT_EQ(kept.bits, made.image.bits) << made.file;
        // A compiler that fuses multiplications and additions rounds some texels to the next value: one step, and few.
        const double step = 1.0 / ((1 << made.image.bits) - 1);
        size_t others = 0;
        for (size_t i = 0; i < kept.values.size(); ++i) {
            const double off = std::abs(double(kept.values[i]) - made.image.values[i]);
            ASSERT_LE(off, 1.51 * step) << made.file << ", value " << i;  // the map made is not rounded yet
            others += off > 0.51 * step;
        }
        EXPECT_LE(others, kept.values.size() / 1000) << made.file;
    }
}

TEST(Textures, AreMadeAsTheyLieInTheRepository) {
    for (const char* surface : {"bricks", "paving", "garden", "quilt", "rope", "marble"}) expect_made_as_kept(surface);
}

TEST(Urn, IsMadeAsItLiesInTheRepository) { EXPECT_EQ(make_urn(), read_file(course_root() / "assets/urn.obj")); }

TEST(Garden, IsMadeAsItLiesInTheRepository) {
    for (const auto& [name, text] : make_garden()) EXPECT_EQ(text, read_file(course_root() / "assets" / name)) << name;
}

TEST(Rope, IsMadeAsItLiesInTheRepository) {
    const std::filesystem::path folder = course_root() / "assets";
    const Mesh made = make_coarse_rope(), kept = read_gltf(folder / "rope.gltf").mesh;
    EXPECT_EQ(made.indices, kept.indices);
    ASSERT_EQ(made.vertices.size(), kept.vertices.size());
    for (size_t i = 0; i < made.vertices.size(); ++i) {  // another C library rounds sines differently
        EXPECT_LT(glm::distance(made.vertices[i].position, kept.vertices[i].position), 1e-6f);
        EXPECT_LT(glm::distance(made.vertices[i].normal, kept.vertices[i].normal), 1e-6f);
        EXPECT_LT(glm::distance(made.vertices[i].tangent, kept.vertices[i].tangent), 1e-5f);
        EXPECT_LT(glm::distance(made.vertices[i].uv, kept.vertices[i].uv), 1e-6f);
    }
}

}  // namespace
}  // namespace relief
