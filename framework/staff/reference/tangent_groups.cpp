#include "framework/staff/reference/tangent_groups.h"

#include <algorithm>

namespace relief {
namespace {

using Corners = std::span<CornerAtVertex>;

/// Calls `visit(i, j)` for corners i and j where the edge that leaves the vertex along i arrives along j: in rising
/// order of i, then of j.
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

/// Across the edge that leaves first, then across the one that arrives; what was taken on may be passed on.
void take_on_handedness(Corners corners, std::vector<uint64_t>& scratch) {
    for (bool changed = true; changed;) {
        changed = false;
        std::vector<int8_t> leaving(corners.size()), arriving(corners.size());
        for_each_shared_edge(corners, scratch, [&](size_t i, size_t j) {
            if (corners[i].face->in_no_group || corners[j].face->in_no_group) return;
            if (leaving[i] == 0) leaving[i] = corners[j].handedness;
            if (arriving[j] == 0) arriving[j] = corners[i].handedness;
        });
        for (size_t i = 0; i < corners.size(); ++i)
            if (corners[i].handedness == 0)
                if (const int8_t taken = leaving[i] ? leaving[i] : arriving[i]; taken != 0)
                    corners[i].handedness = taken, changed = true;
    }
}

}  // namespace

void group_corners(Corners corners, std::vector<uint64_t>& scratch) {
    bool undecided = false;
    for (size_t i = 0; i < corners.size(); ++i) {
        corners[i].group = uint32_t(i);
        corners[i].handedness = corners[i].face->in_no_group ? 0 : corners[i].face->handedness;
        undecided |= corners[i].handedness == 0 && !corners[i].face->in_no_group;
    }
    if (undecided) take_on_handedness(corners, scratch);
    for_each_shared_edge(corners, scratch, [&](size_t i, size_t j) {
        if (corners[i].handedness != corners[j].handedness || corners[i].handedness == 0) return;
        const uint32_t a = root_of(corners, uint32_t(i)), b = root_of(corners, uint32_t(j));
        corners[std::max(a, b)].group = std::min(a, b);
    });
    for (size_t i = 0; i < corners.size(); ++i) corners[i].group = root_of(corners, uint32_t(i));
}

}  // namespace relief
