#include "globe.h"

#include <fmt/format.h>

#include <utility>

#include "framework/core/base/parallel.h"

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
    drop_outdated(std::exchange(recipe_, recipe), maps);
    drawn_.clear();
    for (const Leaf& leaf : patches) drawn_.push_back(leaf.id);
    const std::set<SpherePatch> wanted(drawn_.begin(), drawn_.end());
    make_room(int(wanted.size()));
    make_vertices(slots_.keep(wanted));
    if (maps) make_maps();
}

/// Drops vertices and maps that another recipe or program made.
void Globe::drop_outdated(const MapRecipe& before, bool maps) {
    const auto drop_maps = [&] {
        for (auto& [id, slot] : slots_) slot.value.has_map = false;
    };
    if (!(recipe_.shape == before.shape)) slots_.reset(slots_.capacity());
    if (!maps || recipe_.texels != before.texels) map_.reset();
    if (!map_ || !(recipe_ == before)) drop_maps();
    if (!maps) return;
    // A program gets another name when its shaders are saved and compiled again.
    const std::array<GLuint, 2> programs = {heights_program(), normals_program()};
    if (std::exchange(programs_, programs) != programs) drop_maps();
}

/// Makes buffers for this many patches, unless they have room. New ones are empty.
void Globe::make_room(int patches) {
    if (!buffers_) buffers_.emplace();
    if (recipe_.shape.quads == grid_.quads && patches <= slots_.capacity()) return;
    grid_.quads = recipe_.shape.quads;
    slots_.reset((patches / 64 + 1) * 64), map_.reset();
    glBindVertexArray(buffers_->layout);
    const std::vector<uint32_t> indices = grid_.indices();  // the same triangles for all patches
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_->indices);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(indices.size() * sizeof(uint32_t)), indices.data(),
                 GL_STATIC_DRAW);
    glBindBuffer(GL_ARRAY_BUFFER, buffers_->vertices);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(sizeof(Vertex)) * slots_.capacity() * grid_.vertices(), nullptr,
                 GL_DYNAMIC_DRAW);
    for (const GLuint location : {0u, 1u}) glEnableVertexAttribArray(location);
}

std::vector<Globe::Vertex> Globe::vertices_of(const SpherePatch& patch) const {
    const Shape& shape = recipe_.shape;
    const glm::dvec3 middle = slots_.at(patch).value.middle;
    std::vector<Vertex> vertices;
    for (int y = 0; y <= shape.quads; ++y)
        for (int x = 0; x <= shape.quads; ++x) {
            const glm::dvec2 local = glm::dvec2(x, y) / double(shape.quads);
            const glm::dvec3 place = shape.place(direction_at(shape.mapping, patch.face, patch.on_face(local)));
            // Subtracted in double: the small difference fits a float, which is exact to a millionth of it.
            vertices.push_back({place - middle, 0, local});
        }
    for (int i = 0; i < grid_.skirt_vertices(); ++i) {
        Vertex vertex = vertices[size_t(grid_.hangs_from(i))];
        vertex.is_skirt = 1;
        vertices.push_back(vertex);
    }
    return vertices;
}

void Globe::make_vertices(const std::vector<SpherePatch>& fresh) {
    const Shape& shape = recipe_.shape;
    for (const SpherePatch& id : fresh)
        slots_.at(id).value = {.middle = shape.place(direction_at(shape.mapping, id.face, id.on_face({0.5, 0.5})))};
    std::vector<std::vector<Vertex>> made(fresh.size());
    parallel_each(fresh.size(), 0, [&](size_t i) { made[i] = vertices_of(fresh[i]); });
    glBindBuffer(GL_ARRAY_BUFFER, buffers_->vertices);
    for (size_t i = 0; i < fresh.size(); ++i) {
        const GLsizeiptr bytes = GLsizeiptr(sizeof(Vertex) * made[i].size());
        glBufferSubData(GL_ARRAY_BUFFER, bytes * slots_.at(fresh[i]).place, bytes, made[i].data());
    }
}

const Program& Globe::heights_program() const {
    return heights_.with({mapping_define(recipe_.shape.mapping), recipe_.gutter ? "" : "NO_GUTTER"});
}

const Program& Globe::normals_program() const {
    return normals_.with({mapping_define(recipe_.shape.mapping), recipe_.gutter ? "" : "NO_GUTTER",
                          recipe_.slopes ? "PROBE_slope" : normal_rules.define(int(recipe_.normals)),
                          strengths.define(int(recipe_.strength))});
}

void Globe::set_patch(const Program& program, const SpherePatch& patch) const {
    program.set("u_face", glm::mat3(face_axes(recipe_.shape.mapping, patch.face)));
    program.set("u_patch", glm::ivec2(patch.x, patch.y));
    program.set("u_level", patch.level);
    program.set("u_texels", recipe_.texels);
}

