// Reflection of one light of strength 1, including the cosine. All directions have unit length and point away from the
// surface.

// Lambert plus Blinn-Phong (Blinn 1977). The highlight is scaled by (shininess + 8) / 8, so that it gets brighter as it
// gets smaller (Akenine-Moller et al. 2008).
//(blinn-phong
vec3 blinn_phong(vec3 albedo, float specular, float shininess, vec3 normal, vec3 to_light, vec3 to_eye) {
    float facing = max(dot(normal, to_light), 0.0);
    float lobe = pow(max(dot(normal, normalize(to_light + to_eye)), 0.0), shininess);
    return facing * (albedo + specular * (shininess + 8.0) / 8.0 * lobe);
}
//)
