#include "baker.h"

#include <algorithm>

namespace relief::baking {

Mesh Recipe::high_mesh() const {
    return model.shape == Shape::own ? own->high(has_fine)
                                     : make_high(model, high_finenesses[size_t(high)], cord, sculpt);
}

Mesh Recipe::low_mesh(bool other_diagonal) const {
    return model.shape == Shape::own ? own->low()
                                     : make_low(model, low_finenesses[size_t(low)], overlapping, other_diagonal);
}

const RayMesh& Baker::high(const Recipe& recipe) {
    return *of_shape(recipe).high.get({recipe.model, recipe.high, recipe.cord, recipe.sculpt, recipe.version},
                                      [&] { return std::make_unique<RayMesh>(recipe.high_mesh()); });
}

const GpuMesh& Baker::low(const Recipe& recipe, bool other_diagonal) {
    auto& low = of_shape(recipe).low[other_diagonal ? 1 : 0];
    return *low.get({recipe.model, recipe.low, recipe.overlapping, recipe.version},
                    [&] { return std::make_unique<GpuMesh>(upload([=] { return recipe.low_mesh(other_diagonal); })); });
}

const Baked& Baker::bake(const Recipe& recipe) {
    const Program& bake = bake_.with({recipe.object_space ? "OBJECT_SPACE" : frames.define(recipe.frame),
                                      recipe.rays_of_face ? "RAYS_OF_FACE" : ""});
    const Program& pad = pad_.with();
    const Program& store = store_.with();
    // A program gets another name when its shaders are saved and compiled again.
    const std::array<GLuint, 3> programs = {bake, pad, store};
    OfShape& kept = of_shape(recipe);
    if (kept.baked && kept.baked->recipe == recipe && kept.baked->programs == programs) return *kept.baked;
    kept.report.reset(), kept.baked.reset();

    const glm::ivec2 size(recipe.size);
    auto baked = std::unique_ptr<Baked>(new Baked{.recipe = recipe,
                                                  .programs = programs,
                                                  .texels = {size, {GL_RGBA32F, GL_RGBA32F}},
                                                  .map = {size, {formats[size_t(recipe.bits)].format}, true}});
    glDisable(GL_DEPTH_TEST);
    cast_rays(bake, recipe, baked->texels);
    const TexelTarget* texels = &baked->texels;
    std::optional<TexelTarget> padded[2];  // padding alternates between two textures
    for (int i = 0; i < recipe.padding; ++i) {
        std::optional<TexelTarget>& next = padded[i % 2];
        if (!next) next.emplace(size, std::initializer_list<GLenum>{GL_RGBA32F});
        grow_islands(pad, recipe, *texels, *next);
        texels = &*next;
    }
    round_texels(store, *texels, baked->map);
    baked->map.make_mips();
    glEnable(GL_DEPTH_TEST);
    kept.baked = std::move(baked);
    return *kept.baked;
}

/// Draws the coarse model into its map, where each texel casts its ray.
void Baker::cast_rays(const Program& program, const Recipe& recipe, const TexelTarget& texels) {
    const GpuMesh& coarse = low(recipe, false);
    const float nothing[2][4] = {{-1, -1, -1, 0}, {0, 0, 0, 0}};  // black, and no hit
    texels.begin();
    for (const GLint attachment : {0, 1}) glClearBufferfv(GL_COLOR, attachment, nothing[attachment]);
    glUseProgram(program);
    high(recipe).set(program, 0);
    program.set("u_take", recipe.take);
    const bool grows = recipe.is_ammonite();
    program.set("u_reach",
                float(grows ? double(recipe.reach) * recipe.model.tube_radius(whorls) : recipe.reach_at({})));
    program.set("u_growth", grows ? float(growth) : 1.0f);
    // All of a file's map is turn 0.
    program.set("u_layout", recipe.model.shape == Shape::own ? glm::vec4(0, 1e9, 0, 1e9)
                                                             : glm::vec4(border, step, border, 1 - 2 * border));
    glBindVertexArray(coarse.layout());
    glDrawElements(GL_TRIANGLES, coarse.count(), GL_UNSIGNED_INT, nullptr);
}

/// Carries the islands of a map on by a texel.
void Baker::grow_islands(const Program& program, const Recipe& recipe, const TexelTarget& from, const TexelTarget& to) {
    to.begin();
    glUseProgram(program);
    program.set("s_texels", 0);
    program.set("u_size", recipe.size);
    from.bind(0);
    window_.draw();
}

/// Rounds the texels to the map's format.
void Baker::round_texels(const Program& program, const TexelTarget& texels, const TexelTarget& map) {
    map.begin();
    glUseProgram(program);
    program.set("s_texels", 0);
    texels.bind(0);
    window_.draw();
}

void Baker::draw_cover(const Recipe& recipe) {
    glDisable(GL_DEPTH_TEST);
    const Program& clear = clear_.with();
    glUseProgram(clear);
    clear.set("u_value", 0.0f);
    window_.draw();
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
