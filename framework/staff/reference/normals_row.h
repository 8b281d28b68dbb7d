// The inner loop of normals_from_heights: one row, eight texels at a time.
#pragma once

#include "framework/staff/reference/normals.h"

namespace relief {

/// Rows of heights around the one whose normals are wanted. `u` and `v` weigh the difference of the next neighbours,
/// `u_side` and `v_side` those of the rows beside, or of the neighbours after the next.
struct HeightRows {
    const float *up2, *up, *here, *down, *down2;
    float u, v, u_side, v_side;
};

/// Writes 0.5 n + 0.5 of texels `begin` to `end`, at least normals_row_lanes of them, to `result`, three floats each;
/// reads two texels beyond both ends. `uncached`: past the caches, for results that are too large to stay there. False
/// when a slope is not a number or beyond 1e18: then nothing of that row is to be believed. Not for
/// SlopeFilter::spline.
bool normals_of_row(SlopeFilter filter, const HeightRows& rows, int begin, int end, float* result, bool uncached);
constexpr int normals_row_lanes = 8;

/// One texel, of any slopes: one that is not a number counts as 0, and beyond 1e18 as that.
void normal_of_slope(float du, float dv, float* result);

}  // namespace relief
