// Three normal maps of a quilted column: in object, world and tangent space.
#pragma once

#include "framework/core/image/image.h"

namespace relief {

// Texels per side. labs/04_object_space/quilt.h has the same column; the lab's test keeps both equal.
constexpr int quilt_texels = 512;

struct QuiltMaps {
    Image object, world, tangent;
};

/// Returns maps of `0.5 n + 0.5`, u around the column and v up. World space is that of the column at rest.
QuiltMaps make_quilt();

}  // namespace relief
