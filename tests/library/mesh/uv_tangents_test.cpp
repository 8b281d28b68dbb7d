// Tangents from the gradients of uv.
#include "framework/library/mesh/uv_tangents.h"

#include <gtest/gtest.h>

#include "framework/library/mesh/obj.h"

namespace relief {
namespace {

glm::vec4 tangent(const std::string& uvs) {
    Mesh mesh = parse_obj("v 0 0 0\nv 1 0 0\nv 1 1 0\n" + uvs + "f 1/1 2/2 3/3\n").mesh;
    set_uv_tangents(mesh);
    return mesh.vertices.at(0).tangent;
}

TEST(UvTangents, PointAlongIncreasingUAndMarkMirroredUv) {
    EXPECT_EQ(tangent("vt 0 0\nvt 1 0\nvt 1 1\n"), glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(tangent("vt 0 0\nvt -1 0\nvt -1 1\n"), glm::vec4(-1, 0, 0, -1));
    EXPECT_EQ(tangent("vt 0 0\nvt 0 -1\nvt 1 -1\n"), glm::vec4(0, 1, 0, 1));
}

TEST(UvTangents, KeepTheTangentsOfTrianglesWithoutAreaInUv) {
    Mesh mesh = parse_obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0.5 0.5\nf 1/1 2/1 3/1\n").mesh;
    const glm::vec4 before = mesh.vertices.at(0).tangent;
    set_uv_tangents(mesh);
    EXPECT_EQ(mesh.vertices[0].tangent, before);
}

}  // namespace
}  // namespace relief
