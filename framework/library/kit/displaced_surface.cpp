#include "framework/library/kit/displaced_surface.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "framework/library/kit/relief_surface.h"
#include "framework/library/mesh/shapes.h"

namespace relief {
namespace {

constexpr std::array displaced_shapes = {"wall", "ground", "sphere", "globe", "torus", "column", "box", "urn"};
constexpr std::array corner_counts = {"3", "4"};
constexpr std::array spacing_defines = {"SPACING equal_spacing", "SPACING fractional_odd_spacing",
                                        "SPACING fractional_even_spacing"};  // in the order of spacings
constexpr float around = 2 * glm::pi<float>();

/// The uv of a shape: metres per unit of u at its middle, and tiles per unit of uv where `repeat` is 1.
struct Lay {
    float metres;
    glm::vec2 tiles;
};
constexpr std::array<Lay, 9> lays = {{{DisplacedSurface::wall_metres, {2, 2}},
                                      {DisplacedSurface::ground_metres, {1, 1}},
                                      {around / 4, {1, 1}},
                                      {around, {6, 3}},
                                      {around, {6, 2}},
                                      {around / 2, {3, 2}},
                                      {DisplacedSurface::box_metres, {1, 1}},
                                      {3.2f, {3, 2}},
                                      {0, {1, 1}}}};  // an own model: metres_per_uv()

}  // namespace

void DisplacedSurface::knobs(Knobs& knobs) {
    knobs.group("Surface");
    knobs.choice_or_file("surface", shape, own_, displaced_shapes, "shape with the relief");
    knobs.choice("corners", corners_choice, corner_counts, KnobHelp("corners of a patch").titled("Patch corners"));
    knobs.steps("patches", density, 1, most_density,
                "patches along a side, before tessellation; the urn and a file have their own");
    material.knobs(knobs);
    knobs.slider("depth", depth, 0, 0.5f, "depth of the relief, in widths of a tile");
    knobs.steps("repeat", repeat, 1, 8, "repeats of the tile");
}

Define DisplacedSurface::spacing_define(int spacing) { return spacing_defines[size_t(spacing)]; }

glm::vec2 DisplacedSurface::tiles() const { return lays[size_t(shape)].tiles * float(repeat); }

float DisplacedSurface::tile() const {
    return (shape == own ? made().own_metres : lays[size_t(shape)].metres) / tiles().x;
}

Mesh DisplacedSurface::mesh() const {
    const glm::vec2 tiles = this->tiles();
    switch (Shape(shape)) {
        case wall:
            return make_quad(
                {.width = wall_metres, .height = wall_metres, .columns = density, .rows = density, .repeat = tiles});
        case ground:
            return make_grid(
                {.width = ground_metres, .depth = ground_metres, .columns = density, .rows = density, .repeat = tiles});
        case sphere:
            return make_cube_sphere({.radius = 1, .cells = std::max(1, density / 2), .repeat = tiles});
        case globe:
            return make_sphere({.radius = 1, .sides = 3 * density, .rows = std::max(2, density), .repeat = tiles});
        case torus:
            return make_torus(
                {.ring_radius = 1, .tube_radius = 0.4f, .sides = 3 * density, .rows = density, .repeat = tiles});
        case column: {
            Mesh mesh = make_column({.bottom_radius = 0.5f,
                                     .top_radius = 0.5f,
                                     .height = 2,
                                     .sides = std::max(3, density),
                                     .rows = std::max(1, density / 2),
                                     .repeat = tiles});
            for (Vertex& vertex : mesh.vertices) vertex.position.y -= 1;  // centred, as the other shapes are
            return mesh;
        }
        case box:
            return make_box(
                {.size = glm::vec3(box_metres), .cells = glm::ivec3(std::max(1, density / 2)), .repeat = tiles});
        case urn:
        case own:
            break;
    }
    Mesh mesh = shape == own ? own_.mesh_with_tangents() : read_urn();
    for (Vertex& vertex : mesh.vertices) vertex.uv *= tiles;
    return mesh;
}

const DisplacedSurface::Made& DisplacedSurface::made() const {
    return made_.get({shape, corners(), density, repeat, own_.version()}, [this]() -> Made {
        return {make_patches(mesh(), corners()), GpuPatches([this] { return patches(); }),
                shape == own ? float(metres_per_uv(own_.mesh())) : 0};
    });
}

std::pair<glm::dvec3, glm::dvec3> DisplacedSurface::box_around() const {
    glm::dvec3 low(INFINITY), high(-INFINITY);
    for (const PatchCorner& corner : patches().points) {
        const glm::dvec3 position(corner.vertex.position);
        low = glm::min(low, position), high = glm::max(high, position);
    }
    return {low - double(scale()), high + double(scale())};
}

Mesh DisplacedSurface::mesh_on_floor() const {
    Mesh standing = mesh();
    for (Vertex& vertex : standing.vertices)
        if (vertex.normal.y > 0) vertex.position -= scale() * vertex.normal;
    return standing;
}

void DisplacedSurface::set(const Program& program, const Frame& frame) const {
    // Multiply in double precision: far from the world's origin, a float cannot resolve millimetres.
    program.set("u_clip_from_model", frame.camera.clip_from_world() * glm::translate(glm::dmat4(1), origin));
    program.set("u_eye", frame.camera.eye() - origin);
    program.set("u_scale", scale());
    program.set("u_normal_strength", glm::vec2(depth / ReliefMaterial::normals_depth));
    material.set(program);
}

void DisplacedSurface::draw() const {
    const GpuPatches& patches = made().uploaded;
    glBindVertexArray(patches.layout());
    draw_patches(patches.count(), patches.control_points());
}

int DisplacedSurface::draw_and_count() const {
    if (!count_) count_.emplace();
    {
        // Ends the query also when a draw call throws.
        struct Counted {
            explicit Counted(GLuint query) { glBeginQuery(GL_PRIMITIVES_GENERATED, query); }
            ~Counted() { glEndQuery(GL_PRIMITIVES_GENERATED); }
        };
        const Counted counted(*count_);
        draw();
    }
    GLint triangles = 0;
    glGetQueryObjectiv(*count_, GL_QUERY_RESULT, &triangles);
    return triangles;
}

float DisplacedSurface::most_level(int draws) const {
    // A quad of level l becomes 2 l² triangles, a triangle 1.5 l².
    const double of_one = (corners() == 4 ? 2.0 : 1.5) * double(std::max<size_t>(1, patches().patches()));
    return std::clamp(float(std::floor(std::sqrt(most_triangles / (of_one * draws)))), 1.0f, finest_level);
}

float DisplacedSurface::most_level(const Program& program, float wanted, int draws) const {
    const float certain = most_level(draws);
    if (wanted <= certain) return finest_level;
    // Culled and distant patches need few triangles. The triangles of any other patch grow at most with the square of
    // its level.
    const float coarse = std::min(8.0f, certain);
    program.set("u_most_level", coarse);
    glEnable(GL_RASTERIZER_DISCARD);
    const int counted = draw_and_count();
    glDisable(GL_RASTERIZER_DISCARD);
    const double larger = std::sqrt(most_triangles / (std::max(1.0, double(counted)) * draws));
    return std::clamp(std::floor(coarse * float(larger)), certain, finest_level);
}

void DisplacedSurface::begin_winding() {
    constexpr float zero[4] = {};
    glClearBufferfv(GL_COLOR, 0, zero);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
}

void DisplacedSurface::end_winding() {
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
}

}  // namespace relief
