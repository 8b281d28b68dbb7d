#include "cut.h"

#include <glm/gtc/constants.hpp>

namespace relief::baking {
namespace {

/// Calls draw(from, to) for the section of each triangle by a half plane: from the z axis towards `outwards`.
template <class Draw>
void cut_mesh(const Mesh& mesh, const glm::dvec3& outwards, const Draw& draw) {
    const glm::dvec3 across(-outwards.y, outwards.x, 0);
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        glm::dvec3 ends[2];
        int count = 0;
        for (size_t k = 0; k < 3 && count < 2; ++k) {
            const glm::dvec3 a = mesh.vertices[mesh.indices[i + k]].position,
                             b = mesh.vertices[mesh.indices[i + (k + 1) % 3]].position;
            const double at_a = glm::dot(a, across), at_b = glm::dot(b, across);
            if ((at_a < 0) == (at_b < 0)) continue;
            ends[count++] = glm::mix(a, b, at_a / (at_a - at_b));
        }
        if (count == 2 && glm::dot(ends[0], outwards) > 0) draw(ends[0], ends[1]);
    }
}

}  // namespace

std::vector<CutLine> cut_lines(const Recipe& recipe, const Mesh& high, const Image& hits, float share) {
    constexpr glm::vec3 high_color{0.86f, 0.72f, 0.52f}, low_color{0.55f, 0.62f, 0.70f},
        cage_color{0.36f, 0.40f, 0.46f};
    std::vector<CutLine> lines;
    if (recipe.model.shape == Shape::cube) return lines;
    // The section goes through the centres of a column of texels.
    const int column = std::clamp(int((1.0f / 16 + 14.0f / 16 * share) * float(recipe.size)), 0, recipe.size - 1);
    const double u = (column + 0.5) / recipe.size;
    const double angle = 2 * glm::pi<double>() * turn_at({u, 0.0});
    const double side = recipe.model.shape == Shape::mirrored ? -1 : 1;
    const glm::dvec3 outwards(side * std::cos(angle), std::sin(angle), 0);
    const auto flat = [&](const glm::dvec3& place) { return glm::vec2(glm::dot(place, outwards), place.z); };
    const auto add = [&](const glm::dvec3& a, const glm::dvec3& b, glm::vec3 color, float width) {
        lines.push_back({flat(a), flat(b), color, width});
    };
    // Finds the place on the coarse model of a texel's centre. Quads are cut along the diagonals of the bake.
    const Fineness fineness = low_finenesses[size_t(recipe.low)];
    const Mesh low = make_low(recipe.model, fineness, false, false);
    struct Place {
        glm::dvec3 position, outwards;
    };
    const auto place_of = [&](int whorl, double s, double t) {
        const double x = std::clamp(s, 0.0, 1.0) * fineness.columns, y = std::clamp(t, 0.0, 1.0) * fineness.sides;
        const int i = std::min(int(x), fineness.columns - 1), j = std::min(int(y), fineness.sides - 1);
        const double a = x - i, b = y - j;
        const size_t row = size_t(fineness.sides) + 1;
        const size_t first = size_t(whorl) * size_t(fineness.columns + 1) * row + size_t(i) * row + size_t(j);
        const Vertex &v00 = low.vertices[first], &v10 = low.vertices[first + row], &v11 = low.vertices[first + row + 1],
                     &v01 = low.vertices[first + 1];
        const auto mixed = [&](auto member) {
            const glm::dvec3 p = v00.*member, q = a > b ? v10.*member : v01.*member, r = v11.*member;
            return a > b ? (1 - a) * p + (a - b) * q + b * r : (1 - b) * p + (b - a) * q + a * r;
        };
        return Place{mixed(&Vertex::position), glm::normalize(mixed(&Vertex::normal))};
    };
    const double s = (u - 1.0 / 16) / (14.0 / 16);
    for (int whorl = 0; whorl < whorls; ++whorl) {
        const int strip = recipe.overlapping ? std::max(whorl, 1) : whorl;
        const int begin = (1 + 5 * strip) * recipe.size / 16, texels = recipe.size / 4;
        const double reach = recipe.reach_at({u, (1 + 5 * whorl) / 16.0 + 0.1});
        for (int j = 0; j < texels; ++j) {
            const Place here = place_of(whorl, s, (j + 0.5) / texels);
            const float* const hit = hits.pixel(column, recipe.size - 1 - (begin + j));
            const glm::vec3 color = hit[2] > 0      ? unwritten_color
                                    : hit[1] == 0   ? miss_color
                                    : hit[1] < 1.5f ? hit_color
                                                    : wrong_color;
            const double end = hit[1] == 0 ? -reach : double(hit[0]);
            add(here.position + reach * here.outwards, here.position + end * here.outwards, color,
                color == hit_color ? 0.7f : 1.6f);
        }
        constexpr int steps = 96;
        for (int j = 0; j < steps; ++j) {
            const Place a = place_of(whorl, s, double(j) / steps), b = place_of(whorl, s, double(j + 1) / steps);
            add(a.position + reach * a.outwards, b.position + reach * b.outwards, cage_color, 1);
        }
    }
    cut_mesh(low, outwards, [&](const auto& a, const auto& b) { add(a, b, low_color, 1.2f); });
    cut_mesh(high, outwards, [&](const auto& a, const auto& b) { add(a, b, high_color, 1.8f); });
    return lines;
}

}  // namespace relief::baking
