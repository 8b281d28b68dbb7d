// The topics of relief bench, one file each.
#pragma once

#include "framework/staff/measure/bench.h"

namespace relief {

BenchTopic storage_topic();
BenchTopic normals_topic();
BenchTopic tangents_topic();
BenchTopic intersection_topic();
BenchTopic parallax_topic();
BenchTopic displacement_topic();
BenchTopic lighting_topic();
BenchTopic budget_topic();
BenchTopic frames_topic();
BenchTopic grade_topic();
BenchTopic start_topic();

}  // namespace relief
