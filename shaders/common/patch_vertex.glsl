// For the evaluation shader: the undisplaced surface at gl_TessCoord. CORNERS is 3 or 4; SPACING is an argument of
// layout().

#include "common/patch.glsl"
#include "common/patch_corner.glsl"

#if CORNERS == 4
layout(quads, SPACING, ccw) in;
#else
layout(triangles, SPACING, ccw) in;
#endif

in PatchCorner c_corner[];

struct PatchVertex {
    vec3 position;
    vec3 normal;   // for shading; not normalised
    vec4 tangent;  // not normalised
    vec2 uv;
    vec3 direction;  // of displacement; not normalised
    vec2 height_uv;  // uv for the height
    vec2 spacing;
};

#define BLEND(part) blend(weights, c_corner[0].part, c_corner[1].part, c_corner[2].part, c_corner[CORNERS - 1].part)

PatchVertex patch_vertex() {
#if CORNERS == 4
    vec4 weights = quad_weights(gl_TessCoord.xy);
    int edge = edge_of_quad(gl_TessCoord.xy);
#else
    vec4 weights = vec4(gl_TessCoord, 0.0);
    int edge = edge_of_triangle(gl_TessCoord);
#endif
    PatchVertex vertex;
    vertex.position = BLEND(position);
    vertex.normal = BLEND(normal);
    vertex.tangent = BLEND(tangent);
    vertex.uv = BLEND(uv);
    vertex.direction = BLEND(direction);
    vertex.spacing = BLEND(spacing);
    vertex.height_uv = vertex.uv;
    if (edge >= 0) {
        // llvmpipe reads the corners for every vertex, even if edge is -1, so clamp the index.
        int first = max(edge, 0), next = (first + 1) % CORNERS;
        vertex.height_uv = uv_on_edge(weights[first], weights[next], c_corner[first].edge_uv, c_corner[first].height_uv,
                                      c_corner[next].height_uv);
    }
    return vertex;
}
