// Points on a patch. Corners 0, 1, 2 (and 3) run around it; edge i goes from corner i to the next. Every sum over an
// edge has two nonzero terms, and the sum of two terms does not depend on their order. So two patches compute shared
// values with the same bits.

// Returns the bilinear weights of the corners (0, 0), (1, 0), (1, 1) and (0, 1).
vec4 quad_weights(vec2 place) {
    vec2 rest = 1.0 - place;
    return vec4(rest.x * rest.y, place.x * rest.y, place.x * place.y, rest.x * place.y);
}

// Without `precise` a compiler may fuse only one of two products with their sum. Then the result would depend on the
// order.
vec4 blend(vec4 weights, vec4 a, vec4 b, vec4 c, vec4 d) {
    precise vec4 sum = (weights.x * a + weights.y * b) + (weights.z * c + weights.w * d);
    return sum;
}
vec3 blend(vec4 weights, vec3 a, vec3 b, vec3 c, vec3 d) {
    return blend(weights, vec4(a, 0.0), vec4(b, 0.0), vec4(c, 0.0), vec4(d, 0.0)).xyz;
}
vec2 blend(vec4 weights, vec2 a, vec2 b, vec2 c, vec2 d) {
    return blend(weights, vec4(a, 0.0, 0.0), vec4(b, 0.0, 0.0), vec4(c, 0.0, 0.0), vec4(d, 0.0, 0.0)).xy;
}

// Returns the edge on which a point lies, or -1 inside. The point is given by the weights of three corners, or by its
// position in the domain for four. A corner gives one of its two edges.
int edge_of_triangle(vec3 weights) {
    return weights.z == 0.0 ? 0 : weights.x == 0.0 ? 1 : weights.y == 0.0 ? 2 : -1;
}
int edge_of_quad(vec2 place) {
    return place.y == 0.0 ? 0 : place.x == 1.0 ? 1 : place.y == 1.0 ? 2 : place.x == 0.0 ? 3 : -1;
}

// Returns the uv at which a vertex on an edge reads its height, interpolated between the edge's ends. At an end it is
// the corner's own uv.
vec2 uv_on_edge(float here, float there, vec4 edge_uv, vec2 uv_here, vec2 uv_there) {
    precise vec2 uv = here * edge_uv.xy + there * edge_uv.zw;
    return here == 1.0 ? uv_here : there == 1.0 ? uv_there : uv;
}

// Returns dF/du and dF/dv from the changes of F and uv along two directions; 0 if the changes of uv are parallel.
mat2x3 by_uv(vec3 along_x, vec3 along_y, vec2 uv_x, vec2 uv_y) {
    float area = uv_x.x * uv_y.y - uv_x.y * uv_y.x, scale = area == 0.0 ? 0.0 : 1.0 / area;
    return mat2x3(scale * (uv_y.y * along_x - uv_x.y * along_y), scale * (uv_x.x * along_y - uv_y.x * along_x));
}

// Returns the derivative of a normalised vector from the derivative `change` of the vector; 0 for the zero vector.
vec3 turn_of_unit(vec3 vector, vec3 change) {
    float squared = dot(vector, vector);
    return squared > 0.0 ? inversesqrt(squared) * (change - vector * (dot(vector, change) / squared)) : vec3(0.0);
}
