// Lab 16, your tasks: what a polished surface mirrors and how much, how blurred it is, where the sun is hidden, and how
// open a place is to the sky.

#include "common/unfinished.glsl"

// TASK 16.1 (3 points): the direction from which the mirrored light comes. All arguments have unit length and are in
// the world's space; `to_eye` points to the eye, `normal` is the bumped one, `face` that of the surface itself. A bumped
// normal may mirror what lies behind the surface: such a direction is mirrored once more, at the surface, to its front.
//(mirrored
vec3 mirrored(vec3 to_eye, vec3 normal, vec3 face) {
    //[solution
    vec3 from = 2.0 * dot(normal, to_eye) * normal - to_eye;
    return from - 2.0 * min(dot(from, face), 0.0) * face;
    //]starter
    //| return unfinished(face);
    //]
}
//)

// TASK 16.2 (3 points): fresnel() is the share of the light that is mirrored, by Schlick's approximation, where
// `straight` is mirrored head-on. `cosine` is that between direction and normal; below 0 count it as 0.
// sharpness() is the exponent of a surface: `largest` times its gloss. `maps` is a texel of the packed map: gloss is
// red, height green, occlusion blue. `roughness`, from 0 to 1, reduces the gloss: it becomes gloss (1 - roughness).
//(fresnel
float fresnel(float straight, float cosine) {
    //[solution
    float away = 1.0 - clamp(cosine, 0.0, 1.0), squared = away * away;
    return straight + (1.0 - straight) * (squared * squared * away);
    //]starter
    //| return unfinished(straight);
    //]
}

float sharpness(vec3 maps, float roughness, float largest) {
    //[solution
    return largest * maps.r * (1.0 - roughness);
    //]starter
    //| return unfinished(largest);
    //]
}
//)

// TASK 16.3 (3 points): the mip level of a cube map with `side` texels along each edge that is as blurred as a lobe
// cos^exponent. The lobe covers the solid angle 2 pi / (exponent + 1), a texel of level 0 on average 4 pi / (6 side^2).
// Each level's texels are twice as wide as the previous level's. Trilinear filtering blurs, too: half a level less
// is enough. No level is below 0.
//(blur
float blur_level(float exponent, float side) {
    //[solution
    float lobe = 2.0 / (exponent + 1.0), texel = 4.0 / (6.0 * side * side);  // both without pi
    return max(0.0, 0.5 * log2(lobe / texel) - 0.5);
    //]starter
    //| return unfinished(0.0);
    //]
}
//)

// TASK 16.4 (4 points): shadow_bias() returns by how many metres a place has to move towards the sun, so that no plane
// hides itself. The shadow map looks along -z of the light's space; `normal` is the plane's there, its z is above 0 and
// may be tiny: count it as at least 0.001. A texel is `texel` metres wide and holds the depth of its middle. It is
// compared with places up to (radius + 1/2) texels away, along x and along y.
// lit() is the share of (2 radius + 1)^2 texels around a place that do not hide it. `place` is in the light's clip
// space; a texture's coordinates and depths are from 0 to 1. texture(map, vec3(uv, depth)) is 1 where depth is at most
// that of the nearest texel. `bias` is in the map's depths.
//(shadow
float shadow_bias(vec3 normal, float texel, int radius) {
    //[solution
    vec2 slope = normal.xy / max(normal.z, 0.001);
    return (float(radius) + 0.5) * texel * (abs(slope.x) + abs(slope.y));
    //]starter
    //| return unfinished(0.0);
    //]
}

float lit(sampler2DShadow map, vec4 place, float bias, int radius) {
    //[solution
    vec3 middle = place.xyz / place.w * 0.5 + 0.5;
    vec2 texel = 1.0 / vec2(textureSize(map, 0));
    float sum = 0.0;
    for (int row = -radius; row <= radius; ++row)
        for (int column = -radius; column <= radius; ++column)
            sum += texture(map, vec3(middle.xy + vec2(column, row) * texel, middle.z - bias));
    float side = float(2 * radius + 1);
    return sum / (side * side);
    //]starter
    //| return unfinished(1.0);
    //]
}
//)

// TASK 16.5 (4 points): a plane through the line of sight, and in it two horizons, h1 <= 0 <= h2, and the normal's
// projection g: angles from the direction to the eye, radians. Both horizons are in front of the surface, so from
// g - pi / 2 to g + pi / 2. open_share() is the integral of cos(h - g) |sin(h)| over all h between them: 1 where g is 0
// and nothing is higher than the surface. From 0 to x the integral of cos(h - g) sin(h) is
//     (-cos(2 x - g) + cos(g) + 2 x sin(g)) / 4.
//(open
float open_share(float h1, float h2, float g) {
    //[solution
    vec2 ends = vec2(h1, h2);
    vec2 halves = 0.25 * (-cos(2.0 * ends - g) + cos(g) + 2.0 * ends * sin(g));
    return halves.x + halves.y;
    //]starter
    //| return unfinished(1.0);
    //]
}
//)

// TASK 16.6 (1 point): the light that leaves a place, from the light of the sky (`ambient`), of the lamps, and of the
// mirrored sky (`mirror`). `occlusion` is the share of the sky that is visible from there.
//(sum
vec3 sum_of_light(vec3 ambient, vec3 lamps, vec3 mirror, float occlusion) {
    //[solution
    return ambient * occlusion + lamps + mirror;
    //]starter
    //| return unfinished(ambient);
    //]
}
//)
