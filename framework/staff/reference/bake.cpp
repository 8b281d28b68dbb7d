#include "framework/staff/reference/bake.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/core/base/error.h"
#include "framework/core/base/parallel.h"
#include "framework/staff/reference/mesh_rays.h"
#include "framework/staff/reference/tangent_space.h"

namespace relief {
namespace {

enum State : uint8_t { empty, full, next };

/// Gives every empty texel the mean of its full neighbours, from the full ones outwards. Returns the number of texels
/// that were empty.
size_t fill(Image& values, std::vector<uint8_t>& states) {
    const int width = values.width, height = values.height;
    const auto index = [&](int x, int y) { return size_t(y) * size_t(width) + size_t(x); };
    const auto each_neighbour = [&](size_t i, const auto& take) {
        const int x = int(i % size_t(width)), y = int(i / size_t(width));
        for (int v = std::max(0, y - 1); v <= std::min(height - 1, y + 1); ++v)
            for (int u = std::max(0, x - 1); u <= std::min(width - 1, x + 1); ++u)
                if (u != x || v != y) take(index(u, v));
    };
    // Texels that are empty and touch a full one.
    const auto border_of = [&](const std::vector<size_t>& texels) {
        std::vector<size_t> border;
        for (const size_t i : texels)
            each_neighbour(i, [&](size_t other) {
                if (states[other] != empty) return;
                states[other] = next;
                border.push_back(other);
            });
        return border;
    };
    std::vector<size_t> texels;
    for (size_t i = 0; i < states.size(); ++i)
        if (states[i] == full) texels.push_back(i);
    size_t filled = 0;
    for (texels = border_of(texels); !texels.empty(); texels = border_of(texels)) {
        // A step reads the texels of the steps before it only, so that the order of the texels has no influence.
        for (const size_t i : texels) {
            glm::dvec3 sum(0);
            double count = 0;
            each_neighbour(i, [&](size_t other) {
                if (states[other] != full) return;
                for (int c = 0; c < values.channels; ++c)
                    sum[c] += double(values.values[other * size_t(values.channels) + size_t(c)]);
                ++count;
            });
            if (values.channels == 3) {
                const double length = glm::length(sum);
                sum = length > 1e-6 * count ? sum / length : glm::dvec3(0, 0, 1);
            } else {
                sum /= count;
            }
            for (int c = 0; c < values.channels; ++c)
                values.values[i * size_t(values.channels) + size_t(c)] = float(sum[c]);
        }
        for (const size_t i : texels) states[i] = full;
        filled += texels.size();
    }
    return filled;
}

/// Returns false also for NaN.
bool has_direction(const glm::dvec3& vector) { return glm::length(vector) > 1e-12; }

void check_uv(const Mesh& coarse) {
    constexpr float rounding = 1e-4f;
    for (const uint32_t index : coarse.indices) {
        const glm::vec2 uv = coarse.vertices[index].uv;
        if (!(uv.x >= -rounding && uv.y >= -rounding && uv.x <= 1 + rounding && uv.y <= 1 + rounding))
            throw Error(fmt::format("has the uv ({}, {}): all of them must be in the map, from 0 to 1", uv.x, uv.y));
    }
}

}  // namespace

BakePlace place_at(const Mesh& mesh, size_t triangle, const glm::dvec3& weights) {
    BakePlace place;
    for (size_t corner = 0; corner < 3; ++corner) {
        const Vertex& vertex = mesh.vertices[mesh.indices[triangle * 3 + corner]];
        const double weight = weights[int(corner)];
        place.position += weight * glm::dvec3(vertex.position), place.normal += weight * glm::dvec3(vertex.normal);
        place.tangent += weight * glm::dvec4(vertex.tangent), place.uv += weight * glm::dvec2(vertex.uv);
    }
    return place;
}

std::vector<BakePlace> texel_places(const Mesh& mesh, glm::ivec2 size) { return texel_places(mesh, size, 0, size.y); }

std::vector<BakePlace> texel_places(const Mesh& mesh, glm::ivec2 size, int first_row, int rows) {
    std::vector<BakePlace> places(size_t(size.x) * size_t(rows));
    // The same rows, counted from below as v is.
    const int low_row = size.y - first_row - rows, high_row = size.y - first_row;
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
        const glm::ivec2 begin = glm::max(glm::ivec2(low), glm::ivec2(0, low_row)),
                         end = glm::min(glm::ivec2(high) + 1, glm::ivec2(size.x, high_row));
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
                BakePlace& place = places[size_t(high_row - 1 - y) * size_t(size.x) + size_t(x)];
                const double cover = place.cover + 1;
                place = place_at(mesh, triangle, weights), place.cover = cover;
            }
    }
    return places;
}

