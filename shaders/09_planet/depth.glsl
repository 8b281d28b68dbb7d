// Logarithmic depth: its resolution is the same share of the distance everywhere.

in float v_away;

uniform float u_near;
uniform float u_far;

void write_depth() {
#ifdef LOG_DEPTH
    gl_FragDepth = log2(1.0 + max(v_away, 0.0) / u_near) / log2(1.0 + u_far / u_near);
#endif
}
