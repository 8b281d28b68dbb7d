// Reflection of one light of strength 1 by GGX, including the cosine (Walter and others 2007).
// All directions have unit length and point away from the surface.

// Lambert plus GGX, for the exponent of a Blinn-Phong highlight of about the same width: alpha^2 = 2 / (shininess + 2).
// `specular` is the share that is mirrored; as in blinn_phong() it does not grow towards the horizon. Facets hide each
// other after Smith, where light and eye see them at correlated heights (Heitz 2014).
//(ggx
vec3 ggx(vec3 albedo, float specular, float shininess, vec3 normal, vec3 to_light, vec3 to_eye) {
    float a2 = 2.0 / (shininess + 2.0);
    float l = max(dot(normal, to_light), 0.0), v = max(dot(normal, to_eye), 1e-4);  // v: a normal may face away
    float h = max(dot(normal, normalize(to_light + to_eye)), 0.0), spread = 1.0 + h * h * (a2 - 1.0);
    float facets = a2 / (spread * spread);  // pi D
    float hidden = l * sqrt(a2 + (1.0 - a2) * v * v) + v * sqrt(a2 + (1.0 - a2) * l * l);
    return l * (albedo + specular * facets * 0.5 / hidden);
}
//)
