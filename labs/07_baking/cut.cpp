#include "cut.h"

#include <glm/gtc/constants.hpp>

#include "section.h"

namespace relief::baking {
namespace {

constexpr glm::vec3 high_color{0.86f, 0.72f, 0.52f}, low_color{0.55f, 0.62f, 0.70f}, cage_color{0.36f, 0.40f, 0.46f};
constexpr glm::vec3 hit_color{0.36f, 0.78f, 0.42f}, miss_color{0.93f, 0.28f, 0.20f}, wrong_color{0.68f, 0.36f, 0.95f},
    unwritten_color{0.85f, 0.0f, 0.85f};

/// The coarse model as the bake cuts it: places of the map on its triangles.
class CoarseModel {
public:
    explicit CoarseModel(const Recipe& recipe)
        : fineness_(low_finenesses[size_t(recipe.low)]), mesh_(make_low(recipe.model, fineness_, false, false)) {}

    const Mesh& mesh() const { return mesh_; }

    struct Place {
        glm::dvec3 position, outwards;
    };
    /// Returns the place at (s, t) in [0, 1] of a whorl's strip.
    Place at(int whorl, double s, double t) const {
        const double x = std::clamp(s, 0.0, 1.0) * fineness_.columns, y = std::clamp(t, 0.0, 1.0) * fineness_.sides;
        const int i = std::min(int(x), fineness_.columns - 1), j = std::min(int(y), fineness_.sides - 1);
        const double a = x - i, b = y - j;
        const size_t row = size_t(fineness_.sides) + 1;
        const size_t first = size_t(whorl) * size_t(fineness_.columns + 1) * row + size_t(i) * row + size_t(j);
        const Vertex &v00 = mesh_.vertices[first], &v10 = mesh_.vertices[first + row],
                     &v11 = mesh_.vertices[first + row + 1], &v01 = mesh_.vertices[first + 1];
        const auto mixed = [&](auto member) {
            const glm::dvec3 p = v00.*member, q = a > b ? v10.*member : v01.*member, r = v11.*member;
            return a > b ? (1 - a) * p + (a - b) * q + b * r : (1 - b) * p + (b - a) * q + a * r;
        };
        return {mixed(&Vertex::position), glm::normalize(mixed(&Vertex::normal))};
    }

private:
    Fineness fineness_;
    Mesh mesh_;
};

/// Collects lines, projected onto the half plane from the z axis towards `outwards`.
class Section {
public:
    explicit Section(const glm::dvec3& outwards) : outwards_(outwards) {}

    void add(const glm::dvec3& a, const glm::dvec3& b, glm::vec3 color, float width) {
        lines.push_back({flat(a), flat(b), color, width});
    }
    void add_mesh(const Mesh& mesh, glm::vec3 color, float width) {
        for (const auto& [a, b] : plane_section(mesh, {-outwards_.y, outwards_.x, 0}))
            if (glm::dot(a, outwards_) > 0) add(a, b, color, width);
    }

    std::vector<DrawnLine> lines;

private:
    glm::vec2 flat(const glm::dvec3& place) const { return glm::vec2(glm::dot(place, outwards_), place.z); }
    glm::dvec3 outwards_;
};

/// Adds the rays of one column of a whorl's texels, each from the cage to its hit. `hits` begins at the strip's lower
/// end.
void add_rays(Section& section, const CoarseModel& coarse, int whorl, double s, double reach,
              const std::vector<glm::vec3>& hits) {
    for (size_t j = 0; j < hits.size(); ++j) {
        const auto here = coarse.at(whorl, s, (double(j) + 0.5) / double(hits.size()));
        const glm::vec3 hit = hits[j];
        const glm::vec3 color = hit.z > 0      ? unwritten_color
                                : hit.y == 0   ? miss_color
                                : hit.y < 1.5f ? hit_color
                                               : wrong_color;
        const double end = hit.y == 0 ? -reach : double(hit.x);
        section.add(here.position + reach * here.outwards, here.position + end * here.outwards, color,
                    color == hit_color ? 0.7f : 1.6f);
    }
}

void add_cage(Section& section, const CoarseModel& coarse, int whorl, double s, double reach) {
    constexpr int steps = 96;
    for (int j = 0; j < steps; ++j) {
        const auto a = coarse.at(whorl, s, double(j) / steps), b = coarse.at(whorl, s, double(j + 1) / steps);
        section.add(a.position + reach * a.outwards, b.position + reach * b.outwards, cage_color, 1);
    }
}

}  // namespace

std::vector<DrawnLine> cut_lines(const Recipe& recipe, const Mesh& high, const Image& hits, float share) {
    if (!recipe.is_ammonite()) return {};
    // The section goes through the centres of a column of texels.
    const float across = float(border) + float(1 - 2 * border) * share;
    const int column = std::clamp(int(across * float(recipe.size)), 0, recipe.size - 1);
    const double u = (column + 0.5) / recipe.size, s = (u - border) / (1 - 2 * border);
    const double angle = 2 * glm::pi<double>() * turn_at({u, 0.0});
    const double side = recipe.model.shape == Shape::mirrored ? -1 : 1;
    Section section({side * std::cos(angle), std::sin(angle), 0});
    const CoarseModel coarse(recipe);
    for (int whorl = 0; whorl < whorls; ++whorl) {
        const double low = border + step * (recipe.overlapping ? std::max(whorl, 1) : whorl);
        const int begin = int(low * recipe.size), texels = int(strip * recipe.size);
        std::vector<glm::vec3> of_column;
        for (int j = begin; j < begin + texels; ++j) {
            const float* const hit = hits.pixel(column, recipe.size - 1 - j);
            of_column.emplace_back(hit[0], hit[1], hit[2]);
        }
        const double reach = recipe.reach_at({u, border + step * whorl + 0.1});
        add_rays(section, coarse, whorl, s, reach, of_column);
        add_cage(section, coarse, whorl, s, reach);
    }
    section.add_mesh(coarse.mesh(), low_color, 1.2f);
    section.add_mesh(high, high_color, 1.8f);
    return std::move(section.lines);
}

}  // namespace relief::baking
