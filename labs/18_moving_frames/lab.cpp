// Lab 18: moving frames.
//
// A skin over a chain of bones, and a flock of bodies. A frame moves by the derivative of the motion, and in a skin the
// weights have a derivative, too. Your tasks: shaders/18_moving_frames/task.glsl
#include <fmt/format.h>

#include "bodies.h"
#include "framework/core/image/compare.h"
#include "framework/core/lab/lab.h"
#include "framework/library/kit/culling.h"
#include "framework/library/kit/drawn_numbers.h"
#include "framework/library/kit/labels.h"
#include "framework/library/kit/tiles.h"
#include "framework/library/kit/uniforms.h"
#include "framework/library/kit/view_axes.h"
#include "framework/library/kit/window_triangle.h"
#include "framework/library/maps/own_picture.h"
#include "scales.h"
#include "truth.h"

namespace relief::moving_frames {

class MovingFrames final : public Lab {
public:
    void draw(const Frame& frame) override {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glViewport(0, 0, frame.size.x, frame.size.y);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        if (settings_.view == Settings::unrolled_skin)
            draw_unrolled(frame);
        else if (settings_.view == Settings::four_ways && !frame.probe)
            draw_four_ways(frame);
        else
            draw_flock(frame);
        labels_.draw(frame);
    }

    void knobs(Knobs& knobs) override { settings_.knobs(knobs); }

    std::optional<Image> truth(const Frame& frame) const override {
        // With a stretch of 0 there are no normals where this bone is the only one with a weight.
        if (frame.probe.name == "normal" && settings_.stretch == 0) return {};
        return moving_frames::truth(frame, scene_of(settings_, settings_.body()));
    }

private:
    /// The purpose of a draw call. It selects a permutation of the program.
    struct Purpose {
        int way = Settings::gradient;
        Define shows = "";      ///< a probe, ERROR, MEASURE or ZEBRA; empty for the picture
        bool unrolled = false;  ///< u to the right and v up, over the whole viewport
    };

    // ---- the views

    /// The mist, the first body, and the others.
    void draw_flock(const Frame& frame) {
        if (!frame.probe) draw_sky(frame);
        const Purpose purpose{.way = settings_.way, .shows = frame.probe};
        const Scene scene = scene_of(settings_, settings_.body());
        std::vector<Instance> others;
        for (const Instance& instance : std::span(scene.instances).subspan(1))
            if (is_in_picture(frame, scene, instance)) others.push_back(instance);
        if (is_in_picture(frame, scene, scene.instances[0])) draw_first(frame, scene, purpose);
        if (!others.empty()) {
            flock_.fill(scene.body, scene.coarse, scene.pose, others);
            draw_bodies(frame, scene, purpose, flock_);
        }
    }

    /// The skin of the first body: a probe, or its errors.
    void draw_unrolled(const Frame& frame) {
        const Scene scene = scene_of(settings_, settings_.body());
        if (frame.probe)
            return draw_first(frame, scene, {.way = settings_.way, .shows = frame.probe, .unrolled = true});
        const auto tiles = tiles_of(frame.size, 1, Labels::scale_height(frame.size));
        const Tile tile = Labels::with_feet(frame.size, tiles, settings_.folds ? 3 : 2, 24)[0];
        glViewport(tile.corner.x, tile.corner.y, tile.size.x, tile.size.y);
        draw_first(frame_in(frame, tile), scene, {.way = settings_.way, .shows = "ERROR", .unrolled = true});
        describe(frame.size, tile, scene, settings_.way);
        if (settings_.folds) labels_.legend(frame.size, tile, "folds over itself", {0.10f, 0.72f, 0.95f});
        add_error_scale(frame);
    }

    /// Four normals of a tube, each under striped light and with its errors.
    void draw_four_ways(const Frame& frame) {
        const Scene scene = scene_of(settings_, tube);
        const auto tiles = tile_grid(frame.size, 2, 2, Labels::scale_height(frame.size));
        add_error_scale(frame);
        for (int way = 0; way < 4; ++way) {
            const Tile& tile = tiles[size_t(way)];
            const glm::ivec2 half(tile.size.x / 2, tile.size.y);
            draw_close(frame, {tile.corner, half}, scene, {.way = way, .shows = "ZEBRA"});
            draw_close(frame, {tile.corner + glm::ivec2(half.x, 0), {tile.size.x - half.x, half.y}}, scene,
                       {.way = way, .shows = "ERROR"});
            describe(frame.size, tile, scene, way);
        }
    }

    void draw_close(const Frame& frame, const Tile& tile, const Scene& scene, const Purpose& purpose) {
        if (tile.size.x <= 0 || tile.size.y <= 0) return;
        Frame part = frame_in(frame, tile);
        Orbit orbit = part.camera.orbit();
        orbit.distance *= 0.31, orbit.target = {0, 0, 0};  // a tube is smaller than a serpent
        part.camera = Camera(orbit, double(tile.size.x) / tile.size.y);
        glViewport(tile.corner.x, tile.corner.y, tile.size.x, tile.size.y);
        draw_first(part, scene, purpose);
    }

    void add_error_scale(const Frame& frame) {
        labels_.scale(frame.size, "0~", "30~");  // error_scale of serpent.frag
    }

