// Displacement, 512 x 512 pixels: levels of lab 14 on a ground of hills, time against how far places of the surface are
// from where they should be on the screen; what culling saves; lab 13's spacings on a torus of stones, where `wrong` is
// the share of pixels that are apart from the outline of micro-polygons; and how fast triangles are at all.
#include <fmt/format.h>

#include <cmath>

#include "framework/gl/gpu_mesh.h"
#include "framework/gl/program.h"
#include "framework/image/height_maps.h"
#include "framework/lab/displaced_surface.h"
#include "framework/lab/manifest.h"
#include "framework/measure/topics.h"
#include "framework/reference/patches.h"

namespace relief {
namespace {

using Set = std::vector<std::pair<std::string, std::string>>;

/// Draws, and counts the triangles that came of it.
double triangles_of(const std::function<void()>& draw) {
    const QueryName query;
    glBeginQuery(GL_PRIMITIVES_GENERATED, query);
    draw();
    glEndQuery(GL_PRIMITIVES_GENERATED);
    GLuint count = 0;
    glGetQueryObjectuiv(query, GL_QUERY_RESULT, &count);
    return count;
}

/// What the scenes share: where they are drawn, and what the methods are added to.
class Scenes {
public:
    explicit Scenes(std::vector<BenchMethod>& methods) : methods_(methods) {}

    /// One way of drawing: timed as it writes `place`, of which the error is taken, too.
    void add(const std::string& name, const Set& knobs, const std::function<void()>& draw, const BenchError& error) {
        BenchMethod& method = methods_.emplace_back();
        method.name = name, method.knobs = knobs, method.item = "frame";
        method.work = triangles_of(draw);
        method.error = error;
        method.run = [draw] { draw(), glFinish(); };
    }
    void add_lab(const char* number, const std::string& name, const Set& scene, const Set& set, const Orbit& camera,
                 const std::function<BenchError(const Image& place, const Image& depth)>& error_of = {}) {
        Shot shot{.size = size, .time = 0, .camera = camera, .probe = {"place"}, .set = scene};
        shot.set.insert(shot.set.end(), set.begin(), set.end());
        const std::shared_ptr<Lab> lab = make_lab(find_lab(number), shot);
        const auto draw = [lab, shot, target = target_] { draw_lab(*lab, frame_of(shot, *target)); };
        BenchError error;
        if (error_of) {
            Shot deep = shot;
            deep.probe = {"depth"};
            error = error_of(take(*lab, shot), take(*lab, deep));
        }
        add(name, set, draw, error);
    }

