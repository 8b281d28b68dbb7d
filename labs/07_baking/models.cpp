#include "models.h"

#include <glm/gtc/constants.hpp>

#include "framework/library/mesh/shapes.h"

namespace relief::baking {
namespace {

constexpr double two_pi = 2 * glm::pi<double>();
constexpr int ribs = 15;                     // per turn
constexpr int dents = 10, dents_around = 4;  // periods per turn, and around the tube; each has two dents
constexpr double seam = 0.9;  // of the map's strips: angle around the tube from the outermost line, radians

/// Returns the height of the relief, in radii of the tube. Ribs bend forwards, and fade where the next whorl lies on
/// them.
double relief_height(double turn, double around, bool with_growth_lines, const Sculpt& sculpt) {
    const double phase = two_pi * (ribs * turn - 0.45 * (1 - std::cos(around)) + 0.1 * std::sin(2 * around));
    const double free = 0.5 + 0.5 * std::cos(around);
    const double rib = std::pow(0.5 + 0.5 * std::cos(phase), 1.4) * (0.12 + 0.88 * free);
    const double line = with_growth_lines ? 0.5 + 0.5 * std::cos(5 * phase) : 0;
    const double far_from_bulge = std::pow((turn - 2.6) / 0.13, 2) + (1 - std::cos(around)) / 0.3;
    const double dent = std::max(0.0, std::cos(two_pi * dents * turn) * std::cos(dents_around * around)) * free;
    return double(sculpt.ribs) * rib_height * rib + growth_line_height * line +
           double(sculpt.bulge) * std::exp(-far_from_bulge) - double(sculpt.dents) * dent * dent;
}

/// Returns the place at `height` above the tube, in radii of the tube.
glm::dvec3 place(const Model& model, double turn, double around, double height) {
    const double angle = two_pi * turn;
    const glm::dvec3 outwards(std::cos(angle), std::sin(angle), 0);
    const double radius = model.tube_radius(turn) * (1 + height);
    return (model.centre_radius(turn) + radius * std::cos(around)) * outwards +
           glm::dvec3(0, 0, radius * std::sin(around));
}

/// Returns position, normal and dP/dturn of a surface P(turn, around). Derivatives are central differences, whose error
/// is negligible in floats.
template <class Surface>
Vertex vertex_of(const Surface& at, double turn, double around) {
    constexpr double h = 1e-5;
    const glm::dvec3 along = (at(turn + h, around) - at(turn - h, around)) / (2 * h);
    const glm::dvec3 across = (at(turn, around + h) - at(turn, around - h)) / (2 * h);
    const glm::dvec3 normal = glm::normalize(glm::cross(along, across));
    return {at(turn, around), normal, glm::vec4(glm::normalize(along), 1), {turn, 0}};
}

void add_quad(Mesh& mesh, uint32_t a, uint32_t b, uint32_t c, uint32_t d, bool other_diagonal) {
    if (other_diagonal)
        mesh.indices.insert(mesh.indices.end(), {a, b, d, b, c, d});
    else
        mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
}

/// Adds a tube that is closed around its centre line. uv.x of a vertex is its turn plus `mark`.
template <class Surface>
void add_tube(Mesh& mesh, Fineness fineness, double begin, double end, float mark, const Surface& at) {
    const uint32_t first = uint32_t(mesh.vertices.size()), sides = uint32_t(fineness.sides);
    for (int i = 0; i <= fineness.columns; ++i)
        for (int j = 0; j < fineness.sides; ++j) {
            mesh.vertices.push_back(
                vertex_of(at, begin + (end - begin) * i / fineness.columns, two_pi * j / fineness.sides));
            mesh.vertices.back().uv.x += mark;
        }
    for (uint32_t i = 0; i < uint32_t(fineness.columns); ++i)
        for (uint32_t j = 0; j < sides; ++j) {
            const uint32_t a = first + i * sides + j, d = first + i * sides + (j + 1) % sides;
            add_quad(mesh, a, a + sides, d + sides, d, false);
        }
}

/// Mirrors the mesh: left becomes right, and frames change their handedness.
void mirror(Mesh& mesh) {
    for (Vertex& vertex : mesh.vertices)
        vertex.position.x *= -1, vertex.normal.x *= -1, vertex.tangent.x *= -1, vertex.tangent.w *= -1;
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
}

/// Returns the face of square f on the map. The order is +x, +y, +z, -x, -y, -z.
const CubeFace& face_on_map(uint32_t f) { return cube_face(int(f < 3 ? 2 * f : 2 * f - 5)); }

Mesh make_cube(bool averaged, bool other_diagonal) {
    Mesh mesh;
    for (uint32_t f = 0; f < 6; ++f) {
        const CubeFace& face = face_on_map(f);
        const glm::vec3 out(face.normal), u(face.right), v(face.up);
        const glm::vec2 corner = float(border) + float(step) * glm::vec2(f % 3, f / 3);
        for (const glm::vec2 at : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)}) {
            const glm::vec3 direction = out + (2 * at.x - 1) * u + (2 * at.y - 1) * v;
            const glm::vec3 normal = averaged ? glm::normalize(direction) : out;
            const glm::vec3 tangent = glm::normalize(u - glm::dot(u, normal) * normal);
            mesh.vertices.push_back({cube_centre + direction * (cube_side / 2), normal, glm::vec4(tangent, 1),
                                     averaged ? corner + float(strip) * at : glm::vec2(0)});
        }
        add_quad(mesh, 4 * f, 4 * f + 1, 4 * f + 2, 4 * f + 3, other_diagonal);
    }
    return mesh;
}

}  // namespace

