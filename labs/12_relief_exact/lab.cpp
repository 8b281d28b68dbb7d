// Lab 12: the exact hit.
//
// The exact first hit of the view ray and the relief, with five ways to skip places that it cannot hit, and one that is
// not safe. Shadow, depth and outline follow from the hit. Your tasks: shaders/12_relief_exact/task.glsl
#include <fmt/format.h>

#include <glm/gtc/constants.hpp>

#include "framework/core/lab/lab.h"
#include "framework/library/kit/drawn_numbers.h"
#include "framework/library/kit/kept.h"
#include "framework/library/kit/labels.h"
#include "framework/library/kit/light.h"
#include "framework/library/kit/studio.h"
#include "framework/library/kit/tiles.h"
#include "framework/library/mesh/shapes.h"
#include "skips.h"
#include "truth.h"

namespace relief {

using namespace exact;

class ReliefExact final : public Lab {
public:
    ReliefExact() {
        surface_.material.map = ReliefMap::stones;
        surface_.extent = 3;
        floor_.material.map = ReliefMap::paving;
        floor_.material.asset_texels = 256;
        floor_.extent = 3;
        floor_.depth = 0.06f;
        wall_.material.asset_texels = 256;
        wall_.extent = 2.2f;
        wall_.depth = 0.07f;
        column_.shape = ReliefSurface::column;
        column_.material.map = ReliefMap::stones;
        column_.material.size = ReliefMaterial::texels_256;
        column_.depth = 0.12f;
    }

    void draw(const Frame& frame) override {
        const auto tiles = tiles_of_view(frame.size);
        const Show show = shown();
        std::vector<double> mean_turns;
        if (view_ == compare && !frame.probe)
            for (size_t i = 0; i < tiles.size(); ++i) mean_turns.push_back(measure(frame, method_of(i)));
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        for (size_t i = 0; i < tiles.size(); ++i) {
            glViewport(tiles[i].corner.x, tiles[i].corner.y, tiles[i].size.x, tiles[i].size.y);
            const Frame part = frame_in(frame, tiles[i]);
            const float middle = float(tiles[i].corner.x) + float(tiles[i].size.x) / 2;
            const float turns_from = show == show_light ? 1e9f : show == show_half ? middle : 0;
            for (const Object& object : objects()) draw_object(part, object, method_of(i), shadow_of(i), turns_from);
            if (view_ == scene) draw_ball(part);
            studio_.draw(part, tiles[i], studio_inputs(), [this] { return mesh_on_floor(); });
            if (!mean_turns.empty()) describe(frame.size, tiles[i], method_of(i), mean_turns[i]);
            if (view_ == guesses) labels_.caption(frame.size, tiles[i], 0, compared_shadows[i].second);
        }
        if (has_scale()) labels_.scale(frame.size, "1", "256 iterations", 8);
        labels_.notes(notes_of_files(*this));
        labels_.draw(frame);
    }

    void knobs(Knobs& knobs) override {
        knobs.group("Picture");
        knobs.choice("view", view_, views, "reliefs and a ball, every exact method, or one method");
        knobs.choice("method", method_, methods.names,
                     "how the search skips; the hit is the same, except with relaxed");
        knobs.choice("show", show_, shows,
                     KnobHelp("the light, the iterations of each pixel, or half of each")
                         .only("view", {"scene", "compare", "one"}));
        knobs.choice("shadow", shadow_, shadows.names,
                     KnobHelp("shadow of the relief on itself: by search, or guessed from normals")
                         .only("view", {"scene", "compare", "one"}));
        knobs.toggle("write_depth", write_depth_, "write the depth of the hit; off: of the base");
        knobs.toggle("outline", outline_, "end where the relief ends, and curve with a column");
        knobs.toggle(
            "costs", costs_,
            KnobHelp("show the time and memory of each method's map").only("view", {"compare"}).titled("Show costs"));
        light_.knobs(knobs, -10, 89);
        KnobsOnly of_surface(knobs, "view", {"compare", "one", "shadows"});
        surface_.knobs(of_surface);
    }

