#include "globe.h"

#include <fmt/format.h>

#include <set>

#include "framework/base/parallel.h"

namespace relief::planet {
namespace {

constexpr std::array normals_defines = {"", "RIGHT_ANGLED", "B_BY_CROSS", "ONE_SCALE"};
constexpr std::array strength_defines = {"", "STRENGTH_PLUS_1", "STRENGTH_NONE"};
constexpr int batch_columns = 8;  // heights are computed for 8 x 8 tiles at a time

glm::ivec2 tile(int index, int columns, int size) { return glm::ivec2(index % columns, index / columns) * size; }

}  // namespace

Define mapping_define(Mapping mapping) {
    return mapping == Mapping::lat_long ? "LAT_LONG" : mapping == Mapping::gnomonic ? "GNOMONIC" : "";
}

void set_ground(const Program& program, const Ground& ground) {
    program.set("u_seed", ground.seed);
    program.set("u_detail", ground.detail);
    program.set("u_height", ground.height);
    for (int i = 0; i < crater_count; ++i) {
        const Crater c = crater(ground.seed, i);
        program.set(fmt::format("u_craters[{}]", i).c_str(), glm::vec4(c.middle, c.size));
    }
}

void Globe::make_buffers(int quads) {
    quads_ = quads;
    const int side = quads + 1;
    std::vector<uint32_t> indices;
    const auto quad = [&](uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
        indices.insert(indices.end(), {a, b, d, a, d, c});
    };
    for (int y = 0; y < quads; ++y)
        for (int x = 0; x < quads; ++x) {
            const uint32_t a = uint32_t(y * side + x);
            quad(a, a + 1, a + uint32_t(side), a + uint32_t(side) + 1);
        }
    // The skirts come last, so that they can be left out.
    for (int edge = 0; edge < 4; ++edge)
        for (int i = 0; i < quads; ++i) {
            const auto border = [&](int at) {
                return uint32_t(edge == 0   ? at
                                : edge == 1 ? at * side + quads
                                : edge == 2 ? quads * side + quads - at
                                            : (quads - at) * side);
            };
            const uint32_t below = uint32_t(side * side + edge * side + i);
            quad(below, below + 1, border(i), border(i + 1));
        }
    index_count_ = int(indices.size());
    glBindVertexArray(buffers_->layout);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_->indices);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(indices.size() * sizeof(uint32_t)), indices.data(),
                 GL_STATIC_DRAW);
}

void Globe::make_vertices(const Shape& shape, const std::vector<PatchId>& fresh) {
    const int side = shape.quads + 1, count = side * side + 4 * side;
    std::vector<std::vector<Vertex>> made(fresh.size());
    parallel_each(fresh.size(), 0, [&](size_t i) {
        const PatchId& id = fresh[i];
        const glm::dvec3 middle = slots_.at(id).middle;
        std::vector<Vertex>& vertices = made[i];
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const glm::dvec2 local = glm::dvec2(x, y) / double(shape.quads);
                const glm::dvec3 r = direction_at(shape.mapping, id.face, id.on_face(local));
                // Subtracted in double: the small difference fits a float, which is exact to a millionth of it.
                vertices.push_back({(1 + height(shape.ground, r)) * r - middle, 0, local});
            }
        for (int edge = 0; edge < 4; ++edge)
            for (int at = 0; at < side; ++at) {
                Vertex vertex = vertices[size_t(edge == 0   ? at
                                                : edge == 1 ? at * side + side - 1
                                                : edge == 2 ? (side - 1) * side + side - 1 - at
                                                            : (side - 1 - at) * side)];
                vertex.is_skirt = 1;
                vertices.push_back(vertex);
            }
    });
    glBindBuffer(GL_ARRAY_BUFFER, buffers_->vertices);
    for (size_t i = 0; i < fresh.size(); ++i)
        glBufferSubData(GL_ARRAY_BUFFER, GLintptr(sizeof(Vertex)) * count * slots_.at(fresh[i]).place,
                        GLsizeiptr(sizeof(Vertex) * made[i].size()), made[i].data());
}

void Globe::set_patch(const Program& program, const MapRecipe& recipe, const PatchId& id) const {
    program.set("u_face", glm::mat3(face_axes(recipe.shape.mapping, id.face)));
    program.set("u_patch", glm::ivec2(id.x, id.y));
    program.set("u_level", id.level);
    program.set("u_texels", recipe.texels);
}

std::pair<const Program&, const Program&> Globe::programs_of(const MapRecipe& recipe) const {
    const Define mapping = mapping_define(recipe.shape.mapping), gutter = recipe.gutter ? "" : "NO_GUTTER";
    return {heights_.with({mapping, gutter}),
            normals_.with({mapping, gutter, recipe.slopes ? "PROBE_slope" : normals_defines[size_t(recipe.normals)],
                           strength_defines[size_t(recipe.strength)]})};
}

