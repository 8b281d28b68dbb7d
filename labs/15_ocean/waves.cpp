#include "waves.h"

#include <array>

namespace relief::ocean {

const std::vector<PlaneWave>& waves_of(int map) {
    static const std::array made = {
        random_waves({.lowest = 3, .highest = 15, .course = 0.5, .spread = 0.9, .fall = 1.35, .seed = 11}, waves_a_map),
        random_waves({.lowest = 2, .highest = 17, .course = -0.4, .spread = 1.5, .fall = 1.25, .seed = 5},
                     waves_a_map)};
    return made[size_t(map)];
}

}  // namespace relief::ocean
