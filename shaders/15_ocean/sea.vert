#version 410 core
// The corners of the sea's patches. They form rings around the point below the eye, out to the horizon. Radii grow by a
// constant ratio. There are no buffers: the position follows from the vertex number.

uniform vec3 u_rings;         // sectors, radius of the first ring, ratio of two radii
uniform float u_segments[27]; // longest segments at each ring: exponents of 2 of metres

out vec3 v_polar;  // radius, angle, exponent of the longest segment

void main() {
    int patch_ = gl_VertexID / 4, corner = gl_VertexID % 4, sectors = int(u_rings.x);
    int ring = patch_ / sectors + (corner == 2 || corner == 3 ? 1 : 0);
    int sector = patch_ % sectors + (corner == 1 || corner == 2 ? 1 : 0);
    float radius = ring == 0 ? 0.0 : u_rings.y * pow(u_rings.z, float(ring - 1));
    v_polar = vec3(radius, 6.28318531 * float(sector) / u_rings.x, u_segments[ring]);
}
