// Displacement at 512 x 512 pixels (or --size), in four parts:
// - Levels of lab 14 on hilly ground: time against the screen distance of surface points from their correct positions.
// - The gain by culling.
// - Spacings of lab 13 on a torus of stones: `wrong` is the share of pixels that differ from the outline of
//   micro-polygons.
// - The plain speed of triangles.
#include <fmt/format.h>

#include <cmath>

#include "framework/core/gl/gpu_mesh.h"
#include "framework/core/gl/program.h"
#include "framework/course/manifest/manifest.h"
#include "framework/library/kit/displaced_surface.h"
#include "framework/staff/measure/bench.h"
#include "framework/staff/measure/drawn_subject.h"
#include "framework/staff/measure/stability.h"
#include "framework/staff/reference/patch_points.h"

namespace relief::measure {
namespace {

glm::ivec2 size_of(const BenchSettings& settings) { return settings.size.value_or(usual_size); }

/// Returns the errors of a shot of the probe `place`, one for each pixel with a surface, from the top left. The shot of
/// `depth` is taken on demand.
using ErrorsOf = std::function<std::vector<double>(const Image& place, const std::function<Image()>& depth)>;
using FiguresOf = std::function<BenchError(const Image& place, std::vector<double> errors)>;

Image map_of(const std::vector<double>& errors, const Image& place) {
    Image map(place.width, place.height, 1);
    size_t next = 0;
    for (size_t i = 0; i < map.values.size(); ++i)
        map.values[i] = place.values[4 * i] == no_surface ? no_surface : float(errors.at(next++));
    return map;
}

/// A lab's drawing method: the probe `place` is timed and gives the error as well.
BenchMethod of_lab(const char* number, const std::string& name, const BenchKnobs& knobs, const BenchKnobs& set,
                   const Orbit& camera, const ErrorsOf& errors_of, const FiguresOf& figures_of,
                   const BenchSettings& settings) {
    const Shot shot{
        .size = size_of(settings), .time = 0, .camera = camera, .probe = {"place"}, .set = together(set, knobs)};
    return {name, knobs, [=] {
                const std::shared_ptr<Lab> lab = make_lab(find_lab(number), shot);
                BenchSubject subject = drawn(lab, shot);
                const auto depth = [&] {
                    Shot deep = shot;
                    deep.probe = {"depth"};
                    return render_shot(*lab, deep);
                };
                if (settings.pictures) show_picture(subject, *lab, shot);
                if (!errors_of) return subject;
                const Image place = render_shot(*lab, shot);
                const std::vector<double> errors = errors_of(place, depth);
                subject.error = figures_of(place, errors);
                if (settings.pictures)
                    show_errors(subject, map_of(errors, place), subject.error.unit == "metre" ? 0.05 : 2);
                return subject;
            }};
}

BenchError pixels_off(std::vector<double> errors) {
    const auto wrong = std::count_if(errors.begin(), errors.end(), [](double error) { return error > 1; });
    const double count = std::max(1.0, double(errors.size()));
    BenchError error = error_figures(std::move(errors), "pixel");
    error.wrong = double(wrong) / count;
    return error;
}

/// Micro-polygons, tessellated beforehand. Draws each pixel's patch position, like the labs' probe `place`.
class TessellatedMesh {
public:
    TessellatedMesh(const Mesh& mesh, int n)
        : vertices_a_patch_((n + 1) * (n + 1)), mesh_(upload([&] { return mesh; })) {
        mesh_.layout();  // uploads it while `mesh` is in scope
    }

