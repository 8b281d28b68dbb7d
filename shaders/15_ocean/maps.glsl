// The two wave maps, and their placement on the water.

const float map_texels = 256.0, tile_metres = 16.0;

uniform sampler2D s_waves_1, s_waves_2;      // slopes along x and z, height
uniform sampler2D s_moments_1, s_moments_2;  // squared slopes and their product
uniform sampler2D s_normals_1, s_normals_2;

uniform vec2 u_amplitude;     // metres of significant wave height
uniform vec2 u_tiles;         // tiles per tile_metres
uniform vec4 u_offset;        // uv of both maps below the eye, tiles
uniform float u_level;

// `place` is in metres from the eye, so that uv near the eye keep the precision of a float.
vec2 map_uv(vec2 place, int map) {
    return map == 0 ? u_offset.xy + u_tiles.x / tile_metres * place : u_offset.zw + u_tiles.y / tile_metres * place;
}

// Returns the mip level whose texels are half a segment wide.
float level_of(float segment, int map) {
    float tiles = map == 0 ? u_tiles.x : u_tiles.y;
    return max(0.0, log2(0.5 * segment * tiles * map_texels / tile_metres));
}

vec3 read_map(sampler2D map, vec2 uv) {
#ifdef ONE_LEVEL
    return textureLod(map, uv, u_level).xyz;
#else
    return texture(map, uv).xyz;
#endif
}
