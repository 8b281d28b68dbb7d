// The map of a patch, filtered bilinearly, up to the texels of its gutter.

uniform sampler2D s_map;
uniform ivec2 u_map_corner;
uniform int u_texels;

// Returns the filtered map: normal (not of unit length) or slope in xyz; in w the elevation, or -9 where a task is
// unfinished. Filters by itself: coordinates of a whole texture would be rounded by its size and by the tile's place in
// it, which depend on the patches that earlier pictures had.
vec4 map_mean(vec2 local) {
    vec2 texel = 0.5 + clamp(local, 0.0, 1.0) * float(u_texels), low = floor(texel), share = texel - low;
    ivec2 corner = u_map_corner + ivec2(low);
    vec4 below = mix(texelFetch(s_map, corner, 0), texelFetch(s_map, corner + ivec2(1, 0), 0), share.x);
    vec4 above = mix(texelFetch(s_map, corner + ivec2(0, 1), 0), texelFetch(s_map, corner + ivec2(1, 1), 0), share.x);
    return mix(below, above, share.y);
}

vec4 map_at(vec2 local) {
    vec4 mean = map_mean(local);
    return vec4(normalize(mean.xyz), mean.w);
}
