// Slopes along lines of heights: borders, the cubic spline, levels of detail.
#pragma once

#include <array>
#include <vector>

#include "framework/image/image.h"

namespace relief {

/// How the slope dh/du of a row of heights is taken at a texel; along v likewise. On a clean height map, the mean error
/// of the normal at 8 texels a wavelength and slopes up to 1 stands beside it, in degrees; noise is what the slope's
/// rms is per unit rms of the heights' (rounding to 8 bits is noise).
enum class SlopeFilter {
    forward,       ///< h(+1) - h(0); first order, and shifts the relief by half a texel; noise 1.41
    central,       ///< (h(+1) - h(-1)) / 2; second order; 1.83 degrees, noise 0.71
    sobel,         ///< central, smoothed across by (1 2 1) / 4; 2.61 degrees, noise 0.43
    scharr,        ///< central, smoothed across by (3 10 3) / 16: keeps directions; 2.39 degrees, noise 0.48
    fourth_order,  ///< (8 (h(+1) - h(-1)) - (h(+2) - h(-2))) / 12; 0.18 degrees, noise 0.95
    spline         ///< of the cubic spline through all heights, m(-1) + 4 m + m(+1) = 3 (h(+1) - h(-1)); 0.034 degrees
};

struct NormalOptions {
    /// A height of 1, in texels along u and along v (they differ where texels are not square).
    double texels_u = 1;
    double texels_v = 1;
    SlopeFilter filter = SlopeFilter::central;
    /// Beyond the border: the other side (a tile), or nothing. Then slopes at the border are one-sided and of the
    /// filter's order where the map has enough texels, and smoothing across repeats the border.
    bool wrap = true;
    /// How strong each level of detail is, from the finest: level k is what changes over about 2^k texels (the
    /// difference of two smoothings by the cubic B-spline, as in an undecimated wavelet transform); what is coarser
    /// than all of them keeps its strength. Empty, or all 1, changes nothing.
    std::vector<double> level_strengths = {};
};

/// An index beyond a line of `count`, brought back: around, or to the border.
int inside(int index, int count, bool wrap);

/// A slope is a sum of weighted differences: of equal heights it is 0 exactly.
struct SlopeDifference {
    int plus = 0, minus = 0;  ///< indices in the line
    double weight = 0;
};
struct SlopeDifferences {
    std::array<SlopeDifference, 4> values;
    int count = 0;
    const SlopeDifference* begin() const { return values.data(); }
    const SlopeDifference* end() const { return values.data() + count; }
};

/// Of element `i` of a line of `count`, without smoothing across. Without wrap, central differences (and what is built
/// on them) become (-3 h0 + 4 h1 - h2) / 2 at a border, the fourth order its own one-sided forms (Fornberg 1988), as
/// far as the line is long enough; `forward` looks back at the last element. The spline's row gives what its end slopes
/// are.
SlopeDifferences slope_differences(SlopeFilter filter, int i, int count, bool wrap);

/// The slope of a line is smoothed across: each of the two lines beside it has this weight, itself the rest.
double weight_beside(SlopeFilter filter);

constexpr int spline_lanes = 16;

/// The slopes of the cubic splines through several lines at once. They solve m(i-1) + 4 m(i) + m(i+1) =
/// 3 (h(i+1) - h(i-1)), around the line when it wraps, else with end slopes of the fourth order.
class SplineLines {
public:
    SplineLines(int count, bool wrap);
    /// Element `i` of `lanes` lines, whose heights lie `stride` apart.
    void set(int i, const float* heights, size_t stride, int lanes);
    void solve();
    double slope(int i, int lane) const { return values_[size_t(i)][size_t(lane)]; }

private:
    using Lanes = std::array<double, spline_lanes>;
    void solve_around();
    void solve_between_ends();

    bool wrap_;
    std::vector<Lanes> values_, work_;
    std::vector<double> factors_;
};

/// The height map with each level of detail as strong as `strengths` says, see NormalOptions.
Image with_level_strengths(const Image& heights, const std::vector<double>& strengths, bool wrap, unsigned threads);

}  // namespace relief
