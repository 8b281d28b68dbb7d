// The scales of a skin, as a normal map that repeats.
#pragma once

#include "framework/image/image.h"

namespace relief::moving_frames {

/// Two scales from side to side, four from tip to tip; tips point down. Normals (green up) and, in the fourth channel,
/// heights, 8 bits.
Image make_scales(int texels);

}  // namespace relief::moving_frames
