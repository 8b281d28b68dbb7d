// The lamp, and the share of its light that reaches a place.

uniform vec3 u_lamp;  // position
uniform vec3 u_axis;
uniform float u_range;
uniform float u_cone;
uniform vec3 u_attenuation;

float lamp_share(vec3 from_lamp) { return spot(from_lamp, u_axis, u_range, u_cone, u_attenuation); }
