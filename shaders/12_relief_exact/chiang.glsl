// The guess of a relief's shadow by Chiang, Li and Burley ("Taming the shadow terminator", 2019). A test compares it with
// its twin in double precision, like the functions in common.

// Returns a factor on the light, from 0 to 1, for unit vectors: the normal of the base, the normal of the map, and the
// direction to the light. It falls smoothly to 0 where the light sets behind the base.
float chiang_shadow(vec3 surface, vec3 mapped, vec3 to_light) {
    float g = dot(surface, to_light) / max(dot(mapped, to_light) * dot(surface, mapped), 1e-6);
    g = clamp(g, 0.0, 1.0);
    return g * (1.0 + g * (1.0 - g));
}
