// An error budget on lab 17's wall, which reaches the horizon, at 512 x 512 pixels (or --size). Compares the cheapest
// method per patch and pixel with each method alone. Times both the probe `uv` (the search and little else) and the
// picture. The error is the number of pixels by which the relief would have to move to make the picture correct.
#include <fmt/format.h>

#include <algorithm>

#include "framework/course/manifest/manifest.h"
#include "framework/library/kit/relief_material.h"
#include "framework/staff/measure/bench.h"
#include "framework/staff/measure/drawn_subject.h"
#include "framework/staff/reference/least_move.h"

namespace relief::measure {
namespace {

constexpr double wall_depth = 0.03;  // metres
constexpr double wall_texels = 512;  // per metre

/// The wall with its height map, which is created on demand.
class Wall {
public:
    explicit Wall(int map) {
        material_.map = map;
        material_.size = 2;
        material_.asset_texels = int(wall_texels);
    }
    /// Returns the errors in pixels for a shot of the probe `uv`.
    Image errors(const Image& uv, const Camera& camera) {
        if (!field_) field_.emplace(material_.heights(), true);
        Image errors(uv.width, uv.height, 1);
        std::fill(errors.values.begin(), errors.values.end(), no_surface);
        for (const ShownError& one : wall_errors(uv, *field_, wall_texels, wall_depth, camera.clip_from_world()))
            *errors.pixel(one.pixel.x, one.pixel.y) = float(one.pixels);
        return errors;
    }

private:
    ReliefMaterial material_;
    std::optional<HeightField> field_;
};

std::vector<BenchScene> budget_scenes(const BenchSettings& settings) {
    std::vector<BenchScene> result;
    std::vector<std::pair<std::string, int>> maps = {{"wall", ReliefMap::wall}};
    if (!settings.quick) {
        maps.emplace_back("stones", ReliefMap::stones);
        maps.emplace_back("fbm", ReliefMap::fbm);
        maps.emplace_back("smooth", ReliefMap::smooth);
    }
    for (const auto& one : maps)
        for (const std::string draws : {"uv", "picture"}) {
            const std::string& map = one.first;  // not a structured binding: clang 14 cannot capture one in a lambda
            BenchScene& scene = result.emplace_back();
            scene.knobs = {{"map", map}, {"draws", draws}};
            scene.item = "frame";
            const auto wall = std::make_shared<Wall>(one.second);
            const auto add = [&](const std::string& name, const BenchKnobs& knobs, const BenchKnobs& set) {
                const auto subject_of = [=] {
                    const LabEntry& entry = find_lab("17");
                    Shot shot{.size = settings.size.value_or(usual_size),
                              .time = 0,
                              .camera = load_manifest(entry).camera,
                              .probe = {"uv"},
                              .set = together(set, knobs)};
                    const BenchKnobs view = {
                        {"view", "picture"}, {"map", map}, {"size", "512"}, {"depth", fmt::format("{}", wall_depth)}};
                    shot.set = together(shot.set, view);
                    const std::shared_ptr<Lab> lab = make_lab(entry, shot);
                    Shot timed = shot;
                    if (draws == "picture") timed.probe = {};
                    BenchSubject subject = drawn(lab, timed);
                    const Image errors = wall->errors(render_shot(*lab, shot), Camera(shot.camera, 1));
                    subject.error = error_over(errors, "pixel");
                    subject.work.emplace_back("taps", mean_of_probe(*lab, shot, "work"));
                    if (settings.pictures) {
                        show_picture(subject, *lab, shot);
                        show_errors(subject, errors, 4);
                    }
                    return subject;
                };
                scene.methods.push_back({name, knobs, subject_of});
            };
            std::vector<const char*> budgets = {"1"};
            if (!settings.is_first_look()) budgets = {"0.5", "1", "2", "4"};
            for (const char* budget : budgets) add("auto", {{"budget", budget}}, {});
            // The methods of labs 11 and 12, without a budget.
            for (const char* method : {"plain", "normal-map", "parallax", "exact"})
                add(method, {}, {{"method", method}});
            // One method in all pixels, with the budget spent.
            for (const char* method : {"parallax", "exact"})
                for (const char* budget : budgets)
                    add(std::string(method) + "-thinned", {{"budget", budget}}, {{"method", method}, {"spend", "on"}});
            // Tens of millions of triangles take seconds per frame on the software renderer, so one is enough.
            if (!settings.quick && draws == "uv") add("displacement", {{"budget", "4"}}, {{"method", "displacement"}});
        }
    return result;
}

}  // namespace

const TopicRegistration budget_topic(
    {.name = "budget",
     .help = "lab 17's wall within a budget of pixels; taps are heights read per pixel",
     .question = "Which method keeps a budget of pixels in the least time?",
     .scenes = budget_scenes,
     .draws = true,
     .labs = {"17"}});

}  // namespace relief::measure
