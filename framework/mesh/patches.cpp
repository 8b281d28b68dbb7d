#include "framework/mesh/patches.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <optional>

#include "framework/base/error.h"
#include "framework/mesh/corners.h"
#include "framework/mesh/frame.h"

namespace relief {
namespace {

/// So that a sphere's pole is one place, and 0 and -0 are: what is nothing beside the mesh's extent becomes 0.
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

/// Convex seen along the mean normal of the two triangles that it is along its diagonal from 1 to 3, which are folded
/// by no more than 60 degrees. A triangle without area fits any other.
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

/// The quad that two triangles are, from the first corner of the first; `same[i]` is the vertex that vertex i counts
/// as.
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
            // As quad, the first corner comes first when it is opposite the shared edge, else second or last.
            std::rotate(quad.begin(), quad.begin() + (i == 0 ? 1 : i == 1 ? 0 : 3), quad.end());
            return quad;
        }
    return {};
}

/// Four indices for each two triangles in a row; nothing where two do not make a quad.
std::optional<std::vector<uint32_t>> paired(const Mesh& mesh) {
    if (mesh.indices.size() % 6 != 0) return {};
    const Buffer<uint32_t> same = welded_vertices(mesh);
    std::vector<uint32_t> quads;
    quads.reserve(mesh.indices.size() / 6 * 4);
    for (size_t i = 0; i < mesh.indices.size(); i += 6) {
        const auto quad = joined(mesh, same, &mesh.indices[i]);
        if (!quad) return {};
        quads.insert(quads.end(), quad->begin(), quad->end());
    }
    return quads;
}

/// Of two vertices it is the same to the bit in either order: sums of two commute.
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

/// Each triangle as three quads, which meet in its middle.
Mesh split(const Mesh& mesh) {
    Mesh result;
    result.vertices.reserve(mesh.indices.size() / 3 * 7);
    result.indices.reserve(mesh.indices.size() * 4);
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vertex *a = &mesh.vertices[mesh.indices[i]], *b = &mesh.vertices[mesh.indices[i + 1]],
                     *c = &mesh.vertices[mesh.indices[i + 2]];
        const auto first = static_cast<uint32_t>(result.vertices.size());
        for (const Vertex& vertex : {*a, *b, *c, middle({a, b}), middle({b, c}), middle({c, a}), middle({a, b, c})})
            result.vertices.push_back(vertex);
        for (const uint32_t corner : {0, 3, 6, 5, 1, 4, 6, 3, 2, 5, 6, 4}) result.indices.push_back(first + corner);
    }
    return result;
}

/// The mesh with `corners` indices a patch.
Mesh cut(Mesh mesh, int corners) {
    if (corners == 3) return mesh;
    auto quads = paired(mesh);
    if (!quads) return split(mesh);
    mesh.indices = std::move(*quads);
    return mesh;
}

/// The patches' corners, and where they meet.
struct Meeting {
    std::vector<PatchCorner>& points;
    const Buffer<uint32_t>& place;  ///< of each corner
    size_t places, corners;

    /// The corner of the same patch so many steps on.
    size_t after(size_t corner, size_t steps = 1) const {
        const size_t first = corner - corner % corners;
        return first + (corner - first + steps) % corners;
    }
    size_t patch(size_t corner) const { return corner / corners; }
};

/// The angle of its patch at a corner. Where a side has no length the last of the corners that coincide has it.
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
    return angle > 0 ? angle : 0;  // nor does what is not a number count
}

/// One direction and one uv for each place.
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
            point.direction = here.owner->normal;  // a mean would round
        else
            point.direction = length > 1e-6 * here.weight ? glm::vec3(here.normals / length) : point.vertex.normal;
    }
}

/// One pair of uv for each edge, and what they say of the spacing in each place. Returns whether the mesh is closed.
bool share_edges(const Meeting& meeting) {
    struct Edge {
        uint64_t places;  ///< the lower one above: a key for both ways
        uint32_t from;    ///< the corner
        auto operator<=>(const Edge&) const = default;
    };
    std::vector<PatchCorner>& points = meeting.points;
    std::vector<Edge> edges;
    edges.reserve(points.size());
    for (size_t i = 0; i < points.size(); ++i) {
        const auto [low, high] = std::minmax({meeting.place[i], meeting.place[meeting.after(i)]});
        if (low == high)
            points[i].edge_uv = {points[i].height_uv, points[i].height_uv};
        else
            edges.push_back({uint64_t(low) << 32 | high, uint32_t(i)});
    }
    std::sort(edges.begin(), edges.end());

    struct Lengths {
        glm::dvec2 sum{0};
        double count = 0;
    };
    std::vector<Lengths> lengths(meeting.places);
    bool is_closed = true;
    for (size_t begin = 0, end; begin < edges.size(); begin = end) {
        for (end = begin; end < edges.size() && edges[end].places == edges[begin].places;) ++end;
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

        int along = 0, against = 0;
        for (size_t i = begin; i < end; ++i) {
            // A triangle with two corners in one place, as at a pole, runs there and back and closes nothing.
            const bool turns_back = i + 1 < end && meeting.patch(edges[i].from) == meeting.patch(edges[i + 1].from) &&
                                    is_along(edges[i]) != is_along(edges[i + 1]);
            if (turns_back)
                ++i;
            else
                ++(is_along(edges[i]) ? along : against);
        }
        is_closed = is_closed && along == against && along <= 1;
    }
    for (size_t i = 0; i < points.size(); ++i) {
        const Lengths& at = lengths[meeting.place[i]];
        points[i].spacing = at.sum / std::max(at.count, 1.0);
    }
    return is_closed;
}

}  // namespace

PatchMesh make_patches(const Mesh& mesh, int corners) {
    check_indices(mesh);
    if (corners != 3 && corners != 4) throw Error(fmt::format("a patch has 3 or 4 corners, not {}", corners));
    const Mesh pieces = cut(snapped(mesh), corners);

    // A vertex that is nothing but its position is the same as another when both are in one place.
    Mesh positions;
    positions.vertices.reserve(pieces.vertices.size());
    for (const Vertex& vertex : pieces.vertices)
        positions.vertices.push_back({.position = vertex.position, .normal = {}, .tangent = {}, .uv = {}});
    const Buffer<uint32_t> place_of = welded_vertices(positions);

    PatchMesh patches{.corners = corners, .points = std::vector<PatchCorner>(pieces.indices.size())};
    Buffer<uint32_t> place(pieces.indices.size());
    for (size_t i = 0; i < place.size(); ++i) {
        patches.points[i].vertex = pieces.vertices[pieces.indices[i]];
        place[i] = place_of[pieces.indices[i]];
    }
    const Meeting meeting{patches.points, place, pieces.vertices.size(), size_t(corners)};
    share_places(meeting);
    patches.is_closed = share_edges(meeting);
    return patches;
}

}  // namespace relief
