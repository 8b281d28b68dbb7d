// The tessellator between the control and the evaluation stage, on the processor. Needs no GL.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <tuple>
#include <vector>

namespace relief::web {

enum class TessellationSpacing { equal, fractional_odd, fractional_even };

/// The values that a control stage writes into gl_TessLevelOuter and gl_TessLevelInner. A triangle has three outer
/// levels and one inner level; the rest is ignored.
struct TessellationLevels {
    std::array<float, 4> outer{};
    std::array<float, 2> inner{};
    bool operator<(const TessellationLevels& other) const {
        return std::tie(outer, inner) < std::tie(other.outer, other.inner);
    }
};

struct Tessellation {
    std::vector<glm::vec3> points;                   ///< values of gl_TessCoord; z is 0 for a quad
    std::vector<std::array<uint32_t, 3>> triangles;  ///< indices of points, in the order that `ccw` asks for
};

/// Divides a patch as OpenGL 4.1, section 2.12.2, asks for. `corners`: 3 for the domain `triangles`, 4 for `quads`.
/// Levels are clamped to the range of the spacing, up to 64. If an outer level is not above 0 (also if it is not a
/// number), the patch is dropped: the result is empty.
/// All coordinates are multiples of 2^-16. So an edge's points are exactly symmetric, and patches with the same level
/// along a common edge have exactly the same points there.
/// OpenGL leaves open where between its ends a fractional level's short segments lie, and how rings of points are
/// joined. Both are as in the reference for Direct3D 11, which Mesa's llvmpipe has, too.
Tessellation tessellate(int corners, TessellationSpacing spacing, const TessellationLevels& levels);

}  // namespace relief::web
