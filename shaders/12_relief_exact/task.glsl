// Lab 12, your tasks: how far a ray may go before it must read again, and the results of the hit.

#include "common/unfinished.glsl"

// A ray over the height map, in texels from the centre of the map's first texel (so that cell (0, 0) lies between 0 and 1)
// and in heights. At t it is over start + t * along, and height.x + t * height.y + t * t * height.z high: on a flat base a
// view ray has (1, -1, 0), from the top of the relief at t = 0 to its ground at t = 1.
struct ReliefRay {
    vec2 start;
    vec2 along;
    vec3 height;
};

// TASK 12.1 (3 points): the ray is in the square from `low` to `low` + `side` (texels). At which t does it leave it
// along u, through the right or the left wall, whichever lies ahead, and at which t along v? (It leaves at the smaller
// of the two.) `inverse` is 1 / ray.along, finite and never 0: its sign says which wall lies ahead, also along an axis
// on which the ray does not move.
vec2 leave_square(ReliefRay ray, vec2 inverse, vec2 low, float side) {
    //[solution
    vec2 wall = low + side * step(0.0, inverse);
    return (wall - ray.start) * inverse;
    //]starter
    //| return unfinished(vec2(1.0));
    //]
}

// TASK 12.2 (4 points): skip cells that cannot be hit. The ray is about to leave its cell at `leaves_cell`. Around it
// are four windows. Nothing in window k is as high as the ray until t = above_until[k], and the ray is in that window
// until t = leaves_window[k]: while both hold there is nothing to hit. How far may it go? At least to leaves_cell;
// each window may allow more.
//(next-look
float next_look(float leaves_cell, vec4 leaves_window, vec4 above_until) {
    //[solution
    vec4 safe = min(leaves_window, above_until);
    return max(max(leaves_cell, max(safe.x, safe.y)), max(safe.z, safe.w));
    //]starter
    //| return unfinished(leaves_cell);
    //]
}
//)

// TASK 12.3 (3 points): the ray from the hit towards the light, to see whether the relief shadows itself. `hit` is the
// position of the hit (texels, as in ReliefRay) and its height; `to_light` the direction to the light in tangent
// space; `depth` a height of 1, in texels along u and along v. At t = 1 the ray must be at height 1: no height is
// above that. The light is above the horizon: to_light.z > 0.
//(shadow
ReliefRay shadow_ray(vec3 hit, vec3 to_light, vec2 depth) {
    //[solution
    float rise = 1.0 - hit.z;
    return ReliefRay(hit.xy, to_light.xy / to_light.z * depth * rise, vec3(hit.z, rise, 0.0));
    //]starter
    //| return ReliefRay(hit.xy, unfinished(vec2(0.0)), vec3(hit.z, 1.0 - hit.z, 0.0));
    //]
}
//)

// TASK 12.4 (2 points): the depth for the depth test, for a point of the world: 0 at the near plane, 1 at the far one,
// as the rasteriser computes it (glDepthRange is 0 to 1).
float window_depth(vec3 world, mat4 clip_from_world) {
    //[solution
    vec4 clip = clip_from_world * vec4(world, 1.0);
    return 0.5 + 0.5 * clip.z / clip.w;
    //]starter
    //| return unfinished(gl_FragCoord.z);
    //]
}

// TASK 12.5 (3 points): a curved base. Seen from the fragment, a cylinder of radius `radius` (metres) falls away below
// its tangent plane by x * x / (2 * radius) at the distance x along the tangent. So a view ray that moves `across`
// metres along the tangent from t = 0 to t = 1 gains height over the base. By how much at t = 1, in heights
// (`depth_metres` each)? That is the ray's height.z: the ray sinks ever more slowly, and may turn up and leave the
// relief without a hit.
float bend(float across, float radius, float depth_metres) {
    //[solution
    return across * across / (2.0 * radius * depth_metres);
    //]starter
    //| return unfinished(0.0);
    //]
}

// TASK 12.6 (2 points): a guess of the relief's shadow without a search, from three unit vectors: the normal of the base,
// the normal of the map, and the direction to the light, which is above the base. A low lamp is blocked the more, the
// steeper the map is (Conty Estevez, Lecocq and Stein 2019). With c = |surface . mapped| and l = surface . to_light:
//     a = (1 - c^2) / (8 c^2), but at most 1        t = (1 - l^2) / l^2        2 / (1 + sqrt(1 + a t))
// c and l may be 0: count each as 1e-6 at least, so that the result is finite.
//(guess
float guessed_shadow(vec3 surface, vec3 mapped, vec3 to_light) {
    //[solution
    float c = max(abs(dot(surface, mapped)), 1e-6), l = max(dot(surface, to_light), 1e-6);
    float a = min((1.0 - c * c) / (8.0 * c * c), 1.0), t = (1.0 - l * l) / (l * l);
    return 2.0 / (1.0 + sqrt(1.0 + max(a, 0.0) * max(t, 0.0)));
    //]starter
    //| return unfinished(1.0);
    //]
}
//)