std::optional<BakeHit> nearest_hit(const TriangleTree& fine_tree, const Mesh& fine, const BakePlace& place,
                                   double reach) {
    const glm::dvec3 outwards = glm::normalize(place.normal);
    std::optional<MeshHit> best;
    each_hit(fine_tree, fine, {place.position + reach * outwards, -outwards}, 2 * reach, [&](const MeshHit& hit) {
        if (hit.is_front && (!best || std::abs(reach - hit.t) < std::abs(reach - best->t))) best = hit;
    });
    if (!best) return {};
    return BakeHit{reach - best->t, normal_at(fine, *best)};
}

BakedMap bake(const Mesh& fine, const Mesh& coarse, const BakeOptions& options) {
    check_uv(coarse);
    const int width = options.size.x, height = options.size.y;
    const int channels = options.store == BakeStore::heights ? 1 : 3;
    const TriangleTree tree = build_tree(fine);
    BakedMap map{.values = Image(width, height, channels)};
    std::vector<uint8_t> states(map.values.pixel_count(), empty);
    // Places take 13 doubles a texel, so a part has about a hundred thousand of them.
    const int rows_of_part = std::clamp(100'000 / width, 1, height), parts = (height - 1) / rows_of_part + 1;
    for (int part = 0; part < parts; ++part) {
        if (options.before_part) options.before_part(part, parts);
        const int first_row = part * rows_of_part, rows = std::min(rows_of_part, height - first_row);
        const std::vector<BakePlace> places = texel_places(coarse, options.size, first_row, rows);
        std::vector<std::optional<BakeHit>> hits(places.size());
        parallel_each(size_t(rows), 0, [&](size_t row) {
            for (size_t i = row * size_t(width); i < (row + 1) * size_t(width); ++i)
                if (places[i].cover > 0 && has_direction(places[i].normal))
                    hits[i] = nearest_hit(tree, fine, places[i], options.reach);
        });
        for (size_t i = 0; i < places.size(); ++i) {
            const BakePlace& place = places[i];
            if (place.cover == 0) continue;
            const size_t texel = size_t(first_row) * size_t(width) + i;
            states[texel] = full;
            ++(hits[i] ? map.hit : map.missed);
            map.covered_twice += place.cover > 1;
            if (hits[i]) map.largest_distance = std::max(map.largest_distance, std::abs(hits[i]->height));
            float* const value = map.values.values.data() + texel * size_t(channels);
            if (options.store == BakeStore::heights) {
                *value = hits[i] ? float(hits[i]->height) : 0;
                continue;
            }
            glm::dvec3 normal = hits[i] ? hits[i]->normal : glm::normalize(place.normal);
            if (options.store == BakeStore::tangent)
                normal = to_interpolated_frame(normal, place.normal, place.tangent);
            if (!has_direction(normal)) normal = {0, 0, 1};
            for (int c = 0; c < 3; ++c) value[c] = float(normal[c]);
        }
    }
    if (map.hit + map.missed == 0) throw Error("covers no texel of the map: its uv have no area");
    map.filled = fill(map.values, states);
    return map;
}

}  // namespace relief
