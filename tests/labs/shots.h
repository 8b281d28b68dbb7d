// Short forms for shots of a lab in tests.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

#include "framework/core/gl/counters.h"
#include "framework/core/gl/gl.h"
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

/// What drawing takes: triangles, and changes of the counters.
struct Work {
    int64_t triangles = 0, draws = 0, links = 0, texture_bytes = 0;
};

/// Returns the work of drawing a shot.
inline Work work_of(Lab& lab, const Shot& shot) {
    const Target target(shot.probe ? TargetKind::probe : TargetKind::picture, shot.size);
    const Counters before = counters();
    GLuint query = 0, triangles = 0;
    glGenQueries(1, &query);
    glBeginQuery(GL_PRIMITIVES_GENERATED, query);
    draw_lab(lab, frame_of(shot, target));
    glEndQuery(GL_PRIMITIVES_GENERATED);
    glGetQueryObjectuiv(query, GL_QUERY_RESULT, &triangles);
    glDeleteQueries(1, &query);
    const Counters after = counters();
    return {triangles, after.draw_calls - before.draw_calls, after.links - before.links,
            after.texture_bytes - before.texture_bytes};
}

/// Returns the work of a shot's first picture.
inline Work work_of(const char* lab, const Shot& shot) { return work_of(*make_lab(find_lab(lab), shot), shot); }

inline std::vector<Knob> with(std::vector<Knob> knobs, const std::vector<Knob>& more) {
    knobs.insert(knobs.end(), more.begin(), more.end());
    return knobs;
}

/// Returns how many random views a test looks at. `./relief test --all` asks for more.
inline int view_count() {
    const char* const wanted = std::getenv("RELIEF_RANDOM_VIEWS");
    return wanted ? std::max(1, std::atoi(wanted)) : 200;
}

/// Random values from a fixed seed.
struct Dice {
    std::mt19937 random;
    explicit Dice(unsigned seed) : random(seed) {}
    double between(double low, double high) { return std::uniform_real_distribution(low, high)(random); }
    /// Returns a random number between `low` and `high`, evenly distributed in its logarithm.
    double octaves(double low, double high) { return std::exp2(between(std::log2(low), std::log2(high))); }
    template <size_t count>
    const char* one_of(const char* const (&names)[count]) {
        return names[random() % count];
    }
    glm::dvec3 direction() {
        while (true) {
            const glm::dvec3 at(between(-1, 1), between(-1, 1), between(-1, 1));
            if (const double length = glm::length(at); length > 0.1 && length < 1) return at / length;
        }
    }
};

/// Counts the pixels of the probe `winding` at which rays do not enter the surface as often as they leave it. From
/// inside, they leave it once more.
inline size_t holes_of(const Image& winding, bool is_inside = false) {
    size_t count = 0;
    for (size_t i = 0; i < winding.values.size(); i += 4) count += winding.values[i] != (is_inside ? -1.0f : 0.0f);
    return count;
}

/// Expects that at most `pixels` pixels of two pictures differ by more than `steps` of 255.
inline void expect_same_picture(const Image& a, const Image& b, double steps, size_t pixels) {
    const Difference off = difference(a, b, steps / 255 + 1e-6);
    EXPECT_LE(off.pixels_over, pixels) << "the most by " << off.largest * 255 << " / 255";
}

}  // namespace relief
