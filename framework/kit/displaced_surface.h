// The surface that labs 13 and 14 displace: patches of a shape, a height map, and its depth.
#pragma once

#include <optional>

#include "framework/gl/patches.h"
#include "framework/kit/kept.h"
#include "framework/kit/relief_material.h"
#include "framework/lab/lab.h"

namespace relief {

class DisplacedSurface {
public:
    enum Shape { wall, ground, sphere, globe, torus, column, box, urn };
    static constexpr float wall_metres = 2, ground_metres = 16;  ///< sides

    /// The spacings, the positions of vertices at a fractional level: the choices of a lab's knob.
    static constexpr std::array spacings = {"equal", "fractional-odd", "fractional-even"};

    void knobs(Knobs& knobs);

    const PatchMesh& patches() const { return made().patches; }
    const Image& heights() const { return material.heights(); }
    /// Counts up when patches() or heights() change.
    int version() const {
        made();
        return made_.version() + material.version();
    }
    /// Per unit of the shape's own uv; those of the patches are in tiles.
    glm::vec2 tiles() const;
    /// Of the relief, in metres.
    float scale() const { return depth * tile(); }

    /// Whether back faces are never seen from outside.
    bool is_one_sided() const { return shape == ground || patches().is_closed; }

    /// What common/patch_vertex.glsl and the control shader are compiled for: "CORNERS 3" or "CORNERS 4".
    Define corners_define() const { return "CORNERS " + std::to_string(corners()); }
    /// What common/patch_vertex.glsl is compiled for; `spacing` is a place in spacings.
    static Define spacing_define(int spacing);
    int corners() const { return corners_choice == 0 ? 3 : 4; }

    /// u_clip_from_model, u_eye (in the model), u_scale, u_normal_strength, and the material's maps. The program is in
    /// use.
    void set(const Program& program, const Frame& frame) const;
    void draw() const;
    /// The same; how many triangles the tessellator made of it. Waits until they are drawn.
    int draw_and_count() const;

    /// For the probe `winding`: what is drawn in between is added up from 0 on in the bound framebuffer, whatever its
    /// depth. Each front face adds 1, each back face takes 1 away: seen from outside, a closed surface sums up to 0.
    /// Afterwards there is a depth test and no blending, as a lab finds them.
    static void begin_winding();
    static void end_winding();

    // The knobs. A lab may begin with others.
    ReliefMaterial material;
    int shape = sphere, corners_choice = 1, density = 8, repeat = 1;
    int most_density = 128;  ///< that the knob offers; no knob
    float depth = 0.1f;      ///< of the relief, in widths of a tile
    glm::dvec3 origin{};     ///< no knob: where the model stands in the world, however far

private:
    float tile() const;  ///< its width, metres
    Mesh mesh() const;

    struct Made {
        PatchMesh patches;
        GpuPatches uploaded;
    };
    const Made& made() const;
    mutable Kept<Made, int, int, int, int> made_;  ///< by shape, corners, density and repeat
    mutable std::optional<QueryName> count_;
};

}  // namespace relief
