// The march of published parallax shaders, in the terms of lab 11, whose march() it replaces. Each march takes steps of
// length 1 / steps until the ray is no longer above the surface.
// - HALVINGS 0: linear intersection, as in LearnOpenGL (de Vries 2014) and three.js (ParallaxShader, kind "occlusion").
// - HALVINGS 5: three.js, kind "relief". Both kinds of three.js are after Dyhta 2013.
// None of them checks whether the ray has left the relief. A step may end past t = 1, and the point before the first
// step may lie before the entry. The linear versions fetch the height before the crossing a second time. texture() can
// return a different height there, because its derivatives differ. So a few pixels end thousands of texels away.
Bracket march(sampler2D heights, ReliefRay ray, float steps) {
    float stride = 1.0 / steps, t = 0.0, above = gap(heights, ray, t);
    for (int i = 0; i < MOST_STEPS && above > 0.0; ++i) {
        t += stride;
        above = gap(heights, ray, t);
    }
#if HALVINGS == 0
    float before = t - stride;
    return Bracket(before, t, gap(heights, ray, before), above);
#else
    float part = 0.5 * stride;
    t -= part;
    for (int i = 0; i < HALVINGS; ++i) {
        part *= 0.5;
        t += gap(heights, ray, t) > 0.0 ? part : -part;
    }
    return Bracket(t, t, 0.0, 0.0);
#endif
}
