// The map of a patch, filtered bilinearly, up to the texels of its gutter.

uniform sampler2D s_map;
uniform ivec2 u_map_corner;
uniform int u_texels;

// Returns the filtered map: normal (not of unit length) or slope in xyz; in w the elevation, or -9 where a task is
// unfinished.
vec4 map_mean(vec2 local) {
    vec2 texel = vec2(u_map_corner) + 1.0 + clamp(local, 0.0, 1.0) * float(u_texels);
    return textureLod(s_map, texel / vec2(textureSize(s_map, 0)), 0.0);
}

vec4 map_at(vec2 local) {
    vec4 mean = map_mean(local);
    return vec4(normalize(mean.xyz), mean.w);
}