double Model::centre_radius(double turn) const { return outer_radius * std::pow(growth, turn - whorls); }

double Model::tube_radius(double turn) const { return touching_radius * (1 - double(gap)) * centre_radius(turn); }

double Model::unit(const glm::dvec2& uv) const {
    if (shape == Shape::own) return own_radius / 4;
    return shape == Shape::cube ? cube_side / 2 : tube_radius(turn_at(uv));
}

double turn_at(const glm::dvec2& uv) {
    const double whorl = std::clamp(std::floor((uv.y - border / 2) / step), 0.0, whorls - 1.0);
    return whorl + (uv.x - border) / (1 - 2 * border);
}

double Sculpt::highest() const { return double(ribs) * rib_height + growth_line_height + std::max(0.0, double(bulge)); }

double Sculpt::deepest() const { return double(dents) + std::max(0.0, -double(bulge)); }

Mesh make_high(const Model& model, Fineness fineness, bool cord, const Sculpt& sculpt) {
    if (model.shape == Shape::cube) return make_cube(false, false);
    Mesh mesh;
    const bool fine = fineness.columns >= whorls * ribs * 5 * 3;
    add_tube(mesh, fineness, 0, whorls, 0, [&](double turn, double around) {
        return place(model, turn, around, relief_height(turn, around, fine, sculpt));
    });
    if (cord)
        add_tube(mesh, {96, 10}, 2.1, 2.9, 100, [&](double turn, double around) {
            // The cord's centre line is above the tube and meanders.
            const double at = 0.9 + 0.5 * std::sin(two_pi * 2.3 * turn);
            const double aside = cord_radius / (1 + cord_height);
            return place(model, turn, at + aside * std::sin(around), cord_height + cord_radius * std::cos(around));
        });
    if (model.shape == Shape::mirrored) mirror(mesh);
    return mesh;
}

Mesh make_low(const Model& model, Fineness fineness, bool overlapping, bool other_diagonal) {
    if (model.shape == Shape::cube) return make_cube(true, other_diagonal);
    Mesh mesh;
    for (int whorl = 0; whorl < whorls; ++whorl) {
        const uint32_t first = uint32_t(mesh.vertices.size()), row = uint32_t(fineness.sides) + 1;
        const double low = border + step * (overlapping ? std::max(whorl, 1) : whorl);
        for (int i = 0; i <= fineness.columns; ++i)
            for (int j = 0; j <= fineness.sides; ++j) {
                const glm::dvec2 share(double(i) / fineness.columns, double(j) / fineness.sides);
                mesh.vertices.push_back(
                    vertex_of([&](double turn, double around) { return place(model, turn, around, 0); },
                              whorl + share.x, seam + two_pi * share.y));
                mesh.vertices.back().uv = {border + (1 - 2 * border) * share.x, low + strip * share.y};
            }
        for (uint32_t i = 0; i < uint32_t(fineness.columns); ++i)
            for (uint32_t j = 0; j < uint32_t(fineness.sides); ++j) {
                const uint32_t a = first + i * row + j;
                add_quad(mesh, a, a + row, a + row + 1, a + 1, other_diagonal);
            }
    }
    if (model.shape == Shape::mirrored) mirror(mesh);
    return mesh;
}

Mesh OwnModels::low() const {
    Mesh mesh = coarse.mesh_with_tangents();
    for (Vertex& vertex : mesh.vertices) vertex.position += cube_centre;
    return mesh;
}

Mesh OwnModels::high(bool has_fine) const {
    Mesh mesh = has_fine ? fine.mesh() : coarse.mesh();
    const Placement& from = has_fine ? fine.placement() : coarse.placement();
    const Placement& to = coarse.placement();
    for (Vertex& vertex : mesh.vertices) {
        vertex.position = placed(vertex.position, from, to) + glm::dvec3(cube_centre);
        vertex.uv = {0, 0};
    }
    return mesh;
}

double reach_needed(const Model& model, Fineness low, const Sculpt& sculpt) {
    if (model.shape == Shape::cube || model.shape == Shape::own) return 0;
    const double tube = touching_radius * (1 - double(model.gap));
    const double along = (1 + tube) / tube * (1 - std::cos(glm::pi<double>() / low.columns));
    return std::max(sculpt.highest(), sculpt.deepest()) + along + (1 - std::cos(glm::pi<double>() / low.sides));
}

}  // namespace relief::baking
