#version 410 core
// Ambient occlusion in screen space, by horizons: in a few planes through the line of sight it finds the horizons among
// nearby surfaces in the picture (Bavoil et al. 2008, Jimenez et al. 2016).

#include "common/unfinished.glsl"
#include "16_environment/task.glsl"

in vec2 v_clip;

uniform sampler2D s_surface;  // normal in the camera's space, distance ahead; 0 where there is nothing
uniform vec2 u_half;          // half of the picture's size, one metre ahead
uniform int u_slices;
uniform int u_taps;           // on each side
uniform float u_reach;        // metres
uniform float u_most;         // largest distance of a tap, texels

layout(location = 0) out vec4 o_open;  // share, below 0 where the task is unfinished; distance ahead

const float pi = 3.14159265;

vec3 place_of(vec2 uv, float ahead) { return vec3((2.0 * uv - 1.0) * u_half, -1.0) * ahead; }

void main() {
    vec2 size = vec2(textureSize(s_surface, 0)), uv = gl_FragCoord.xy / size;
    vec4 surface = texelFetch(s_surface, ivec2(gl_FragCoord.xy), 0);
    o_open = vec4(1.0, surface.w, 0.0, 0.0);
    if (surface.w <= 0.0) return;
    vec3 normal = surface.xyz, place = place_of(uv, surface.w), to_eye = -normalize(place);
    float radius = min(u_reach * size.y / (2.0 * u_half.y * surface.w), u_most);
    // Four neighbours search in different directions and at different distances. smooth.frag averages them.
    ivec2 pixel = ivec2(gl_FragCoord.xy) & 1;
    float turn = float(pixel.x + 2 * (pixel.x ^ pixel.y)) / 4.0;
    float open = 0.0;
    for (int slice = 0; slice < u_slices; ++slice) {
        float angle = (float(slice) + turn) * pi / float(u_slices);
        vec2 way = vec2(cos(angle), sin(angle));
        vec3 along = vec3(way, 0.0) - dot(vec3(way, 0.0), to_eye) * to_eye;
        vec3 axis = normalize(cross(along, to_eye));
        vec3 within = normal - dot(normal, axis) * axis;
        // A normal that faces away counts as perpendicular to the line of sight.
        float weight = length(within), cosine = clamp(dot(within, to_eye) / max(weight, 1e-6), 0.0, 1.0);
        float turned = dot(within, along) < 0.0 ? -1.0 : 1.0;
        float g = turned * acos(cosine), sine = turned * sqrt(1.0 - cosine * cosine);
        float horizons[2];
        for (int side = 0; side < 2; ++side) {
            // Without occluders the surface itself bounds the horizons: g - pi / 2 and g + pi / 2.
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
                // Occluders fade out over the last fifth of the reach, so that it shows no edge. Taps that are hardly
                // above the surface fade out, too: they may be the surface itself, since a tap is at the centre of a
                // texel beside the slice.
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
