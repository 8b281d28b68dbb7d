#include "framework/library/mesh/patches.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <optional>

#include "framework/core/base/error.h"
#include "framework/library/mesh/corners.h"
#include "framework/library/mesh/frame.h"

namespace relief {
namespace {

/// Rounds coordinates that are negligible against the mesh's extent to 0. So a sphere's pole is one place, and -0
/// equals 0.
Mesh snapped(Mesh mesh) {
    double extent = 0;
    for (const Vertex& vertex : mesh.vertices)
        for (int i = 0; i < 3; ++i)
            if (std::isfinite(vertex.position[i])) extent = std::max(extent, std::abs(double(vertex.position[i])));
    for (Vertex& vertex : mesh.vertices)
        for (int i = 0; i < 3; ++i)
            if (std::abs(double(vertex.position[i])) <= 1e-12 * extent) vertex.position[i] = 0;
    return mesh;
}

/// Returns whether a quad is convex, seen along the mean normal of the two triangles at its diagonal from corner 1 to
/// 3. They may be folded by at most 60 degrees. A triangle without area fits any other.
bool is_convex(const std::array<glm::dvec3, 4>& quad) {
    std::array<glm::dvec3, 4> sides;
    double size = 0;
    for (size_t i = 0; i < 4; ++i) {
        sides[i] = quad[(i + 1) % 4] - quad[i];
        size = std::max(size, glm::dot(sides[i], sides[i]));
    }
    const double slack = 1e-6 * size;  // corners are rounded to floats
    const glm::dvec3 one = glm::cross(sides[3], sides[0]), two = glm::cross(sides[1], sides[2]), mean = one + two;
    if (!(glm::dot(one, two) >= 0.5 * glm::length(one) * glm::length(two) - slack * size)) return false;
    for (size_t i = 0; i < 4; ++i)
        if (!(glm::dot(glm::cross(sides[(i + 3) % 4], sides[i]), mean) >= -slack * glm::length(mean))) return false;
    return true;
}

/// Returns whether two corners coincide. Such a triangle is invisible, but would become a fin if the heights between
/// the uv of these corners displaced it.
bool is_slit(const Mesh& mesh, const uint32_t* triangle) {
    const glm::vec3 &a = mesh.vertices[triangle[0]].position, &b = mesh.vertices[triangle[1]].position,
                    &c = mesh.vertices[triangle[2]].position;
    return a == b || b == c || c == a;
}

/// Returns the quad of two triangles, from the first corner of the first on, or nothing. Vertex i counts as vertex
/// same[i].
std::optional<std::array<uint32_t, 4>> joined(const Mesh& mesh, const Buffer<uint32_t>& same,
                                              const uint32_t* triangles) {
    const std::array<uint32_t, 3> one = {triangles[0], triangles[1], triangles[2]};
    const std::array<uint32_t, 3> two = {triangles[3], triangles[4], triangles[5]};
    for (size_t i = 0; i < 3; ++i)
        for (size_t k = 0; k < 3; ++k) {
            const uint32_t here = one[i], there = one[(i + 1) % 3];
            if (same[here] == same[there] || same[here] != same[two[(k + 1) % 3]] || same[there] != same[two[k]])
                continue;
            std::array<uint32_t, 4> quad = {one[(i + 2) % 3], here, two[(k + 2) % 3], there};
            std::array<glm::dvec3, 4> positions;
            for (size_t m = 0; m < 4; ++m) positions[m] = mesh.vertices[quad[m]].position;
            if (!is_convex(positions)) continue;
            // The quad starts opposite the shared edge.
            std::rotate(quad.begin(), quad.begin() + (i == 0 ? 1 : i == 1 ? 0 : 3), quad.end());
            return quad;
        }
    return {};
}

/// Returns four indices per pair of consecutive triangles, or nothing if a pair does not form a quad. Drops degenerate
/// quads.
std::optional<std::vector<uint32_t>> paired(const Mesh& mesh) {
    if (mesh.indices.size() % 6 != 0) return {};
    const Buffer<uint32_t> same = welded_vertices(mesh);
    std::vector<uint32_t> quads;
    quads.reserve(mesh.indices.size() / 6 * 4);
    for (size_t i = 0; i < mesh.indices.size(); i += 6) {
        const auto quad = joined(mesh, same, &mesh.indices[i]);
        if (!quad) return {};
        if (is_slit(mesh, &mesh.indices[i]) && is_slit(mesh, &mesh.indices[i + 3])) continue;
        quads.insert(quads.end(), quad->begin(), quad->end());
    }
    return quads;
}

/// Returns the mean of vertices. For two vertices, the order does not change the bits, because a sum of two commutes.
Vertex middle(std::initializer_list<const Vertex*> vertices) {
    glm::dvec3 position(0), normal(0), tangent(0);
    glm::dvec2 uv(0);
    for (const Vertex* vertex : vertices) {
        position += glm::dvec3(vertex->position), uv += glm::dvec2(vertex->uv);
        normal += glm::dvec3(vertex->normal), tangent += glm::dvec3(vertex->tangent);
    }
    const double count = double(vertices.size());
    const Vertex& first = **vertices.begin();
    const auto unit = [](const glm::dvec3& v, const glm::dvec3& otherwise) {
        const double length = glm::length(v);
        return length > 1e-6 ? v / length : otherwise;
    };
    normal = unit(normal, glm::dvec3(first.normal));
    tangent = unit(tangent - normal * glm::dot(normal, tangent), any_perpendicular(normal));
    return {.position = position / count,
            .normal = normal,
            .tangent = glm::dvec4(tangent, first.tangent.w),
            .uv = uv / count};
}

/// Cuts each triangle into three quads, which meet in its centre.
Mesh split(const Mesh& mesh) {
    Mesh result{.vertices = mesh.vertices, .indices = {}};
    result.vertices.reserve(mesh.vertices.size() + mesh.indices.size() / 3 * 4);
    result.indices.reserve(mesh.indices.size() * 4);
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const uint32_t *const triangle = &mesh.indices[i], first = uint32_t(result.vertices.size());
        const Vertex *a = &mesh.vertices[triangle[0]], *b = &mesh.vertices[triangle[1]],
                     *c = &mesh.vertices[triangle[2]];
        result.vertices.insert(result.vertices.end(),
                               {middle({a, b}), middle({b, c}), middle({c, a}), middle({a, b, c})});
        const uint32_t ab = first, bc = first + 1, ca = first + 2, centre = first + 3;
        result.indices.insert(result.indices.end(),
                              {triangle[0], ab, centre, ca, triangle[1], bc, centre, ab, triangle[2], ca, centre, bc});
    }
    return result;
}

/// Cuts the mesh into `corners` indices per patch.
Mesh cut(Mesh mesh, int corners) {
    if (corners == 4)
        if (auto quads = paired(mesh)) {
            mesh.indices = std::move(*quads);
            return mesh;
        }
    size_t kept = 0;
    for (size_t i = 0; i < mesh.indices.size(); i += 3)
        if (!is_slit(mesh, &mesh.indices[i])) {
            std::copy_n(&mesh.indices[i], 3, &mesh.indices[kept]);
            kept += 3;
        }
    mesh.indices.resize(kept);
    return corners == 3 ? mesh : split(mesh);
}

/// The patches' corners, and the places where they meet.
struct Meeting {
    std::vector<PatchCorner>& points;
    const Buffer<uint32_t>& place;  ///< of each corner
    size_t places, corners;