    std::optional<Image> truth(const Frame& frame) const override {
        const Sight sight{objects(), view_ == scene ? std::optional(Ball{}) : std::nullopt, outline_,
                          light_.direction<double>()};
        const auto values = exact::truth(frame.probe, sight);
        if (!values) return {};
        return truth_in_tiles(frame, tiles_of_view(frame.size),
                              [&](const Frame& part, size_t) { return values(part); });
    }

private:
    enum View { scene, compare, one, guesses };
    enum Show { show_light, show_half, show_turns };
    enum Shadow { no_shadow, hard, soft, estevez, chiang, schuessler };
    static constexpr std::array views = {"scene", "compare", "one", "shadows"};
    static constexpr std::array shows = {"light", "half-and-half", "iterations"};
    static constexpr auto shadows = choices<Shadow>({{no_shadow, "none"},
                                                     {hard, "hard", "HARD_SHADOW"},
                                                     {soft, "soft", "SOFT_SHADOW"},
                                                     {estevez, "estevez", "GUESS_ESTEVEZ"},
                                                     {chiang, "chiang", "GUESS_CHIANG"},
                                                     {schuessler, "schuessler", "GUESS_SCHUESSLER"}});
    static constexpr std::array<std::pair<Shadow, const char*>, 4> compared_shadows = {
        {{hard, "search"}, {estevez, "guess: estevez"}, {chiang, "guess: chiang"}, {schuessler, "guess: schuessler"}}};

    std::vector<Tile> tiles_of_view(glm::ivec2 size) const {
        const int below = has_scale() ? Labels::scale_height(size) : 0;
        if (view_ == guesses) return Labels::with_feet(size, tiles_of(size, int(compared_shadows.size())), 1, 18);
        if (view_ != compare) return tiles_of(size, 1, below);
        return Labels::with_feet(size, tiles_of(size, exact_methods, below), costs_ ? 3 : 2, 16);
    }
    Show shown() const { return view_ == guesses ? show_light : Show(show_); }
    bool has_scale() const { return view_ != scene && shown() != show_light; }
    Shadow shadow_of(size_t tile) const { return view_ == guesses ? compared_shadows[tile].first : Shadow(shadow_); }
    Method method_of(size_t tile) const { return Method(view_ == compare ? int(tile) : method_); }

    std::vector<Object> objects() const {
        const glm::dmat4 here(1);
        if (view_ != scene) {
            const double down = surface_.shape == ReliefSurface::column ? -ReliefSurface::column_height / 2 : 0;
            return {{&surface_, glm::translate(here, glm::dvec3(0, down, 0))}};
        }
        return {{&floor_, glm::rotate(here, -glm::half_pi<double>(), glm::dvec3(1, 0, 0))},
                {&wall_, glm::translate(here, glm::dvec3(0.25, 0.75, -0.55))},
                {&column_, glm::translate(here, glm::dvec3(-0.85, -0.3, 0.05))}};
    }

    /// Returns the inputs of mesh_on_floor().
    std::vector<double> studio_inputs() const {
        std::vector<double> inputs = surface_.studio_inputs();
        inputs.push_back(view_ == scene);
        return inputs;
    }
    /// Returns all meshes in one. Those of the scene begin at its ground, which hides their lower ends.
    Mesh mesh_on_floor() const {
        Mesh all;
        const auto add = [&](const Mesh& mesh, const glm::dmat4& world_from_model) {
            const uint32_t begin = uint32_t(all.vertices.size());
            for (const uint32_t index : mesh.indices) all.indices.push_back(begin + index);
            for (Vertex vertex : mesh.vertices) {
                vertex.position = glm::vec3(world_from_model * glm::dvec4(vertex.position, 1));
                if (view_ == scene) vertex.position.y = std::max(0.0f, vertex.position.y);
                all.vertices.push_back(vertex);
            }
        };
        for (const Object& object : objects()) add(object.surface->mesh(), object.world_from_model);
        if (view_ == scene) {
            const Ball ball;
            add(make_sphere({.radius = float(ball.radius), .sides = 16, .rows = 8}),
                glm::translate(glm::dmat4(1), ball.centre));
        }
        return all;
    }

