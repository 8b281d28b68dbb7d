#include "framework/image/normals.h"

#include <algorithm>
#include <cmath>

namespace relief {

Image normals_from_heights(const Image& heights, const NormalOptions& options) {
    const auto height = [&](int x, int y) -> double {
        const auto inside = [&](int i, int n) { return options.wrap ? (i % n + n) % n : std::clamp(i, 0, n - 1); };
        return *heights.pixel(inside(x, heights.width), inside(y, heights.height));
    };
    const double side = options.filter == SlopeFilter::sobel ? 0.25 : 0.0, middle = 1 - 2 * side;

    Image normals(heights.width, heights.height, 3, 8);
    for (int y = 0; y < heights.height; ++y)
        for (int x = 0; x < heights.width; ++x) {
            double du = 0, dv = 0;
            for (int k = -1; k <= 1; ++k) {
                const double weight = k == 0 ? middle : side;
                if (weight == 0) continue;
                du += weight * (height(x + 1, y + k) - height(x - 1, y + k)) / 2;
                dv += weight * (height(x + k, y - 1) - height(x + k, y + 1)) / 2;  // row 0 is the top, v grows up
            }
            du *= options.texels_u, dv *= options.texels_v;
            const double length = std::sqrt(du * du + dv * dv + 1);
            float* const texel = normals.pixel(x, y);
            texel[0] = static_cast<float>(0.5 - 0.5 * du / length);
            texel[1] = static_cast<float>(0.5 - 0.5 * dv / length);
            texel[2] = static_cast<float>(0.5 + 0.5 / length);
        }
    return normals;
}

}  // namespace relief