    static constexpr glm::ivec2 size{512, 512};
    const Target& target() const { return *target_; }

private:
    std::vector<BenchMethod>& methods_;
    std::shared_ptr<Target> target_ = std::make_shared<Target>(TargetKind::probe, size);
};

BenchError pixels_off(std::vector<double> errors) {
    const auto wrong = std::count_if(errors.begin(), errors.end(), [](double error) { return error > 1; });
    const double count = std::max(1.0, double(errors.size()));
    BenchError error = error_figures(std::move(errors), "pixel");
    error.wrong = double(wrong) / count;
    return error;
}

/// Micro-polygons, tessellated beforehand; what is drawn is each pixel's place, as the labs' probe has it.
class TessellatedMesh {
public:
    TessellatedMesh(const Mesh& mesh, int n)
        : vertices_a_patch_((n + 1) * (n + 1)), mesh_(upload([&] { return mesh; })) {
        mesh_.layout();  // while the mesh is there
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

/// Of pixels that one of two pictures covers: how many the other does not.
double share_apart(const Image& a, const Image& b) {
    double covered = 0, apart = 0;
    for (size_t i = 0; i < a.values.size(); i += 4) {
        const bool in_a = a.values[i] != no_surface, in_b = b.values[i] != no_surface;
        covered += in_a || in_b, apart += in_a != in_b;
    }
    return apart / std::max(1.0, covered);
}

void add_levels(Scenes& scenes, bool quick) {
    const Orbit camera{.yaw = 30, .pitch = 7, .distance = 7.5, .target = {0, -0.5, 0}};
    DisplacedSurface surface;
    surface.shape = DisplacedSurface::ground, surface.density = 32, surface.depth = 0.1f;
    surface.material.map = int(HeightMap::fbm), surface.material.size = 2;
    const HeightField heights(surface.heights(), true);
    const Set scene = {{"view", "eye"},
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
    const Camera seen(camera, 1);
    const auto off = [&](const Image& place, const Image&) {
        return pixels_off(
            screen_errors(place, surface.patches(), heights, double(surface.scale()), seen.clip_from_world()));
    };
    const auto add = [&](const char* method, const char* knob, std::initializer_list<const char*> values) {
        for (const char* value : values)
            scenes.add_lab("14", method, scene, {{"method", method}, {knob, value}}, camera, off);
    };
    add("uniform", "level", {"1", "2", "4", "8", "16"});
    add("distance", "finest", {"3", "4", "5", "6"});
    add("size", "segment", {"32", "16", "8", "4"});
    add("error", "budget", {"8", "4", "2", "1", "0.5"});
    if (quick) return;
    add("uniform", "level", {"32"});
    for (const int n : {4, 8, 16}) {
        const auto mesh = std::make_shared<TessellatedMesh>(
            micro_polygons(surface.patches(), heights, double(surface.scale()), n), n);
        const auto target = std::make_shared<Target>(TargetKind::probe, Scenes::size);
        mesh->draw(*target, seen);
        scenes.add(
            "mesh", {{"squares", fmt::format("{} x {} a patch", n, n)}},
            [mesh, target, seen] { mesh->draw(*target, seen); }, off(target->read(), {}));
    }
}

void add_culling(Scenes& scenes) {
    // A tenth of the patches is in the picture.
    const Orbit camera{.yaw = 45, .pitch = 8, .distance = 3, .target = {-2, 0, -2}, .field_of_view = 27};
    for (const Set& levels : {Set{{"method", "uniform"}, {"level", "1"}}, Set{{"method", "uniform"}, {"level", "8"}},
                              Set{{"method", "uniform"}, {"level", "16"}}, Set{{"method", "error"}, {"budget", "1"}}})
        for (const char* cull : {"none", "outside", "all"})
            scenes.add_lab("14", "cull",
                           {{"view", "eye"},
                            {"surface", "ground"},
                            {"corners", "4"},
                            {"patches", "128"},
                            {"map", "fbm"},
                            {"size", "1024"},
                            {"depth", "0.1"},
                            {"fade", "off"}},
                           {levels[0], levels[1], {"cull", cull}}, camera);
}

void add_spacings(Scenes& scenes) {
    const Orbit camera{.yaw = 35, .pitch = 25, .distance = 3.4};
    DisplacedSurface surface;
    surface.shape = DisplacedSurface::torus, surface.density = 4, surface.depth = 0.1f;
    surface.material.map = int(HeightMap::stones), surface.material.size = 1;
    const TessellatedMesh micro(
        micro_polygons(surface.patches(), HeightField(surface.heights(), true), double(surface.scale()), 192), 192);
    micro.draw(scenes.target(), Camera(camera, 1));
    const Image exact = scenes.target().read();
    const HeightField heights(surface.heights(), true);
    const Camera seen(camera, 1);
    const auto pixels = [&](const Image& place, const Image&) {
        BenchError error = pixels_off(
            screen_errors(place, surface.patches(), heights, double(surface.scale()), seen.clip_from_world()));
        error.wrong = share_apart(place, exact);
        return error;
    };
    const auto metres = [&](const Image& place, const Image& depth) {
        std::vector<double> errors;
        const Frame frame{0, Scenes::size, 0, seen, {}};
        for (const auto& [pixel, truth] : shown_places(place, surface.patches(), heights, double(surface.scale()))) {
            const Ray ray = frame.ray(pixel.x, pixel.y);
            errors.push_back(glm::distance(truth, ray.origin + double(*depth.pixel(pixel.x, pixel.y)) * ray.direction));
        }
        return error_figures(std::move(errors), "metre");
    };
    const auto add = [&](const char* name, const auto& error_of) {
        for (const char* spacing : DisplacedSurface::spacings)
            for (const char* level : {"2", "4", "8", "16", "32", "64"})
                scenes.add_lab("13", name,
                               {{"view", "one"},
                                {"surface", "torus"},
                                {"mip", "base"},
                                {"corners", "4"},
                                {"patches", "4"},
                                {"map", "stones"},
                                {"size", "256"},
                                {"depth", "0.1"}},
                               {{"spacing", spacing}, {"level", level}}, camera, error_of);
    };
    add("torus", pixels);
    add("torus-metres", metres);
}

std::vector<BenchMethod> methods(const BenchSettings& settings) {
    std::vector<BenchMethod> result;
    Scenes scenes(result);
    add_levels(scenes, settings.quick);
    add_culling(scenes);
    if (settings.quick) return result;
    add_spacings(scenes);
    scenes.add_lab("13", "most",
                   {{"view", "one"},
                    {"surface", "wall"},
                    {"mip", "base"},
                    {"corners", "4"},
                    {"patches", "16"},
                    {"map", "fbm"},
                    {"size", "512"}},
                   {{"level", "64"}}, {.yaw = 20, .pitch = 10, .distance = 3});
    return result;
}

}  // namespace

BenchTopic displacement_topic() {
    return {"displacement",
            "levels of tessellation, 512 x 512 pixels: work is triangles, a tenth of a ground culled, outlines",
            methods, true};
}

}  // namespace relief
