// Returns a unit vector perpendicular to a unit vector, without a branch, for every direction (Duff et al. 2017). It is
// discontinuous where z changes sign. No continuous choice exists for all directions.
//(any-perpendicular
vec3 any_perpendicular(vec3 unit) {
    float sign_ = unit.z < 0.0 ? -1.0 : 1.0, a = -1.0 / (sign_ + unit.z);
    return vec3(1.0 + sign_ * unit.x * unit.x * a, sign_ * unit.x * unit.y * a, -sign_ * unit.x);
}
//)
