// Materials: the time of a frame of lab 08 with a program for each set of features, and with one program with branches.
// The errors of orders, masks and filters. The time to read a large model.
#include <fmt/format.h>

#include <cmath>

#include "framework/core/gl/counters.h"
#include "framework/core/image/compare.h"
#include "framework/course/manifest/manifest.h"
#include "framework/library/mesh/obj.h"
#include "framework/staff/measure/bench.h"
#include "framework/staff/measure/drawn_subject.h"
#include "framework/staff/reference/masks.h"

namespace relief::measure {
namespace {

Shot garden_shot(const BenchSettings& settings, BenchKnobs set) {
    Shot shot;
    shot.size = settings.frame_size(), shot.camera = load_manifest(find_lab("08")).camera;
    shot.set = together({{"view", "one"}}, set);
    return shot;
}

/// A frame, with the number of programs linked for its first run.
BenchSubject frame_of(const std::shared_ptr<Lab>& lab, const Shot& shot, const BenchSettings& settings) {
    const int64_t before = counters().links;
    BenchSubject subject = drawn(lab, shot);
    subject.work.emplace_back("programs", double(counters().links - before));
    if (settings.pictures) show_picture(subject, *lab, shot);
    return subject;
}

/// Adds the error against the exact light of a small picture, which the methods of a scene share.
void add_light_error(BenchSubject& subject, Lab& lab, Shot shot, glm::ivec2 size, Image& exact,
                     const BenchSettings& settings) {
    shot.size = size, shot.probe = {"color"};
    if (exact.values.empty()) exact = truth_of(lab, shot);
    const Image errors = error_image(render_shot(lab, shot), exact, ErrorMetric::distance);
    subject.error = error_over(errors, "light");
    subject.error.wrong.reset();
    if (settings.pictures) show_errors(subject, errors, 0.5);
}

BenchScene programs(const char* file, const BenchSettings& settings) {
    BenchScene scene{{{"file", file}}, "frame"};
    for (const char* kind : {"compiled", "branches"})
        for (const char* order : {"sorted", "file"}) {
            if (settings.is_first_look() && order == std::string("file")) continue;
            scene.methods.push_back(
                {kind, {{"programs", kind}, {"order", order}}, [=] {
                     const Shot shot = garden_shot(settings, {{"file", file}, {"programs", kind}, {"order", order}});
                     return frame_of(make_lab(find_lab("08"), shot), shot, settings);
                 }});
        }
    return scene;
}

/// Three panes from behind, so that the file's order is wrong.
BenchScene orders(const BenchSettings& settings) {
    BenchScene scene{{{"panes", "3"}}, "frame"};
    const auto exact = std::make_shared<Image>();
    for (const char* order : {"sorted", "file", "backwards", "weighted"})
        scene.methods.push_back(
            {order, {{"order", order}}, [=] {
                 Shot shot = garden_shot(settings, {{"maps", "off"}, {"order", order}});
                 shot.camera = {
                     .yaw = 180, .pitch = 0, .distance = 1.4, .target = {-2.2, 0.8, 1.7}, .field_of_view = 75};
                 const std::shared_ptr<Lab> lab = make_lab(find_lab("08"), shot);
                 BenchSubject subject = frame_of(lab, shot, settings);
                 add_light_error(subject, *lab, shot, {128, 128}, *exact, settings);
                 return subject;
             }});
    return scene;
}

/// The coverage of a fence when a pixel is as wide as a texel of a mip level, compared with the formula of its wires.
BenchScene masks(int level, const BenchSettings& settings) {
    BenchScene scene{{{"level", fmt::format("{}", level)}}, "frame"};
    const auto add = [&](const char* name, const BenchKnobs& knobs, bool is_peer = false) {
        scene.methods.push_back(
            {name, knobs,
             [=] {
                 Shot shot = garden_shot(settings, knobs);
                 // One metre of the fence: 1463 texels of level 0.
                 shot.camera = {.yaw = 0, .pitch = 0, .distance = 8, .target = {-2.3, 1.15, 0}, .field_of_view = 7.15};
                 const std::shared_ptr<Lab> lab = make_lab(find_lab("08"), shot);
                 BenchSubject subject = frame_of(lab, shot, settings);
                 shot.size = glm::ivec2(1463 >> level);
                 const double off = std::abs(mean_of_probe(*lab, shot, "coverage") - wire_coverage);
                 subject.error = {off, off, off, "share"};
                 return subject;
             },
             is_peer});
    };
    add("test", {{"alpha", "test"}, {"threshold", "0.1"}}, true);
    add("test", {{"alpha", "test"}, {"threshold", "0.5"}}, true);
    if (settings.is_first_look()) scene.methods.erase(scene.methods.begin());
    for (const char* alpha : {"keep", "to-coverage", "hashed"}) add(alpha, {{"alpha", alpha}});
    return scene;
}

/// The lawn at a grazing angle, up to its far end.
BenchScene filters(const BenchSettings& settings) {
    BenchScene scene{{{"ground", "grazing"}}, "frame"};
    const auto exact = std::make_shared<Image>();
    for (const char* filter : {"nearest", "mips", "2", "4", "8", "16", "samples"}) {
        if (settings.quick && std::string(filter) == "samples") continue;
        if (settings.is_first_look() && (std::string(filter) == "2" || std::string(filter) == "8")) continue;
        scene.methods.push_back(
            {filter, {{"filter", filter}}, [=] {
                 Shot shot = garden_shot(settings, {{"filter", filter}, {"lamp", "sun"}});
                 shot.camera = {.yaw = 0, .pitch = 6, .distance = 12, .target = {-4.6, 0, -18}, .field_of_view = 8};
                 const std::shared_ptr<Lab> lab = make_lab(find_lab("08"), shot);
                 BenchSubject subject = frame_of(lab, shot, settings);
                 add_light_error(subject, *lab, shot, {48, 32}, *exact, settings);
                 return subject;
             }});
    }
    return scene;
}

/// A grid of triangles with uv and a normal, in strips of ten materials.
BenchScene reading(int side) {
    BenchScene scene{{{"faces", fmt::format("{}", 2 * side * side)}}, "face"};
    scene.methods.push_back({"read_obj", {}, [=] {
                                 const auto text = std::make_shared<std::string>("vn 0 1 0\n");
                                 std::string materials;
                                 for (int i = 0; i < 10; ++i) materials += fmt::format("newmtl {}\n", i);
                                 for (int i = 0; i <= side; ++i)
                                     for (int j = 0; j <= side; ++j)
                                         *text += fmt::format("v {0} 0 {1}\nvt {0} {1}\n", j, -i);
                                 for (int i = 0; i < side; ++i) {
                                     *text += fmt::format("usemtl {}\n", i % 10);
                                     for (int j = 0; j < side; ++j) {
                                         const int a = i * (side + 1) + j + 1, b = a + 1, c = b + side + 1, d = c - 1;
                                         *text += fmt::format("f {0}/{0}/1 {1}/{1}/1 {2}/{2}/1\n", a, b, c);
                                         *text += fmt::format("f {0}/{0}/1 {1}/{1}/1 {2}/{2}/1\n", a, c, d);
                                     }
                                 }
                                 BenchSubject subject;
                                 subject.items = 2 * size_t(side) * size_t(side);
                                 subject.bytes_per_item = double(text->size()) / double(subject.items);
                                 const ObjModel model = parse_obj(*text, materials);
                                 subject.work = {{"triangles", double(model.mesh.indices.size()) / 3},
                                                 {"vertices", double(model.mesh.vertices.size())},
                                                 {"subsets", double(model.subsets.size())}};
                                 subject.run = [text, materials] { parse_obj(*text, materials); };
                                 return subject;
                             }});
    return scene;
}

std::vector<BenchScene> materials_scenes(const BenchSettings& settings) {
    std::vector<BenchScene> all = {programs("garden", settings)};
    if (!settings.quick) all.push_back(programs("thousand", settings));
    all.push_back(orders(settings));
    for (const int level : {1, 3, 5})
        if (!settings.quick || level == 3) all.push_back(masks(level, settings));
    all.push_back(filters(settings));
    all.push_back(reading(settings.quick ? 70 : 707));
    return all;
}

}  // namespace

const TopicRegistration materials_topic(
    {.name = "materials",
     .help = "programs, orders, masks and filters of lab 08, and a model of a million faces",
     .question = "What do programs, orders and filters of materials cost?",
     .scenes = materials_scenes,
     .draws = true,
     .labs = {"08"}});

}  // namespace relief::measure
