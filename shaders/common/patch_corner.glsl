// A corner of a patch as it goes from the vertices to the control shader and on to the evaluation shader. What two patches
// share, both know in the same bits: see framework/mesh/patches.h.

struct PatchCorner {
    vec3 position, normal;
    vec4 tangent;
    vec2 uv;
    vec3 direction;  // of unit length: the direction of displacement; the same for all corners that meet here
    vec2 height_uv;  // where this corner reads its height
    vec4 edge_uv;    // the same along the edge from here to the next corner: here (xy) and there (zw)
    vec2 spacing;    // mean length of the edges that meet here: metres, and units of uv
};