void Globe::make_maps(const MapRecipe& recipe, const std::vector<PatchId>& fresh) {
    if (fresh.empty()) return;
    const int tile_side = recipe.texels + 2, heights_side = recipe.texels + 4;
    const size_t batch = batch_columns * batch_columns;
    const int rows = int(std::min<size_t>(batch, fresh.size()) + batch_columns - 1) / batch_columns;
    const TexelTarget heights({batch_columns * heights_side, rows * heights_side}, {GL_RGBA32F});
    const auto [low, high] = programs_of(recipe);
    glDisable(GL_DEPTH_TEST);
    glBindVertexArray(*nothing_);
    for (size_t begin = 0; begin < fresh.size(); begin += batch) {
        const size_t end = std::min(fresh.size(), begin + batch);
        heights.begin();
        glUseProgram(low);
        set_ground(low, recipe.shape.ground);
        for (size_t i = begin; i < end; ++i) {
            const glm::ivec2 corner = tile(int(i - begin), batch_columns, heights_side);
            glViewport(corner.x, corner.y, heights_side, heights_side);
            set_patch(low, recipe, fresh[i]);
            low.set("u_corner", corner);
            glDrawArrays(GL_TRIANGLES, 0, 3);
        }
        map_->begin();
        glUseProgram(high);
        high.set("s_heights", 0);
        heights.bind(0);
        for (size_t i = begin; i < end; ++i) {
            const glm::ivec2 corner = tile(slots_.at(fresh[i]).place, tile_columns(), tile_side);
            glViewport(corner.x, corner.y, tile_side, tile_side);
            set_patch(high, recipe, fresh[i]);
            high.set("u_corner", corner);
            high.set("u_heights_corner", tile(int(i - begin), batch_columns, heights_side));
            glDrawArrays(GL_TRIANGLES, 0, 3);
        }
    }
    glEnable(GL_DEPTH_TEST);
}

void Globe::prepare(const MapRecipe& recipe, const std::vector<Leaf>& patches, bool maps) {
    if (!buffers_) buffers_.emplace(), nothing_.emplace();
    // A program gets another name when its shaders are saved and compiled again.
    std::array<GLuint, 2> programs = programs_;
    if (maps) {
        const auto [heights, normals] = programs_of(recipe);
        programs = {heights, normals};
    }
    if (!(recipe.shape == recipe_.shape)) slots_.clear();
    if (!(recipe == recipe_) || programs != programs_)
        for (auto& [id, slot] : slots_) slot.has_map = false;
    const bool other_tiles = recipe.texels != recipe_.texels;
    recipe_ = recipe, programs_ = programs;

    drawn_.clear();
    for (const Leaf& leaf : patches) drawn_.push_back(leaf.id);
    const std::set<PatchId> wanted(drawn_.begin(), drawn_.end());
    std::erase_if(slots_, [&](const auto& slot) { return !wanted.contains(slot.first); });
    const bool other_quads = recipe.shape.quads != quads_;
    if (other_quads) make_buffers(recipe.shape.quads);
    if (other_quads || int(wanted.size()) > capacity_) {
        capacity_ = (int(wanted.size()) / 64 + 1) * 64;
        slots_.clear(), map_.reset();
        const int side = quads_ + 1;
        glBindVertexArray(buffers_->layout);
        glBindBuffer(GL_ARRAY_BUFFER, buffers_->vertices);
        glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(sizeof(Vertex)) * capacity_ * side * (side + 4), nullptr,
                     GL_DYNAMIC_DRAW);
        for (const GLuint location : {0u, 1u}) glEnableVertexAttribArray(location);
        glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(Vertex), nullptr);
        glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                              reinterpret_cast<const void*>(offsetof(Vertex, local)));
    }
    if (other_tiles || !maps) map_.reset();
    if (!map_)
        for (auto& [id, slot] : slots_) slot.has_map = false;

    std::vector<bool> taken(size_t(capacity_), false);
    for (const auto& [id, slot] : slots_) taken[size_t(slot.place)] = true;
    std::vector<PatchId> bare, plain;
    for (int next = 0; const PatchId& id : wanted) {
        const auto [found, is_new] = slots_.try_emplace(id);
        Slot& slot = found->second;
        if (is_new) {
            while (taken[size_t(next)]) ++next;
            slot.place = next++;
            const glm::dvec3 r = direction_at(recipe.shape.mapping, id.face, id.on_face({0.5, 0.5}));
            slot.middle = (1 + height(recipe.shape.ground, r)) * r;
        }
        if (!slot.has_vertices) bare.push_back(id), slot.has_vertices = true;
        if (maps && !slot.has_map) plain.push_back(id), slot.has_map = true;
    }
    make_vertices(recipe.shape, bare);
    if (maps && !map_) {
        map_ = std::make_unique<TexelTarget>(
            glm::ivec2(tile_columns(), (capacity_ + tile_columns() - 1) / tile_columns()) * (recipe.texels + 2),
            std::initializer_list<GLenum>{GL_RGBA32F});
        map_->bind(0);
        for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
            glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
    }
    make_maps(recipe, plain);
}

glm::ivec2 Globe::map_corner(size_t i) const {
    return tile(slots_.at(drawn_[i]).place, tile_columns(), recipe_.texels + 2);
}

void Globe::draw(const Program& program, const Plan& plan, size_t i, bool precise) const {
    const Slot& slot = slots_.at(drawn_[i]);
    // Precise: subtracts in double and rounds the difference. Otherwise rounds both, and the shader subtracts.
    const glm::dvec3 middle = slot.middle * plan.radius, eye = plan.eye.place * plan.radius;
    program.set("u_middle", precise ? glm::vec3(middle - eye) : glm::vec3(middle));
    program.set("u_minus", precise ? glm::vec3(0) : glm::vec3(eye));
    program.set("u_centre", slot.middle);
    program.set("u_map_corner", map_ ? map_corner(i) : glm::ivec2(0));
    const int side = quads_ + 1;
    glBindVertexArray(buffers_->layout);
    const int count = plan.skirts ? index_count_ : index_count_ - skirt_triangles() * 3;
    glDrawElementsBaseVertex(GL_TRIANGLES, count, GL_UNSIGNED_INT, nullptr, slot.place * side * (side + 4));
}

}  // namespace relief::planet
