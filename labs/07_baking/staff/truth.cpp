// The staff's part of lab 07: see ../truth.h.
#include "truth.h"

#include <cmath>

#include "framework/core/kit/numbers.h"
#include "framework/staff/reference/mesh_rays.h"
#include "framework/staff/reference/tangent_space.h"

namespace relief::baking {
namespace {

/// A place on the coarse model, interpolated between the corners of its triangle.
struct Place {
    glm::dvec3 position{}, normal{};
    glm::dvec4 tangent{};
    glm::dvec2 uv{};
    double cover = 0;  ///< number of triangles that cover it on the map
};

Place place_at(const Mesh& mesh, size_t triangle, const glm::dvec3& weights) {
    Place place;
    for (size_t corner = 0; corner < 3; ++corner) {
        const Vertex& vertex = mesh.vertices[mesh.indices[triangle * 3 + corner]];
        const double weight = weights[int(corner)];
        place.position += weight * glm::dvec3(vertex.position), place.normal += weight * glm::dvec3(vertex.normal);
        place.tangent += weight * glm::dvec4(vertex.tangent), place.uv += weight * glm::dvec2(vertex.uv);
    }
    return place;
}

struct Scene {
    explicit Scene(const Recipe& of, bool other_diagonal)
        : recipe(of),
          high(make_high(of.model, high_finenesses[size_t(of.high)], of.cord)),
          low(make_low(of.model, low_finenesses[size_t(of.low)], of.overlapping, other_diagonal)),
          high_tree(build_tree(high)) {}

    const Recipe& recipe;
    Mesh high, low;
    TriangleTree high_tree;

    /// Returns the height and the normal of the hit that is nearest to the place. Only front faces count, on the ray
    /// from the cage inwards. Returns nothing if there is none.
    std::optional<std::pair<double, glm::dvec3>> met_from(const Place& place) const {
        const glm::dvec3 outwards = glm::normalize(place.normal);
        const double reach = recipe.reach_at(place.uv);
        std::optional<MeshHit> best;
        each_hit(high_tree, high, {place.position + reach * outwards, -outwards}, 2 * reach, [&](const MeshHit& hit) {
            if (hit.is_front && (!best || std::abs(reach - hit.t) < std::abs(reach - best->t))) best = hit;
        });
        if (!best) return {};
        return std::pair(reach - best->t, normal_at(high, *best));
    }

