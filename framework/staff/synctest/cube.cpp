#include "framework/staff/synctest/cube.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "framework/core/base/parallel.h"
#include "framework/core/image/color.h"
#include "framework/library/mesh/shapes.h"
#include "framework/staff/reference/mesh_rays.h"
#include "framework/staff/reference/tangent_space.h"

namespace relief::synctest {
namespace {

/// Faces in the order of their squares on the map: +x, +y, +z, -x, -y, -z.
const CubeFace& face_on_map(uint32_t f) { return cube_face(int(f < 3 ? 2 * f : 2 * f - 5)); }
// Squares of side 4 / 16 with gaps of 1 / 16: all borders lie between texels.
constexpr double square = 4.0 / 16, gap = 1.0 / 16;

glm::dvec2 corner_of(size_t face) {
    return {gap + double(face % 3) * (square + gap), gap + double(face / 3) * (square + gap)};
}

/// The values interpolated at a point.
struct Place {
    glm::dvec3 normal{}, bitangent{};
    glm::dvec4 tangent{};
    glm::dvec2 uv{};
};

Place place_at(const Mesh& mesh, size_t triangle, const glm::dvec3& weights) {
    Place place;
    for (size_t corner = 0; corner < 3; ++corner) {
        const Vertex& vertex = mesh.vertices[mesh.indices[3 * triangle + corner]];
        const glm::dvec3 normal(vertex.normal);
        const glm::dvec4 tangent(vertex.tangent);
        const double weight = weights[int(corner)];
        place.normal += weight * normal, place.tangent += weight * tangent;
        place.bitangent += weight * tangent.w * glm::cross(normal, glm::dvec3(tangent));
        place.uv += weight * glm::dvec2(vertex.uv);
    }
    return place;
}

/// Returns the values at a point of a face, with coordinates in [0, 1]. The diagonal runs from (0, 0) to (1, 1).
Place place_on(const Mesh& mesh, size_t face, const glm::dvec2& at) {
    return at.x >= at.y ? place_at(mesh, 2 * face, {1 - at.x, at.x - at.y, at.y})
                        : place_at(mesh, 2 * face + 1, {1 - at.y, at.x, at.y - at.x});
}

/// Returns three channels at level 0 with linear filtering; coordinates are clamped to the border.
glm::dvec3 texel_at(const Image& map, const glm::dvec2& uv, bool as_srgb) {
    const double x = uv.x * map.width - 0.5, y = (1 - uv.y) * map.height - 0.5;
    const int left = int(std::floor(x)), top = int(std::floor(y));
    glm::dvec3 sum(0);
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i) {
            const float* const texel =
                map.pixel(std::clamp(left + i, 0, map.width - 1), std::clamp(top + j, 0, map.height - 1));
            const double weight = (i ? x - left : 1 - (x - left)) * (j ? y - top : 1 - (y - top));
            for (int c = 0; c < 3; ++c) sum[c] += weight * (as_srgb ? linear_from_srgb(texel[c]) : double(texel[c]));
        }
    return sum;
}

glm::dmat3 frame_of(SyncFrame frame, const Place& place) {
    switch (frame) {
        case SyncFrame::interpolated:
            break;
        case SyncFrame::each_unit:
            return interpolated_frame(glm::normalize(place.normal),
                                      glm::dvec4(glm::normalize(glm::dvec3(place.tangent)), place.tangent.w));
        case SyncFrame::gram_schmidt:
            return tangent_frame(place.normal, place.tangent);
        case SyncFrame::vertex_bitangent:
            return {glm::dvec3(place.tangent), place.bitangent, place.normal};
    }
    return interpolated_frame(place.normal, place.tangent);
}

glm::dvec3 shown(const SyncRenderer& renderer, const Place& place, const Image& map) {
    if (renderer.slip == SyncSlip::no_map) return glm::normalize(place.normal);
    glm::dvec3 stored = 2.0 * texel_at(map, place.uv, renderer.slip == SyncSlip::srgb_map) - 1.0;
    if (renderer.slip == SyncSlip::green_turned) stored.y = -stored.y;
    return glm::normalize(frame_of(renderer.frame, place) * stored);
}

}  // namespace

