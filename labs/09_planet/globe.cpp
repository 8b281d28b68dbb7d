#include "globe.h"

#include <fmt/format.h>

#include "framework/base/parallel.h"

namespace relief::planet {
namespace {

constexpr int map_columns = 16;   // tiles of a map, side by side
constexpr int batch_columns = 8;  // heights are computed for 8 x 8 tiles at a time

glm::ivec2 tile(int index, int columns, int size) { return glm::ivec2(index % columns, index / columns) * size; }

}  // namespace

void set_ground(const Program& program, const Ground& ground) {
    program.set("u_seed", ground.seed);
    program.set("u_detail", ground.detail);
    program.set("u_height", ground.height);
    for (int i = 0; i < crater_count; ++i) {
        const Crater c = crater(ground.seed, i);
        program.set(fmt::format("u_craters[{}]", i).c_str(), glm::vec4(c.middle, c.size));
    }
}

void Globe::prepare(const MapRecipe& recipe, const std::vector<Leaf>& patches, bool maps) {
    drop_outdated(recipe, maps);
    drawn_.clear();
    for (const Leaf& leaf : patches) drawn_.push_back(leaf.id);
    const Patches wanted(drawn_.begin(), drawn_.end());
    std::erase_if(slots_, [&](const auto& slot) { return !wanted.contains(slot.first); });
    make_room(recipe.shape.quads, int(wanted.size()));
    make_vertices(recipe.shape, take_slots(recipe.shape, wanted));
    if (maps) make_maps(recipe);
}

/// Drops what was made from another recipe or by another program.
void Globe::drop_outdated(const MapRecipe& recipe, bool maps) {
    // A program gets another name when its shaders are saved and compiled again.
    std::array<GLuint, 2> programs = programs_;
    if (maps) programs = {heights_program(recipe), normals_program(recipe)};
    if (!(recipe.shape == recipe_.shape)) slots_.clear();
    if (!maps || recipe.texels != recipe_.texels) map_.reset();
    if (!map_ || !(recipe == recipe_) || programs != programs_)
        for (auto& [id, slot] : slots_) slot.has_map = false;
    recipe_ = recipe, programs_ = programs;
}

/// Makes buffers for this many patches, unless they have room. New ones are empty.
void Globe::make_room(int quads, int patches) {
    if (!buffers_) buffers_.emplace();
    if (quads == shape_.quads && patches <= capacity_) return;
    shape_.quads = quads;
    capacity_ = (patches / 64 + 1) * 64;
    slots_.clear(), map_.reset();
    glBindVertexArray(buffers_->layout);
    const std::vector<uint32_t> indices = shape_.indices();  // the same triangles for all patches
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_->indices);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(indices.size() * sizeof(uint32_t)), indices.data(),
                 GL_STATIC_DRAW);
    glBindBuffer(GL_ARRAY_BUFFER, buffers_->vertices);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(sizeof(Vertex)) * capacity_ * shape_.vertices(), nullptr, GL_DYNAMIC_DRAW);
    for (const GLuint location : {0u, 1u}) glEnableVertexAttribArray(location);
    glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(Vertex), nullptr);
    glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                          reinterpret_cast<const void*>(offsetof(Vertex, local)));
}

/// Gives each patch without a slot a free one. Returns these patches.
std::vector<SpherePatch> Globe::take_slots(const Shape& shape, const Patches& wanted) {
    std::vector<bool> taken(size_t(capacity_), false);
    for (const auto& [id, slot] : slots_) taken[size_t(slot.place)] = true;
    std::vector<SpherePatch> fresh;
    for (int next = 0; const SpherePatch& id : wanted) {
        if (slots_.contains(id)) continue;
        while (taken[size_t(next)]) ++next;
        const glm::dvec3 middle = shape.place(direction_at(shape.mapping, id.face, id.on_face({0.5, 0.5})));
        slots_[id] = {.place = next++, .middle = middle};
        fresh.push_back(id);
    }
    return fresh;
}

std::vector<Globe::Vertex> Globe::vertices_of(const Shape& shape, const SpherePatch& patch) const {
    const glm::dvec3 middle = slots_.at(patch).middle;
    std::vector<Vertex> vertices;
    for (int y = 0; y <= shape.quads; ++y)
        for (int x = 0; x <= shape.quads; ++x) {
            const glm::dvec2 local = glm::dvec2(x, y) / double(shape.quads);
            const glm::dvec3 place = shape.place(direction_at(shape.mapping, patch.face, patch.on_face(local)));
            // Subtracted in double: the small difference fits a float, which is exact to a millionth of it.
            vertices.push_back({place - middle, 0, local});
        }
    for (int i = 0; i < shape_.skirt_vertices(); ++i) {
        Vertex vertex = vertices[size_t(shape_.hangs_from(i))];
        vertex.is_skirt = 1;
        vertices.push_back(vertex);
    }
    return vertices;
}

