// Light on a surface: from the sky and the ground, from the sun, and from the lamp.

uniform vec3 u_to_sun;
uniform vec3 u_sun;
uniform vec3 u_sky;
uniform vec3 u_ground;
uniform vec3 u_lamp_light;

/// Returns diffuse light and a Blinn-Phong highlight; `shine` has its colour and its exponent. A thin surface (glass)
/// is lit diffusely from both sides.
vec3 light_from(vec3 to_light, vec3 light, vec3 normal, vec3 to_eye, vec3 color, vec4 shine, bool is_thin) {
    float facing = dot(normal, to_light);
    vec3 diffuse = color * light * (is_thin ? abs(facing) : max(facing, 0.0));
    if (facing <= 0.0 || shine.rgb == vec3(0.0)) return diffuse;
    float gloss = pow(max(dot(normal, normalize(to_light + to_eye)), 0.0), shine.a);
    return diffuse + shine.rgb * light * gloss * facing;
}

vec3 shaded(vec3 place, vec3 normal, vec3 to_eye, vec3 color, vec4 shine, bool is_thin) {
    vec3 light = color * mix(u_ground, u_sky, 0.5 + 0.5 * normal.y);
    light += light_from(u_to_sun, u_sun, normal, to_eye, color, shine, is_thin);
#ifdef LAMP
    vec3 from_lamp = place - u_lamp;
    float share = lamp_share(from_lamp);
    if (share > 0.0) {
        float away = max(length(from_lamp), 1e-6);
        light += light_from(-from_lamp / away, share * u_lamp_light, normal, to_eye, color, shine, is_thin);
    }
#endif
    return light;
}
