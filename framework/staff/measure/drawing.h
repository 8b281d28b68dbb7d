// Shared parts of topics that draw: a lab's shot as a subject to time, with the work that GL counts.
#pragma once

#include <functional>
#include <memory>

#include "framework/image/compare.h"
#include "framework/lab/shot.h"
#include "framework/staff/measure/bench.h"

namespace relief {

/// A set of knobs after another.
BenchKnobs together(BenchKnobs first, const BenchKnobs& second);

/// Draws, to its end, into a target of its own, and what GL counts while it first does so: draw calls, triangles (after
/// tessellation), and bytes of the textures that it asks for, whoever else has them.
BenchSubject drawn(TargetKind kind, glm::ivec2 size, const std::function<void(const Target&)>& draw);
/// The same of a lab's shot. The lab lives as long as the subject.
BenchSubject drawn(const std::shared_ptr<Lab>& lab, const Shot& shot);

/// A probe's error as tests hold labs to it, and `wrong`: the share of pixels off by more than one unit.
BenchError error_over(const Image& errors, const std::string& unit);

/// Of a shot's pixels with a surface, the first channel of another probe: {"steps"}.
double mean_of_probe(Lab& lab, Shot shot, const char* name);

/// What the page shows of a subject: the shot's picture,
void show_picture(BenchSubject& subject, Lab& lab, Shot shot);
/// and its error as a map of heat, `most` and more being the brightest. Of the pixels that share one of the map's the
/// worst counts.
void show_errors(BenchSubject& subject, const Image& errors, double max_error);

}  // namespace relief
