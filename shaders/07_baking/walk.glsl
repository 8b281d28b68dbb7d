// The fine model's triangles, and the way of a ray through the tree over them. All are textures 1024 texels wide.

#include "common/mesh_rays.glsl"
#include "07_baking/task.glsl"

uniform sampler2D s_nodes;    // two texels a node: low, where to go on after a miss; high, a leaf's triangles
uniform sampler2D s_corners;  // three texels a triangle: position, and which vertex it is
uniform sampler2D s_normals;  // a texel a vertex: normal and turn
uniform int u_nodes;
uniform int u_take;           // the nearest hit, the first, or the last

vec4 row_texel(sampler2D map, int i) { return texelFetch(map, ivec2(i & 1023, i >> 10), 0); }

struct Found {
    float height;  // metres above the coarse model; 1e30 if nothing was found
    vec3 weights;
    int triangle;
};

bool is_better(float height, bool is_front, float best) {
    if (u_take == 1) return is_front && (best > 1e29 || height > best);
    if (u_take == 2) return is_front && (best > 1e29 || height < best);
    return takes(height, is_front, best);
}

// What `ray` meets within 2 * reach of its origin. Heights are measured along it, so its direction must be unit.
Found walk(BakeRay ray, float reach) {
    Found found = Found(1e30, vec3(0.0), 0);
    vec3 inverse = inverse_direction(ray.direction), shear = ray_shear(ray.direction);
    float end = 2.0 * reach;
    int node = 0;
    //(walk
    // No ray that leads somewhere looks at so many boxes; one that is not a number might look at all.
    for (int visited = 0; visited < 4096 && node < u_nodes; ++visited) {
        vec4 low = row_texel(s_nodes, 2 * node), high = row_texel(s_nodes, 2 * node + 1);
        if (!meets_box(ray.origin, inverse, end, low.xyz, high.xyz)) {
            node = int(low.w);
            continue;
        }
        int first = int(high.w) / 8, last = first + int(high.w) % 8;  // none in an inner node
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
