#version 410 core
// How open each place is to the sky, as far as the picture knows: in a few planes through the line of sight, the
// horizons among what lies near in the picture (Bavoil and Sainz 2008, Jimenez et al. 2016).

#include "16_environment/task.glsl"

in vec2 v_window;

uniform sampler2D s_surface;  // normal in the camera's space, distance ahead; 0 where there is nothing
uniform vec2 u_half;          // of the picture, one metre ahead
uniform int u_slices;
uniform int u_taps;           // on each side
uniform float u_reach;        // metres
uniform float u_most;         // texels: no tap is farther away

layout(location = 0) out vec4 o_open;  // share, below 0 where the task is missing; distance ahead

const float pi = 3.14159265;

vec3 place_of(vec2 uv, float ahead) { return vec3((2.0 * uv - 1.0) * u_half, -1.0) * ahead; }

void main() {
    vec2 size = vec2(textureSize(s_surface, 0)), uv = gl_FragCoord.xy / size;
    vec4 surface = texelFetch(s_surface, ivec2(gl_FragCoord.xy), 0);
    o_open = vec4(1.0, surface.w, 0.0, 0.0);
    if (surface.w <= 0.0) return;
    vec3 normal = surface.xyz, place = place_of(uv, surface.w), to_eye = -normalize(place);
    float radius = min(u_reach * size.y / (2.0 * u_half.y * surface.w), u_most);
    // Four neighbours look in different directions and at different distances; their mean is taken afterwards.
    ivec2 pixel = ivec2(gl_FragCoord.xy) & 1;
    float turn = float(pixel.x + 2 * (pixel.x ^ pixel.y)) / 4.0;
    float open = 0.0;
    for (int slice = 0; slice < u_slices; ++slice) {
        float angle = (float(slice) + turn) * pi / float(u_slices);
        vec2 way = vec2(cos(angle), sin(angle));
        vec3 along = vec3(way, 0.0) - dot(vec3(way, 0.0), to_eye) * to_eye;
        vec3 axis = normalize(cross(along, to_eye));
        vec3 within = normal - dot(normal, axis) * axis;
        // A normal that faces away is seen edge-on.
        float weight = length(within), cosine = clamp(dot(within, to_eye) / max(weight, 1e-6), 0.0, 1.0);
        float turned = dot(within, along) < 0.0 ? -1.0 : 1.0;
        float g = turned * acos(cosine), sine = turned * sqrt(1.0 - cosine * cosine);
        float horizons[2];
        for (int side = 0; side < 2; ++side) {
            // Nothing hides what lies in front of the surface itself: from g - pi / 2 to g + pi / 2.
            float lowest = side == 0 ? sine : -sine, best = lowest;
            float start = 0.25 + 0.5 * fract(turn + 0.5 * float(side));
            for (int tap = 0; tap < u_taps; ++tap) {
                float share = (float(tap) + start) / float(u_taps);
                float off = max(share * share * radius, float(tap) + 1.0);
                ivec2 at = ivec2(gl_FragCoord.xy + (side == 0 ? -way : way) * off);
                if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, ivec2(size)))) break;
                float ahead = texelFetch(s_surface, at, 0).w;
                vec3 to = place_of((vec2(at) + 0.5) / size, ahead) - place;
                float square = max(dot(to, to), 1e-12), inverse = inversesqrt(square);
                // Fades out over the last fifth of the reach, so that no edge is seen there. And a tap is in the middle of
                // a texel, beside the plane: so what is hardly above the surface may be the surface.
                float counts = ahead > 0.0 ? clamp(5.0 * (1.0 - square * inverse / u_reach), 0.0, 1.0) : 0.0;
                counts *= clamp(40.0 * dot(to, normal) * inverse, 0.0, 1.0);
                best = max(best, mix(lowest, dot(to, to_eye) * inverse, counts));
            }
            horizons[side] = acos(clamp(best, -1.0, 1.0));
        }
        open += weight * open_share(-horizons[0], horizons[1], g);
    }
    o_open.x = is_unfinished ? -1.0 : clamp(open / float(u_slices), 0.0, 1.0);
}