    glm::dvec3 baked_normal(const Place& place) const {
        const auto met = met_from(place);
        return met ? met->second : glm::normalize(place.normal);
    }
};

/// Returns the places of a map's texels, row 0 at the top. A texel belongs to the triangle that covers its centre, or
/// to one of two triangles if its centre is on their common edge.
std::vector<Place> texel_places(const Mesh& mesh, glm::ivec2 size) {
    std::vector<Place> places(size_t(size.x) * size_t(size.y));
    for (size_t triangle = 0; triangle < mesh.indices.size() / 3; ++triangle) {
        glm::dvec2 at[3], low(INFINITY), high(-INFINITY);
        for (size_t corner = 0; corner < 3; ++corner) {
            at[corner] = glm::dvec2(mesh.vertices[mesh.indices[triangle * 3 + corner]].uv) * glm::dvec2(size);
            low = glm::min(low, at[corner]), high = glm::max(high, at[corner]);
        }
        const auto twice_area = [](glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
            return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        };
        const double area = twice_area(at[0], at[1], at[2]);
        if (area == 0) continue;
        const glm::ivec2 begin = glm::max(glm::ivec2(low), 0), end = glm::min(glm::ivec2(high) + 1, size);
        for (int y = begin.y; y < end.y; ++y)
            for (int x = begin.x; x < end.x; ++x) {
                glm::dvec3 weights;
                bool is_inside = true;
                for (int corner = 0; corner < 3; ++corner) {
                    const glm::dvec2 from = at[(corner + 1) % 3], to = at[(corner + 2) % 3];
                    weights[corner] = twice_area(from, to, {x + 0.5, y + 0.5}) / area;
                    const glm::dvec2 along = (to - from) * (area < 0 ? -1.0 : 1.0);
                    const bool owns_edge = along.y < 0 || (along.y == 0 && along.x > 0);
                    is_inside &= weights[corner] > 0 || (weights[corner] == 0 && owns_edge);
                }
                if (!is_inside) continue;
                Place& place = places[size_t(size.y - 1 - y) * size_t(size.x) + size_t(x)];
                const double cover = place.cover + 1;
                place = place_at(mesh, triangle, weights), place.cover = cover;
            }
    }
    return places;
}

/// Returns the normal n in the recipe's frame, of unit length.
glm::dvec3 stored(const Recipe& recipe, const Place& place, const glm::dvec3& n) {
    if (recipe.object_space) return n;
    const glm::dvec3 tangent(place.tangent);
    if (recipe.frame == 2) return to_tangent_space(n, place.normal, place.tangent);
    if (recipe.frame == 1)
        return to_interpolated_frame(n, glm::normalize(place.normal), {glm::normalize(tangent), place.tangent.w});
    return to_interpolated_frame(n, place.normal, place.tangent);
}

const glm::dvec4 nothing(std::numeric_limits<double>::infinity());

std::optional<Image> exact_normals(const Frame& frame, const Sight& sight) {
    const Scene scene(sight.recipe, sight.other_diagonal);
    if (sight.shown == Shown::high)
        return image_of_values(frame.size, [&](int x, int y) {
            const auto hit = first_hit(scene.high_tree, scene.high, frame.ray(x, y), 1e9);
            return hit ? glm::dvec4(normal_at(scene.high, *hit), 0) : nothing;
        });
    const TriangleTree low_tree = build_tree(scene.low);
    return image_of_values(frame.size, [&](int x, int y) {
        const auto hit = first_hit(low_tree, scene.low, frame.ray(x, y), 1e9);
        if (!hit) return nothing;
        const Place place = place_at(scene.low, hit->triangle, hit->weights);
        if (sight.recipe.model.shape != Shape::cube) return glm::dvec4(scene.baked_normal(place), 0);
        // The face is that of the longest coordinate.
        const glm::dvec3 p = place.position - glm::dvec3(cube_centre), size = glm::abs(p);
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        glm::dvec4 face(0);
        face[axis] = p[axis] < 0 ? -1 : 1;
        return face;
    });
}

std::optional<Image> exact_map(const Frame& frame, const Probe& probe, const Recipe& recipe) {
    const Scene scene(recipe, false);
    if (probe.name == "cover") {
        const std::vector<Place> places = texel_places(scene.low, frame.size);
        return image_of_values(frame.size, [&](int x, int y) {
            return glm::dvec4(places[size_t(y) * size_t(frame.size.x) + size_t(x)].cover, 0, 0, 0);
        });
    }
    if (recipe.overlapping) return {};  // either of two triangles may have the texel
    const std::vector<Place> places = texel_places(scene.low, glm::ivec2(recipe.size));
    return image_of_values(frame.size, [&](int x, int y) {
        // A pixel centre on the border of texels belongs to the upper and right one.
        const auto texel_of = [&](int i, int count) {
            return std::min(recipe.size - 1, int((i + 0.5) / count * recipe.size + 0.001));
        };
        const int row = recipe.size - 1 - texel_of(frame.size.y - 1 - y, frame.size.y);
        const Place& place = places[size_t(row) * size_t(recipe.size) + size_t(texel_of(x, frame.size.x))];
        if (place.cover == 0) return nothing;
        if (probe.name == "stored") return glm::dvec4(stored(recipe, place, scene.baked_normal(place)), 0);
        const auto met = scene.met_from(place);
        return met ? glm::dvec4(met->first, 0, 0, 0) : nothing;
    });
}

const decltype(normal_truth)::Provided provided_normals(normal_truth, exact_normals);
const decltype(map_truth)::Provided provided_map(map_truth, exact_map);

}  // namespace
}  // namespace relief::baking
