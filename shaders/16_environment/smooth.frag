#version 410 core
// The mean of neighbours at about the same distance. The weights 1 2 1 along both axes give all four patterns of
// occlusion.frag the same weight.

uniform sampler2D s_open;

layout(location = 0) out vec4 o_open;

void main() {
    ivec2 middle = ivec2(gl_FragCoord.xy), last = textureSize(s_open, 0) - 1;
    vec4 here = texelFetch(s_open, middle, 0);
    float sum = 0.0, weights = 0.0;
    for (int row = -1; row <= 1; ++row)
        for (int column = -1; column <= 1; ++column) {
            vec4 there = texelFetch(s_open, clamp(middle + ivec2(column, row), ivec2(0), last), 0);
            float weight = float((2 - abs(row)) * (2 - abs(column))) *
                           clamp(1.0 - 20.0 * abs(there.y - here.y) / max(here.y, 1e-6), 0.0, 1.0);
            sum += weight * there.x;
            weights += weight;
        }
    o_open = vec4(weights > 0.0 ? sum / weights : here.x, here.y, 0.0, 0.0);
}
