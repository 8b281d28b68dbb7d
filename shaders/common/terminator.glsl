// The bump terminator: what replaces the missing shadow of a normal map, from directions alone. All of them are unit
// vectors: the normal of the base, the normal of the map, and the direction to the light. Each function has a twin in
// double precision.

#include "common/light.glsl"

// A factor on the light, from 0 to 1, by Chiang, Li and Burley ("Taming the shadow terminator", 2019). It falls smoothly
// to 0 where the light sets behind the base.
float chiang_shadow(vec3 surface, vec3 mapped, vec3 to_light) {
    float g = dot(surface, to_light) / max(dot(mapped, to_light) * dot(surface, mapped), 1e-6);
    g = clamp(g, 0.0, 1.0);
    return g * (1.0 + g * (1.0 - g));
}

// The share of the mapped facet that is visible along `way`: see schuessler_light().
float visible_share(vec3 surface, vec3 mapped, vec3 other, float sine, vec3 way) {
    float area = max(dot(mapped, way), 0.0) + sine * max(dot(other, way), 0.0);
    return area > 0.0 ? min(dot(surface, way) * dot(surface, mapped) / area, 1.0) : 1.0;
}

// The cosine of the light on the mapped facet, straight from the lamp (x) and by way of a second facet, an upright mirror
// that completes it to a surface (y). Seen from straight above the base. By Schuessler, Heitz, Hanika and Dachsbacher
// ("Microfacet-based normal mapping for robust Monte Carlo path tracing", 2017).
vec2 schuessler_light(vec3 surface, vec3 mapped, vec3 to_light) {
    float upright = dot(mapped, surface);
    float above = dot(to_light, surface);
    if (min(upright, above) <= 0.0) return vec2(0.0);
    vec3 lean = mapped - upright * surface;
    float sine = length(lean);
    if (sine < 1e-6) return vec2(above, 0.0);
    vec3 other = -lean / sine;
    float direct = visible_share(surface, mapped, other, sine, to_light);
    float on_other = dot(other, to_light), mirrored = 0.0;
    if (on_other > 0.0) {
        vec3 way = to_light - 2.0 * on_other * other;
        mirrored = max(dot(mapped, way), 0.0) * (1.0 - visible_share(surface, mapped, other, sine, way)) * direct;
    }
    return vec2(max(dot(mapped, to_light), 0.0) * direct, mirrored);
}

// blinn_phong() of common/light.glsl on two facets: both ways of the light are diffuse, the direct one has a highlight.
vec3 blinn_phong_on_facets(vec3 albedo, float specular, float shininess, vec3 surface, vec3 mapped, vec3 to_light,
                           vec3 to_eye) {
    vec2 light = schuessler_light(surface, mapped, to_light);
    float visible = light.x / max(dot(mapped, to_light), 1e-6);
    return albedo * (light.x + light.y) +
           visible * blinn_phong(vec3(0.0), specular, shininess, mapped, to_light, to_eye);
}
