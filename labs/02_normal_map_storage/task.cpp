// Lab 02, your last task: one channel of a compressed block. (Tasks 2.1 to 2.4 are in
// shaders/02_normal_map_storage/task.glsl.)
#include "task.h"

#include <algorithm>
#include <cmath>

#include "framework/core/base/unfinished.h"

namespace relief::storage {

// TASK 2.5 (2 points): a channel of a BC5 block stores two whole numbers, and an index of 3 bits for each of 16 values.
// Store the largest value as `first` and the smallest as `second`, each rounded to the nearest whole number. They
// divide the range between them into 7 equal steps. So the decoder knows 8 values, in this order from `first` down to
// `second`:
//     index   0  2  3  4  5  6  7  1
// Store the index of the nearest of these 8 values. (The decoder uses this order only where first > second. If both
// ends are the same number, the indices 6 and 7 mean the limits of the format: store none of them then.)
//(channel
ChannelBlock encode_channel(const std::array<double, 16>& values) {
    //[solution
    const auto [smallest, largest] = std::minmax_element(values.begin(), values.end());
    ChannelBlock block{.first = int(std::lround(*largest)), .second = int(std::lround(*smallest))};
    if (block.first == block.second) return block;
    constexpr std::array index_of_step = {0, 2, 3, 4, 5, 6, 7, 1};
    for (size_t texel = 0; texel < values.size(); ++texel) {
        const double steps = 7 * (block.first - values[texel]) / (block.first - block.second);
        block.indices[texel] = index_of_step[size_t(std::clamp(int(std::lround(steps)), 0, 7))];
    }
    return block;
    //]starter
    //| static_cast<void>(values);
    //| unfinished("2.5");
    //]
}
//)

}  // namespace relief::storage
