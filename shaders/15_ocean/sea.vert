#version 410 core
// The corners of the sea's patches: rings around the point below the eye, each so much wider than the one within, out
// to the horizon. There are no buffers: the number of a vertex says where it is.

uniform vec3 u_rings;         // sectors, radius of the first ring, ratio of two radii
uniform float u_segments[27]; // how long segments may be at each ring: exponents of 2, metres

out vec3 v_polar;  // radius, angle, exponent

void main() {
    int patch_ = gl_VertexID / 4, corner = gl_VertexID % 4, sectors = int(u_rings.x);
    int ring = patch_ / sectors + (corner == 2 || corner == 3 ? 1 : 0);
    int sector = patch_ % sectors + (corner == 1 || corner == 2 ? 1 : 0);
    float radius = ring == 0 ? 0.0 : u_rings.y * pow(u_rings.z, float(ring - 1));
    v_polar = vec3(radius, 6.28318531 * float(sector) / u_rings.x, u_segments[ring]);
}