    void draw(const Target& target, const Camera& camera) const {
        glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
        glViewport(0, 0, target.size().x, target.size().y);
        glEnable(GL_DEPTH_TEST);
        glEnable(GL_CULL_FACE);
        constexpr float nothing[] = {no_surface, no_surface, no_surface, no_surface};
        glClearBufferfv(GL_COLOR, 0, nothing);
        glClear(GL_DEPTH_BUFFER_BIT);
        glUseProgram(program_);
        program_.set("u_clip_from_world", camera.clip_from_world());
        program_.set("u_vertices_a_patch", vertices_a_patch_);
        glBindVertexArray(mesh_.layout());
        glDrawElements(GL_TRIANGLES, mesh_.count(), GL_UNSIGNED_INT, nullptr);
        glDisable(GL_CULL_FACE);
        glDisable(GL_DEPTH_TEST);
    }

private:
    static ShaderSource stage(const char* file, const char* text) {
        return {file, text, {}, {"u_clip_from_world", "u_vertices_a_patch"}};
    }

    Program program_{{stage("tessellated.vert",
                            "#version 410 core\nlayout(location = 0) in vec3 a_position;\n"
                            "layout(location = 3) in vec2 a_uv;\nuniform mat4 u_clip_from_world;\n"
                            "uniform int u_vertices_a_patch;\nout vec3 v_place;\nvoid main() {\n"
                            "    v_place = vec3(a_uv, gl_VertexID / u_vertices_a_patch);\n"
                            "    gl_Position = u_clip_from_world * vec4(a_position, 1.0);\n}\n"),
                      stage("tessellated.frag",
                            "#version 410 core\nin vec3 v_place;\nlayout(location = 0) out vec4 o_color;\n"
                            "void main() { o_color = vec4(v_place, 0.0); }\n")}};
    int vertices_a_patch_;
    GpuMesh mesh_;
};

/// Returns the share of pixels covered by only one of two pictures, among the pixels covered by either.
double share_apart(const Image& a, const Image& b) {
    double covered = 0, apart = 0;
    for (size_t i = 0; i < a.values.size(); i += 4) {
        const bool in_a = a.values[i] != no_surface, in_b = b.values[i] != no_surface;
        covered += in_a || in_b;
        apart += in_a != in_b;
    }
    return apart / std::max(1.0, covered);
}

/// A hilly ground that reaches the horizon: lab 14's, with these knobs.
const BenchKnobs ground_knobs = {{"view", "eye"},
                                 {"surface", "ground"},
                                 {"corners", "4"},
                                 {"patches", "32"},
                                 {"map", "fbm"},
                                 {"size", "512"},
                                 {"depth", "0.1"},
                                 {"repeat", "1"},
                                 {"fade", "off"},
                                 {"cull", "all"},
                                 {"spacing", "fractional-odd"}};

struct Ground {
    DisplacedSurface surface;
    Orbit camera{.yaw = 30, .pitch = 7, .distance = 7.5, .target = {0, -0.5, 0}};
    std::optional<HeightField> heights;

