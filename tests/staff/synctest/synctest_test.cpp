// The cube that must appear flat, and the faults of a renderer that its pictures reveal.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "framework/core/base/file.h"
#include "framework/core/image/color.h"
#include "framework/core/image/file.h"
#include "framework/library/mesh/obj.h"
#include "framework/staff/reference/mikktspace.h"
#include "framework/staff/synctest/files.h"
#include "framework/staff/synctest/flatness.h"
#include "tests/support.h"

namespace relief::synctest {
namespace {

constexpr int side = 160;

/// Converts normals to a screenshot: 8 bits, and black outside the cube.
Image screenshot(const Image& normals) {
    Image picture(normals.width, normals.height, 3, 8);
    for (size_t i = 0; i < normals.values.size(); ++i)
        picture.values[i] =
            std::isinf(normals.values[i]) ? 0 : std::round(255 * (0.5f * normals.values[i] + 0.5f)) / 255;
    return picture;
}
Image screenshot_by(const SyncRenderer& renderer) {
    return screenshot(render_synctest(renderer, bake_synctest_map(512, 8), side, side));
}

TEST(Synctest, IsFlatToTwoTenthsOnlyInTheMapsOwnFrame) {
    const struct {
        SyncRenderer renderer;
        double mean;  ///< degrees, as lab 07 measures its cube on the GPU
    } cases[] = {{{SyncFrame::interpolated, SyncSlip::none}, 0.2},
                 {{SyncFrame::each_unit, SyncSlip::none}, 4.5},
                 {{SyncFrame::gram_schmidt, SyncSlip::none}, 5.0},
                 {{SyncFrame::vertex_bitangent, SyncSlip::none}, 6.2},
                 {{SyncFrame::interpolated, SyncSlip::other_diagonal}, 7.7}};
    for (const auto& [renderer, mean] : cases) {
        const Image normals = render_synctest(renderer, bake_synctest_map(512, 8), side, side);
        const SyncJudgement judgement = judge_synctest(normals);
        // The visible faces and their angles change the mean by some per cent.
        EXPECT_NEAR(judgement.mean, mean, std::max(0.1, 0.06 * mean)) << renderer.text();
        EXPECT_EQ(judgement.is_flat(), renderer.is_in_sync()) << renderer.text();
    }
    const SyncJudgement fine = judge_synctest(render_synctest({}, bake_synctest_map(512, 16), side, side));
    EXPECT_LT(fine.mean, 0.02) << "what is left with 16 bits is the filtering between texels";
}

TEST(Synctest, IdentifiesEachRendererFromAScreenshot) {
    for (const SyncRenderer& renderer : sync_renderers()) {
        const SyncJudgement judgement = judge_synctest(screenshot_by(renderer));
        ASSERT_TRUE(judgement.renderer()) << renderer.text();
        EXPECT_EQ(judgement.renderer()->text(), renderer.text());
        EXPECT_EQ(judgement.is_flat(), renderer.is_in_sync()) << renderer.text();
        EXPECT_LT(judgement.likenesses[0].degrees, 0.4) << renderer.text();
    }
}

TEST(Synctest, AcceptsTheConventionsOfOtherEngines) {
    const Image normals =
        render_synctest({SyncFrame::gram_schmidt, SyncSlip::none}, bake_synctest_map(512, 8), side, side);
    const auto expect_gram_schmidt = [](const Image& picture, const char* what) {
        const SyncJudgement judgement = judge_synctest(picture);
        ASSERT_TRUE(judgement.renderer()) << what;
        EXPECT_EQ(judgement.renderer()->frame, SyncFrame::gram_schmidt) << what;
        EXPECT_NEAR(judgement.mean, 5, 0.3) << what;
    };
    const auto changed = [&](const auto& change) {
        Image result = screenshot(normals);
        for (size_t i = 0; i < result.pixel_count(); ++i)
            if (!std::isinf(normals.values[i * 3])) change(&result.values[i * 3]);
        return result;
    };
    expect_gram_schmidt(normals, "floats that hold the vector itself");
    expect_gram_schmidt(changed([](float* c) { std::swap(c[1], c[2]), c[1] = 1 - c[1]; }), "z up");
    expect_gram_schmidt(changed([](float* c) { c[2] = 1 - c[2]; }), "left-handed");
    expect_gram_schmidt(changed([](float* c) {
                            for (int i = 0; i < 3; ++i) c[i] = float(srgb8_from_linear(c[i])) / 255;
                        }),
                        "stored as sRGB");
    Image on_blue = screenshot(normals);
    for (size_t i = 0; i < on_blue.pixel_count(); ++i)
        if (std::isinf(normals.values[i * 3]))
            on_blue.values[i * 3] = on_blue.values[i * 3 + 1] = 128.0f / 255, on_blue.values[i * 3 + 2] = 1;
    expect_gram_schmidt(on_blue, "a background that is a normal");
    expect_gram_schmidt(
        screenshot(render_synctest({SyncFrame::gram_schmidt, SyncSlip::none}, bake_synctest_map(512, 8), 300, 170)),
        "a wide picture");
}

TEST(Synctest, FromAnotherCameraReportsOnlyFlatness) {
    Image shifted(side, side, 3, 8);
    const Image picture = screenshot_by({SyncFrame::gram_schmidt, SyncSlip::none});
    for (int y = 0; y < side; ++y) std::copy_n(picture.pixel(12, y), (side - 12) * 3, shifted.pixel(0, y));
    const SyncJudgement judgement = judge_synctest(shifted);
    EXPECT_NEAR(judgement.mean, 5, 0.3);
    EXPECT_FALSE(judgement.renderer());
    EXPECT_LT(judgement.overlap, 0.97);
}

TEST(Synctest, ColoursThatAreNoNormalsOfWorldOrObjectAreToldFromWrongFrames) {
    const glm::dvec3 back = glm::normalize(Camera(synctest_camera, 1).eye());
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), back)), up = glm::cross(back, right);
    const auto problem_of_shot = [&](const SyncRenderer& renderer, bool moved, const auto& change) {
        const Image normals = render_synctest(renderer, bake_synctest_map(256, 8), side, side);
        Image picture(side, side, 3, 8);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                // Another camera: the cube is off the middle, and cut off at the side.
                const float* const n = normals.pixel(moved ? std::min(x + 25, side - 1) : x, y);
                if (std::isinf(n[0])) continue;
                const glm::dvec3 color = change(glm::dvec3(n[0], n[1], n[2]));
                for (int c = 0; c < 3; ++c)
                    picture.pixel(x, y)[c] = float(std::round(255 * std::clamp(color[c], 0.0, 1.0)) / 255);
            }
        const SyncJudgement judgement = judge_synctest(picture);
        EXPECT_EQ(judgement.shows_normals, judgement.problem.empty());
        return judgement.problem;
    };
    const auto plain = [](const glm::dvec3& n) { return 0.5 * n + 0.5; };
    const auto in_camera = [&](const glm::dvec3& n) {
        return 0.5 * glm::dvec3(glm::dot(n, right), glm::dot(n, up), glm::dot(n, back)) + 0.5;
    };
    const auto each = [&](const auto& curve) {
        return [=](const glm::dvec3& n) {
            const glm::dvec3 stored = 0.5 * n + 0.5;
            return glm::dvec3(curve(stored.x), curve(stored.y), curve(stored.z));
        };
    };
    for (const bool moved : {false, true}) {
        for (const SyncRenderer& renderer : sync_renderers())
            EXPECT_EQ(moved ? problem_of_shot(renderer, moved, plain) : "", "") << renderer.text();
        {
            const SyncFrame frame = moved ? SyncFrame::interpolated : SyncFrame::gram_schmidt;
            EXPECT_TRUE(contains(problem_of_shot({frame, {}}, moved, in_camera), "space of the camera")) << moved;
            EXPECT_TRUE(
                contains(problem_of_shot({frame, {}}, moved, each([](double c) { return linear_from_srgb(c); })),
                         "decoded from sRGB"))
                << moved;
            for (const double exposure : {0.5, 0.8, 0.95, 1.2})
                EXPECT_NE(problem_of_shot({frame, {}}, moved, each([=](double c) { return exposure * c; })), "")
                    << exposure << moved;
            EXPECT_NE(problem_of_shot({frame, {}}, moved, each([](double c) { return c / (c + 0.3); })), "")
                << "a curve";
            EXPECT_NE(problem_of_shot({frame, {}}, moved, each([](double c) { return std::pow(c, 1 / 1.8); })), "");
        }
    }
}

