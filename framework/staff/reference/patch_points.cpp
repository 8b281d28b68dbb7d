#include "framework/staff/reference/patch_points.h"

#include "framework/core/base/parallel.h"

namespace relief {

glm::dvec4 quad_weights(glm::dvec2 place) {
    const glm::dvec2 rest = 1.0 - place;
    return {rest.x * rest.y, place.x * rest.y, place.x * place.y, rest.x * place.y};
}

glm::dvec4 blend(const glm::dvec4& weights, const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4& c,
                 const glm::dvec4& d) {
    return weights.x * a + weights.y * b + (weights.z * c + weights.w * d);
}

int edge_of_triangle(const glm::dvec3& weights) {
    return weights.z == 0 ? 0 : weights.x == 0 ? 1 : weights.y == 0 ? 2 : -1;
}

int edge_of_quad(glm::dvec2 place) {
    return place.y == 0 ? 0 : place.x == 1 ? 1 : place.y == 1 ? 2 : place.x == 0 ? 3 : -1;
}

glm::dvec2 uv_on_edge(double here, double there, const glm::dvec4& edge_uv, glm::dvec2 uv_here, glm::dvec2 uv_there) {
    if (here == 1) return uv_here;
    if (there == 1) return uv_there;
    return here * glm::dvec2(edge_uv.x, edge_uv.y) + there * glm::dvec2(edge_uv.z, edge_uv.w);
}

std::array<glm::dvec3, 2> by_uv(const glm::dvec3& along_x, const glm::dvec3& along_y, glm::dvec2 uv_x,
                                glm::dvec2 uv_y) {
    const double area = uv_x.x * uv_y.y - uv_x.y * uv_y.x, scale = area == 0 ? 0 : 1 / area;
    return {scale * (uv_y.y * along_x - uv_x.y * along_y), scale * (uv_x.x * along_y - uv_y.x * along_x)};
}

glm::dvec3 turn_of_unit(const glm::dvec3& vector, const glm::dvec3& change) {
    const double squared = glm::dot(vector, vector);
    if (squared == 0) return {};
    return (change - vector * (glm::dot(vector, change) / squared)) / std::sqrt(squared);
}

DisplacedPoint displaced_on(const PatchMesh& mesh, size_t patch, const PatchPlace& place, const HeightField& heights,
                            double scale) {
    const bool is_quad = mesh.corners == 4;
    const PatchCorner* const corner = mesh.points.data() + patch * size_t(mesh.corners);
    const glm::dvec4 weights = is_quad ? quad_weights(place) : glm::dvec4(place, 0);
    const int edge = is_quad ? edge_of_quad(place) : edge_of_triangle(place);
    const PatchCorner& last = corner[mesh.corners - 1];
    const auto blended = [&](const auto& member) {
        return blend(weights, {member(corner[0]), 0}, {member(corner[1]), 0}, {member(corner[2]), 0},
                     {member(last), 0});
    };
    const auto position = [](const PatchCorner& at) { return glm::dvec3(at.vertex.position); };
    const auto direction = [](const PatchCorner& at) { return glm::dvec3(at.direction); };
    const auto uv = [](const PatchCorner& at) { return glm::dvec3(at.vertex.uv, 0); };
    const auto along_x = [&](const auto& member) {
        const glm::dvec3 near = member(corner[1]) - member(corner[0]);
        return is_quad ? glm::mix(near, member(corner[2]) - member(last), place.y) : near;
    };
    const auto along_y = [&](const auto& member) {
        return is_quad ? glm::mix(member(last) - member(corner[0]), member(corner[2]) - member(corner[1]), place.x)
                       : member(corner[2]) - member(corner[0]);
    };

    const glm::dvec3 long_normal(blended(direction));
    const auto [du, dv] = by_uv(along_x(position), along_y(position), along_x(uv), along_y(uv));
    const auto [turn_u, turn_v] = by_uv(along_x(direction), along_y(direction), along_x(uv), along_y(uv));
    const SurfacePoint base{.position = glm::dvec3(blended(position)),
                            .normal = glm::normalize(long_normal),
                            .du = du,
                            .dv = dv,
                            .normal_du = turn_of_unit(long_normal, turn_u),
                            .normal_dv = turn_of_unit(long_normal, turn_v)};
    glm::dvec2 read_at(blended(uv));
    if (edge >= 0) {
        const int next = (edge + 1) % mesh.corners;
        read_at = uv_on_edge(weights[edge], weights[next], corner[edge].edge_uv, corner[edge].height_uv,
                             corner[next].height_uv);
    }
    const glm::dvec2 size(heights.size()), texel = read_at * size;
    return displace(base, {heights.height(texel), heights.slope(texel) * size}, scale);
}

Mesh micro_polygons(const PatchMesh& mesh, const HeightField& heights, double scale, int n) {
    const size_t side = size_t(n) + 1, patches = mesh.patches();
    Mesh result;
    result.vertices.resize(patches * side * side);
    result.indices.resize(patches * size_t(n) * size_t(n) * 6);
    parallel_pieces(patches, 1, 0, [&](size_t begin, size_t end) {
        for (size_t patch = begin; patch < end; ++patch) {
            Vertex* vertex = result.vertices.data() + patch * side * side;
            for (size_t y = 0; y < side; ++y)
                for (size_t x = 0; x < side; ++x, ++vertex) {
                    const PatchPlace place{double(x) / n, double(y) / n, 0};
                    const DisplacedPoint point = displaced_on(mesh, patch, place, heights, scale);
                    *vertex = {point.position, point.normal, {}, glm::dvec2(place)};
                }
            uint32_t* index = result.indices.data() + patch * size_t(n) * size_t(n) * 6;
            for (size_t y = 0; y < size_t(n); ++y)
                for (size_t x = 0; x < size_t(n); ++x) {
                    const auto a = uint32_t(patch * side * side + y * side + x), c = a + uint32_t(side);
                    for (const uint32_t corner : {a, a + 1, c + 1, a, c + 1, c}) *index++ = corner;
                }
        }
    });
    return result;
}

std::vector<ShownPlace> shown_places(const Image& places, const PatchMesh& mesh, const HeightField& heights,
                                     double scale) {
    std::vector<ShownPlace> shown;
    for (int y = 0; y < places.height; ++y)
        for (int x = 0; x < places.width; ++x) {
            const float* const at = places.pixel(x, y);
            if (at[0] == no_surface) continue;
            const size_t patch = size_t(std::lround(at[2]));
            shown.push_back({{x, y}, displaced_on(mesh, patch, {at[0], at[1], 0}, heights, scale).position});
        }
    return shown;
}

std::vector<double> screen_errors(const Image& places, const PatchMesh& mesh, const HeightField& heights, double scale,
                                  const glm::dmat4& clip_from_model) {
    const glm::dvec2 size(places.width, places.height);
    std::vector<double> errors;
    for (const auto& [pixel, truth] : shown_places(places, mesh, heights, scale)) {
        const glm::dvec4 clip = clip_from_model * glm::dvec4(truth, 1);
        const glm::dvec2 wanted = (glm::dvec2(clip) / clip.w * glm::dvec2(0.5, -0.5) + 0.5) * size;
        errors.push_back(glm::distance(wanted, glm::dvec2(pixel) + 0.5));
    }
    return errors;
}

}  // namespace relief
