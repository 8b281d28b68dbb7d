#include "baker.h"

#include <algorithm>

namespace relief::baking {
namespace {

constexpr int row = 1024;  // texels of a data texture, as in shaders/07_baking/walk.glsl

/// Returns an image of `count` texels in rows of 1024, the lowest row first. `texel(i)` returns a vec4.
template <class Source>
Image data_image(size_t count, const Source& texel) {
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
                          : glm::vec4(node.high, float(node.first * 8 + node.count));
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

constexpr std::array<GLenum, 3> formats = {GL_RGBA8, GL_RGBA16, GL_RGBA32F};

}  // namespace

HighModel::HighModel(const Model& model, int fineness, bool cord)
    : mesh(make_high(model, high_finenesses[size_t(fineness)], cord)),
      tree(build_tree(mesh)),
      nodes(data_texture("boxes", [this] { return node_image(tree); })),
      corners(data_texture("corners", [this] { return corner_image(tree, mesh); })),
      normals(data_texture("normals", [this] { return normal_image(mesh); })),
      uploaded(upload([this] { return mesh; })) {}

const HighModel& Baker::high(const Recipe& recipe) {
    return *of_shape(recipe).high.get({recipe.model, recipe.high, recipe.cord}, [&] {
        return std::make_unique<HighModel>(recipe.model, recipe.high, recipe.cord);
    });
}

const GpuMesh& Baker::low(const Recipe& recipe, bool other_diagonal) {
    auto& low = of_shape(recipe).low[other_diagonal ? 1 : 0];
    return *low.get({recipe.model, recipe.low, recipe.overlapping}, [&] {
        return std::make_unique<GpuMesh>(upload([=] {
            return make_low(recipe.model, low_finenesses[size_t(recipe.low)], recipe.overlapping, other_diagonal);
        }));
    });
}

void Baker::draw_window() {
    if (!nothing_) nothing_.emplace();
    glBindVertexArray(*nothing_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

const Baked& Baker::bake(const Recipe& recipe) {
    const Program& bake =
        recipe.object_space
            ? bake_.with({"OBJECT_SPACE", recipe.rays_of_face ? "RAYS_OF_FACE" : ""})
            : bake_.with({frame_defines[size_t(recipe.frame)], recipe.rays_of_face ? "RAYS_OF_FACE" : ""});
    const Program& pad = pad_.with();
    const Program& store = store_.with();
    // A program gets another name when its shaders are saved and compiled again.
    const std::array<GLuint, 3> programs = {bake, pad, store};
    OfShape& kept = of_shape(recipe);
    if (kept.baked && kept.baked->recipe == recipe && kept.baked->programs == programs) return *kept.baked;
    kept.report.reset(), kept.baked.reset();

    const HighModel& fine = high(recipe);
    const GpuMesh& coarse = low(recipe, false);
    const glm::ivec2 size(recipe.size);
    auto baked = std::unique_ptr<Baked>(
        new Baked{recipe, programs, {size, {GL_RGBA32F, GL_RGBA32F}}, {size, {formats[size_t(recipe.bits)]}, true}});
    glDisable(GL_DEPTH_TEST);
    const float nothing[2][4] = {{-1, -1, -1, 0}, {0, 0, 0, 0}};  // black, and no hit
    baked->texels.begin();
    for (const GLint attachment : {0, 1}) glClearBufferfv(GL_COLOR, attachment, nothing[attachment]);
    glUseProgram(bake);
    bake.set("s_nodes", 0, fine.nodes);
    bake.set("s_corners", 1, fine.corners);
    bake.set("s_normals", 2, fine.normals);
    bake.set("u_nodes", int(fine.tree.nodes.size()));
    bake.set("u_take", recipe.take);
    const bool is_cube = recipe.model.shape == Shape::cube;
    bake.set("u_reach", float(is_cube ? recipe.reach_at({}) : double(recipe.reach) * recipe.model.tube_radius(whorls)));
    bake.set("u_growth", is_cube ? 1.0f : float(growth));
    bake.set("u_layout", glm::vec4(1 / 16.0f, 5 / 16.0f, 1 / 16.0f, 14 / 16.0f));
    glBindVertexArray(coarse.layout());
    glDrawElements(GL_TRIANGLES, coarse.count(), GL_UNSIGNED_INT, nullptr);

    // Padding alternates between two textures.
    const TexelTarget* texels = &baked->texels;
    std::optional<TexelTarget> padded[2];
    for (int step = 0; step < recipe.padding; ++step) {
        std::optional<TexelTarget>& next = padded[step % 2];
        if (!next) next.emplace(size, std::initializer_list<GLenum>{GL_RGBA32F});
        next->begin();
        glUseProgram(pad);
        pad.set("s_texels", 0);
        pad.set("u_size", recipe.size);
        texels->bind(0);
        draw_window();
        texels = &*next;
    }
    baked->map.begin();
    glUseProgram(store);
    store.set("s_texels", 0);
    texels->bind(0);
    draw_window();
    baked->map.make_mips();
    glEnable(GL_DEPTH_TEST);
    kept.baked = std::move(baked);
    return *kept.baked;
}

void Baker::draw_cover(const Recipe& recipe) {
    glDisable(GL_DEPTH_TEST);
    const Program& clear = clear_.with();
    glUseProgram(clear);
    clear.set("u_value", 0.0f);
    draw_window();
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    const Program& cover = cover_.with();
    glUseProgram(cover);
    cover.set("u_value", 1.0f);
    const GpuMesh& coarse = low(recipe, false);
    glBindVertexArray(coarse.layout());
    glDrawElements(GL_TRIANGLES, coarse.count(), GL_UNSIGNED_INT, nullptr);
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
}

Baked::Report Baker::report(const Baked& baked) {
    std::optional<Baked::Report>& report = of_shape(baked.recipe).report;
    if (report) return *report;
    report.emplace();
    const Image texels = baked.texels.read(0), hits = baked.texels.read(1);
    size_t covered = 0, missed = 0, wrong = 0;
    for (size_t i = 0; i < texels.values.size(); i += 4) {
        if (texels.values[i + 3] == 0) continue;
        ++covered, missed += hits.values[i + 1] == 0, wrong += hits.values[i + 1] > 1.5f;
        report->unwritten = std::max(report->unwritten, int(hits.values[i + 2]));
    }
    report->missed = double(missed) / double(std::max<size_t>(1, covered));
    report->wrong = double(wrong) / double(std::max<size_t>(1, covered));
    const TexelTarget cover(baked.texels.size(), {GL_RGBA32F});
    cover.begin();
    draw_cover(baked.recipe);
    const Image counts = cover.read();
    for (size_t i = 0; i < counts.values.size(); i += 4) report->covered_twice += counts.values[i] > 1.5f;
    return *report;
}

}  // namespace relief::baking