void Globe::make_vertices(const Shape& shape, const std::vector<SpherePatch>& fresh) {
    std::vector<std::vector<Vertex>> made(fresh.size());
    parallel_each(fresh.size(), 0, [&](size_t i) { made[i] = vertices_of(shape, fresh[i]); });
    glBindBuffer(GL_ARRAY_BUFFER, buffers_->vertices);
    for (size_t i = 0; i < fresh.size(); ++i) {
        const GLsizeiptr bytes = GLsizeiptr(sizeof(Vertex) * made[i].size());
        glBufferSubData(GL_ARRAY_BUFFER, bytes * slots_.at(fresh[i]).place, bytes, made[i].data());
    }
}

const Program& Globe::heights_program(const MapRecipe& recipe) const {
    return heights_.with({mapping_define(recipe.shape.mapping), recipe.gutter ? "" : "NO_GUTTER"});
}

const Program& Globe::normals_program(const MapRecipe& recipe) const {
    return normals_.with({mapping_define(recipe.shape.mapping), recipe.gutter ? "" : "NO_GUTTER",
                          recipe.slopes ? "PROBE_slope" : normal_rules.define(int(recipe.normals)),
                          strengths.define(int(recipe.strength))});
}

void Globe::set_patch(const Program& program, const MapRecipe& recipe, const SpherePatch& patch) const {
    program.set("u_face", glm::mat3(face_axes(recipe.shape.mapping, patch.face)));
    program.set("u_patch", glm::ivec2(patch.x, patch.y));
    program.set("u_level", patch.level);
    program.set("u_texels", recipe.texels);
}

void Globe::make_maps(const MapRecipe& recipe) {
    if (!map_) {
        const int rows = (capacity_ + map_columns - 1) / map_columns;
        map_ = std::make_unique<TexelTarget>(glm::ivec2(map_columns, rows) * (recipe.texels + 2),
                                             std::initializer_list<GLenum>{GL_RGBA32F});
        map_->bind(0);
        for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
            glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
    }
    std::vector<SpherePatch> fresh;
    for (auto& [id, slot] : slots_)
        if (!slot.has_map) fresh.push_back(id);
    if (fresh.empty()) return;

    const size_t batch = batch_columns * batch_columns;
    const int rows = int(std::min(batch, fresh.size()) + batch_columns - 1) / batch_columns;
    const TexelTarget heights(glm::ivec2(batch_columns, rows) * (recipe.texels + 4), {GL_RGBA32F});
    glDisable(GL_DEPTH_TEST);
    glBindVertexArray(buffers_->nothing);
    for (size_t begin = 0; begin < fresh.size(); begin += batch) {
        const std::span patches = std::span(fresh).subspan(begin, std::min(batch, fresh.size() - begin));
        draw_heights(recipe, patches, heights);
        draw_normals(recipe, patches, heights);
    }
    glEnable(GL_DEPTH_TEST);
}

void Globe::draw_heights(const MapRecipe& recipe, std::span<const SpherePatch> patches, const TexelTarget& heights) {
    const Program& program = heights_program(recipe);
    const int side = recipe.texels + 4;
    heights.begin();
    glUseProgram(program);
    set_ground(program, recipe.shape.ground);
    for (int i = 0; const SpherePatch& patch : patches) {
        const glm::ivec2 corner = tile(i++, batch_columns, side);
        glViewport(corner.x, corner.y, side, side);
        set_patch(program, recipe, patch);
        program.set("u_corner", corner);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
}

void Globe::draw_normals(const MapRecipe& recipe, std::span<const SpherePatch> patches, const TexelTarget& heights) {
    const Program& program = normals_program(recipe);
    const int side = recipe.texels + 2;
    map_->begin();
    glUseProgram(program);
    program.set("s_heights", 0);
    heights.bind(0);
    for (int i = 0; const SpherePatch& patch : patches) {
        Slot& slot = slots_.at(patch);
        const glm::ivec2 corner = tile(slot.place, map_columns, side);
        glViewport(corner.x, corner.y, side, side);
        set_patch(program, recipe, patch);
        program.set("u_corner", corner);
        program.set("u_heights_corner", tile(i++, batch_columns, recipe.texels + 4));
        glDrawArrays(GL_TRIANGLES, 0, 3);
        slot.has_map = true;
    }
}

glm::ivec2 Globe::map_corner(size_t i) const {
    return tile(slots_.at(drawn_[i]).place, map_columns, recipe_.texels + 2);
}

void Globe::draw(const Program& program, size_t i, const Plan& plan, const Eye& eye, bool precise) const {
    const Slot& slot = slots_.at(drawn_[i]);
    // Precise: subtracts in double and rounds the difference. Otherwise rounds both, and the shader subtracts.
    const glm::dvec3 middle = slot.middle * plan.radius, from = eye.place * plan.radius;
    program.set("u_middle", precise ? glm::vec3(middle - from) : glm::vec3(middle));
    program.set("u_minus", precise ? glm::vec3(0) : glm::vec3(from));
    program.set("u_centre", slot.middle);
    program.set("u_map_corner", map_ ? map_corner(i) : glm::ivec2(0));
    glBindVertexArray(buffers_->layout);
    glDrawElementsBaseVertex(GL_TRIANGLES, 3 * triangles_of_patch(plan.skirts), GL_UNSIGNED_INT, nullptr,
                             slot.place * shape_.vertices());
}

}  // namespace relief::planet