    void describe(glm::ivec2 size, const Tile& tile, const Scene& scene, int way) {
        labels_.caption(size, tile, 0, Settings::ways.names[size_t(way)]);
        const ErrorSummary& error = measure(scene, way);
        if (error.missing == 0 && error.not_finite == 0)
            labels_.caption(size, tile, -1, fmt::format("{:.1f}~ off, {:.0f}~ at most", error.mean, error.largest));
    }

    /// Returns the error of a way over the skin, in degrees, compared with the normal by the gradient.
    const ErrorSummary& measure(const Scene& scene, int way) {
        return measured_[size_t(way)].get(
            {scene.body.is_serpent, scene.pose, settings_.scale_y, scene.fine, skin_.renewals()}, [&] {
                const Frame frame{.target = 0, .size = {64, 128}, .time = 0, .camera = Camera({}, 1), .probe = {}};
                const Image errors = draw_numbers(
                    frame.size, [&] { draw_first(frame, scene, {.way = way, .shows = "MEASURE", .unrolled = true}); });
                return summarize(channels_of(errors, 0, 1));
            });
    }

    // ---- the passes

    void draw_sky(const Frame& frame) {
        const Program& program = sky_.with();
        glUseProgram(program);
        set_rays(program, frame);
        program.set("u_to_light", settings_.light.direction());
        window_.draw();
    }

    void draw_first(const Frame& frame, const Scene& scene, const Purpose& purpose) {
        first_.fill(scene.body, scene.fine, scene.pose, std::span(scene.instances).first(1));
        draw_bodies(frame, scene, purpose, first_);
    }

    void draw_bodies(const Frame& frame, const Scene& scene, const Purpose& purpose, const Bodies& bodies) {
        const Program& program = program_for(scene, purpose);
        glUseProgram(program);
        program.set("u_clip_from_world", frame.camera.clip_from_world());
        program.set("u_eye", frame.camera.eye());
        set_pose(program, scene.body, scene.pose);
        program.set("s_scales", 0, scales_);
        program.set("u_relief", settings_.relief);
        program.set("u_to_light", settings_.light.direction());
        program.set("u_folds", settings_.folds);
        set_each<glm::mat3>(program, "u_materials", scene.materials);
        if (scene.body.is_serpent && !purpose.unrolled) glEnable(GL_CULL_FACE);  // a tube is open
        bodies.draw();
        glDisable(GL_CULL_FACE);
    }

    static bool is_in_picture(const Frame& frame, const Scene& scene, const Instance& instance) {
        const glm::dmat4& m = instance.world_from_model;
        const double size = std::max({glm::length(m[0]), glm::length(m[1]), glm::length(m[2])});
        return may_be_seen(frame.camera.clip_from_world(), glm::dvec3(m * glm::dvec4(scene.ball.centre, 1)),
                           scene.ball.radius * size);
    }

    const Program& program_for(const Scene& scene, const Purpose& purpose) const {
        const std::string& shows = purpose.shows.text;
        const auto is_one_of = [&](std::initializer_list<const char*> names) {
            return std::find(names.begin(), names.end(), shows) != names.end();
        };
        const bool has_scales = shows.empty() && settings_.relief > 0, is_still = scene.pose.is_rest();
        const bool reads_texture = has_scales || is_one_of({"PROBE_uv", "PROBE_tangent"});
        const bool needs_jacobian = purpose.way == Settings::gradient || settings_.folds ||
                                    is_one_of({"PROBE_tangent", "PROBE_carried", "PROBE_fold", "ERROR", "MEASURE"});
        return skin_.with({purpose.shows, Settings::ways.define(purpose.way),
                           Settings::shapes.define(scene.body.is_serpent), is_still ? "RIGID" : "",
                           is_still ? "" : Settings::blends.define(settings_.blend),
                           is_still ? "" : Settings::sums.define(settings_.weights),
                           needs_jacobian && !is_still && !scene.pose.dual ? "NEEDS_JACOBIAN" : "",
                           settings_.textured && reads_texture ? "TEXTURED" : "", has_scales ? "BUMPS" : "",
                           purpose.unrolled ? "UNROLLED" : ""});
    }

    static void set_pose(const Program& program, const Body& body, const Pose& pose) {
        const double over = std::clamp(pose.over * body.radius, 0.001 * body.radius, 3 * body.spacing());
        program.set("u_body", glm::vec4(body.length, body.radius, body.joints, over));
        program.set("u_odd_sign", pose.opposite ? -1.0f : 1.0f);
        for (size_t i = 0; const Bone& bone : bones_of(body, pose)) {
            const std::string index = "[" + std::to_string(i++) + "]";
            program.set(("u_bones" + index).c_str(), bone.matrix);
            program.set(("u_bone_normals" + index).c_str(), glm::mat3(bone.normals));
            program.set(("u_rotations" + index).c_str(), glm::vec4(bone.motion.real));
            program.set(("u_duals" + index).c_str(), glm::vec4(bone.motion.dual));
        }
    }

    Settings settings_;
    Programs skin_{"18_moving_frames/serpent.vert", "18_moving_frames/serpent.frag"};
    Programs sky_{"common/window.vert", "18_moving_frames/sky.frag"};
    Texture scales_{"scales", [] { return make_scales(256); }};
    Bodies first_, flock_;
    /// By way. Inputs: shape, pose, scale_y, triangles, renewals of the program.
    std::array<Kept<ErrorSummary, bool, Pose, float, Fineness, int>, 4> measured_;
    WindowTriangle window_;
    Labels labels_;
};

RELIEF_LAB(MovingFrames);

}  // namespace relief::moving_frames
