#include "framework/staff/reference/tangent_groups.h"

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

uint32_t root_of(Corners corners, uint32_t i) {
    while (corners[i].group != i) i = corners[i].group = corners[corners[i].group].group;
    return i;
}

}  // namespace

void gather_corners(const Mesh& mesh, const Buffer<uint32_t>& vertex_of, const Buffer<TangentFace>& faces,
                    std::span<const uint32_t> list, std::vector<CornerAtVertex>& corners) {
    corners.clear();
    for (const uint32_t corner : list) {
        const uint32_t first = corner / 3 * 3, k = corner % 3;
        const auto at = [&](uint32_t i) { return vertex_of[mesh.indices[first + i]]; };
        corners.push_back(
            {&faces[corner / 3], at(k == 2 ? 0 : k + 1), at(k == 0 ? 2 : k - 1), uint32_t(corners.size())});
    }
}

bool is_closed_fan(std::span<const CornerAtVertex> corners) {
    const size_t count = corners.size();
    if (count > 16) return false;
    for (size_t at = 0, seen = 1; seen <= count; ++seen) {
        const uint32_t edge = corners[at].next;
        for (at = 0; at < count && corners[at].previous != edge;) ++at;
        if (at == count) return false;
        if (at == 0) return seen == count;
    }
    return false;
}

void group_corners(Corners corners, std::vector<uint64_t>& scratch) {
    for_each_shared_edge(corners, scratch, [&](size_t i, size_t j) {
        const int8_t handedness = corners[i].face->handedness;
        if (handedness == 0 || handedness != corners[j].face->handedness) return;
        const uint32_t a = root_of(corners, uint32_t(i)), b = root_of(corners, uint32_t(j));
        corners[std::max(a, b)].group = std::min(a, b);
    });
    for (size_t i = 0; i < corners.size(); ++i) corners[i].group = root_of(corners, uint32_t(i));
}

void take_on_handedness(const Mesh& mesh, const Buffer<uint32_t>& vertex_of, const CornerLists& lists,
                        Buffer<TangentFace>& faces) {
    std::vector<bool> undecided(faces.size());
    for (size_t i = 0; i < faces.size(); ++i) undecided[i] = faces[i].handedness == 0 && !faces[i].in_no_group;

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
        if (std::none_of(list.begin(), list.end(), [&](uint32_t at) { return faces[at / 3].handedness != 0; }))
            continue;
        gather_corners(mesh, vertex_of, faces, list, corners);
        for_each_shared_edge(Corners(corners), scratch, [&](size_t a, size_t b) {
            if (corners[a].face->in_no_group || corners[b].face->in_no_group) return;
            links.emplace_back(list[a], list[b]), links.emplace_back(list[b], list[a]);
        });
    }
    std::sort(links.begin(), links.end());

    std::vector<bool> grouped(mesh.indices.size());
    std::vector<uint32_t> ahead;
    for (const auto& link : links) {
        if (undecided[link.first / 3] || grouped[link.first]) continue;
        const int8_t handedness = faces[link.first / 3].handedness;
        grouped[link.first] = true;
        for (ahead = {link.first}; !ahead.empty();) {
            const uint32_t from = ahead.back();
            ahead.pop_back();
            for (auto at = std::lower_bound(links.begin(), links.end(), std::pair(from, 0u));
                 at != links.end() && at->first == from; ++at) {
                int8_t& theirs = faces[at->second / 3].handedness;
                if (theirs == 0) theirs = handedness;
                if (theirs != handedness || grouped[at->second]) continue;
                grouped[at->second] = true;
                ahead.push_back(at->second);
            }
        }
    }
}

}  // namespace relief
