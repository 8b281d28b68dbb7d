// The triangles of the fine model, and the walk of a ray through their tree.

#include "common/mesh_rays.glsl"
#include "07_baking/ray_mesh.glsl"
#include "common/unfinished.glsl"
#include "07_baking/takes.glsl"
#include "07_baking/task.glsl"

uniform sampler2D s_nodes;
uniform sampler2D s_corners;
uniform sampler2D s_normals;  // u is the turn
uniform int u_nodes;
uniform int u_take;

vec4 row_texel(sampler2D map, int i) { return texelFetch(map, ivec2(i & ((1 << row_bits) - 1), i >> row_bits), 0); }

struct Found {
    float height;  // metres above the coarse model; 1e30 if nothing was found
    vec3 weights;
    int triangle;
};

bool is_better(float height, bool is_front, float best) {
    if (u_take == take_first) return is_front && (best > 1e29 || height > best);
    if (u_take == take_last) return is_front && (best > 1e29 || height < best);
    return takes(height, is_front, best);
}

// Returns the hit that is_better() prefers, within 2 * reach of the ray's origin. Precondition: the direction has unit
// length, since heights are measured along the ray.
Found walk(BakeRay ray, float reach) {
    Found found = Found(1e30, vec3(0.0), 0);
    vec3 inverse = inverse_direction(ray.direction), shear = ray_shear(ray.direction);
    float end = 2.0 * reach;
    int node = 0;
    //(walk
    // The limit is for rays with NaN, which might visit all boxes. No valid ray visits that many.
    for (int visited = 0; visited < 4096 && node < u_nodes; ++visited) {
        vec4 low = row_texel(s_nodes, 2 * node), high = row_texel(s_nodes, 2 * node + 1);
        if (!meets_box(ray.origin, inverse, end, low.xyz, high.xyz)) {
            node = int(low.w);
            continue;
        }
        //)
        //(leaf
        int first = int(high.w) / node_radix, last = first + int(high.w) % node_radix;  // none in an inner node
        for (int i = first; i < last; ++i) {
            vec4 hit = triangle_hit(ray.origin, ray.direction, shear, row_texel(s_corners, 3 * i).xyz,
                                    row_texel(s_corners, 3 * i + 1).xyz, row_texel(s_corners, 3 * i + 2).xyz);
            if (hit.w == 0.0 || hit.x < 0.0 || hit.x > end) continue;
            float height = reach - hit.x;
            if (is_better(height, hit.w > 0.0, found.height))
                found = Found(height, vec3(hit.yz, 1.0 - hit.y - hit.z), i);
        }
        ++node;
    }
    //)
    return found;
}

vec4 vertex_of(int triangle, int corner) {
    return row_texel(s_normals, int(row_texel(s_corners, 3 * triangle + corner).w));
}