TEST(Synctest, APictureWithoutNormalsIsNotJudged) {
    for (const int channels : {1, 2, 3, 4})
        for (const int size : {1, 2, 3, 64}) {
            EXPECT_FALSE(judge_synctest(Image(size, size, channels, 8)).shows_normals);
            Image broken(size, size, channels);
            std::fill(broken.values.begin(), broken.values.end(), NAN);
            EXPECT_FALSE(judge_synctest(broken).shows_normals);
        }
}

TEST(Synctest, ItsFilesHoldTheSameCube) {
    const TemporaryFolder folder;
    write_synctest(folder.path());
    const Mesh cube = make_synctest_cube();

    const ObjModel obj = read_obj(folder.path() / "cube.obj");
    EXPECT_TRUE(obj.notes.empty());
    EXPECT_TRUE(obj.has_normals && obj.has_uvs);
    EXPECT_TRUE(std::filesystem::exists(obj.materials.at(0).normal_map));
    ASSERT_EQ(obj.mesh.indices.size(), cube.indices.size());
    const std::vector<glm::dvec4> tangents = mikktspace_reference(obj.mesh);
    for (size_t i = 0; i < cube.indices.size(); ++i) {
        const Vertex &read = obj.mesh.vertices[obj.mesh.indices[i]], &made = cube.vertices[cube.indices[i]];
        EXPECT_EQ(read.position, made.position);
        EXPECT_EQ(read.normal, made.normal);
        EXPECT_EQ(read.uv, made.uv);
        EXPECT_LT(glm::length(tangents[i] - glm::dvec4(made.tangent)), 1e-6) << "an engine makes the same tangents";
    }

    const auto json = nlohmann::json::parse(read_file(folder.path() / "cube.gltf"));
    const std::string buffer = read_file(folder.path() / json["buffers"][0]["uri"].get<std::string>());
    EXPECT_EQ(json["asset"]["version"], "2.0");
    EXPECT_EQ(json["buffers"][0]["byteLength"], buffer.size());
    EXPECT_TRUE(std::filesystem::exists(folder.path() / json["images"][0]["uri"].get<std::string>()));
    const auto& primitive = json["meshes"][0]["primitives"][0];
    const auto floats = [&](const char* attribute, size_t index) {
        const auto& accessor = json["accessors"][primitive["attributes"][attribute].get<size_t>()];
        const auto& view = json["bufferViews"][accessor["bufferView"].get<size_t>()];
        const size_t components = view["byteLength"].get<size_t>() / accessor["count"].get<size_t>() / sizeof(float);
        std::vector<float> values(components);
        std::memcpy(values.data(),
                    buffer.data() + view["byteOffset"].get<size_t>() + index * components * sizeof(float),
                    components * sizeof(float));
        return values;
    };
    for (size_t i = 0; i < cube.vertices.size(); ++i) {
        const Vertex& vertex = cube.vertices[i];
        EXPECT_EQ(floats("POSITION", i), (std::vector{vertex.position.x, vertex.position.y, vertex.position.z}));
        EXPECT_EQ(floats("NORMAL", i), (std::vector{vertex.normal.x, vertex.normal.y, vertex.normal.z}));
        EXPECT_EQ(floats("TANGENT", i),
                  (std::vector{vertex.tangent.x, vertex.tangent.y, vertex.tangent.z, vertex.tangent.w}));
        EXPECT_EQ(floats("TEXCOORD_0", i), (std::vector{vertex.uv.x, 1 - vertex.uv.y})) << "v grows down in glTF";
    }
    const auto& view =
        json["bufferViews"][json["accessors"][primitive["indices"].get<size_t>()]["bufferView"].get<size_t>()];
    for (size_t i = 0; i < cube.indices.size(); ++i) {
        uint16_t index;
        std::memcpy(&index, buffer.data() + view["byteOffset"].get<size_t>() + 2 * i, 2);
        EXPECT_EQ(index, cube.indices[i]);
    }

    EXPECT_EQ(read_image(folder.path() / "cube_normal.png").values, bake_synctest_map(512, 8).values);
    EXPECT_EQ(read_image(folder.path() / "cube_normal_16.png").bits, 16);
    EXPECT_TRUE(judge_synctest(read_image(folder.path() / "expected.png")).is_flat());
}

}  // namespace
}  // namespace relief::synctest
