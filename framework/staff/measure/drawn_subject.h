// Shared by topics that draw: a lab's shot as a BenchSubject, with the work that GL counts.
#pragma once

#include <functional>
#include <memory>

#include "framework/core/image/compare.h"
#include "framework/core/lab/shot.h"
#include "framework/staff/measure/bench.h"

namespace relief::measure {

/// Concatenates the knobs of both, in this order.
BenchKnobs together(BenchKnobs first, const BenchKnobs& second);

/// Returns a subject that draws into its own target; its `run` does not wait for the GPU. Its work is counted in one
/// first run: draw calls, triangles after tessellation, and the bytes of the textures that it uses, shared ones
/// included.
BenchSubject drawn(TargetKind kind, glm::ivec2 size, const std::function<void(const Target&)>& draw);
/// The same for a lab's shot. The subject shares ownership of the lab.
BenchSubject drawn(const std::shared_ptr<Lab>& lab, const Shot& shot);

/// Returns the figures of an error image, as the tests compute them. `wrong` is the share of pixels that are off by
/// more than one unit. Throws Error if an error is not finite.
BenchError error_over(const Image& errors, const std::string& unit);

/// Returns the mean of the first channel of the probe `name`, over the pixels with a surface.
double mean_of_probe(Lab& lab, Shot shot, const char* name);

/// Draws the subject's picture for the page.
void show_picture(BenchSubject& subject, Lab& lab, Shot shot);
/// Makes the subject's error map for the page: a heat map whose brightest colour is at `max_error`. A pixel of the map
/// shows the largest error of the pixels that it covers.
void show_errors(BenchSubject& subject, const Image& errors, double max_error);

}  // namespace relief::measure
