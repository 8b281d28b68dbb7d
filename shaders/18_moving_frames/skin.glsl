// The skin of lab 18: its shape at rest, its weights and its bones. The twin in double precision is
// labs/18_moving_frames/skin.cpp.

uniform vec4 u_body;  // length, radius, joints, length of a joint; metres
uniform mat4 u_bones[16];
uniform mat3 u_bone_normals[16];  // cofactors of the bones
uniform vec4 u_rotations[16];     // dual quaternions without the stretch; neighbours have the same sign
uniform vec4 u_duals[16];
uniform float u_odd_sign;         // factor on every second one in the input of task 18.3

const float turn_rad = 6.28318531;

struct Rest {
    vec3 position, normal;
    mat2x3 along;  // derivatives by u and v, times the radius, so that they are finite at the tips
};

// Returns the square of the radius as a share of its maximum, and the derivative by v.
vec2 squared_profile(float v) {
#ifdef SERPENT
    float w = 1.0 - v, v2 = v * v, v4 = v2 * v2, v8 = v4 * v4, v16 = v8 * v8;
    float tail = 1.0 - w * w * w, cap = 1.0 - v16 * v8;
    vec2 middles = vec2(0.45, 0.945), widths = vec2(0.24, 0.035), off = (v - middles) / widths;
    vec2 bumps = vec2(0.5, 0.55) * exp(-off * off), slopes = -2.0 * off / widths * bumps;
    float body = 0.5 + bumps.x + bumps.y;
    float ends_slope = 6.0 * tail * w * w * cap - tail * tail * 24.0 * v16 * v4 * v2 * v;
    return vec2(tail * tail * cap * body, ends_slope * body + tail * tail * cap * (slopes.x + slopes.y));
#else
    return vec2(1.0, 0.0);
#endif
}

Rest rest_at(vec2 uv) {
    float angle = turn_rad * (uv.x - 0.25), c = cos(angle), s = sin(angle);
    vec3 out_ = vec3(0.0, s, -c);
    vec2 squared = squared_profile(uv.y);
    float radius = u_body.y * sqrt(max(squared.x, 0.0));
    float slope = u_body.y * u_body.y * squared.y / (2.0 * u_body.x);
    Rest rest;
    rest.position = vec3(u_body.x * (uv.y - 0.5), radius * out_.yz);
    vec3 normal = radius * out_ - vec3(slope, 0.0, 0.0);
    float size = length(normal);
    rest.normal = size > 0.0 ? normal / size : vec3(1.0, 0.0, 0.0);
    rest.along = mat2x3(turn_rad * radius * radius * vec3(0.0, c, s), u_body.x * vec3(radius, slope * out_.yz));
    return rest;
}

struct Influence {
    int first;
    vec4 weights, slopes;  // of four bones, and their derivatives along x
};

Influence influence_at(float x) {
    float spacing = u_body.x / (u_body.z + 1.0), first_joint = spacing - 0.5 * u_body.x;
    Influence influence;
    int bones = max(int(u_body.z) + 1, 4);
    influence.first = clamp(int(floor((x - 0.5 * u_body.w - first_joint) / spacing)) + 1, 0, bones - 4);
    vec2 before = vec2(1.0, 0.0);
    for (int i = 0; i < 4; ++i) {
        vec2 joint = vec2(0.0);
        float number = float(influence.first + i);
        if (i < 3 && number < u_body.z) {
            float t = clamp((x - first_joint - number * spacing) / u_body.w + 0.5, 0.0, 1.0);
            joint = vec2(t * t * (3.0 - 2.0 * t), 6.0 * t * (1.0 - t) / u_body.w);
        }
        influence.weights[i] = before.x - joint.x;
        influence.slopes[i] = before.y - joint.y;
        before = joint;
    }
#ifdef UNEVEN
    float wave = 4.0 / u_body.y, sum = 0.8 + 0.15 * sin(wave * x);
    influence.slopes = sum * influence.slopes + 0.15 * wave * cos(wave * x) * influence.weights;
    influence.weights *= sum;
#endif
    return influence;
}

mat2x4 motion_of(int bone) {
    float side = bone % 2 == 1 ? u_odd_sign : 1.0;
    return side * mat2x4(u_rotations[bone], u_duals[bone]);
}

// Returns a symmetric bilinear form of two dual quaternions. moved_by(a, a, p) is the place p moved by a, times the
// squared length of a's real part.
vec3 moved_by(mat2x4 a, mat2x4 b, vec3 p) {
    vec3 v = a[0].xyz, w = b[0].xyz, d = a[1].xyz, e = b[1].xyz;
    vec3 turned = p * (a[0].w * b[0].w - dot(v, w)) + dot(v, p) * w + dot(w, p) * v + a[0].w * cross(w, p) +
                  b[0].w * cross(v, p);
    return turned + a[0].w * e + b[0].w * d - a[1].w * w - b[1].w * v + cross(v, e) + cross(w, d);
}

mat3 rotation_of(vec4 q) {
    vec3 twice = 2.0 * q.xyz;
    mat3 spin = mat3(0.0, twice.z, -twice.y, -twice.z, 0.0, twice.x, twice.y, -twice.x, 0.0);
    return mat3(1.0) + q.w * spin + 0.5 * spin * spin;
}
