// Short forms for shots of a lab in tests.
#pragma once

#include <gtest/gtest.h>

#include "framework/course/manifest/manifest.h"

namespace relief {

using Knob = std::pair<std::string, std::string>;

inline Shot shot_of(const char* lab, std::vector<Knob> knobs, const char* probe = "", glm::ivec2 size = {128, 128}) {
    return {.size = size,
            .time = 0,
            .camera = load_manifest(find_lab(lab)).camera,
            .probe = {probe},
            .set = std::move(knobs)};
}

/// Returns the picture or the probe of a shot. Throws if a pixel of a probe is not finite.
inline Image drawn(const char* lab, const Shot& shot) { return render_shot(*make_lab(find_lab(lab), shot), shot); }

/// Returns the error of the probe of a shot against its truth.
inline ErrorSummary error_of(const char* lab, const Shot& shot) {
    const auto made = make_lab(find_lab(lab), shot);
    const Manifest manifest = load_manifest(find_lab(lab));
    return summarize(
        error_image(render_shot(*made, shot), truth_of(*made, shot), manifest.probe(shot.probe.name).error));
}

/// Expects that at most `pixels` pixels of two pictures differ by more than `steps` of 255.
inline void expect_same_picture(const Image& a, const Image& b, double steps, size_t pixels) {
    const Difference off = difference(a, b, steps / 255 + 1e-6);
    EXPECT_LE(off.pixels_over, pixels) << "the most by " << off.largest * 255 << " / 255";
}

}  // namespace relief
