// The map of a patch: bilinear between its texels and those of its gutter.

uniform sampler2D s_map;
uniform ivec2 u_map_corner;
uniform int u_texels;

// xyz: as it was stored; w: elevation, or -9 where a task is unfinished.
vec4 map_mean(vec2 local) {
    vec2 at = clamp(local, 0.0, 1.0) * float(u_texels) + 0.5;
    ivec2 low = min(ivec2(at), ivec2(u_texels));
    vec2 share = at - vec2(low);
    low += u_map_corner;
    vec4 a = texelFetch(s_map, low, 0), b = texelFetch(s_map, low + ivec2(1, 0), 0);
    vec4 c = texelFetch(s_map, low + ivec2(0, 1), 0), d = texelFetch(s_map, low + ivec2(1, 1), 0);
    vec4 mean = mix(mix(a, b, share.x), mix(c, d, share.x), share.y);
    if (min(min(a.w, b.w), min(c.w, d.w)) < -8.0) mean.w = -9.0;
    return mean;
}

vec4 map_at(vec2 local) {
    vec4 mean = map_mean(local);
    return vec4(normalize(mean.xyz), mean.w);
}
