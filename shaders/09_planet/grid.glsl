// The grids of the planet: by equal angles (task 9.1), gnomonic, or by latitude and longitude.

#include "common/unfinished.glsl"
#include "09_planet/task.glsl"

#if defined LAT_LONG
vec3 grid_direction(mat3 face, vec2 st) {
    vec2 angles = radians(90.0) * st;  // longitude from the middle of the half, latitude
    return face * vec3(cos(angles.y) * sin(angles.x), sin(angles.y), cos(angles.y) * cos(angles.x));
}
#elif defined GNOMONIC
vec3 grid_direction(mat3 face, vec2 st) { return direction(face, atan(st) / radians(45.0)); }
#else
vec3 grid_direction(mat3 face, vec2 st) { return direction(face, st); }
#endif

// Returns the grid's tangents dr/ds and dr/dt in u and v, by central differences.
void grid_tangents(mat3 face, vec2 st, out vec3 u, out vec3 v) {
    const float e = 1.0 / 256.0;
    u = (grid_direction(face, st + vec2(e, 0.0)) - grid_direction(face, st - vec2(e, 0.0))) / (2.0 * e);
    v = (grid_direction(face, st + vec2(0.0, e)) - grid_direction(face, st - vec2(0.0, e))) / (2.0 * e);
}
