#include "framework/staff/reference/masks.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <vector>

namespace relief {
namespace {

struct Placed {
    glm::dvec2 stalk, along;  ///< as long as the leaf
};

/// Random numbers in [0, 1), the same on any machine (the finaliser of SplitMix64, Steele et al. 2014).
class Numbers {
public:
    double next() {
        uint64_t bits = state_ += 0x9e3779b97f4a7c15u;
        bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
        bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
        return double((bits ^ (bits >> 31)) >> 11) * 0x1p-53;
    }

private:
    uint64_t state_ = 8;
};

const std::vector<Placed>& leaves() {
    static const std::vector<Placed> placed = [] {
        Numbers numbers;
        std::vector<Placed> all;
        for (int i = 0; i < 150; ++i) {
            const double u = numbers.next(), share = numbers.next(), size = 0.06 + 0.05 * numbers.next(),
                         hang = numbers.next() + numbers.next() - 1, strand = numbers.next();
            // Strands climb to different heights.
            const double top =
                0.45 + 0.42 * std::pow(0.5 + 0.5 * std::sin(2 * glm::pi<double>() * (2 * u + 0.13)), 1.5);
            const double v = 0.13 + (top - 0.13) * (strand < 0.7 ? share : share * share);
            // Leaves hang: their tips point roughly downwards.
            const double angle = -glm::half_pi<double>() + 1.3 * hang;
            all.push_back({{u, v}, size * glm::dvec2(std::cos(angle), std::sin(angle))});
        }
        return all;
    }();
    return placed;
}

/// Returns whether a point is in the leaf: three lobes, one to the tip and one to each side.
bool is_inside(const glm::dvec2& place) {
    const auto lobe = [&](glm::dvec2 centre, glm::dvec2 axis, double length, double width) {
        const glm::dvec2 off = place - centre;
        const double along = glm::dot(off, axis) / length, across = (off.x * axis.y - off.y * axis.x) / width;
        return along * along + across * across < 1;
    };
    const glm::dvec2 side = glm::normalize(glm::dvec2(0.8, 0.45));
    return lobe({0, 0.52}, {0, 1}, 0.48, 0.3) || lobe({0.3, 0.36}, side, 0.36, 0.22) ||
           lobe({-0.3, 0.36}, {-side.x, side.y}, 0.36, 0.22);
}

constexpr int cells = 32;

/// For each cell of the tile, the leaves that may overlap it, the highest first.
const std::vector<std::vector<int>>& leaves_near() {
    static const std::vector<std::vector<int>> near = [] {
        std::vector<std::vector<int>> lists(cells * cells);
        for (int i = int(leaves().size()) - 1; i >= 0; --i) {
            const Placed& leaf = leaves()[size_t(i)];
            // All lobes end within the leaf's length from its stalk; 15 % are a margin.
            const double reach = 1.15 * glm::length(leaf.along);
            const glm::ivec2 low(glm::floor((leaf.stalk - reach) * double(cells))),
                high(glm::floor((leaf.stalk + reach) * double(cells)));
            for (int y = std::max(low.y, 0); y <= std::min(high.y, cells - 1); ++y)
                for (int x = low.x; x <= high.x; ++x) lists[size_t(y * cells + (x + cells) % cells)].push_back(i);
        }
        return lists;
    }();
    return near;
}

}  // namespace

bool is_wire(const glm::dvec2& uv) {
    // 1 - (1 - share)² of the tile is wire.
    static const double half_share = (1 - std::sqrt(1 - wire_coverage)) / 2;
    const auto on_wire = [](double across) { return std::abs(across - std::round(across)) < half_share; };
    return on_wire(wires * (uv.x + uv.y)) || on_wire(wires * (uv.x - uv.y));
}

std::optional<Leaf> leaf_at(const glm::dvec2& uv) {
    if (uv.y < 0 || uv.y >= 1) return leaf_at({uv.x, uv.y - std::floor(uv.y)});
    const std::vector<Placed>& all = leaves();
    const int column = std::min(int((uv.x - std::floor(uv.x)) * cells), cells - 1);
    for (const int i : leaves_near()[size_t(int(uv.y * cells) * cells + column)]) {
        glm::dvec2 off = uv - all[size_t(i)].stalk;
        off.x -= std::round(off.x);
        const glm::dvec2& along = all[size_t(i)].along;
        const double square = glm::dot(along, along);
        const glm::dvec2 place((off.x * along.y - off.y * along.x) / square, glm::dot(off, along) / square);
        if (is_inside(place)) return Leaf{i, place};
    }
    return {};
}

double leaf_coverage() {
    static const double share = [] {
        constexpr int side = 1024;
        int inside = 0;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) inside += leaf_at((glm::dvec2(x, y) + 0.5) / double(side)).has_value();
        return double(inside) / (side * side);
    }();
    return share;
}

}  // namespace relief
