// A unit vector perpendicular to a unit one, without a branch, right for every direction (Duff et al. 2017).
// It jumps where z changes its sign, as every such choice must somewhere.
//(any-perpendicular
vec3 any_perpendicular(vec3 unit) {
    float sign_ = unit.z < 0.0 ? -1.0 : 1.0, a = -1.0 / (sign_ + unit.z);
    return vec3(1.0 + sign_ * unit.x * unit.x * a, sign_ * unit.x * unit.y * a, -sign_ * unit.x);
}
//)
