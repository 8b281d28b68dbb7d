// The sky's cube map. The sun's azimuth in it is +z, so the map turns with the light.

uniform samplerCube s_sky;
uniform vec2 u_sun;  // sine and cosine of the sun's yaw

vec3 sky_at(vec3 direction, float level) {
    vec3 turned = vec3(u_sun.y * direction.x - u_sun.x * direction.z, direction.y,
                       u_sun.x * direction.x + u_sun.y * direction.z);
    return textureLod(s_sky, turned, level).rgb;
}

// Compresses bright light to values below 1. It keeps some of its colour.
vec3 exposed(vec3 light) { return 1.0 - exp(-1.5 * light); }
