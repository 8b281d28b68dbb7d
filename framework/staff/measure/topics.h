// The topics of relief bench, one file each.
#pragma once

#include "framework/mesh/mesh.h"
#include "framework/staff/measure/bench.h"

namespace relief {

BenchTopic storage_topic();
BenchTopic normals_topic();
BenchTopic tangents_topic();
BenchTopic intersection_topic();
BenchTopic parallax_topic();
BenchTopic displacement_topic();
BenchTopic lighting_topic();
BenchTopic baking_topic();
BenchTopic budget_topic();
BenchTopic frames_topic();
BenchTopic grade_topic();
BenchTopic start_topic();

/// What tangents are measured on: a torus of places that are jittered by up to 0.24 cells, diagonals by chance, with
/// the exact dP/du as its tangents. Below a quarter of a cell no triangle can be folded: a folded one's dP/du is
/// nobody's.
Mesh bench_torus(int columns, int rows);

}  // namespace relief