Mesh make_synctest_cube(bool other_diagonal) {
    Mesh mesh;
    for (uint32_t f = 0; f < 6; ++f) {
        const CubeFace& face = face_on_map(f);
        const glm::vec3 out(face.normal), u(face.right), v(face.up);
        for (const glm::vec2 at : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)}) {
            const glm::vec3 direction = out + (2 * at.x - 1) * u + (2 * at.y - 1) * v;
            const glm::vec3 normal = glm::normalize(direction);
            const glm::vec3 tangent = glm::normalize(u - glm::dot(u, normal) * normal);
            mesh.vertices.push_back(
                {0.5f * direction, normal, glm::vec4(tangent, 1), glm::vec2(corner_of(f) + square * glm::dvec2(at))});
        }
        const uint32_t a = 4 * f, b = a + 1, c = a + 2, d = a + 3;
        if (other_diagonal)
            mesh.indices.insert(mesh.indices.end(), {a, b, d, b, c, d});
        else
            mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
    }
    return mesh;
}

Image bake_synctest_map(int size, int bits) {
    const Mesh mesh = make_synctest_cube();
    const float largest = bits == 16 ? 65535 : 255;
    Image map(size, size, 3, bits);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const glm::dvec2 uv((x + 0.5) / size, 1 - (y + 0.5) / size);
            // The squares on both sides share a gap. The outer border belongs to the last squares.
            const auto cell = [](double at, int count) {
                return std::clamp(int((at - gap / 2) / (square + gap)), 0, count - 1);
            };
            const size_t face = size_t(3 * cell(uv.y, 2) + cell(uv.x, 3));
            const glm::dvec2 at = glm::clamp((uv - corner_of(face)) / square, 0.0, 1.0);
            const Place place = place_on(mesh, face, at);
            const glm::dvec3 n = to_interpolated_frame(face_on_map(uint32_t(face)).normal, place.normal, place.tangent);
            for (int c = 0; c < 3; ++c) {
                const float value = float(0.5 * n[c] + 0.5);
                map.pixel(x, y)[c] = bits == 32 ? value : std::round(value * largest) / largest;
            }
        }
    return map;
}

std::string SyncRenderer::text() const {
    if (slip == SyncSlip::no_map) return "no normal map";
    static constexpr std::array frames = {"as interpolated", "each column made unit", "Gram-Schmidt at each pixel",
                                          "the bitangent interpolated from the vertices"};
    static constexpr std::array slips = {"", ", quads cut along the other diagonal", ", green turned around",
                                         ", the map decoded as sRGB"};
    return std::string(frames[size_t(frame)]) + slips[size_t(slip)];
}

std::vector<SyncRenderer> sync_renderers() {
    std::vector<SyncRenderer> all;
    for (const SyncSlip slip : {SyncSlip::none, SyncSlip::other_diagonal, SyncSlip::green_turned, SyncSlip::srgb_map})
        for (const SyncFrame frame :
             {SyncFrame::interpolated, SyncFrame::each_unit, SyncFrame::gram_schmidt, SyncFrame::vertex_bitangent})
            all.push_back({frame, slip});
    all.push_back({SyncFrame::interpolated, SyncSlip::no_map});
    return all;
}

Image render_synctest(const SyncRenderer& renderer, const Image& map, int width, int height, int step) {
    const Mesh mesh = make_synctest_cube(renderer.slip == SyncSlip::other_diagonal);
    const TriangleTree tree = build_tree(mesh);
    const Camera camera(synctest_camera, double(width) / height);
    Image normals((width + step - 1) / step, (height + step - 1) / step, 3);
    parallel_pieces(size_t(normals.height), 1, 0, [&](size_t begin, size_t end) {
        for (int y = int(begin); y < int(end); ++y)
            for (int x = 0; x < normals.width; ++x) {
                const Ray ray = camera.ray({(2 * x * step + 1.0) / width - 1, 1 - (2 * y * step + 1.0) / height});
                const auto hit = first_hit(tree, mesh, ray, 1e9);
                const glm::dvec3 n =
                    hit ? shown(renderer, place_at(mesh, hit->triangle, hit->weights), map) : glm::dvec3(no_surface);
                for (int c = 0; c < 3; ++c) normals.pixel(x, y)[c] = float(n[c]);
            }
    });
    return normals;
}

}  // namespace relief::synctest