void Globe::make_maps() {
    if (!map_) {
        const int rows = (slots_.capacity() + map_columns - 1) / map_columns;
        map_ = std::make_unique<TexelTarget>(glm::ivec2(map_columns, rows) * (recipe_.texels + 2),
                                             std::initializer_list<GLenum>{GL_RGBA32F});
    }
    std::vector<SpherePatch> fresh;
    for (auto& [id, slot] : slots_)
        if (!slot.value.has_map) fresh.push_back(id);
    if (fresh.empty()) return;

    const size_t batch = batch_columns * batch_columns;
    const int rows = int(std::min(batch, fresh.size()) + batch_columns - 1) / batch_columns;
    const TexelTarget heights(glm::ivec2(batch_columns, rows) * (recipe_.texels + 4), {GL_RGBA32F});
    glDisable(GL_DEPTH_TEST);
    glBindVertexArray(buffers_->nothing);
    for (size_t begin = 0; begin < fresh.size(); begin += batch) {
        const std::span patches = std::span(fresh).subspan(begin, std::min(batch, fresh.size() - begin));
        draw_heights(patches, heights);
        draw_normals(patches, heights);
    }
    glEnable(GL_DEPTH_TEST);
}

void Globe::draw_heights(std::span<const SpherePatch> patches, const TexelTarget& heights) {
    const Program& program = heights_program();
    const int side = recipe_.texels + 4;
    heights.begin();
    glUseProgram(program);
    set_ground(program, recipe_.shape.ground);
    for (int i = 0; const SpherePatch& patch : patches) {
        const glm::ivec2 corner = tile(i++, batch_columns, side);
        glViewport(corner.x, corner.y, side, side);
        set_patch(program, patch);
        program.set("u_corner", corner);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
}

void Globe::draw_normals(std::span<const SpherePatch> patches, const TexelTarget& heights) {
    const Program& program = normals_program();
    const int side = recipe_.texels + 2;
    map_->begin();
    glUseProgram(program);
    program.set("s_heights", 0);
    heights.bind(0);
    for (int i = 0; const SpherePatch& patch : patches) {
        auto& slot = slots_.at(patch);
        const glm::ivec2 corner = tile(slot.place, map_columns, side);
        glViewport(corner.x, corner.y, side, side);
        set_patch(program, patch);
        program.set("u_corner", corner);
        program.set("u_heights_corner", tile(i++, batch_columns, recipe_.texels + 4));
        glDrawArrays(GL_TRIANGLES, 0, 3);
        slot.value.has_map = true;
    }
}

glm::ivec2 Globe::map_corner(size_t i) const {
    return tile(slots_.at(drawn_[i]).place, map_columns, recipe_.texels + 2);
}

std::optional<Image> Globe::map_picture() const {
    if (!map_ || drawn_.empty() || recipe_.slopes) return {};
    const Image atlas = map_->read();
    const int texels = recipe_.texels, count = int(drawn_.size());
    const int columns = std::min(count, map_columns), rows = (count + columns - 1) / columns;
    Image picture(columns * texels, rows * texels, 3);
    for (int i = 0; i < count; ++i) {
        const glm::ivec2 from = map_corner(size_t(i)) + 1, to = tile(i, columns, texels);  // inside of the gutter
        for (int y = 0; y < texels; ++y)
            for (int x = 0; x < texels; ++x) {
                const float* const normal = atlas.pixel(from.x + x, atlas.height - 1 - (from.y + texels - 1 - y));
                for (int c = 0; c < 3; ++c) picture.pixel(to.x + x, to.y + y)[c] = 0.5f + 0.5f * normal[c];
            }
    }
    return picture;
}

void Globe::draw(const Program& program, size_t i, const Plan& plan, const Eye& eye, bool precise) const {
    const auto& slot = slots_.at(drawn_[i]);
    // Precise: subtracts in double and rounds the difference. Otherwise rounds both, and the shader subtracts.
    const glm::dvec3 middle = slot.value.middle * plan.radius, from = eye.place * plan.radius;
    program.set("u_middle", precise ? glm::vec3(middle - from) : glm::vec3(middle));
    program.set("u_minus", precise ? glm::vec3(0) : glm::vec3(from));
    program.set("u_centre", slot.value.middle);
    program.set("u_map_corner", map_ ? map_corner(i) : glm::ivec2(0));
    glBindVertexArray(buffers_->layout);
    glBindBuffer(GL_ARRAY_BUFFER, buffers_->vertices);
    // WebGL has no glDrawElementsBaseVertex: the attributes begin at the slot.
    const size_t begin = sizeof(Vertex) * size_t(slot.place * grid_.vertices());
    glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(Vertex), reinterpret_cast<const void*>(begin));
    glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                          reinterpret_cast<const void*>(begin + offsetof(Vertex, local)));
    glDrawElements(GL_TRIANGLES, 3 * triangles_of_patch(plan.skirts), GL_UNSIGNED_INT, nullptr);
}

}  // namespace relief::planet
