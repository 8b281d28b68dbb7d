// Slopes along lines of heights: borders, the cubic spline, levels of detail.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "framework/core/image/image.h"

namespace relief {

/// Finite differences for the slope dh/du at a texel of a row of heights; likewise for v. Degrees are the mean error of
/// the normal on a height map without noise, at 8 texels per wavelength and slopes up to 1. Noise is the RMS of the
/// slope per unit of RMS noise in the heights (rounding to 8 bits is noise).
enum class SlopeFilter {
    forward,       ///< h(+1) - h(0); first order, and shifts the relief by half a texel; noise 1.41
    central,       ///< (h(+1) - h(-1)) / 2; second order; 1.83 degrees, noise 0.71
    sobel,         ///< central, smoothed across by (1 2 1) / 4; 2.61 degrees, noise 0.43
    scharr,        ///< central, smoothed across by (3 10 3) / 16: keeps directions; 2.39 degrees, noise 0.48
    fourth_order,  ///< (8 (h(+1) - h(-1)) - (h(+2) - h(-2))) / 12; 0.18 degrees, noise 0.95
    spline         ///< slope m of the cubic spline, m(-1) + 4 m + m(+1) = 3 (h(+1) - h(-1)); 0.034 degrees
};
/// Their names in commands and tables.
constexpr std::pair<const char*, SlopeFilter> slope_filters[] = {
    {"forward", SlopeFilter::forward}, {"central", SlopeFilter::central},           {"sobel", SlopeFilter::sobel},
    {"scharr", SlopeFilter::scharr},   {"fourth-order", SlopeFilter::fourth_order}, {"spline", SlopeFilter::spline}};

struct NormalOptions {
    /// A height of 1, in texels along u and along v. They differ when texels are not square.
    double texels_u = 1;
    double texels_v = 1;
    SlopeFilter filter = SlopeFilter::central;
    /// Whether the map tiles. If not, slopes at the border are one-sided. They have the filter's order where the map
    /// has enough texels. Smoothing across then repeats the border.
    bool wrap = true;
    /// Strength of each level of detail, from the finest. Level k holds the features of about 2^k texels: the
    /// difference of two smoothings by the cubic B-spline, as in an undecimated wavelet transform. Coarser features
    /// than those of the last level keep their strength. Empty, or all 1, changes nothing.
    std::vector<double> level_strengths = {};
};

/// Returns an index into a line of `count`: wrapped around if `wrap`, else clamped.
int inside(int index, int count, bool wrap);

/// One term of a slope, a sum of weighted differences. So the slope of equal heights is exactly 0.
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

/// Returns the slope at element `i` of a line of `count`, without smoothing across. Without wrap, central differences
/// (and filters based on them) become (-3 h0 + 4 h1 - h2) / 2 at a border. The fourth order has one-sided forms of its
/// own (Fornberg 1988). A line that is too short for these gets a lower order. `forward` looks back at the last
/// element. `spline` gets the fourth-order differences that are its end slopes.
SlopeDifferences slope_differences(SlopeFilter filter, int i, int count, bool wrap);

/// Returns the weight of each of the two neighbouring lines when slopes are smoothed across. The line itself has the
/// rest.
double weight_beside(SlopeFilter filter);

constexpr int spline_lanes = 16;

/// Slopes of the cubic splines through several lines at once. The slopes m solve m(i-1) + 4 m(i) + m(i+1) =
/// 3 (h(i+1) - h(i-1)): cyclically when the line wraps, else with fourth-order end slopes.
class SplineLines {
public:
    SplineLines(int count, bool wrap);
    /// Sets element `i` of the first `lanes` lines. `stride` is the distance in floats from one line to the next.
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

/// Returns the differences of a filter as a table that a shader can read: a row for each texel of a line of `count`
/// texels, of which row 0 is the last. A column holds one difference: its two texels and its weight, which is 0 in
/// unused columns. There are 4 columns; a spline has `count`, because its slope depends on the whole line.
Image slope_table(SlopeFilter filter, int count, bool wrap);

/// Returns the height map with its levels of detail scaled by `strengths`, see NormalOptions::level_strengths.
Image with_level_strengths(const Image& heights, const std::vector<double>& strengths, bool wrap, unsigned threads);

}  // namespace relief
