// A march by relaxed cones (Policarpo and Oliveira 2007): 15 steps to the walls of cones that may cut the surface, then 8
// bisections. Unlike the other methods it is not exact: the crossing that it finds need not be the first one, and 15 steps
// need not reach the surface.

uniform sampler2D s_relaxed;  // radius of the cone above a texel, texels per unit of height

vec2 relaxed_uv(ReliefRay ray, float t) { return (ray.start + t * ray.along + 0.5) / vec2(textureSize(s_heights, 0)); }

float relaxed_gap(ReliefRay ray, float t) {
    return height_of(ray, t) - textureLod(s_heights, relaxed_uv(ray, t), 0.0).r;
}

//(relaxed
// Returns the t at which the ray leaves the cone above its texel. Until then it may have entered the surface.
float leave_cone(ReliefRay ray, float t, float gap) {
    float cone = textureLod(s_relaxed, relaxed_uv(ray, t), 0.0).r, wall = length(ray.along) / max(cone, 1e-9);
    float falls = -(ray.height.y + 2.0 * t * ray.height.z);
    return t + gap / max(falls + wall, 1e-9);
}
//)

// As first_hit() of search.glsl. The hit is the last place above the surface, so that it does not shade itself.
ReliefHit first_hit(ReliefRay ray, bool plain, float t, float t_end, int before) {
    const int steps = 15, bisections = 8;
    float above = t, gap = relaxed_gap(ray, t);
    int i = 0;
    for (; i < steps && gap > 0.0 && t < t_end; ++i) {
        above = t;
        t = min(leave_cone(ray, t, gap), t_end);
        gap = relaxed_gap(ray, t);
    }
    if (gap > 0.0) return ReliefHit(t, t >= t_end, t < t_end, i + 1);
    float below = t;
    for (int k = 0; k < bisections; ++k) {
        float middle = 0.5 * (above + below);
        if (relaxed_gap(ray, middle) > 0.0) above = middle; else below = middle;
    }
    return ReliefHit(above, false, false, i + 1 + bisections);
}
