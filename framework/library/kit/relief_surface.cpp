#include "framework/library/kit/relief_surface.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "framework/core/base/paths.h"
#include "framework/library/mesh/obj.h"
#include "framework/library/mesh/shapes.h"

namespace relief {
namespace {

constexpr std::array base_shapes = {"wall", "column", "urn"};

constexpr ColumnShape column_shape{.bottom_radius = ReliefSurface::column_radius,
                                   .top_radius = ReliefSurface::column_radius,
                                   .height = ReliefSurface::column_height,
                                   .sides = 96,  // a tile is a third of the way around: 32 whole sides
                                   .rows = 1};
constexpr float around_column = 2 * glm::pi<float>() * ReliefSurface::column_radius;
constexpr float around_urn = 3.2f, up_urn = 2.4f;  // metres per unit of uv, at the urn's middle

/// Returns the matrix from (x, y, 1) of gl_FragCoord to the direction of that pixel's view ray in the world. The
/// direction is not normalised.
glm::dmat3 world_from_pixel(const Camera& camera) {
    GLint viewport[4];
    glGetIntegerv(GL_VIEWPORT, viewport);
    const glm::dvec2 corner(viewport[0], viewport[1]), size(viewport[2], viewport[3]);
    const glm::dmat4 clip_from_view = camera.clip_from_view();
    const glm::dvec2 pixel = 2.0 / size / glm::dvec2(clip_from_view[0][0], clip_from_view[1][1]);
    const glm::dmat3 view_from_pixel({pixel.x, 0, 0}, {0, pixel.y, 0}, {-(corner + 0.5 * size) * pixel, -1});
    return glm::transpose(glm::dmat3(camera.view_from_world())) * view_from_pixel;
}

}  // namespace

Mesh read_urn() {
    Mesh mesh = read_obj(course_root() / "assets" / "urn.obj").mesh;
    // On a surface of revolution, uv determine the tangent.
    for (Vertex& vertex : mesh.vertices) {
        const float around = 2 * glm::pi<float>() * vertex.uv.x;
        vertex.tangent = glm::vec4(std::cos(around), 0, -std::sin(around), 1);
    }
    return mesh;
}

void ReliefSurface::knobs(Knobs& knobs) {
    knobs.group("Surface");
    knobs.choice_or_file("surface", shape, own_, base_shapes, "shape with the relief");
    material.knobs(knobs);
    knobs.slider("depth", depth, 0, 1, "depth of the relief, in widths of a tile");
    knobs.steps("repeat", repeat, 1, 8,
                "repeats of the tile: per metre of wall, per third of the column, per unit of a file's uv");
    knobs.slider("stretch", stretch, 0.25f, 4, "height of a tile divided by its width: texels that are not square");
    knobs.slider("extent", extent, 0.25f, 64, KnobHelp("side of the wall").in("metres").titled("Extent of wall"));
    knobs.toggle("mirror", mirror, KnobHelp("mirror the texture: u runs the other way").titled("Mirror u"));
    knobs.steps("shift", shift, 0, 10000,
                KnobHelp("offset of the uv, in tiles; all but three whole ones are dropped before the shader")
                    .titled("Shift of uv"));
}

const ReliefSurface::Shaped& ReliefSurface::shaped() const {
    return shaped_.get({shape, extent, own_.version()}, [this]() -> Shaped {
        return {shape == wall     ? make_quad({.width = extent, .height = extent})
                : shape == column ? make_column(column_shape)
                : shape == urn    ? read_urn()
                                  : own_.mesh_with_tangents(),
                upload([this] { return mesh(); }), shape == own ? float(metres_per_uv(own_.mesh())) : 0};
    });
}

ReliefMapping ReliefSurface::mapping() const {
    const glm::vec2 metres = shape == wall     ? glm::vec2(extent)
                             : shape == column ? glm::vec2(around_column, column_shape.height)
                             : shape == urn    ? glm::vec2(around_urn, up_urn)
                                               : glm::vec2(shaped().own_metres);
    // A whole number of tiles around; on the wall, a tile is a metre wide, and on an own model a unit of its uv.
    const float tile = shape == wall  ? 1.0f / float(repeat)
                       : shape == own ? metres.x / float(repeat)
                                      : metres.x / float(3 * repeat);
    glm::vec2 tiles = metres / glm::vec2(tile, tile * stretch);
    if (mirror) tiles.x = -tiles.x;
    // At 10,000 tiles, a float is wrong by a quarter of a texel. A map that repeats looks the same without whole tiles.
    // A few tiles stay, to expose code that assumes uv < 1.
    return {tiles, glm::vec2(float(shift % 4)), glm::vec2(depth, depth / stretch), depth * tile, heights().width};
}

void ReliefSurface::set(const Program& program, const Frame& frame, const glm::dmat4& world_from_model) const {
    const ReliefMapping here = mapping();
    program.set("u_clip_from_world", frame.camera.clip_from_world());
    program.set("u_world_from_model", world_from_model);
    program.set("u_eye", frame.camera.eye());
    program.set("u_repeat", here.repeat);
    program.set("u_shift", here.shift);
    program.set("u_depth", here.depth);
    program.set("u_depth_metres", here.metres);
    program.set("u_normal_strength", here.depth / ReliefMaterial::normals_depth);
    material.set(program);
    set_view_ray(program, frame, world_from_model);
}

void ReliefSurface::set_view_ray(const Program& program, const Frame& frame, const glm::dmat4& world_from_model) const {
    if (glGetUniformLocation(program, "u_base_from_pixel") < 0) return;  // labs 10 and 11 use interpolated rays
    program.set("u_is_flat", shape == wall);
    if (shape != wall) return;
    const ReliefMapping here = mapping();
    const glm::dvec2 tiles(here.repeat), tiles_per_metre = glm::abs(tiles) / double(extent);
    const glm::dmat4 model_from_world = glm::inverse(world_from_model);
    glm::dvec3 eye(model_from_world * glm::dvec4(frame.camera.eye(), 1));
    const glm::dvec2 uv = (glm::dvec2(eye) / double(extent) + 0.5) * tiles + glm::dvec2(here.shift);
    eye = {uv, eye.z};
    const glm::dmat3 base_from_model({tiles.x < 0 ? -1 : 1, 0, 0}, {0, 1, 0}, {0, 0, 1});
    const glm::dmat3 base_from_pixel = base_from_model * glm::dmat3(model_from_world) * world_from_pixel(frame.camera);
    glUniformMatrix3dv(glGetUniformLocation(program, "u_base_from_pixel"), 1, GL_FALSE,
                       glm::value_ptr(base_from_pixel));
    glUniform3dv(glGetUniformLocation(program, "u_eye_over_base"), 1, glm::value_ptr(eye));
    glUniform2dv(glGetUniformLocation(program, "u_tiles_per_metre"), 1, glm::value_ptr(tiles_per_metre));
}

void ReliefSurface::set_exact_hit(const Program& program, int unit) const {
    if (glGetUniformLocation(program, "u_window_extent") < 0) return;  // a permutation without exact_hit()
    program.set("s_windows", unit, windows().texture);
    program.set("u_window_extent", windows().heights.extents());
}

const ReliefSurface::Windows& ReliefSurface::windows() const {
    return windows_.get({version()}, [this]() -> Windows {
        return {height_windows(heights()),
                Texture("windows", [this] { return windows().heights.clearance; }, {.mips = false, .layers = 8})};
    });
}

void ReliefSurface::draw() const {
    const GpuMesh& mesh = shaped().uploaded;
    glBindVertexArray(mesh.layout());
    glDrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
}

}  // namespace relief
