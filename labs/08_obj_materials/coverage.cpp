#include "coverage.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace relief {
namespace {

/// Returns the alpha of a level at (u, v) in tiles by GL's bilinear filter.
double alpha_at(const Image& level, double u, double v) {
    const double x = u * level.width - 0.5, y = v * level.height - 0.5;
    const double left = std::floor(x), low = std::floor(y);
    const auto texel = [&](double column, double row) {
        const int w = level.width, h = level.height;
        return double(*level.pixel(((int(column) % w) + w) % w, ((int(row) % h) + h) % h));
    };
    const double bottom = glm::mix(texel(left, low), texel(left + 1, low), x - left);
    return glm::mix(bottom, glm::mix(texel(left, low + 1), texel(left + 1, low + 1), x - left), y - low);
}

/// Returns the alpha at 16,384 evenly distributed places, for any size of texels (Roberts 2018).
std::vector<double> alphas_of(const Image& level) {
    std::vector<double> alphas;
    for (int i = 0; i < 1 << 14; ++i) {
        const double u = (i + 0.5) * 0.7548776662466927, v = (i + 0.5) * 0.5698402909980532;
        alphas.push_back(alpha_at(level, u - std::floor(u), v - std::floor(v)));
    }
    return alphas;
}

}  // namespace

std::vector<float> coverage_scales(const std::vector<Image>& levels) {
    const std::vector<double> whole = alphas_of(levels.at(0));
    const double share = double(std::count_if(whole.begin(), whole.end(), [](double alpha) { return alpha > 0.5; })) /
                         double(whole.size());
    std::vector<float> scales = {1};
    for (size_t i = 1; i < levels.size(); ++i) {
        std::vector<double> alphas = alphas_of(levels[i]);
        const auto place = alphas.begin() + std::ptrdiff_t(double(alphas.size() - 1) * (1 - share));
        std::nth_element(alphas.begin(), place, alphas.end());
        scales.push_back(float(0.5 / std::max(*place, 1.0 / 512)));
    }
    return scales;
}

}  // namespace relief
