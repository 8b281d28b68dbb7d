// The staff's part of lab 07: see ../truth.h.
#include "truth.h"

#include <cmath>

#include "framework/library/kit/drawn_numbers.h"
#include "framework/staff/reference/bake.h"
#include "framework/staff/reference/mesh_rays.h"
#include "framework/staff/reference/tangent_space.h"

namespace relief::baking {
namespace {

struct Scene {
    explicit Scene(const Recipe& of, bool other_diagonal)
        : recipe(of), high(of.high_mesh()), low(of.low_mesh(other_diagonal)), high_tree(build_tree(high)) {}

    const Recipe& recipe;
    Mesh high, low;
    TriangleTree high_tree;

    /// Returns the hit of the ray from the cage inwards that is nearest to the place.
    std::optional<BakeHit> met_from(const BakePlace& place) const {
        return nearest_hit(high_tree, high, place, recipe.reach_at(place.uv));
    }

    glm::dvec3 baked_normal(const BakePlace& place) const {
        const auto met = met_from(place);
        return met ? met->normal : glm::normalize(place.normal);
    }
};

/// Returns the normal n in the recipe's frame, of unit length.
glm::dvec3 stored(const Recipe& recipe, const BakePlace& place, const glm::dvec3& n) {
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
        const BakePlace place = place_at(scene.low, hit->triangle, hit->weights);
        if (sight.recipe.model.shape != Shape::cube) return glm::dvec4(scene.baked_normal(place), 0);
        // The face is that of the longest coordinate.
        const glm::dvec3 p = place.position - glm::dvec3(cube_centre), size = glm::abs(p);
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        glm::dvec4 face(0);
        face[axis] = p[axis] < 0 ? -1 : 1;
        return face;
    });
}

std::optional<Image> exact_map(const Frame& frame, const Recipe& recipe) {
    const Scene scene(recipe, false);
    if (frame.probe.name == "cover") {
        const std::vector<BakePlace> places = texel_places(scene.low, frame.size);
        return image_of_values(frame.size, [&](int x, int y) {
            return glm::dvec4(places[size_t(y) * size_t(frame.size.x) + size_t(x)].cover, 0, 0, 0);
        });
    }
    if (recipe.overlapping) return {};  // either of two triangles may have the texel
    const std::vector<BakePlace> places = texel_places(scene.low, glm::ivec2(recipe.size));
    return image_of_values(frame.size, [&](int x, int y) {
        // A pixel centre on the border of texels belongs to the upper and right one.
        const auto texel_of = [&](int i, int count) {
            return std::min(recipe.size - 1, int((i + 0.5) / count * recipe.size + 0.001));
        };
        const int row = recipe.size - 1 - texel_of(frame.size.y - 1 - y, frame.size.y);
        const BakePlace& place = places[size_t(row) * size_t(recipe.size) + size_t(texel_of(x, frame.size.x))];
        if (place.cover == 0) return nothing;
        if (frame.probe.name == "stored") return glm::dvec4(stored(recipe, place, scene.baked_normal(place)), 0);
        const auto met = scene.met_from(place);
        return met ? glm::dvec4(met->height, 0, 0, 0) : nothing;
    });
}

const decltype(normal_truth)::Provided provided_normals(normal_truth, exact_normals);
const decltype(map_truth)::Provided provided_map(map_truth, exact_map);

}  // namespace
}  // namespace relief::baking
