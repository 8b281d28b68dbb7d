// Parallax: each search of labs 11 and 12 on a wall, at angles around the middle and at grazing ones. Timed is the
// probe `uv`, which is the search and hardly anything else.
#include <fmt/format.h>

#include "framework/image/compare.h"
#include "framework/lab/manifest.h"
#include "framework/measure/topics.h"

namespace relief {
namespace {

struct Search {
    std::string name, lab;
    std::vector<std::pair<std::string, std::string>> set;
};

std::vector<Search> searches() {
    std::vector<Search> all;
    for (const char* method : {"walk", "coarse", "windows", "max-mips"})
        all.push_back({method, "12", {{"method", method}}});
    all.push_back({"windows-fixed", "12", {{"method", "windows"}, {"fixed", "1"}}});
    for (const char* steps : {"32", "64"})
        all.push_back({fmt::format("linear-{}", steps), "12", {{"method", "linear"}, {"steps", steps}}});
    return all;
}

/// Cameras whose pixels see the wall at these angles from its normal, in degrees.
struct Angles {
    const char* name;
    double middle, field_of_view, distance;
};
constexpr Angles angles[] = {{"15-65", 40, 50, 1.1}, {"60-85", 72.5, 25, 1.5}};

BenchError error_of(Lab& lab, const Shot& shot) {
    const Image error = error_image(take(lab, shot), truth_of(lab, shot), ErrorMetric::distance);
    const ErrorSummary summary = summarize(error);
    size_t wrong = 0;
    for (const float value : error.values) wrong += std::isfinite(value) && value > 1;
    BenchError result{summary.mean, summary.p99, summary.largest, "texel"};
    result.wrong = double(wrong) / double(std::max<size_t>(1, summary.count));
    return result;
}

double mean_steps(Lab& lab, Shot shot) {
    shot.probe = {"steps"};
    const Image steps = take(lab, shot);
    double sum = 0, count = 0;
    for (size_t i = 0; i < steps.values.size(); i += 4)
        if (std::isfinite(steps.values[i])) sum += double(steps.values[i]), ++count;
    return sum / std::max(1.0, count);
}

std::vector<BenchMethod> methods(const BenchSettings& settings) {
    std::vector<BenchMethod> result;
    const auto target = std::make_shared<Target>(TargetKind::probe, glm::ivec2(512));
    std::vector<std::string> maps = {"bricks", "stones", "posts"};
    if (!settings.quick) maps.insert(maps.end(), {"fbm", "rock", "smooth", "paving"});
    for (const char* size : {"512", "1024"})
        for (const std::string& map : maps)
            for (const char* bits : {"float", "8"})
                for (const Angles& seen : angles) {
                    if (settings.quick && (std::string(size) == "1024" || std::string(bits) == "8")) continue;
                    for (const Search& search : searches()) {
                        Shot shot{.size = target->size(),
                                  .camera = {.yaw = seen.middle,
                                             .pitch = 0,
                                             .distance = seen.distance,
                                             .field_of_view = seen.field_of_view},
                                  .probe = {"uv"},
                                  .set = search.set};
                        const std::vector<std::pair<std::string, std::string>> scene = {
                            {"map", map}, {"size", size}, {"bits", bits}};
                        shot.set.insert(shot.set.end(), scene.begin(), scene.end());
                        shot.set.emplace_back("extent", "10");
                        const std::shared_ptr<Lab> lab = make_lab(find_lab(search.lab), shot);
                        BenchMethod& method = result.emplace_back();
                        method.name = search.name, method.item = "frame", method.knobs = scene;
                        method.knobs.emplace_back("angle", seen.name);
                        method.error = error_of(*lab, shot), method.work = mean_steps(*lab, shot);
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
    return {"parallax", "searches of a relief's hit, at 512 x 512: time, error, heights read or cells looked at",
            methods, true};
}

}  // namespace relief
