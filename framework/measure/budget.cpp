// An error budget on lab 17's wall, from the eye to the horizon: whatever is cheapest against every method alone, 512 x
// 512 pixels, each as the probe `uv` (the search, and hardly anything else) and as the picture. The error is by how
// many pixels the relief would have to move for what is shown to be right.
#include <fmt/format.h>

#include <cmath>

#include "framework/lab/manifest.h"
#include "framework/lab/relief_material.h"
#include "framework/measure/topics.h"
#include "framework/reference/least_move.h"

namespace relief {
namespace {

using Set = std::vector<std::pair<std::string, std::string>>;

constexpr glm::ivec2 size{512, 512};
constexpr double depth = 0.03, texels = 512;  // metres; a metre

BenchError error_of(const std::vector<ShownError>& shown) {
    std::vector<double> errors;
    double wrong = 0;
    for (const ShownError& one : shown) errors.push_back(one.pixels), wrong += one.pixels > 1;
    const double count = std::max(1.0, double(errors.size()));
    BenchError error = error_figures(std::move(errors), "pixel");
    error.wrong = wrong / count;
    return error;
}

class Walls {
public:
    Walls(std::vector<BenchMethod>& methods, const std::string& map) : methods_(methods), map_(map) {
        material_.map = map == "wall" ? 6 : map == "fbm" ? 1 : map == "smooth" ? 0 : 3;
        material_.size = 2, material_.asset_texels = int(texels);
        field_.emplace(material_.heights(), true);
    }

    /// As the probe and as the picture.
    void add(const char* name, const Set& set) {
        const LabEntry& entry = find_lab("17");
        Shot shot{.size = size, .time = 0, .camera = load_manifest(entry).camera, .probe = {"uv"}, .set = set};
        shot.set.insert(shot.set.end(),
                        {{"view", "picture"}, {"map", map_}, {"size", "512"}, {"depth", fmt::format("{}", depth)}});
        const std::shared_ptr<Lab> lab = make_lab(entry, shot);
        const BenchError error =
            error_of(wall_errors(take(*lab, shot), *field_, texels, depth, Camera(shot.camera, 1).clip_from_world()));
        const double work = mean_work(*lab, shot);
        for (const char* what : {"uv", "picture"}) {
            const bool is_probe = what == std::string("uv");
            const auto target = std::make_shared<Target>(is_probe ? TargetKind::probe : TargetKind::picture, size);
            Shot seen = shot;
            if (!is_probe) seen.probe = {};
            BenchMethod& method = methods_.emplace_back();
            method.name = name, method.item = "frame", method.error = error, method.work = work;
            method.knobs = {{"map", map_}, {"draws", what}};
            method.knobs.insert(method.knobs.end(), set.begin(), set.end());
            method.run = [lab, target, seen] { draw_lab(*lab, frame_of(seen, *target)), glFinish(); };
        }
    }

private:
    static double mean_work(Lab& lab, Shot shot) {
        shot.probe = {"work"};
        const Image read = take(lab, shot);
        double sum = 0, count = 0;
        for (size_t i = 0; i < read.values.size(); i += 4)
            if (std::isfinite(read.values[i])) sum += double(read.values[i]), ++count;
        return sum / std::max(1.0, count);
    }

    std::vector<BenchMethod>& methods_;
    std::string map_;
    ReliefMaterial material_;
    std::optional<HeightField> field_;
};

std::vector<BenchMethod> methods(const BenchSettings& settings) {
    std::vector<BenchMethod> result;
    std::vector<const char*> maps{"wall"};
    if (!settings.quick) maps.insert(maps.end(), {"stones", "fbm", "smooth"});
    for (const char* map : maps) {
        Walls walls(result, map);
        for (const char* budget : {"0.5", "1", "2", "4"}) walls.add("auto", {{"budget", budget}});
        // As labs 11 and 12 have them: they know of no budget.
        for (const char* method : {"plain", "normal-map", "parallax", "exact"}) walls.add(method, {{"method", method}});
        // With the budget spent in every pixel, but by one method.
        for (const char* budget : {"0.5", "1", "2", "4"})
            for (const char* method : {"parallax", "exact"})
                walls.add(method, {{"method", method}, {"spend", "on"}, {"budget", budget}});
        if (settings.quick) continue;
        for (const char* budget : {"1", "4"})
            walls.add("displacement", {{"method", "displacement"}, {"budget", budget}});
    }
    return result;
}

}  // namespace

BenchTopic budget_topic() {
    return {"budget", "lab 17's wall within a budget of pixels, 512 x 512 pixels: work is heights read a pixel",
            methods, true};
}

}  // namespace relief
