// The surface of labs 10 to 12: a mesh, a height map, and the mapping between them.
#pragma once

#include <vector>

#include "framework/core/lab/lab.h"
#include "framework/library/kit/kept.h"
#include "framework/library/kit/own_mesh.h"
#include "framework/library/kit/relief_material.h"
#include "framework/library/maps/skips.h"
#include "framework/library/mesh/relief.h"

namespace relief {

/// Reads assets/urn.obj, with exact tangents. Its uv go once around the urn, and once up.
Mesh read_urn();

class ReliefSurface {
public:
    enum Shape { wall, column, urn, own };
    static constexpr float column_radius = 0.5f, column_height = 2;  ///< metres
    static constexpr double own_radius = 1.2;  ///< half the diagonal of an own model's bounding box, metres

    void knobs(Knobs& knobs);

    const Image& heights() const { return material.heights(); }
    const Mesh& mesh() const { return shaped().mesh; }
    ReliefMapping mapping() const;
    /// Increases when heights() or an own model's mesh() change.
    int version() const { return material.version() + own_.version(); }

    /// Returns the inputs of mesh(), for Studio::draw().
    std::vector<double> studio_inputs() const { return {double(shape), extent, double(own_.version())}; }

    /// Sets the uniforms of shaders/common/relief.vert and the stages after it. Binds s_heights to unit 0, s_albedo to
    /// 1, s_normals to 2. Preconditions: the program is in use, and the viewport is the frame's.
    void set(const Program& program, const Frame& frame, const glm::dmat4& world_from_model = glm::dmat4(1)) const;
    void draw() const;
    /// The windows of the heights, and their texture: a layer for each octant.
    struct Windows {
        HeightWindows heights;
        Texture texture;
    };
    /// Returns the windows of heights(), made again when these have changed. Throws as height_windows() does.
    const Windows& windows() const;
    /// Sets the inputs of exact_hit() in shaders/common/exact_hit.glsl: s_windows on `unit`, and u_window_extent. Does
    /// nothing if the permutation does not use them.
    void set_exact_hit(const Program& program, int unit) const;

    // The knobs. A lab may set other defaults.
    ReliefMaterial material;
    int shape = wall, repeat = 1;
    float depth = 0.08f;  ///< of the relief, in tiles along u
    float stretch = 1;    ///< height of a tile divided by its width: not 1 for texels that are not square
    float extent = 4;     ///< side of the wall, metres
    bool mirror = false;
    int shift = 0;  ///< tiles; mapping() returns the remainder of dividing by 4

private:
    /// Sets the view rays of a wall by pixel, for shaders/12_relief_exact/surface.frag. Does nothing if the program has
    /// no such uniform.
    void set_view_ray(const Program& program, const Frame& frame, const glm::dmat4& world_from_model) const;

    struct Shaped {
        Mesh mesh;
        GpuMesh uploaded;
        float own_metres;  ///< a unit of an own model's uv; 0 for other shapes
    };
    const Shaped& shaped() const;
    OwnMesh own_{own_radius};
    mutable Kept<Shaped, int, float, int> shaped_;  ///< inputs: shape, extent and version of the own model
    mutable Kept<Windows, int> windows_;            ///< input: version()
};

}  // namespace relief
