// A corner of a patch, passed from the vertex shader to the control and evaluation shaders. Values that two patches
// share are bit-identical in both: see framework/library/mesh/patches.h.

struct PatchCorner {
    vec3 position, normal;
    vec4 tangent;
    vec2 uv;
    vec3 direction;  // unit direction of displacement; the same for all corners that meet here
    vec2 height_uv;  // uv at which this corner reads its height
    vec4 edge_uv;    // height uv along the edge to the next corner: here (xy) and there (zw)
    vec2 spacing;    // mean length of the edges that meet here: in metres, and in units of uv
};
