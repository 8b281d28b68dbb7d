#include "framework/staff/measure/drawn_subject.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/core/gl/counters.h"
#include "framework/core/gl/object.h"
#include "framework/library/maps/visualize.h"

namespace relief::measure {
namespace {

constexpr int shown_side = 128;

/// Returns the largest error of each square of pixels that becomes one pixel.
Image worst_of(const Image& errors) {
    const int square = std::max(1, errors.width / shown_side);
    Image result(errors.width / square, errors.height / square, 1);
    for (int y = 0; y < result.height; ++y)
        for (int x = 0; x < result.width; ++x) {
            float worst = no_surface;  // for squares without a surface
            for (int i = 0; i < square * square; ++i) {
                const float error = *errors.pixel(x * square + i % square, y * square + i / square);
                if (std::isnan(error) || (error != no_surface && (worst == no_surface || error > worst))) worst = error;
            }
            *result.pixel(x, y) = worst;
        }
    return result;
}

}  // namespace

BenchKnobs together(BenchKnobs first, const BenchKnobs& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

BenchSubject drawn(TargetKind kind, glm::ivec2 size, const std::function<void(const Target&)>& draw) {
    const auto target = std::make_shared<Target>(kind, size);
    BenchSubject subject;
    subject.run = [target, draw, kind] {
        draw(*target);
        if (kind != TargetKind::probe) target->resolve();
    };
    const Counters before = counters();
    // A lab may have its own query for primitives generated, and GL allows one at a time. Clipping input primitives are
    // a separate query.
    const bool can_count = GLAD_GL_ARB_pipeline_statistics_query;
    const QueryName query;
    if (can_count) glBeginQuery(GL_CLIPPING_INPUT_PRIMITIVES_ARB, query);
    draw(*target);
    if (can_count) glEndQuery(GL_CLIPPING_INPUT_PRIMITIVES_ARB);
    subject.work = {{"draws", double(counters().draw_calls - before.draw_calls)},
                    {"texture_bytes", double(counters().texture_bytes - before.texture_bytes + counters().shared_bytes -
                                             before.shared_bytes)}};
    if (!can_count) return subject;
    GLuint triangles = 0;
    glGetQueryObjectuiv(query, GL_QUERY_RESULT, &triangles);
    subject.work.emplace_back("triangles", double(triangles));
    return subject;
}

BenchSubject drawn(const std::shared_ptr<Lab>& lab, const Shot& shot) {
    return drawn(shot.probe ? TargetKind::probe : TargetKind::picture, shot.size,
                 [lab, shot](const Target& target) { draw_lab(*lab, frame_of(shot, target)); });
}

BenchError error_over(const Image& errors, const std::string& unit) {
    const ErrorSummary summary = summarize(errors);
    if (summary.not_finite > 0) throw Error(fmt::format("{} pixels are not a number", summary.not_finite));
    if (summary.count == 0) throw Error("no pixel has a surface both as it is drawn and in the exact values");
    const auto wrong = std::count_if(errors.values.begin(), errors.values.end(),
                                     [](float value) { return std::isfinite(value) && value > 1; });
    return {summary.mean, summary.p99, summary.largest, unit,
            double(wrong) / double(std::max<size_t>(1, summary.count))};
}

double mean_of_probe(Lab& lab, Shot shot, const char* name) {
    shot.probe = {name};
    const Image probe = render_shot(lab, shot);
    double sum = 0, count = 0;
    for (size_t i = 0; i < probe.values.size(); i += 4)
        if (std::isfinite(probe.values[i])) {
            sum += double(probe.values[i]);
            ++count;
        }
    return sum / std::max(1.0, count);
}

void show_picture(BenchSubject& subject, Lab& lab, Shot shot) {
    shot.probe = {};
    shot.size = glm::ivec2(shown_side);
    subject.picture = render_shot(lab, shot);
}

void show_errors(BenchSubject& subject, const Image& errors, double max_error) {
    subject.error_map = visualize_error(worst_of(errors), max_error);
    subject.error_map_max = max_error;
}

}  // namespace relief::measure
