// Parallax: the searches of labs 11 and 12 on a wall, at medium and grazing angles. The probe `uv` is timed: it is the
// search and little else.
#include <optional>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/course/manifest/manifest.h"
#include "framework/staff/grade/overlay.h"
#include "framework/staff/measure/bench.h"
#include "framework/staff/measure/drawn_subject.h"

namespace relief::measure {
namespace {

struct Search {
    const char *name, *lab;
    BenchKnobs knobs;                 // in the plot
    BenchKnobs set = {};              // fixed knobs, not in the plot
    const char* published = nullptr;  // macros of published_march.glsl, which replaces lab 11's march

    bool is_peer() const { return published || name == std::string("usual") || name == std::string("relaxed"); }
};

std::vector<Search> searches() {
    // The commonly copied version: 8 to 32 steps by angle, one linear intersection, texture() in the loop.
    std::vector<Search> all = {
        {"usual", "11", {}, {{"count", "angle"}, {"refine", "linear"}, {"lookup", "implicit"}, {"skip", "off"}}}};
    const auto publish = [&](const char* name, const char* most, const char* least, const char* macros) {
        const BenchKnobs set = {{"count", "angle"},   {"steps", most},        {"least_steps", least},
                                {"refine", "linear"}, {"lookup", "implicit"}, {"skip", "off"}};
        all.push_back({name, "11", {}, set, macros});
    };
    publish("LearnOpenGL", "32", "8", "#define MOST_STEPS 33\n#define HALVINGS 0\n");
    // three.js leaves the counts to the application; these are from its example.
    publish("three.js-occlusion", "25", "20", "#define MOST_STEPS 30\n#define HALVINGS 0\n");
    publish("three.js-relief", "25", "20", "#define MOST_STEPS 30\n#define HALVINGS 5\n");
    const auto march = [&](const char* refine, const char* rounds, std::initializer_list<const char*> counts) {
        for (const char* steps : counts) {
            Search& search = all.emplace_back(Search{refine, "11", {{"steps", steps}}});
            search.set = {{"count", "fixed"}, {"refine", refine}, {"skip", "off"}, {"rounds", rounds}};
            if (rounds[0] != '0') search.knobs.emplace_back("rounds", rounds);
        }
    };
    march("linear", "0", {"8", "16", "32", "64", "128"});
    march("secant", "2", {"8", "16"});
    march("bisection", "5", {"16"});
    march("illinois", "3", {"16"});
    for (const char* texels : {"4", "2", "1"})
        all.push_back({"by-texel",
                       "11",
                       {{"texels_per_step", texels}},
                       {{"count", "texel"}, {"refine", "secant"}, {"rounds", "2"}}});
    for (const char* method : {"walk", "coarse", "windows", "max-mips", "cones", "relaxed"})
        all.push_back(
            {method, "12", {}, {{"method", method}, {"shadow", "none"}, {"write_depth", "off"}, {"outline", "off"}}});
    return all;
}

/// Returns lab 11's task file with another march().
grade::CourseFiles with_march(const std::string& macros) {
    const std::string file = "shaders/11_parallax_occlusion/task.glsl", begin = "//(march\n", end = "//)\n";
    std::string text = read_file(course_root() / file);
    const size_t from = text.find(begin), to = text.find(end, from);
    if (from == std::string::npos || to == std::string::npos) throw Error(file + " does not mark its march()");
    const auto published = course_root() / "labs/11_parallax_occlusion/staff/published_march.glsl";
    text.replace(from + begin.size(), to - from - begin.size(), macros + read_file(published));
    return {{file, text}};
}

/// Cameras whose pixels see the wall at these angles from its normal, in degrees.
struct Angles {
    const char* name;
    double middle, field_of_view, distance;
};
constexpr Angles angles[] = {{"15-65", 40, 50, 1.1}, {"60-85", 72.5, 25, 1.5}};

BenchScene scene_of(const BenchKnobs& map, const Angles& seen, const BenchSettings& settings) {
    BenchScene scene{together(map, {{"angle", seen.name}}), "frame"};
    const auto truth = std::make_shared<std::optional<Image>>();  // the same for every search
    for (const Search& search : searches()) {
        Shot shot;
        shot.size = settings.frame_size();
        shot.probe = {"uv"};
        shot.set = together(together(search.set, search.knobs), {{"view", "one"}, {"extent", "10"}, {"depth", "0.08"}});
        shot.set = together(shot.set, map);
        shot.camera = {.yaw = seen.middle, .pitch = 0, .distance = seen.distance, .field_of_view = seen.field_of_view};
        const auto prepare = [truth, shot, lab_number = search.lab, published = search.published, settings] {
            // The programs are compiled before the overlay ends, because the errors are computed here.
            std::optional<grade::CourseOverlay> overlay;
            if (published) overlay.emplace(with_march(published));
            const std::shared_ptr<Lab> lab = make_lab(find_lab(lab_number), shot);
            if (!*truth) *truth = truth_of(*lab, shot);
            BenchSubject subject = drawn(lab, shot);
            const Image errors = error_image(render_shot(*lab, shot), **truth, ErrorMetric::distance);
            subject.error = error_over(errors, "texel");
            // Heights read in lab 11; visited cells, blocks or cones in lab 12.
            subject.work.emplace_back(lab_number == std::string("11") ? "taps" : "visits",
                                      mean_of_probe(*lab, shot, "steps"));
            if (settings.pictures) {
                show_picture(subject, *lab, shot);
                show_errors(subject, errors, 4);
            }
            return subject;
        };
        scene.methods.push_back({search.name, search.knobs, prepare, search.is_peer()});
    }
    return scene;
}

std::vector<BenchScene> parallax_scenes(const BenchSettings& settings) {
    std::vector<BenchKnobs> maps;
    for (const char* map : {"bricks", "stones", "posts"})
        for (const char* bits : {"float", "8"}) maps.push_back({{"map", map}, {"size", "512"}, {"bits", bits}});
    if (settings.quick)
        maps.resize(1);
    else
        for (const char* map : {"bricks", "stones", "posts", "smooth", "fbm", "rock", "paving"})
            maps.push_back({{"map", map}, {"size", "1024"}, {"bits", "float"}});
    std::vector<BenchScene> result;
    for (const BenchKnobs& map : maps)
        for (const Angles& seen : angles) result.push_back(scene_of(map, seen, settings));
    return result;
}

}  // namespace

const TopicRegistration parallax_topic(
    {.name = "parallax",
     .help = "searches of a relief; taps are heights read, visits cells or blocks looked at",
     .question = "Which search finds the relief soonest, and how far off is it?",
     .scenes = parallax_scenes,
     .draws = true,
     .labs = {"10", "11", "12"}});

}  // namespace relief::measure
