// The topics of relief bench, one file each.
#pragma once

#include <glm/glm.hpp>

#include "framework/core/mesh/mesh.h"
#include "framework/staff/measure/bench.h"

namespace relief::measure {

BenchTopic storage_topic();
BenchTopic normals_topic();
BenchTopic tangents_topic();
BenchTopic intersection_topic();
BenchTopic parallax_topic();
BenchTopic displacement_topic();
BenchTopic lighting_topic();
BenchTopic baking_topic();
BenchTopic materials_topic();
BenchTopic planet_topic();
BenchTopic ocean_topic();
BenchTopic environment_topic();
BenchTopic moving_frames_topic();
BenchTopic layers_topic();
BenchTopic terminator_topic();
BenchTopic budget_topic();
BenchTopic frames_topic();
BenchTopic stability_topic();
BenchTopic grade_topic();
BenchTopic start_topic();

/// The size of pictures if the user names none, in pixels. With --quick, too.
inline constexpr glm::ivec2 usual_size{512, 512};

/// Returns the mesh on which tangents are measured: a torus with vertices jittered by up to 0.24 cells and random
/// diagonals. Its tangents are the exact dP/du. A jitter below a quarter of a cell folds no triangle; a folded triangle
/// would have no meaningful dP/du.
Mesh bench_torus(int columns, int rows);

}  // namespace relief::measure
