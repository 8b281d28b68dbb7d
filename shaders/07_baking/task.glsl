// Lab 07, your tasks: bake the normals of a fine model into the map of a coarse one, and show them.

#include "common/unfinished.glsl"

struct BakeRay {
    vec3 origin, direction;
};

// TASK 7.1 (3 points): the ray of a texel. `position` is its place on the coarse model, `normal` the interpolated one,
// which is not of unit length. The ray begins at a distance of `reach` outside, on the cage, and its direction (of unit
// length) leads inwards, through `position`. The lab follows it for a distance of 2 * reach.
//(ray
BakeRay bake_ray(vec3 position, vec3 normal, float reach) {
    //[solution
    vec3 outwards = normalize(normal);
    return BakeRay(position + reach * outwards, -outwards);
    //]starter
    //| return BakeRay(unfinished(position), vec3(0.0, 0.0, 1.0));
    //]
}
//)

// TASK 7.2 (3 points): the ray meets several triangles. Is this one to be taken in place of the best one so far?
// `height` is where it was met, in metres above the coarse model (below it: negative), `is_front` whether the ray comes
// from outside of the fine model there, and `best` the height of the best one so far, or 1e30 if there is none yet. The
// right one is seen from its front, and of these it is nearest to the coarse model, above it or below.
//(takes
bool takes(float height, bool is_front, float best) {
    //[solution
    return is_front && abs(height) < abs(best);
    //]starter
    //| return unfinished(0.0) > 0.5;
    //]
}
//)

// TASK 7.3 (2 points): the texel of an object-space map: the fine model's normal at the hit, of unit length. `a`, `b`
// and `c` are the normals at the corners of the triangle, `weights` the hit's barycentric coordinates in it.
vec3 object_texel(vec3 a, vec3 b, vec3 c, vec3 weights) {
    //[solution
    return normalize(weights.x * a + weights.y * b + weights.z * c);
    //]starter
    //| return unfinished(vec3(0.0, 0.0, 1.0));
    //]
}

// TASK 7.4 (4 points): the texel of a tangent-space map: the normal n in the frame F = (T, w (N x T), N), that is,
// F^-1 n, made unit at the end. T (`tangent.xyz`) and N (`normal`) are interpolated, and the renderer takes them as
// they are: neither of unit length nor perpendicular. So the transpose is not the inverse. The rows of the inverse are,
// but for a common factor, cross(B, N), cross(N, T) and cross(T, B). Mind the factor's sign.
//(stored
vec3 stored_normal(vec3 n, vec4 tangent, vec3 normal) {
    //[solution
    vec3 t = tangent.xyz, b = tangent.w * cross(normal, t);
    float side = dot(cross(t, b), normal) < 0.0 ? -1.0 : 1.0;
    return normalize(side * vec3(dot(n, cross(b, normal)), dot(n, cross(normal, t)), dot(n, cross(t, b))));
    //]starter
    //| return unfinished(vec3(0.0, 0.0, 1.0));
    //]
}
//)

// TASK 7.5 (2 points): the other way round: the normal on the model, of unit length, for a texel of the map (`stored`,
// each component from -1 to 1). The frame is that of 7.4, as it is interpolated.
//(shown
vec3 shown_normal(vec3 stored, vec4 tangent, vec3 normal) {
    //[solution
    vec3 along_v = cross(normal, tangent.xyz) * tangent.w;
    return normalize(tangent.xyz * stored.x + along_v * stored.y + normal * stored.z);
    //]starter
    //| return unfinished(normalize(normal));
    //]
}
//)

// TASK 7.6 (3 points): one step of padding. In `texel`, and in the eight `around` it, w is 1 where a triangle covers
// the texel (or where a step before has filled it), else 0. A covered texel stays as it is. One that is not becomes the
// mean of its covered neighbours, with w = 1; where there is none it stays as it is.
//(padded
vec4 padded(vec4 texel, vec4 around[8]) {
    //[solution
    if (texel.w > 0.0) return texel;
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 8; ++i)
        if (around[i].w > 0.0) sum += vec4(around[i].xyz, 1.0);
    return sum.w > 0.0 ? vec4(sum.xyz / sum.w, 1.0) : texel;
    //]starter
    //| return unfinished(texel);
    //]
}
//)