    Ground() {
        surface.shape = DisplacedSurface::ground;
        surface.density = 32;
        surface.depth = 0.1f;
        surface.material.map = ReliefMap::fbm;
        surface.material.size = 2;
    }
    const HeightField& field() {
        if (!heights) heights.emplace(surface.heights(), true);
        return *heights;
    }
    /// Returns the errors in pixels for a picture of the probe `place`.
    std::vector<double> off(const Image& place) {
        return screen_errors(place, surface.patches(), field(), double(surface.scale()),
                             Camera(camera, 1).clip_from_world());
    }
};

BenchScene levels(const BenchSettings& settings) {
    const auto ground = std::make_shared<Ground>();
    const ErrorsOf off = [ground](const Image& place, const auto&) { return ground->off(place); };
    const FiguresOf figures = [](const Image&, std::vector<double> errors) { return pixels_off(std::move(errors)); };
    BenchScene scene{{{"surface", "ground"}}, "frame"};
    const auto add = [&](const char* method, const char* knob, const std::vector<const char*>& values) {
        for (size_t i = 0; i < values.size(); i += settings.is_first_look() ? 2 : 1)
            scene.methods.push_back(of_lab("14", method, {{knob, values[i]}},
                                           together(ground_knobs, {{"method", method}}), ground->camera, off, figures,
                                           settings));
    };
    // The settings of common tutorials: level 64 near the eye, 4 far away, by distance alone.
    BenchMethod& usual = scene.methods.emplace_back(of_lab(
        "14", "usual", {},
        together(ground_knobs,
                 {{"method", "distance"}, {"nearest", "0.8"}, {"farthest", "20"}, {"finest", "6"}, {"coarsest", "2"}}),
        ground->camera, off, figures, settings));
    usual.peer = true;
    add("uniform", "level", {"1", "2", "4", "8", "16"});
    add("distance", "finest", {"3", "4", "5", "6"});
    add("size", "segment", {"32", "16", "8", "4"});
    add("error", "budget", {"8", "4", "2", "1", "0.5"});
    if (settings.quick) return scene;
    add("uniform", "level", {"32"});
    for (const int n : {4, 8, 16})
        scene.methods.push_back(
            {"mesh", {{"squares", fmt::format("{0}x{0}", n)}}, [ground, n, size = size_of(settings)] {
                 const DisplacedSurface& surface = ground->surface;
                 const auto mesh = std::make_shared<TessellatedMesh>(
                     micro_polygons(surface.patches(), ground->field(), double(surface.scale()), n), n);
                 const auto draw = [mesh, ground](const Target& target) {
                     mesh->draw(target, Camera(ground->camera, 1));
                 };
                 BenchSubject subject = drawn(TargetKind::probe, size, draw);
                 const Target target(TargetKind::probe, size);
                 draw(target);
                 subject.error = pixels_off(ground->off(target.read()));
                 return subject;
             }});
    return scene;
}

/// Adds scenes in which a tenth of the patches is in the picture.
void add_culling(std::vector<BenchScene>& scenes, const BenchSettings& settings) {
    const Orbit camera{.yaw = 45, .pitch = 8, .distance = 3, .target = {-2, 0, -2}, .field_of_view = 27};
    const BenchKnobs set = {{"view", "eye"}, {"surface", "ground"}, {"corners", "4"}, {"patches", "128"},
                            {"map", "fbm"},  {"size", "1024"},      {"depth", "0.1"}, {"fade", "off"}};
    for (const BenchKnobs& levels :
         {BenchKnobs{{"method", "uniform"}, {"level", "1"}}, BenchKnobs{{"method", "uniform"}, {"level", "8"}},
          BenchKnobs{{"method", "uniform"}, {"level", "16"}}, BenchKnobs{{"method", "error"}, {"budget", "1"}}}) {
        if (settings.is_first_look() && levels[1].second != "8") continue;
        BenchScene& scene = scenes.emplace_back();
        scene.knobs = {{"levels", levels[0].second}, levels[1]};
        scene.item = "frame";
        for (const char* cull : {"none", "outside", "all"}) {
            const auto at = [&](const BenchKnobs& at_levels, const BenchSettings& with) {
                return of_lab("14", "cull", {{"cull", cull}}, together(set, at_levels), camera, {}, {}, with);
            };
            BenchMethod method = at(levels, settings);
            // At level 1 a patch is two triangles, so this counts the remaining patches.
            const auto coarse = at({{"method", "uniform"}, {"level", "1"}}, {}).prepare;
            method.prepare = [whole = method.prepare, coarse] {
                BenchSubject subject = whole();
                for (const auto& [name, amount] : coarse().work)
                    if (name == "triangles") subject.work.emplace_back("patches", amount / 2);
                return subject;
            };
            scene.methods.push_back(std::move(method));
        }
    }
}

/// Lab 13's torus of stones with its exact picture.
struct Torus {
    DisplacedSurface surface;
    Orbit camera{.yaw = 35, .pitch = 25, .distance = 3.4};
    std::optional<HeightField> heights;
    glm::ivec2 size;
    Image exact;  // patch positions of the micro-polygons

