#include "framework/library/mesh/tangent_groups.h"

#include <algorithm>

namespace relief {
namespace {

using Corners = std::span<CornerAtVertex>;

/// Calls `visit(i, j)` for each shared edge: it leaves the vertex at corner i and arrives at corner j. Visits in
/// ascending order of i, then of j.
template <class Visit>
void for_each_shared_edge(Corners corners, std::vector<uint64_t>& scratch, Visit visit) {
    const size_t count = corners.size();
    if (count <= 16) {
        for (size_t i = 0; i < count; ++i)
            for (size_t j = 0; j < count; ++j)
                if (corners[i].next == corners[j].previous && i != j) visit(i, j);
        return;
    }
    scratch.clear();
    for (size_t j = 0; j < count; ++j) scratch.push_back(uint64_t(corners[j].previous) << 32 | j);
    std::sort(scratch.begin(), scratch.end());
    for (size_t i = 0; i < count; ++i) {
        const uint64_t wanted = uint64_t(corners[i].next) << 32;
        for (auto at = std::lower_bound(scratch.begin(), scratch.end(), wanted);
             at != scratch.end() && *at >> 32 == corners[i].next; ++at)
            if (const size_t j = *at & UINT32_MAX; i != j) visit(i, j);
    }
}

/// The other ends of a corner's two edges.
struct Edges {
    uint32_t next, previous;
};

Edges edges_at(const Mesh& mesh, const Buffer<uint32_t>& vertex_of, uint32_t corner) {
    const uint32_t k = corner % 3;
    return {vertex_of[mesh.indices[k == 2 ? corner - 2 : corner + 1]],
            vertex_of[mesh.indices[k == 0 ? corner + 2 : corner - 1]]};
}

uint32_t root_of(Corners corners, uint32_t i) {
    while (corners[i].group != i) i = corners[i].group = corners[corners[i].group].group;
    return i;
}

}  // namespace

void gather_corners(const Mesh& mesh, const Buffer<uint32_t>& vertex_of, const std::vector<Contribution>& contributions,
                    std::span<const uint32_t> list, std::vector<CornerAtVertex>& corners) {
    corners.clear();
    for (const uint32_t corner : list) {
        const Edges edges = edges_at(mesh, vertex_of, corner);
        corners.push_back({glm::vec3(contributions[corner]), face_of(contributions[corner]), edges.next, edges.previous,
                           uint32_t(corners.size())});
    }
}

bool is_closed_fan(const Mesh& mesh, const Buffer<uint32_t>& vertex_of, std::span<const uint32_t> list) {
    constexpr size_t most = 16;
    const size_t count = list.size();
    if (count > most) return false;
    Edges edges[most];
    for (size_t i = 0; i < count; ++i) edges[i] = edges_at(mesh, vertex_of, list[i]);
    for (size_t at = 0, seen = 1; seen <= count; ++seen) {
        const uint32_t edge = edges[at].next;
        for (at = 0; at < count && edges[at].previous != edge;) ++at;
        if (at == count) return false;
        if (at == 0) return seen == count;
    }
    return false;
}

void group_corners(Corners corners, std::vector<uint64_t>& scratch) {
    for_each_shared_edge(corners, scratch, [&](size_t i, size_t j) {
        const int8_t handedness = corners[i].face.handedness;
        if (handedness == 0 || handedness != corners[j].face.handedness) return;
        const uint32_t a = root_of(corners, uint32_t(i)), b = root_of(corners, uint32_t(j));
        corners[std::max(a, b)].group = std::min(a, b);
    });
    for (size_t i = 0; i < corners.size(); ++i) corners[i].group = root_of(corners, uint32_t(i));
}

void take_on_handedness(const Mesh& mesh, const Buffer<uint32_t>& vertex_of, const CornerLists& lists,
                        std::vector<Contribution>& contributions) {
    const size_t count = contributions.size() / 3;
    std::vector<bool> undecided(count);
    std::vector<int8_t> handedness_of(count);
    for (size_t i = 0; i < count; ++i) {
        const TangentFace face = face_of(contributions[3 * i]);
        handedness_of[i] = face.handedness;
        undecided[i] = face.handedness == 0 && !face.in_no_group;
    }

    // Pairs of corners that share an edge at a vertex, in both orders. Only vertices with triangles of both kinds can
    // pass on a handedness.
    std::vector<std::pair<uint32_t, uint32_t>> links;
    std::vector<bool> seen(mesh.vertices.size());
    std::vector<CornerAtVertex> corners;
    std::vector<uint64_t> scratch;
    for (size_t i = 0; i < mesh.indices.size(); ++i) {
        const uint32_t vertex = vertex_of[mesh.indices[i]];
        if (!undecided[i / 3] || seen[vertex]) continue;
        seen[vertex] = true;
        const std::span<const uint32_t> list = lists.at(vertex);
        if (std::none_of(list.begin(), list.end(), [&](uint32_t at) { return handedness_of[at / 3] != 0; })) continue;
        gather_corners(mesh, vertex_of, contributions, list, corners);
        for_each_shared_edge(Corners(corners), scratch, [&](size_t a, size_t b) {
            if (corners[a].face.in_no_group || corners[b].face.in_no_group) return;
            links.emplace_back(list[a], list[b]), links.emplace_back(list[b], list[a]);
        });
    }
    std::sort(links.begin(), links.end());

    std::vector<bool> grouped(mesh.indices.size());
    std::vector<uint32_t> ahead;
    for (const auto& link : links) {
        if (undecided[link.first / 3] || grouped[link.first]) continue;
        const int8_t handedness = handedness_of[link.first / 3];
        grouped[link.first] = true;
        for (ahead = {link.first}; !ahead.empty();) {
            const uint32_t from = ahead.back();
            ahead.pop_back();
            for (auto at = std::lower_bound(links.begin(), links.end(), std::pair(from, 0u));
                 at != links.end() && at->first == from; ++at) {
                int8_t& theirs = handedness_of[at->second / 3];
                if (theirs == 0) theirs = handedness;
                if (theirs != handedness || grouped[at->second]) continue;
                grouped[at->second] = true;
                ahead.push_back(at->second);
            }
        }
    }
    for (size_t i = 0; i < contributions.size(); ++i) {
        if (!undecided[i / 3]) continue;
        TangentFace face = face_of(contributions[i]);
        face.handedness = handedness_of[i / 3];
        contributions[i].w = bits_of(face);
    }
}

}  // namespace relief
