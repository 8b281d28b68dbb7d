#include "assets/urn.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>

namespace relief {
namespace {

constexpr int sides = 28, rows = 22;

/// Returns radius and height of the outline; v runs from the foot to the lip.
glm::dvec2 outline(double v) {
    const double belly = std::sin(glm::pi<double>() * std::pow(std::max(v, 0.0), 0.72)), foot = std::exp(-60 * v * v),
                 lip = std::exp(-70 * (1 - v) * (1 - v));
    return {0.20 + 0.48 * belly * belly * (1 - 0.25 * v) + 0.16 * foot + 0.17 * lip, -0.95 + 1.9 * v};
}

}  // namespace

std::string make_urn() {
    std::string text = "# An urn, turned on a lathe. Written by assets/urn.cpp.\no urn\n";
    for (int row = 0; row <= rows; ++row)
        for (int side = 0; side < sides; ++side) {
            const double v = double(row) / rows, angle = 2 * glm::pi<double>() * side / sides, step = 1e-5;
            const glm::dvec2 at = outline(v), along = glm::normalize(outline(v + step) - outline(v - step));
            const double s = std::sin(angle), c = std::cos(angle);
            text += fmt::format("v {:.6f} {:.6f} {:.6f}\n", at.x * s, at.y, at.x * c);
            text += fmt::format("vn {:.5f} {:.5f} {:.5f}\n", along.y * s, -along.x, along.y * c);
        }
    for (int row = 0; row <= rows; ++row)
        for (int side = 0; side <= sides; ++side)
            text += fmt::format("vt {:.6f} {:.6f}\n", double(side) / sides, double(row) / rows);
    for (int row = 0; row < rows; ++row)
        for (int side = 0; side < sides; ++side) {
            const auto corner = [&](int i, int j) {
                const int point = j * sides + i % sides + 1;
                return fmt::format(" {}/{}/{}", point, j * (sides + 1) + i + 1, point);
            };
            text += "f" + corner(side, row) + corner(side + 1, row) + corner(side + 1, row + 1) +
                    corner(side, row + 1) + "\n";
        }
    return text;
}

}  // namespace relief
