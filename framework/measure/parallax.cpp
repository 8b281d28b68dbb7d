// Parallax: the searches of labs 11 and 12 on a wall, at angles around the middle and at grazing ones. What is timed is
// the probe `uv`: the search, and hardly anything else.
#include <algorithm>
#include <cmath>

#include "framework/image/compare.h"
#include "framework/lab/manifest.h"
#include "framework/measure/topics.h"

namespace relief {
namespace {

using Set = std::vector<std::pair<std::string, std::string>>;

struct Search {
    const char *name, *lab;
    Set set;
};

Search marched(const char* name, const char* count, const char* steps, const char* refine, const char* rounds) {
    return {name, "11", {{"count", count}, {"steps", steps}, {"refine", refine}, {"rounds", rounds}, {"skip", "off"}}};
}

std::vector<Search> searches() {
    std::vector<Search> all = {
        // As it is copied from page to page: 8 to 32 steps by angle, one line, texture() in the loop.
        {"usual", "11", {{"count", "angle"}, {"refine", "linear"}, {"lookup", "implicit"}, {"skip", "off"}}},
        marched("linear-8", "fixed", "8", "linear", "0"),
        marched("linear-16", "fixed", "16", "linear", "0"),
        marched("linear-32", "fixed", "32", "linear", "0"),
        marched("linear-64", "fixed", "64", "linear", "0"),
        marched("linear-128", "fixed", "128", "linear", "0"),
        marched("secant-8+2", "fixed", "8", "secant", "2"),
        marched("secant-16+2", "fixed", "16", "secant", "2"),
        marched("bisection-16+5", "fixed", "16", "bisection", "5"),
        marched("illinois-16+3", "fixed", "16", "illinois", "3"),
        {"texel-4+2", "11", {{"count", "texel"}, {"texels_per_step", "4"}, {"refine", "secant"}, {"rounds", "2"}}},
        {"texel-2+2", "11", {{"count", "texel"}, {"texels_per_step", "2"}, {"refine", "secant"}, {"rounds", "2"}}},
        {"texel-1+2", "11", {{"count", "texel"}, {"texels_per_step", "1"}, {"refine", "secant"}, {"rounds", "2"}}}};
    for (const char* method : {"walk", "coarse", "windows", "cells", "max-mips", "cones"})
        all.push_back(
            {method, "12", {{"method", method}, {"shadow", "none"}, {"write_depth", "off"}, {"outline", "off"}}});
    return all;
}

/// Cameras whose pixels see the wall at these angles from its normal, in degrees.
struct Angles {
    const char* name;
    double middle, field_of_view, distance;
};
constexpr Angles angles[] = {{"15-65", 40, 50, 1.1}, {"60-85", 72.5, 25, 1.5}};

BenchError error_of(Lab& lab, const Shot& shot, const Image& truth) {
    const Image error = error_image(take(lab, shot), truth, ErrorMetric::distance);
    const ErrorSummary summary = summarize(error);
    const auto wrong = std::count_if(error.values.begin(), error.values.end(),
                                     [](float value) { return std::isfinite(value) && value > 1; });
    return {summary.mean, summary.p99, summary.largest, "texel",
            double(wrong) / double(std::max<size_t>(1, summary.count))};
}

double mean_work(Lab& lab, Shot shot) {
    shot.probe = {"steps"};
    const Image steps = take(lab, shot);
    double sum = 0, count = 0;
    for (size_t i = 0; i < steps.values.size(); i += 4)
        if (std::isfinite(steps.values[i])) sum += double(steps.values[i]), ++count;
    return sum / std::max(1.0, count);
}

std::vector<BenchMethod> methods(const BenchSettings& settings) {
    std::vector<Set> scenes;
    for (const char* map : {"bricks", "stones", "posts"})
        for (const char* bits : {"float", "8"}) scenes.push_back({{"map", map}, {"size", "512"}, {"bits", bits}});
    if (settings.quick)
        scenes.resize(1);
    else
        for (const char* map : {"bricks", "stones", "posts", "smooth", "fbm", "rock", "paving"})
            scenes.push_back({{"map", map}, {"size", "1024"}, {"bits", "float"}});
    std::vector<BenchMethod> result;
    const auto target = std::make_shared<Target>(TargetKind::probe, glm::ivec2(512));
    for (const Set& scene : scenes)
        for (const Angles& seen : angles) {
            std::optional<Image> truth;  // the same for every search
            for (const Search& search : searches()) {
                Shot shot;
                shot.size = target->size(), shot.probe = {"uv"}, shot.set = search.set;
                shot.camera = {
                    .yaw = seen.middle, .pitch = 0, .distance = seen.distance, .field_of_view = seen.field_of_view};
                shot.set.insert(shot.set.end(), {{"view", "one"}, {"extent", "10"}, {"depth", "0.08"}});
                shot.set.insert(shot.set.end(), scene.begin(), scene.end());
                const std::shared_ptr<Lab> lab = make_lab(find_lab(search.lab), shot);
                if (!truth) truth = truth_of(*lab, shot);
                BenchMethod& method = result.emplace_back();
                method.name = search.name, method.item = "frame", method.knobs = scene;
                method.knobs.emplace_back("angle", seen.name);
                method.error = error_of(*lab, shot, *truth), method.work = mean_work(*lab, shot);
                method.run = [lab, target, shot] {
                    draw_lab(*lab, frame_of(shot, *target));
                    glFinish();
                };
            }
        }
    return result;
}

}  // namespace

BenchTopic parallax_topic() {
    return {"parallax", "searches of a relief, 512 x 512 pixels: work is heights read, or cells looked at", methods,
            true};
}

}  // namespace relief
