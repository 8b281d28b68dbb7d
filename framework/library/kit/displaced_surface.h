// The surface that labs 13 and 14 displace: patches of a shape, a height map, and its depth.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "framework/core/lab/lab.h"
#include "framework/library/kit/gpu_patches.h"
#include "framework/library/kit/kept.h"
#include "framework/library/kit/own_mesh.h"
#include "framework/library/kit/relief_material.h"

namespace relief {

class DisplacedSurface {
public:
    enum Shape { wall, ground, sphere, globe, torus, column, box, urn, own };
    static constexpr float wall_metres = 2, ground_metres = 16, box_metres = 1.5f;  ///< side lengths
    /// Half the diagonal of a model's bounding box, metres: that of the box.
    static constexpr double own_radius = 0.8660254037844386 * double(box_metres);

    /// The spacings of a tessellation, which place the vertices at a fractional level: the choices of a lab's knob.
    static constexpr std::array spacings = {"equal", "fractional-odd", "fractional-even"};

    void knobs(Knobs& knobs);

    const PatchMesh& patches() const { return made().patches; }
    const Image& heights() const { return material.heights(); }
    /// Increases when patches() or heights() change.
    int version() const {
        made();
        return made_.version() + material.version();
    }
    /// Returns the number of tiles per unit of the shape's own uv. The uv of the patches are in tiles.
    glm::vec2 tiles() const;
    /// Returns the depth of the relief in metres.
    float scale() const { return depth * tile(); }

    /// Returns two corners of a box, parallel to the axes, that holds the displaced surface, in the model's
    /// coordinates.
    std::pair<glm::dvec3, glm::dvec3> box_around() const;

    /// Returns the mesh as it stands on a floor: where it faces up, at the bottom of the relief, so that no height is
    /// below the floor.
    Mesh mesh_on_floor() const;
    /// Returns the inputs of mesh_on_floor(), for Studio::draw().
    std::vector<double> studio_inputs() const {
        return {double(shape), double(density), depth, double(repeat), double(own_.version())};
    }

    /// Returns whether back faces are never visible from outside.
    bool is_one_sided() const { return shape == ground || patches().is_closed; }

    /// Returns the define of common/patch_vertex.glsl and the control shader: "CORNERS 3" or "CORNERS 4".
    Define corners_define() const { return "CORNERS " + std::to_string(corners()); }
    /// Returns the define of common/patch_vertex.glsl for a spacing, an index into `spacings`.
    static Define spacing_define(int spacing);
    int corners() const { return corners_choice == 0 ? 3 : 4; }

    /// Sets u_clip_from_model, u_eye (in the model), u_scale, u_normal_strength, and the material's maps. Precondition:
    /// the program is in use.
    void set(const Program& program, const Frame& frame) const;
    void draw() const;
    /// Draws likewise, and returns the number of triangles from the tessellator. Waits until they are drawn.
    int draw_and_count() const;

    /// Maximum number of triangles from the tessellator in one picture: a few seconds with a software renderer.
    static constexpr double most_triangles = 1e7;
    static constexpr float finest_level = 64;  ///< the maximum level that OpenGL guarantees
    /// Returns the highest level with which `draws` of the surface stay below most_triangles if each patch has it. At
    /// most finest_level.
    float most_level(int draws = 1) const;
    /// Returns the same for patches whose control shader chooses levels up to `wanted` and clamps them to the uniform
    /// u_most_level. If the number of patches gives no bound, counts triangles with a coarse, invisible draw.
    /// Precondition: the program is in use, and all other uniforms are set.
    float most_level(const Program& program, float wanted, int draws) const;

    /// For the probe `winding`: between these calls, drawing accumulates additively from 0 in the bound framebuffer;
    /// the depth test is off. Each front face adds 1 and each back face subtracts 1, so the sum over a closed surface
    /// seen from outside is 0. end_winding() turns the depth test on and blending off, which is the initial state of a
    /// lab.
    static void begin_winding();
    static void end_winding();

    // The knobs. A lab may set other defaults.
    ReliefMaterial material;
    int shape = sphere, corners_choice = 1, density = 8, repeat = 1;
    int most_density = 128;  ///< maximum of the knob `patches`; not a knob itself
    float depth = 0.1f;      ///< of the relief, in widths of a tile
    glm::dvec3 origin{};     ///< not a knob: the model's position in the world, at any distance

private:
    float tile() const;  ///< width of a tile, metres
    OwnMesh own_{own_radius};
    Mesh mesh() const;

    struct Made {
        PatchMesh patches;
        GpuPatches uploaded;
        float own_metres;  ///< a unit of an own model's uv; 0 for other shapes
    };
    const Made& made() const;
    /// Inputs: shape, corners, density, repeat and version of the own model.
    mutable Kept<Made, int, int, int, int, int> made_;
    mutable std::optional<QueryName> count_;
};

}  // namespace relief
