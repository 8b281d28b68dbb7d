// The coverage of a mask at its mip levels.
#pragma once

#include <vector>

#include "framework/core/image/image.h"

namespace relief {

/// Returns for each level of a mask a factor on its alpha that keeps the coverage: the share of places whose alpha,
/// times the factor, is above 1/2 is that of level 0 (Castaño 2010). Places lie between texels, too, and are filtered
/// bilinearly. The first channel is the alpha, the map repeats. Throws std::out_of_range without levels.
std::vector<float> coverage_scales(const std::vector<Image>& levels);

}  // namespace relief
