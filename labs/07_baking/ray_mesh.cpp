#include "ray_mesh.h"

#include <algorithm>

namespace relief {
namespace {

#include "shaders/07_baking/ray_mesh.glsl"

/// Returns an image of `count` texels, the lowest row first, for shaders/07_baking/walk.glsl. `texel(i)` returns a
/// vec4.
template <class Source>
Image data_image(size_t count, const Source& texel) {
    constexpr int row = 1 << row_bits;
    Image image(row, int(std::max<size_t>(1, (count + row - 1) / row)), 4);
    for (size_t i = 0; i < count; ++i) {
        const glm::vec4 value = texel(i);
        std::copy_n(&value.x, 4, image.pixel(int(i % row), image.height - 1 - int(i / row)));
    }
    return image;
}

Texture data_texture(const char* title, std::function<Image()> make) {
    return {title, std::move(make), TextureOptions{.wrap = Wrap::clamp, .mips = false}};
}

Image node_image(const TriangleTree& tree) {
    return data_image(tree.nodes.size() * 2, [&](size_t i) {
        const TreeNode& node = tree.nodes[i / 2];
        // Floats represent whole numbers up to 2^24 exactly.
        return i % 2 == 0 ? glm::vec4(node.low, float(node.skip))
                          : glm::vec4(node.high, float(node.first * node_radix + node.count));
    });
}

Image corner_image(const TriangleTree& tree, const Mesh& mesh) {
    return data_image(tree.triangles.size() * 3, [&](size_t i) {
        const uint32_t vertex = mesh.indices[size_t(tree.triangles[i / 3]) * 3 + i % 3];
        return glm::vec4(mesh.vertices[vertex].position, float(vertex));
    });
}

Image normal_image(const Mesh& mesh) {
    return data_image(mesh.vertices.size(),
                      [&](size_t i) { return glm::vec4(mesh.vertices[i].normal, mesh.vertices[i].uv.x); });
}

}  // namespace

RayMesh::RayMesh(Mesh made)
    : mesh(std::move(made)),
      tree(build_tree(mesh)),
      uploaded(upload([this] { return mesh; })),
      nodes(data_texture("boxes", [this] { return node_image(tree); })),
      corners(data_texture("corners", [this] { return corner_image(tree, mesh); })),
      normals(data_texture("normals", [this] { return normal_image(mesh); })) {}

void RayMesh::set(const Program& program, int unit) const {
    program.set("s_nodes", unit, nodes);
    program.set("s_corners", unit + 1, corners);
    program.set("s_normals", unit + 2, normals);
    program.set("u_nodes", int(tree.nodes.size()));
}

}  // namespace relief