    /// Returns the corner of the same patch that is `steps` further on.
    size_t after(size_t corner, size_t steps = 1) const {
        const size_t first = corner - corner % corners;
        return first + (corner - first + steps) % corners;
    }
};

/// Returns the patch's angle at a corner. The last of several coincident corners has the angle; the others have 0.
double angle_at(const Meeting& meeting, size_t corner) {
    const auto is_here = [&](size_t other) { return meeting.place[other] == meeting.place[corner]; };
    const size_t next = meeting.after(corner);
    if (is_here(next)) return 0;
    size_t steps = meeting.corners - 1;
    while (is_here(meeting.after(corner, steps))) --steps;
    const size_t before = meeting.after(corner, steps);
    const glm::dvec3 here(meeting.points[corner].vertex.position);
    const glm::dvec3 leaving = glm::dvec3(meeting.points[next].vertex.position) - here;
    const glm::dvec3 arriving = glm::dvec3(meeting.points[before].vertex.position) - here;
    const double angle = std::atan2(glm::length(glm::cross(leaving, arriving)), glm::dot(leaving, arriving));
    return angle > 0 ? angle : 0;  // 0 for NaN, too
}

/// Sets one direction and one uv for each place.
void share_places(const Meeting& meeting) {
    struct Place {
        const Vertex* owner = nullptr;
        glm::dvec3 normals{0};
        double weight = 0;
        bool is_smooth = true;
    };
    std::vector<Place> places(meeting.places);
    for (size_t i = 0; i < meeting.points.size(); ++i) {
        Place& here = places[meeting.place[i]];
        const Vertex& vertex = meeting.points[i].vertex;
        if (!here.owner) here.owner = &vertex;
        const double angle = angle_at(meeting, i);
        here.normals += angle * glm::dvec3(vertex.normal), here.weight += angle;
        here.is_smooth = here.is_smooth && vertex.normal == here.owner->normal;
    }
    for (size_t i = 0; i < meeting.points.size(); ++i) {
        const Place& here = places[meeting.place[i]];
        PatchCorner& point = meeting.points[i];
        point.height_uv = here.owner->uv;
        const double length = glm::length(here.normals);
        if (here.is_smooth)
            point.direction = here.owner->normal;  // a mean would be rounded
        else
            point.direction = length > 1e-6 * here.weight ? glm::vec3(here.normals / length) : point.vertex.normal;
    }
}

/// Sets the uv of each edge to its owner's, and the spacing of each place. `corners` lists the corners in each place.
/// Returns whether the mesh is closed.
bool share_edges(const Meeting& meeting, const CornerLists& corners) {
    std::vector<PatchCorner>& points = meeting.points;
    for (size_t i = 0; i < points.size(); ++i)  // a side without length keeps this
        points[i].edge_uv = {points[i].height_uv, points[i].height_uv};

    struct Lengths {
        glm::dvec2 sum{0};
        double count = 0;
    };
    std::vector<Lengths> lengths(meeting.places);
    bool is_closed = true;
    struct Edge {
        uint32_t other;  ///< the place at its other end
        uint32_t from;   ///< the corner where it begins
        auto operator<=>(const Edge&) const = default;
    };
    std::vector<Edge> edges;  // of one place; after sorting, uses of the same edge are adjacent
    for (uint32_t place = 0; place < meeting.places; ++place) {
        edges.clear();
        for (const uint32_t corner : corners.at(place)) {
            const size_t next = meeting.after(corner), before = meeting.after(corner, meeting.corners - 1);
            if (meeting.place[next] > place) edges.push_back({meeting.place[next], corner});
            if (meeting.place[before] > place) edges.push_back({meeting.place[before], uint32_t(before)});
        }
        std::sort(edges.begin(), edges.end());
        for (size_t begin = 0, end; begin < edges.size(); begin = end) {
            for (end = begin; end < edges.size() && edges[end].other == edges[begin].other;) ++end;
            const uint32_t owner = edges[begin].from;
            const Vertex &here = points[owner].vertex, &there = points[meeting.after(owner)].vertex;
            const auto is_along = [&](const Edge& edge) { return meeting.place[edge.from] == meeting.place[owner]; };
            for (size_t i = begin; i < end; ++i)
                points[edges[i].from].edge_uv =
                    is_along(edges[i]) ? glm::vec4(here.uv, there.uv) : glm::vec4(there.uv, here.uv);

            const glm::dvec2 length(glm::distance(glm::dvec3(here.position), glm::dvec3(there.position)),
                                    glm::distance(glm::dvec2(here.uv), glm::dvec2(there.uv)));
            if (std::isfinite(length.x) && std::isfinite(length.y))
                for (const uint32_t corner : {owner, uint32_t(meeting.after(owner))}) {
                    Lengths& at = lengths[meeting.place[corner]];
                    at.sum += length, ++at.count;
                }

            is_closed = is_closed && end - begin == 2 && !is_along(edges[begin + 1]);
        }
    }
    for (size_t i = 0; i < points.size(); ++i) {
        const Lengths& at = lengths[meeting.place[i]];
        points[i].spacing = at.sum / std::max(at.count, 1.0);
    }
    return is_closed;
}

/// Returns for each vertex the first one with the same position.
Buffer<uint32_t> places_of(const Mesh& mesh) {
    Mesh positions;
    positions.vertices.reserve(mesh.vertices.size());
    for (const Vertex& vertex : mesh.vertices)
        positions.vertices.push_back({.position = vertex.position, .normal = {}, .tangent = {}, .uv = {}});
    return welded_vertices(positions);
}

}  // namespace

PatchMesh make_patches(const Mesh& mesh, int corners) {
    check_indices(mesh);
    if (corners != 3 && corners != 4) throw Error(fmt::format("a patch has 3 or 4 corners, not {}", corners));
    const Mesh pieces = cut(snapped(mesh), corners);
    const Buffer<uint32_t> place_of = places_of(pieces);

    PatchMesh patches{.corners = corners, .points = std::vector<PatchCorner>(pieces.indices.size())};
    Buffer<uint32_t> place(pieces.indices.size());
    for (size_t i = 0; i < place.size(); ++i) {
        patches.points[i].vertex = pieces.vertices[pieces.indices[i]];
        place[i] = place_of[pieces.indices[i]];
    }
    const Meeting meeting{patches.points, place, pieces.vertices.size(), size_t(corners)};
    share_places(meeting);
    patches.is_closed = share_edges(meeting, CornerLists(pieces, place_of, 1));
    return patches;
}

}  // namespace relief
