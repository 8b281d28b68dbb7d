// Depth by a logarithm, so that each length is resolved to the same share, however far away it is.

in float v_away;

uniform float u_near;
uniform float u_far;

void write_depth() {
#ifdef LOG_DEPTH
    gl_FragDepth = log2(1.0 + max(v_away, 0.0) / u_near) / log2(1.0 + u_far / u_near);
#endif
}
