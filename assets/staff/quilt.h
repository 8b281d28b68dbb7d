// Three maps of one quilted column: its normals in the object's space, in the world's, and in the tangent's.
#pragma once

#include "framework/image/image.h"

namespace relief {

// The column of lab 04, which has the same numbers in labs/04_object_space/quilt.h (its test holds them together).
constexpr int quilt_texels = 512;

struct QuiltMaps {
    Image object, world, tangent;
};

/// `0.5 n + 0.5`, u around the column and v up. The world is that of the column at rest.
QuiltMaps make_quilt();

}  // namespace relief
