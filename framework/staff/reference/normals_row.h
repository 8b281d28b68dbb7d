// The inner loop of normals_from_heights(): one row, eight texels at a time.
#pragma once

#include "framework/staff/reference/normals.h"

namespace relief {

/// The row of heights whose normals are computed (`here`), and its neighbours. `u` and `v` weight the difference of the
/// direct neighbours. `u_side` and `v_side` weight the adjacent rows and columns, or for fourth_order the second
/// neighbours.
struct HeightRows {
    const float *up2, *up, *here, *down, *down2;
    float u, v, u_side, v_side;
};

/// Writes 0.5 n + 0.5 for texels `begin` to `end` to `result`, three floats per texel. There must be at least
/// normals_row_lanes texels. Reads two texels beyond both ends. `uncached` bypasses the caches, for results too large
/// for them. Returns false if a slope is NaN or beyond 1e18: compute the row by normal_of_slope() then. Not for
/// SlopeFilter::spline.
bool normals_of_row(SlopeFilter filter, const HeightRows& rows, int begin, int end, float* result, bool uncached);
constexpr int normals_row_lanes = 8;

/// Writes 0.5 n + 0.5 for one texel with any slopes. NaN counts as 0. Slopes beyond 1e18 are scaled down together, so
/// that the normal keeps its direction around the vertical.
void normal_of_slope(float du, float dv, float* result);

}  // namespace relief
