// Lab 09, your tasks: levels, skirts and the horizon. (Tasks 9.1 to 9.5 are in shaders/09_planet/task.glsl.)
#include "task.h"

#include <algorithm>
#include <cmath>

#include "framework/core/base/unfinished.h"

namespace relief::planet {

// TASK 9.6 (3 points): a patch is split in four while the eye is nearer than split_distance(): there its error, which
// is known for each level, is as high as the budget. In the middle of the picture a length of 2 d tan(fov / 2) at the
// distance d is as high as the whole picture. skirt_depth() returns the largest gap between two borders: the sum of
// both errors, where the neighbour is as coarse as it may be. (At level 0 the neighbour has level 0.)
//(level
double split_distance(double error, double budget, double pixels, double field_of_view_rad) {
    //[solution
    return error * pixels / (2 * std::tan(field_of_view_rad / 2) * budget);
    //]starter
    //| static_cast<void>(error), static_cast<void>(budget), static_cast<void>(pixels);
    //| static_cast<void>(field_of_view_rad);
    //| unfinished("9.6");
    //]
}

double skirt_depth(std::span<const double> errors, int level) {
    //[solution
    return errors[size_t(level)] + errors[size_t(std::max(level - 1, 0))];
    //]starter
    //| static_cast<void>(errors), static_cast<void>(level);
    //| unfinished("9.6");
    //]
}
//)

// TASK 9.7 (2 points): the line from the eye that touches a ball of radius `lowest` (all of it is ground) touches it at
// an angle, seen from the centre, whose cosine is lowest / eye. Behind that, a place at `highest` is still seen up to
// the angle whose cosine is lowest / highest. An eye that is below `lowest` has no horizon: nothing is hidden.
//(horizon
bool behind_horizon(double eye, double angle, double lowest, double highest) {
    //[solution
    if (eye <= lowest) return false;
    return angle > std::acos(lowest / eye) + std::acos(lowest / highest);
    //]starter
    //| static_cast<void>(eye), static_cast<void>(angle), static_cast<void>(lowest), static_cast<void>(highest);
    //| unfinished("9.7");
    //]
}
//)

}  // namespace relief::planet
