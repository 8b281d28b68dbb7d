// The textures of a mesh into which shaders cast rays, against its tree.
#include "labs/07_baking/ray_mesh.h"

#include <gtest/gtest.h>

#include <vector>

#include "framework/library/mesh/shapes.h"

namespace relief {
namespace {

TEST(RayMesh, HasItsTreeCornersAndNormalsInItsTextures) {
    const RayMesh mesh(make_sphere({.radius = 1, .sides = 40, .rows = 30}));  // textures of several rows
    const auto texels = [](const Texture& texture) {
        bind(0, texture);
        GLint width = 0, height = 0;
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT, &height);
        EXPECT_EQ(width, 1024);
        std::vector<glm::vec4> all(size_t(width) * size_t(height));
        glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, all.data());
        return all;
    };
    const std::vector<glm::vec4> nodes = texels(mesh.nodes), corners = texels(mesh.corners),
                                 normals = texels(mesh.normals);
    size_t triangles = 0;
    for (size_t i = 0; i < mesh.tree.nodes.size(); ++i) {
        const TreeNode& node = mesh.tree.nodes[i];
        ASSERT_EQ(nodes[2 * i], glm::vec4(node.low, float(node.skip)));
        ASSERT_EQ(glm::vec3(nodes[2 * i + 1]), node.high);
        const int content = int(nodes[2 * i + 1].w);
        ASSERT_EQ(content % 8, int(node.count));
        if (node.count > 0) {
            ASSERT_EQ(content / 8, int(node.first));
        }
        triangles += size_t(node.count);
    }
    ASSERT_EQ(triangles * 3, mesh.mesh.indices.size());
    for (size_t i = 0; i < triangles * 3; ++i) {
        const size_t vertex = mesh.mesh.indices[mesh.tree.triangles[i / 3] * 3 + i % 3];
        ASSERT_EQ(corners[i], glm::vec4(mesh.mesh.vertices[vertex].position, float(vertex)));
        ASSERT_EQ(glm::vec3(normals[vertex]), mesh.mesh.vertices[vertex].normal);
    }
}

}  // namespace
}  // namespace relief
