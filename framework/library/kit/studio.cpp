#include "framework/library/kit/studio.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <utility>

#include "framework/core/base/parallel.h"
#include "framework/library/kit/view_axes.h"

namespace relief {
namespace {

constexpr size_t shadow_side = 64;  ///< texels
constexpr double shadow_reach = 4;  ///< half the side of the shadow's map, in radii of the solid
constexpr double shadow_focus = 3;  ///< the map's middle has 1 + shadow_focus times the resolution of an even map
constexpr int facet_cells = 14;     ///< facets of one cell of this grid and one direction become one
constexpr double below = 0.04;      ///< of the floor's places, radii: facets that touch the floor are above them, too
constexpr size_t most_floors = 16;  ///< a slider that is drawn makes many

/// Returns a coordinate of the floor, in units of the map's reach, for one of the map, both in [-1, 1].
/// shaders/common/studio.frag has the inverse.
double on_floor(double coordinate) { return coordinate / (1 + shadow_focus - shadow_focus * std::abs(coordinate)); }

std::vector<glm::dvec3> places_of(const Mesh& mesh, const glm::dmat4& world_from_model) {
    std::vector<glm::dvec3> places;
    for (const Vertex& vertex : mesh.vertices) places.emplace_back(world_from_model * glm::dvec4(vertex.position, 1));
    return places;
}

/// Returns two corners of the box around places, parallel to the axes.
std::pair<glm::dvec3, glm::dvec3> box_of(const std::vector<glm::dvec3>& places) {
    glm::dvec3 low(INFINITY), high(-INFINITY);
    for (const glm::dvec3& place : places) low = glm::min(low, place), high = glm::max(high, place);
    return {low, high};
}

}  // namespace

std::vector<Facet> facets_of(const Mesh& mesh, const glm::dmat4& world_from_model) {
    const std::vector<glm::dvec3> places = places_of(mesh, world_from_model);
    const auto [low, high] = box_of(places);
    const glm::dvec3 cells = double(facet_cells) / glm::max(high - low, glm::dvec3(1e-9));
    std::map<std::array<int, 4>, Facet> merged;  // by cell and direction
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const glm::dvec3 a = places[mesh.indices[i]], b = places[mesh.indices[i + 1]], c = places[mesh.indices[i + 2]];
        const glm::dvec3 area = glm::cross(b - a, c - a) / 2.0;
        const double size = glm::length(area);
        if (!(size > 0)) continue;
        const glm::dvec3 middle = (a + b + c) / 3.0, steep = glm::abs(area);
        const glm::ivec3 cell((middle - low) * cells);
        const int axis = steep.x > steep.y ? (steep.x > steep.z ? 0 : 2) : (steep.y > steep.z ? 1 : 2);
        Facet& facet = merged[{cell.x, cell.y, cell.z, 2 * axis + (area[axis] > 0)}];
        const double before = glm::length(facet.area);
        facet.place = (facet.place * before + middle * size) / (before + size);
        facet.area += area;
    }
    std::vector<Facet> facets;
    for (const auto& [cell, facet] : merged) facets.push_back(facet);
    return facets;
}

double hidden_sky(const std::vector<Facet>& facets, const glm::dvec3& place) {
    double front = 0, back = 0;
    for (const Facet& facet : facets) {
        const glm::dvec3 to = facet.place - place;
        if (to.y <= 0) continue;
        const double squared = glm::dot(to, to), area = glm::length(facet.area), facing = glm::dot(facet.area, to);
        // The form factor of a disc seen from a point (Bunnell 2005): it stays finite where they touch. At the foot of
        // a wall most places are close to the wall's plane, so that its facets seem edge-on: their extent counts, too.
        const double shown = std::sqrt(facing * facing + 0.0625 * area * area * area);
        (facing < 0 ? front : back) += to.y * shown / (squared * (glm::pi<double>() * squared + area));
    }
    return std::min(1.0, std::max(front, back));
}

Studio::Floor Studio::floor_under(const Mesh& mesh, const glm::dmat4& world_from_model) {
    const auto [low, high] = box_of(places_of(mesh, world_from_model));
    const glm::dvec3 middle((low.x + high.x) / 2, low.y, (low.z + high.z) / 2);
    const double radius = std::max(1e-6, glm::length(high - low) / 2);
    return {middle, radius,
            Texture("shadow on the floor",
                    [facets = facets_of(mesh, world_from_model), middle, radius] {
                        const auto along = [&](size_t texel) {
                            return shadow_reach * radius * on_floor((double(texel) + 0.5) / shadow_side * 2 - 1);
                        };
                        Image image(shadow_side, shadow_side, 1, 8);
                        parallel_each(shadow_side, 0, [&](size_t row) {
                            for (size_t x = 0; x < shadow_side; ++x) {  // row 0 has the largest z
                                const glm::dvec3 place =
                                    middle + glm::dvec3(along(x), -below * radius, along(shadow_side - 1 - row));
                                *image.pixel(int(x), int(row)) = float(hidden_sky(facets, place));
                            }
                        });
                        return image;
                    },
                    {.wrap = Wrap::clamp, .mips = false})};
}

void Studio::draw(const Frame& frame, const Tile& tile, std::vector<double> inputs, const std::function<Mesh()>& make,
                  const glm::dmat4& world_from_model) {
    if (!frame.studio || tile.size.x <= 0 || tile.size.y <= 0) return;
    inputs.insert(inputs.end(), glm::value_ptr(world_from_model), glm::value_ptr(world_from_model) + 16);
    auto found = floors_.find(inputs);
    if (found == floors_.end()) {
        if (floors_.size() >= most_floors) floors_.clear();
        found = floors_.try_emplace(std::move(inputs), floor_under(make(), world_from_model)).first;
    }
    const Floor& here = found->second;
    const Program& program = program_.with();
    glViewport(tile.corner.x, tile.corner.y, tile.size.x, tile.size.y);
    glUseProgram(program);
    set_rays(program, frame);
    program.set("u_eye", frame.camera.eye() - here.middle);
    program.set("u_radius", here.radius);
    program.set("u_reach", shadow_reach * here.radius);
    program.set("u_focus", shadow_focus);
    program.set("s_shadow", 0, here.shadow);
    window_.draw_behind();
}

}  // namespace relief
