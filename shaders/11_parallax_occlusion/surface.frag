#version 410 core
// A relief by parallax occlusion mapping: lit, or the distance of the march's end from the exact hit, in texels.

#include "common/heat.glsl"
#include "common/light.glsl"
#include "common/srgb.glsl"

// A search reads heights by this function only, which counts the reads. IMPLICIT shows the common mistake of letting
// texture() choose a mip level by derivatives.
int heights_read = 0;
vec4 height_texel(sampler2D heights, vec2 uv, float level) {
    ++heights_read;
#ifdef IMPLICIT
    return texture(heights, uv);
#else
    return textureLod(heights, uv, level);
#endif
}
#define textureLod height_texel
#include "common/unfinished.glsl"
#include "11_parallax_occlusion/task.glsl"
#undef textureLod

#include "11_parallax_occlusion/bounds.glsl"
#if defined ERROR || defined MEASURE
#include "common/exact_hit.glsl"
#endif

in vec3 v_position;
in vec3 v_normal;
in vec4 v_tangent;
in vec2 v_uv;

uniform sampler2D s_heights;
uniform sampler2D s_albedo;
uniform sampler2D s_normals;
uniform sampler2DArray s_windows;  // for the exact hit
uniform mat4 u_window_extent;

uniform vec3 u_eye;
uniform vec3 u_to_light;  // unit
uniform vec2 u_depth;     // of the relief, in tiles along u and v
uniform float u_depth_metres;
uniform vec2 u_normal_strength;

uniform float u_steps;
uniform float u_min_steps;
uniform float u_texels_per_step;
uniform int u_rounds;
uniform float u_level_bias;  // added to the mip level when a smaller picture is measured
uniform bool u_skip;         // marches that would not show
uniform float u_decal;       // opacity of the paint on the pane

layout(location = 0) out vec4 o_color;

const float least_slant = 0.002;  // lower bound: a flatter ray would cross more tiles than a float can resolve

// Returns whether all of the relief below the march has one height, by a single fetch. It reads the level whose texels
// are as wide as the march, or the whole map if the march crosses a border of these texels.
bool is_flat(ReliefRay ray, vec2 size, out float height) {
    // Cells begin at texel centres. A texel of a coarser mip level averages its neighbourhood.
    float margin = ray.level > 0.0 ? exp2(ceil(ray.level)) : 0.01;
    vec2 from = ray.uv * size - 0.5, to = from + ray.march * size;
    vec2 low = min(from, to) - margin, high = max(from, to) + margin;
    float widest = max(max(high.x - low.x, high.y - low.y), 1.0);
    int level = min(int(ceil(log2(widest))), highest_level(s_heights));
    vec2 texels = vec2(bounds_size(s_heights, level)), texel = floor(low / size * texels);
    bool inside = texel == floor(high / size * texels);
    vec2 bounds = inside ? bounds_at(s_heights, ivec2(mod(texel, texels)), level)
                         : bounds_at(s_heights, ivec2(0), highest_level(s_heights));
    height = bounds.g;
    return bounds.r == bounds.g;
}

float steps_of(ReliefRay ray, vec2 size) {
#if defined BY_ANGLE
    return steps_by_angle(ray.slant, u_min_steps, u_steps);
#elif defined BY_TEXEL
    return steps_by_texel(ray, size, u_texels_per_step);
#else
    return u_steps;
#endif
}

//(marched
float marched(ReliefRay ray, vec2 size) {
    Bracket b = march(s_heights, ray, steps_of(ray, size));
#if REFINE == 0
    return b.after;
#else
#if REFINE > 1
    b = refined(s_heights, ray, b, u_rounds, REFINE);
#endif
    return mix(b.before, b.after, crossing(b.gap_before, b.gap_after));
#endif
}
//)

// Returns the t of the hit; 0, the entry, if there is no relief.
float seen(ReliefRay ray, bool has_relief) {
    if (!has_relief) return 0.0;
    vec2 size = vec2(textureSize(s_heights, 0));
    if (u_skip) {
        //(skip
        // No march where it would not show: over less than half a texel of the level read, or over flat ground.
        float height;
        if (length(ray.march * size) < 0.5 * exp2(ray.level)) return 1.0 - height_texel(s_heights, ray.uv, ray.level).r;
        if (is_flat(ray, size, height)) return 1.0 - height;
        //)
    }
    return marched(ray, size);
}

