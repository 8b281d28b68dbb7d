// The inner loop of normals_from_heights(): one row, eight texels at a time.
#pragma once

#include "framework/staff/reference/normals.h"

namespace relief {

/// The row of heights whose normals are computed (`here`), and its neighbours. `u` and `v` are the weights of the
/// difference of the next neighbours; `u_side` and `v_side` are the weights of the rows beside, or of the neighbours
/// after the next.
struct HeightRows {
    const float *up2, *up, *here, *down, *down2;
    float u, v, u_side, v_side;
};

/// Writes 0.5 n + 0.5 for texels `begin` to `end` to `result`, three floats per texel. There must be at least
/// normals_row_lanes texels. Reads two texels beyond both ends. `uncached`: writes past the caches, for results too
/// large for them. Returns false if a slope is NaN or beyond 1e18: the row must then be computed by normal_of_slope().
/// Not for SlopeFilter::spline.
bool normals_of_row(SlopeFilter filter, const HeightRows& rows, int begin, int end, float* result, bool uncached);
constexpr int normals_row_lanes = 8;

/// 0.5 n + 0.5 for one texel, with any slopes: NaN counts as 0; slopes beyond 1e18 are shortened to it together, so
/// that the normal keeps its direction.
void normal_of_slope(float du, float dv, float* result);

}  // namespace relief