    explicit Torus(glm::ivec2 picture) : size(picture) {
        surface.shape = DisplacedSurface::torus;
        surface.density = 4;
        surface.depth = 0.1f;
        surface.material.map = ReliefMap::stones;
        surface.material.size = 1;
    }
    void look() {
        if (heights) return;
        heights.emplace(surface.heights(), true);
        const TessellatedMesh micro(micro_polygons(surface.patches(), *heights, double(surface.scale()), 192), 192);
        const Target target(TargetKind::probe, size);
        micro.draw(target, Camera(camera, 1));
        exact = target.read();
    }
    std::vector<double> pixels(const Image& place) {
        look();
        return screen_errors(place, surface.patches(), *heights, double(surface.scale()),
                             Camera(camera, 1).clip_from_world());
    }
    std::vector<double> metres(const Image& place, const Image& depth) {
        look();
        std::vector<double> errors;
        const Frame frame{0, size, 0, Camera(camera, 1), {}};
        for (const auto& [pixel, truth] : shown_places(place, surface.patches(), *heights, double(surface.scale()))) {
            const Ray ray = frame.ray(pixel.x, pixel.y);
            errors.push_back(glm::distance(truth, ray.origin + double(*depth.pixel(pixel.x, pixel.y)) * ray.direction));
        }
        return errors;
    }
};

void add_spacings(std::vector<BenchScene>& scenes, const BenchSettings& settings) {
    const auto torus = std::make_shared<Torus>(size_of(settings));
    const BenchKnobs set = {{"view", "one"},  {"surface", "torus"}, {"mip", "base"}, {"corners", "4"},
                            {"patches", "4"}, {"map", "stones"},    {"size", "256"}, {"depth", "0.1"}};
    const ErrorsOf pixels = [torus](const Image& place, const auto&) { return torus->pixels(place); };
    const ErrorsOf metres = [torus](const Image& place, const auto& depth) { return torus->metres(place, depth()); };
    const FiguresOf of_pixels = [torus](const Image& place, std::vector<double> errors) {
        BenchError error = pixels_off(std::move(errors));
        error.wrong = share_apart(place, torus->exact);
        return error;
    };
    const FiguresOf of_metres = [](const Image&, std::vector<double> errors) {
        return error_figures(std::move(errors), "metre");
    };
    for (const auto& [unit, errors_of, figures_of] :
         {std::tuple{"pixels", pixels, of_pixels}, {"metres", metres, of_metres}}) {
        BenchScene& scene = scenes.emplace_back();
        scene.knobs = {{"surface", "torus"}, {"error_in", unit}};
        scene.item = "frame";
        for (const char* spacing : DisplacedSurface::spacings)
            for (const char* level : {"2", "4", "8", "16", "32", "64"})
                scene.methods.push_back(of_lab("13", spacing, {{"level", level}}, together(set, {{"spacing", spacing}}),
                                               torus->camera, errors_of, figures_of, settings));
    }
}

std::vector<BenchScene> displacement_scenes(const BenchSettings& settings) {
    std::vector<BenchScene> result = {levels(settings)};
    add_culling(result, settings);
    if (settings.quick) return result;
    add_spacings(result, settings);
    result.push_back({{{"surface", "wall"}},
                      "frame",
                      {of_lab("13", "most", {{"level", "64"}},
                              {{"view", "one"},
                               {"surface", "wall"},
                               {"mip", "base"},
                               {"corners", "4"},
                               {"patches", "16"},
                               {"map", "fbm"},
                               {"size", "512"}},
                              {.yaw = 20, .pitch = 10, .distance = 3}, {}, {}, settings)}});
    return result;
}

}  // namespace

std::vector<double> ground_pixels_off(const BenchKnobs& knobs) {
    static Ground ground;
    const Shot shot{.size = usual_size,
                    .time = 0,
                    .camera = ground.camera,
                    .probe = {"place"},
                    .set = together(ground_knobs, knobs)};
    return ground.off(render_shot(*make_lab(find_lab("14"), shot), shot));
}

const TopicRegistration displacement_topic(
    {.name = "displacement",
     .help = "levels of tessellation; a tenth of a ground culled; spacings, wrong: apart from the "
             "true outline",
     .question = "How fine must triangles be to show a relief?",
     .scenes = displacement_scenes,
     .draws = true,
     .labs = {"13", "14"}});

}  // namespace relief::measure
