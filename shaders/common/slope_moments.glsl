// The slopes that a texel of a mip level has averaged (LEAN mapping: Olano and Baker 2010). A variance has three
// numbers: along u, along v, and the covariance.

// Returns the variance from the means of the slopes, and from the means of their squares and their product.
vec3 variance_of_slopes(vec2 mean, vec3 squares) {
    return vec3(squares.xy - mean * mean, squares.z - mean.x * mean.y);
}

mat2 covariance_matrix(vec3 variance) { return mat2(variance.x, variance.z, variance.z, variance.y); }