    Skips& skips_of(const ReliefSurface& surface) {
        return *skips_[&surface].get({surface.version()}, [&] { return std::make_unique<Skips>(surface); });
    }

    void draw_object(const Frame& frame, const Object& object, Method method, Shadow shadow, float turns_from) {
        const ReliefSurface& surface = *object.surface;
        Skips& skips = skips_of(surface);
        const double radius = object.radius(outline_);
        const Program& program = surface_program_.with(
            {frame.probe, methods.define(method), frame.probe ? "" : shadows.define(shadow),
             write_depth_ ? "WRITE_DEPTH" : "", outline_ ? "OUTLINE" : "", radius > 0 ? "CURVED" : ""});
        glUseProgram(program);
        surface.set(program, frame, object.world_from_model);
        skips.set(program, method);
        const auto [low, high] = object.border(outline_);
        program.set("u_border", glm::vec4(low, high));
        program.set("u_radius", radius);
        program.set("u_to_light", light_.direction<double>());
        program.set("u_turns_from", turns_from);
        program.set("u_soft_samples", 24);
        if (object.is_closed()) glEnable(GL_CULL_FACE);
        surface.draw();
        glDisable(GL_CULL_FACE);
    }

    void draw_ball(const Frame& frame) const {
        const Program& program = ball_program_.with(frame.probe);
        glUseProgram(program);
        program.set("u_clip_from_world", frame.camera.clip_from_world());
        program.set("u_eye", frame.camera.eye());
        program.set("u_centre", Ball{}.centre);
        program.set("u_to_light", light_.direction<double>());
        program.set("u_nothing", no_surface);
        glBindVertexArray(ball_.layout());
        glDrawElements(GL_TRIANGLES, ball_.count(), GL_UNSIGNED_INT, nullptr);
    }

    /// Returns the mean number of iterations in a picture of 64 x 64 pixels by the frame's camera. Infinity before the
    /// tasks are written.
    double measure(const Frame& whole, Method method) {
        Frame frame = frame_in(whole, {{0, 0}, {64, 64}});
        frame.probe = {"steps", MissingTask::told};
        const Image steps = draw_numbers(frame.size, [&] {
            for (const Object& object : objects()) draw_object(frame, object, method, no_shadow, 0);
        });
        double sum = 0, count = 0;
        for (size_t i = 0; i < steps.values.size(); i += 4)
            if (std::isfinite(steps.values[i])) {
                sum += double(steps.values[i]);
                ++count;
            }
        return count > 0 ? sum / count : HUGE_VAL;
    }

    void describe(glm::ivec2 size, const Tile& tile, Method method, double iterations) {
        labels_.caption(size, tile, 0, methods.names[method]);
        if (std::isfinite(iterations)) labels_.caption(size, tile, -1, fmt::format("{:.1f} iterations", iterations));
        if (!costs_) return;
        const Skips::Costs costs = skips_of(surface_).costs(method);
        labels_.caption(size, tile, -2, fmt::format("{:.1f} MB, {:.0f} ms", costs.megabytes, costs.milliseconds));
    }

    Programs surface_program_{"common/relief.vert", "12_relief_exact/surface.frag"};
    Programs ball_program_{"12_relief_exact/ball.vert", "12_relief_exact/ball.frag"};
    ReliefSurface surface_, floor_, wall_, column_;
    std::map<const ReliefSurface*, Kept<std::unique_ptr<Skips>, int>> skips_;  ///< by the surface's version
    GpuMesh ball_ = upload([] { return make_sphere({.radius = float(Ball{}.radius), .sides = 56, .rows = 28}); });
    Studio studio_;
    Labels labels_;

    int view_ = scene, method_ = windows, show_ = show_light, shadow_ = hard;
    bool write_depth_ = true, outline_ = true, costs_ = false;
    DistantLight light_{.yaw = 55};
};

RELIEF_LAB(ReliefExact);

}  // namespace relief
