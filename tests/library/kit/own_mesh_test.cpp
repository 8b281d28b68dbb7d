// Models of the user: their place, their uv and tangents, and refusals.
#include "framework/library/kit/own_mesh.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "framework/core/image/file.h"
#include "framework/library/mesh/shapes.h"
#include "framework/library/mesh/tangents.h"
#include "tests/library/mesh/gltf_file.h"
#include "tests/support.h"

namespace relief {
namespace {

/// A box from (10, 20, 30) on, of 4 x 2 x 1, with neither uv nor normals.
constexpr const char* box =
    "v 10 20 30\nv 14 20 30\nv 14 22 30\nv 10 22 30\nv 10 20 31\nv 14 20 31\nv 14 22 31\nv 10 22 31\ns off\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 4 1 5 8\n";

/// Returns the sums over the corners of a mesh's triangles, which neither sharing nor the order of vertices changes.
struct Sums {
    double area = 0, area_in_uv = 0;
    glm::dvec3 low{INFINITY}, high{-INFINITY};
};
Sums sums_of(const Mesh& mesh) {
    Sums sums;
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vertex &a = mesh.vertices[mesh.indices[i]], &b = mesh.vertices[mesh.indices[i + 1]],
                     &c = mesh.vertices[mesh.indices[i + 2]];
        sums.area +=
            0.5 * glm::length(glm::cross(glm::dvec3(b.position - a.position), glm::dvec3(c.position - a.position)));
        const glm::dvec2 u = b.uv - a.uv, v = c.uv - a.uv;
        sums.area_in_uv += 0.5 * (u.x * v.y - u.y * v.x);
        for (const Vertex* vertex : {&a, &b, &c})
            sums.low = glm::min(sums.low, glm::dvec3(vertex->position)),
            sums.high = glm::max(sums.high, glm::dvec3(vertex->position));
    }
    return sums;
}

TEST(OwnMesh, IsMovedToTheOriginAndScaledByTheHalfDiagonalOfItsBox) {
    const Mesh mesh =
        prepared_model(parse_obj(box).mesh, false, std::sqrt(21.0));  // twice the half diagonal of 4 x 2 x 1
    const Sums sums = sums_of(mesh);
    EXPECT_LT(glm::distance(sums.low, {-4, -2, -1}), 1e-6);
    EXPECT_LT(glm::distance(sums.high, {4, 2, 1}), 1e-6);
}

TEST(OwnMesh, FarFromTheOriginIsTheSameModelAndItsPlacementIsThatOfTheFile) {
    const TemporaryFolder folder;
    const Mesh sphere = make_sphere({.sides = 12, .rows = 6});
    for (const bool is_gltf : {false, true}) {
        const auto read_at = [&](OwnMesh& own, const glm::dvec3& at) {
            GltfFile file = gltf_of(sphere);
            file.json["nodes"][0]["translation"] = {at.x, at.y, at.z};
            const std::string obj =
                fmt::format("v {0} {1} {2}\nv {3} {1} {2}\nv {0} {4} {5}\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n",
                            at.x, at.y, at.z, at.x + 0.8125, at.y + 0.25, at.z + 0.5);
            own.read(is_gltf ? folder.write("m.glb", file.glb()) : folder.write("m.obj", obj));
        };
        const glm::dvec3 away(5412300.25, 250.5, -432100);
        OwnMesh near(1), far(1);
        read_at(near, {0, 0, 0}), read_at(far, away);
        EXPECT_EQ(far.has_tangents(), is_gltf);
        ASSERT_EQ(far.mesh().vertices.size(), is_gltf ? sphere.vertices.size() : 3);
        for (size_t i = 0; i < far.mesh().vertices.size(); ++i) {
            EXPECT_LT(glm::distance(near.mesh().vertices[i].position, far.mesh().vertices[i].position), 1e-6f);
            EXPECT_LT(glm::distance(near.mesh().vertices[i].normal, far.mesh().vertices[i].normal), 1e-6f);
        }
        // A place in the lab has its place in the file.
        EXPECT_LT(glm::distance(far.placement().middle - near.placement().middle, away), 1e-6);
        EXPECT_TRUE(near.notes().empty());
    }
}

TEST(OwnMesh, NamesEachPartOfAFileThatItDoesNotRead) {
    const TemporaryFolder folder;
    OwnMesh own(1);
    testing::internal::CaptureStderr();
    own.read(folder.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\nf 1 2 3\n"));
    const std::string printed = testing::internal::GetCapturedStderr();
    ASSERT_EQ(own.notes().size(), 2u);
    EXPECT_EQ(own.notes()[0], "m.obj:4: 'l' is not read");
    EXPECT_EQ(own.notes()[1], "m.obj: has no uv: they are made by projection along the axes");
    EXPECT_EQ(printed, fmt::format("relief: {}\nrelief: {}\n", own.notes()[0], own.notes()[1]));
    EXPECT_THROW(own.read(folder.path() / "none.obj"), Error);
    EXPECT_EQ(own.notes().size(), 2u) << "those of the former file, which stays";
}

TEST(OwnMesh, IsPlacedAsAnotherModelIsByItsPlacement) {
    const Placement small{{1, 2, 3}, 0.5}, large{{0, 2, 0}, 4};
    const glm::dvec3 in_file(7, 1, 2);
    const glm::dvec3 in_lab = small.scale * (in_file - small.middle);
    EXPECT_LT(glm::distance(placed(in_lab, small, large), large.scale * (in_file - large.middle)), 1e-12);
    EXPECT_EQ(placed(in_lab, small, small), in_lab);
}

TEST(OwnMesh, WithoutUvIsProjectedAlongItsAxesAsTheCoursesBoxIs) {
    const Mesh mesh =
        with_tangents(prepared_model(parse_obj(box).mesh, false, std::sqrt(21.0)), TangentMethod::mikktspace);
    const Mesh wanted = make_box({.size = {8, 4, 2}});
    for (const Vertex& vertex : mesh.vertices) {
        const auto same = [&](const Vertex& other) {
            return glm::distance(vertex.position, other.position) < 1e-5f &&
                   glm::distance(vertex.normal, other.normal) < 1e-5f &&
                   glm::distance(vertex.tangent, other.tangent) < 1e-5f;
        };
        const auto found = std::find_if(wanted.vertices.begin(), wanted.vertices.end(), same);
        ASSERT_NE(found, wanted.vertices.end())
            << vertex.position.x << " " << vertex.position.y << " " << vertex.position.z;
        // The longest side, 8 metres, is one unit of u and v; the course's box has one on each side.
        const glm::vec2 size = std::abs(vertex.normal.x) > 0.5f   ? glm::vec2(2, 4)
                               : std::abs(vertex.normal.y) > 0.5f ? glm::vec2(8, 2)
                                                                  : glm::vec2(8, 4);
        EXPECT_LT(glm::distance(vertex.uv, found->uv * size / 8.0f), 1e-5f);
    }
    EXPECT_NEAR(metres_per_uv(mesh), 8, 1e-5);
}

TEST(OwnMesh, KeepsItsUvAndSharedVerticesAndHasLeftHandedFramesWhereTheyAreMirrored) {
    const char* const quads =
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nvt 0 0\nvt 3 0\nvt 3 3\nvt 0 3\n"
        "f 1/1 2/2 3/3 4/4\nf 2/2 5/1 6/4 3/3\n";
    const Mesh shared = prepared_model(parse_obj(quads).mesh, true, 1);
    EXPECT_EQ(shared.vertices.size(), 6u) << "as in the file";
    EXPECT_EQ(sums_of(shared).area_in_uv, 0) << "9 and -9";
    const TemporaryFolder folder;
    OwnMesh own(1);
    own.read(folder.write("quads.obj", quads));
    const Mesh mesh = own.mesh_with_tangents();
    EXPECT_EQ(mesh.vertices.size(), 8u) << "two vertices where the uv are mirrored";
    ASSERT_EQ(mesh.indices.size(), 12u);
    for (size_t i = 0; i < 12; ++i)
        EXPECT_LT(glm::distance(mesh.vertices[mesh.indices[i]].tangent,
                                i < 6 ? glm::vec4(1, 0, 0, 1) : glm::vec4(-1, 0, 0, -1)),
                  1e-6f)
            << i;
    // 2 x 1 metres become 2 / sqrt(5) of it, and three tiles cover half of the longer side.
    EXPECT_NEAR(metres_per_uv(mesh), 2 / std::sqrt(5.0) / 3, 1e-6);
}

TEST(OwnMesh, HasAPartOfItsTrianglesForEachNormalMapAndTheNotesOfItsFile) {
    const TemporaryFolder folder;
    Image texel(1, 1, 3, 8);
    texel.values = {0.5f, 0.5f, 1};
    GltfFile file = gltf_of(make_quad({}), encode_image(texel, ImageFormat::png));
    nlohmann::json& primitives = file.json["meshes"][0]["primitives"];
    primitives.push_back(primitives[0]);
    primitives[0].erase("material");
    file.json["samplers"] = {{{"wrapT", 33648}}}, file.json["textures"][0]["sampler"] = 0;
    file.json["animations"] = {nlohmann::json::object()};
    OwnMesh own(1);
    own.read(folder.write("two.glb", file.glb()));
    ASSERT_EQ(own.parts().size(), 2u);
    EXPECT_EQ(own.parts()[0].normal_map, -1);
    EXPECT_EQ(own.parts()[1].normal_map, 0);
    EXPECT_EQ(own.parts()[1].first_index, own.parts()[0].index_count);
    ASSERT_EQ(own.normal_maps().size(), 1u);
    EXPECT_EQ(own.normal_maps()[0].wrap_u, GltfWrap::repeat);
    EXPECT_EQ(own.normal_maps()[0].wrap_v, GltfWrap::mirror);
    EXPECT_EQ(own.notes(),
              std::vector<std::string>{"two.glb: its animations are not read: the model has the pose of its nodes"});
    own.read(folder.write("box.obj", box));
    EXPECT_TRUE(own.normal_maps().empty());
    EXPECT_EQ(own.notes(), std::vector<std::string>{"box.obj: has no uv: they are made by projection along the axes"});
    ASSERT_EQ(own.parts().size(), 1u);
    EXPECT_EQ(own.parts()[0].index_count, own.mesh().indices.size());
}

TEST(OwnMesh, KeepsThePreviousModelWhenAFileIsRefused) {
    const TemporaryFolder folder;
    OwnMesh own(1);
    own.read(folder.write("box.obj", box));
    EXPECT_EQ(own.version(), 1);
    const size_t vertices = own.mesh().vertices.size();
    const auto refusal = [&](const char* name, const char* text) {
        return message_of([&] { own.read(folder.write(name, text)); }).substr(folder.path().string().size() + 1);
    };
    EXPECT_TRUE(contains(refusal("bad.obj", "v 0 0 0\nv 1 0 zero\nf 1 2 3\n"), "bad.obj:2: "));
    EXPECT_EQ(refusal("line.obj", "v 0 0 0\nv 1 1 0\nv 3 3 0\nf 1 2 3\n"),
              "line.obj: has no area: the corners of each triangle lie on a line");
    EXPECT_TRUE(contains(refusal("empty.obj", "# nothing\n"), "empty.obj"));
    EXPECT_TRUE(contains(message_of([&] { own.read(folder.path() / "missing.obj"); }), "missing.obj"));
    EXPECT_EQ(own.version(), 1);
    EXPECT_EQ(own.file().filename(), "box.obj");
    EXPECT_EQ(own.mesh().vertices.size(), vertices);
}

}  // namespace
}  // namespace relief
