// The mesh on which the benchmark measures tangents.
#pragma once

#include "framework/core/base/mesh.h"

namespace relief::measure {

/// Returns the mesh on which tangents are measured: a torus with vertices jittered by up to 0.24 cells and random
/// diagonals. Its tangents are the exact dP/du. A jitter below a quarter of a cell folds no triangle; a folded triangle
/// would have no meaningful dP/du.
Mesh bench_torus(int columns, int rows);

}  // namespace relief::measure