// A ring and a cross, white paint on a pane of glass.
float painted(vec2 uv) {
    vec2 place = fract(uv) - 0.5, pixel = fwidth(uv);
    float soft = max(max(pixel.x, pixel.y), 1e-4), r = length(place);
    float ring = clamp((0.035 - abs(r - 0.36)) / soft + 0.5, 0.0, 1.0);
    float arm = min(abs(place.x), abs(place.y));
    float cross_ = clamp((0.02 - arm) / soft + 0.5, 0.0, 1.0) * clamp((0.27 - r) / soft + 0.5, 0.0, 1.0);
    return max(ring, cross_);
}

void main() {
    vec3 normal = normalize(v_normal);
    vec3 bitangent = v_tangent.w * normalize(cross(normal, v_tangent.xyz));
    vec3 tangent = v_tangent.w * cross(bitangent, normal);
    float distance_ = distance(u_eye, v_position);
    vec3 to_eye = distance_ > 0.0 ? (u_eye - v_position) / distance_ : normal;
    float cosine = dot(to_eye, normal), slant = max(cosine, least_slant);
    bool has_relief = cosine > 0.0 && u_depth_metres > 0.0;

    // The vector from the fragment to the ray's hit with the ground plane, then in uv.
    vec3 to_ground = -to_eye * (u_depth_metres / slant);
    vec2 tiles_per_metre = u_depth_metres > 0.0 ? u_depth / u_depth_metres : vec2(0.0);
    ReliefRay ray = ReliefRay(v_uv, vec2(dot(to_ground, tangent), dot(to_ground, bitangent)) * tiles_per_metre, slant, 0.0);
#ifdef FOOTPRINT
    // Not textureQueryLod(), of which each driver has its own.
    vec2 texels = v_uv * vec2(textureSize(s_heights, 0)), right = dFdx(texels), up = dFdy(texels);
    ray.level = max(0.0, 0.5 * log2(max(max(dot(right, right), dot(up, up)), 1e-30)) + u_level_bias);
#endif
    float t = seen(ray, has_relief);
    vec2 uv = v_uv + t * ray.march;

#if defined ERROR || defined MEASURE
    float exact = has_relief ? exact_hit(s_heights, s_windows, u_window_extent, v_uv, ray.march, vec2(0.0, 1.0)) : 0.0;
    float off = abs(t - exact) * length(ray.march * vec2(textureSize(s_heights, 0)));  // texels
#endif
#if defined PROBE_uv
    o_color = probed(vec4(uv * vec2(textureSize(s_heights, 0)), 0.0, 0.0));
#elif defined PROBE_depth
    o_color = probed(vec4(distance_ + t * u_depth_metres / slant, 0.0, 0.0, 0.0));
#elif defined PROBE_steps
    o_color = probed(vec4(float(heights_read), 0.0, 0.0, 0.0));
#elif defined PROBE_count
    o_color = probed(vec4(steps_of(ray, vec2(textureSize(s_heights, 0))), 0.0, 0.0, 0.0));
#elif defined MEASURE
    o_color = measured(vec4(off, float(heights_read), 0.0, -1.0));
#elif defined ERROR
    o_color = finished(vec4(log_heat(off, -2.0, 2.0), 1.0), gl_FragCoord.xy);
#else
    vec3 stored = on_surface(s_normals, v_uv, uv).xyz * 2.0 - 1.0;
    vec3 relief = normalize(vec3(stored.xy * u_normal_strength, max(stored.z, 0.01)));
    vec3 bumped = normalize(mat3(tangent, bitangent, normal) * relief);
    vec3 albedo = on_surface(s_albedo, v_uv, uv).rgb;
    vec3 light = albedo * mix(vec3(0.10, 0.09, 0.09), vec3(0.26, 0.29, 0.35), 0.5 + 0.5 * bumped.y) * (1.0 - 0.6 * t);
    light += vec3(1.5, 1.38, 1.2) * blinn_phong(albedo, 0.04, 24.0, bumped, u_to_light, to_eye);
    light = mix(light, vec3(0.85, 0.87, 0.82), u_decal * painted(above_surface(v_uv, uv)));
    o_color = finished(vec4(srgb_from_linear(light), 1.0), gl_FragCoord.xy);
#endif
}
