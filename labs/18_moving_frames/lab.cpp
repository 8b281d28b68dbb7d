// Lab 18: moving frames.
//
// A skin over a chain of bones, and a flock of bodies. A frame moves by the derivative of the motion, and in a skin the
// weights have a derivative, too. Your tasks: shaders/18_moving_frames/task.glsl
#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "framework/gl/vertex_stream.h"
#include "framework/kit/kept.h"
#include "framework/kit/labels.h"
#include "framework/kit/light.h"
#include "framework/kit/numbers.h"
#include "framework/kit/tiles.h"
#include "framework/lab/lab.h"
#include "scales.h"
#include "skin.h"
#include "truth.h"

namespace relief::moving_frames {

class MovingFrames final : public Lab {
public:
    void draw(const Frame& frame) override {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glViewport(0, 0, frame.size.x, frame.size.y);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        if (view_ == four_ways && !frame.probe)
            draw_four(frame);
        else if (view_ == unrolled_skin && !frame.probe)
            draw_errors(frame);
        else
            draw_scene(frame);
        labels_.draw(frame);
    }

    void knobs(Knobs& knobs) override {
        knobs.group("Picture");
        knobs.choice("view", view_, views,
                     "a serpent and its flock; four normals of a bent tube; one skin unrolled, and its "
                     "errors; or one body");
        knobs.choice("shape", shape_, shapes, "a tube with one joint, or a serpent with thirteen");
        knobs.group("Skin");
        knobs.choice("normal_by", way_, ways, "how the skin moves its normals");
        knobs.choice("blend", blend_, blends,
                     "bones blended as matrices, or as dual quaternions (which do not stretch)");
        knobs.slider("bend", bend_, 0, 150,
                     "bend of the tube's joint, degrees; a serpent's joints take a third at most");
        knobs.slider("twist", twist_, -180, 180, "twist of the tube's joint, degrees; a sixth for each of a serpent's");
        knobs.slider("stretch", stretch_, 0, 2,
                     "stretch of a bone along itself: the tube's second, the serpent's middle one");
        knobs.slider("weights_over", over_, 0, 6, "length of a joint, over which weights change, radii");
        knobs.choice("weights", uneven_, sums, "weights that sum to 1, or do not");
        knobs.choice("signs", opposite_, signs, "dual quaternions of neighbours alike, or opposite (the same motions)");
        knobs.toggle("folds", folds_, "paint blue where the skin folds over itself");
        knobs.group("Bodies");
        knobs.steps("instances", instances_, 1, most_instances, "bodies, the first one included");
        knobs.choice("triangles", fine_, finenesses, "triangles of the first body");
        knobs.choice("flock_triangles", coarse_, finenesses, "triangles of each other body");
        knobs.slider("scale_y", scale_y_, -2, 2, "scale of the first body along y; below 0 it is mirrored");
        knobs.group("Texture");
        knobs.toggle("textured", textured_,
                     "place the texture by instance and material; else by the body's own u and v");
        knobs.slider("instance_turn", instance_turn_, -180, 180, "turn of the first instance's texture, degrees");
        knobs.slider("instance_scale", instance_scale_, -4, 4, "scale of the first instance's texture along u");
        knobs.slider("material_turn", material_turn_, -180, 180, "turn of the materials' textures, degrees");
        knobs.slider("material_scale", material_scale_, 0, 4, "scale of the materials' textures");
        knobs.steps("material", material_, 0, material_count - 1, "material of the first body");
        knobs.slider("relief", relief_, 0, 2, "strength of the scales; 0 is smooth");
        light_.knobs(knobs);
    }

    std::optional<Image> truth(const Frame& frame, const Probe& probe) const override {
        // With a stretch of 0 there are no normals where this bone is the only one with a weight.
        if (probe.name == "normal" && stretch_ == 0) return {};
        return moving_frames::truth(frame, probe, scene());
    }

private:
    enum ViewKind { the_flock, four_ways, unrolled_skin, one_body };
    enum Shape { tube_shape, serpent_shape };
    enum Way { matrix, inverse_transpose, unit_cofactors, gradient };
    static constexpr std::array views = {"flock", "four", "skin", "one"};
    static constexpr std::array shapes = {"tube", "serpent"};
    static constexpr std::array ways = {"matrix", "inverse-transpose", "unit-cofactors", "gradient"};
    static constexpr std::array blends = {"linear", "dual-quaternion"};
    static constexpr std::array sums = {"even", "uneven"};
    static constexpr std::array signs = {"alike", "opposite"};
    static constexpr std::array finenesses = {"288", "3072", "6144", "12288"};
    static constexpr std::array<Fineness, 4> fineness_of = {{{24, 6}, {96, 16}, {128, 24}, {192, 32}}};
    static constexpr float error_scale = 30;  ///< error of the brightest colour (pale yellow), degrees

    /// An instance, in the layout of its vertex attributes.
    struct Placed {
        glm::vec4 rows[3];
        glm::vec3 texture[2];
        int32_t material;
    };
    /// Triangles, the bones of their vertices, and the instances to draw.
    struct Skin {
        Mesh mesh;
        GpuMesh uploaded;
        VertexStream bound{
            {{4, 4, GL_UNSIGNED_BYTE, offsetof(Bound, bones)}, {5, 4, GL_FLOAT, offsetof(Bound, weights)}}};
        VertexStream instances{{{6, 4, GL_FLOAT, 0},
                                {7, 4, GL_FLOAT, sizeof(glm::vec4)},
                                {8, 4, GL_FLOAT, 2 * sizeof(glm::vec4)},
                                {9, 3, GL_FLOAT, offsetof(Placed, texture)},
                                {10, 3, GL_FLOAT, offsetof(Placed, texture) + sizeof(glm::vec3)},
                                {11, 1, GL_INT, offsetof(Placed, material)}},
                               1};
        Kept<bool, double, bool> bound_by;  ///< length of a joint, and whether weights are uneven

        Skin(const Body& body, Fineness fineness)
            : mesh(make_skin(body, fineness.rings, fineness.sides)), uploaded([this] { return mesh; }) {}
        Skin(const Skin&) = delete;
    };
    /// A bounding sphere of a posed body, in the body's coordinates.
    struct Ball {
        glm::dvec3 centre;
        double radius;
    };
    /// The purpose of a draw call, beside the probe. It selects a permutation of the program.
    struct Purpose {
        const Body& body;
        const char* name = "";  ///< ERROR, MEASURE or ZEBRA
        int way = gradient;
        bool unrolled = false;
    };

    /// Returns the body of the knob; with view = four always the tube.
    const Body& body() const { return shape_ == serpent_shape ? serpent : tube; }
    Pose pose() const {
        return {.bend = double(bend_),
                .twist = double(twist_),
                .stretch = double(stretch_),
                .over = double(over_),
                .dual = blend_ == 1,
                .uneven = uneven_ == 1,
                .opposite = opposite_ == 1};
    }

    std::array<glm::dmat3, material_count> materials(const Body& body) const {
        std::array<glm::dmat3, material_count> all;
        for (int i = 0; i < material_count; ++i) {
            // Tiles are nearly square, and a whole number of them goes around the body.
            const glm::dvec2 tiles = body.is_serpent ? glm::dvec2(7, 31) : glm::dvec2(8, 8);
            all[size_t(i)] = textured_ ? texture_transform(material_turn_,
                                                           tiles * double(material_scale_) * (i % 3 == 2 ? 0.7 : 1.0))
                                       : glm::dmat3(1);
        }
        return all;
    }

    /// Returns the first body, at the origin, with the settings of the knobs.
    Instance first(const Body& body) const {
        Instance instance;
        const double y = scale_y_;
        instance.world_from_model = glm::dmat4(1, 0, 0, 0, 0, y, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1) * centred(body);
        if (textured_) instance.texture = texture_transform(instance_turn_, {instance_scale_, 1}, {0.25, 0.1});
        instance.material = material_;
        return instance;
    }
    glm::dmat4 centred(const Body& body) const {
        glm::dmat4 moved(1);
        moved[3] = glm::dvec4(-ball(body).centre, 1);
        return moved;
    }
    const Ball& ball(const Body& body) const {
        const Pose now = pose();
        return ball_.get({body.is_serpent, now}, [&] {
            const std::vector<Bone> bones = bones_of(body, now);
            std::vector<glm::dvec3> places;
            for (int i = 0; i <= 48; ++i)
                for (int j = 0; j < 8; ++j) places.push_back(posed(body, now, bones, {j / 8.0, i / 48.0}));
            const glm::dvec3 centre =
                std::accumulate(places.begin(), places.end(), glm::dvec3(0)) / double(places.size());
            double radius = 0;
            for (const glm::dvec3& place : places) radius = std::max(radius, glm::distance(centre, place));
            // The margin bounds the skin between the sampled places.
            return Ball{centre, radius + body.length / 48 * std::max(1.0, double(stretch_)) + 0.1 * body.radius};
        });
    }

    /// Returns all bodies of the flock, without culling.
    std::vector<Instance> instances() const {
        std::vector<Instance> all = {first(body())};
        if (view_ != the_flock) return all;
        for (Instance instance : make_flock(instances_ - 1)) {
            instance.world_from_model = instance.world_from_model * centred(body());
            if (!textured_) instance.texture = glm::dmat3(1);
            all.push_back(instance);
        }
        return all;
    }
    Scene scene() const {
        return {body().is_serpent,          pose(),
                materials(body()),          instances(),
                fineness_of[size_t(fine_)], fineness_of[size_t(coarse_)],
                view_ == unrolled_skin};
    }

    /// Returns whether a body's bounding sphere may be in the picture. Conservative.
    bool is_in_picture(const Frame& frame, const Instance& instance) const {
        const glm::dmat4& m = instance.world_from_model;
        const double size = std::max({glm::length(m[0]), glm::length(m[1]), glm::length(m[2])});
        const glm::dvec4 centre = m * glm::dvec4(ball(body()).centre, 1);
        const glm::dmat4 rows = glm::transpose(frame.camera.clip_from_world());
        for (int axis = 0; axis < 3; ++axis)
            for (const double side : {-1.0, 1.0}) {
                const glm::dvec4 plane = rows[3] + side * rows[axis];
                if (glm::dot(plane, centre) < -ball(body()).radius * size * glm::length(glm::dvec3(plane)))
                    return false;
            }
        return true;
    }

    void draw_scene(const Frame& frame) {
        const bool is_unrolled = view_ == unrolled_skin;
        if (!frame.probe) draw_sky(frame);
        const Purpose purpose{.body = body(), .way = way_, .unrolled = is_unrolled};
        std::vector<Instance> all = instances(), seen;
        for (const Instance& body : all)
            if (is_unrolled || is_in_picture(frame, body)) seen.push_back(body);
        const bool has_first = is_unrolled || is_in_picture(frame, all[0]);
        const std::span<const Instance> bodies = seen;
        if (has_first) draw_bodies(frame, purpose, fine_skin_, fine_, bodies.first(1));
        if (bodies.size() > has_first) draw_bodies(frame, purpose, coarse_skin_, coarse_, bodies.subspan(has_first));
    }

    void draw_sky(const Frame& frame) {
        const Program& program = sky_.with();
        glUseProgram(program);
        const double up = std::tan(glm::radians(frame.camera.orbit().field_of_view) / 2),
                     right = up * frame.size.x / frame.size.y;
        const glm::dmat4 view = glm::transpose(frame.camera.view_from_world());
        program.set("u_forward", -glm::dvec3(view[2]));
        program.set("u_right", right * glm::dvec3(view[0]));
        program.set("u_up", up * glm::dvec3(view[1]));
        program.set("u_to_light", light_.direction());
        glDisable(GL_DEPTH_TEST);
        glBindVertexArray(nothing_.layout());
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glEnable(GL_DEPTH_TEST);
    }

    using KeptSkin = Kept<std::unique_ptr<Skin>, bool, int>;  ///< by shape and fineness

    /// Draws all `bodies` with one draw call.
    void draw_bodies(const Frame& frame, const Purpose& purpose, KeptSkin& kept, int fineness,
                     std::span<const Instance> bodies) {
        const Body& body = purpose.body;
        Skin& drawn = kept_skin(kept, body, fineness);
        const Pose now = pose();
        drawn.bound_by.get({now.over, now.uneven}, [&] {
            drawn.bound.fill<Bound>(bind_skin(body, drawn.mesh, now.over * body.radius, now.uneven));
            drawn.bound.attach(drawn.uploaded.layout());
            return true;
        });
        std::vector<Placed> placed;
        for (const Instance& instance : bodies) {
            const glm::mat4 rows(glm::transpose(instance.world_from_model));
            const glm::mat3 texture(glm::transpose(instance.texture));
            placed.push_back({{rows[0], rows[1], rows[2]}, {texture[0], texture[1]}, instance.material});
        }
        drawn.instances.fill<Placed>(placed);
        drawn.instances.attach(drawn.uploaded.layout());

        const Program& program = program_for(frame.probe, purpose, now);
        glUseProgram(program);
        program.set("u_clip_from_world", frame.camera.clip_from_world());
        program.set("u_eye", frame.camera.eye());
        set_pose(program, body, now);
        set_look(program, body);
        glBindVertexArray(drawn.uploaded.layout());
        if (body.is_serpent && !purpose.unrolled) glEnable(GL_CULL_FACE);  // a tube is open
        glDrawElementsInstanced(GL_TRIANGLES, drawn.uploaded.count(), GL_UNSIGNED_INT, nullptr,
                                drawn.instances.count());
        glDisable(GL_CULL_FACE);
    }
    static Skin& kept_skin(KeptSkin& kept, const Body& body, int fineness) {
        return *kept.get({body.is_serpent, fineness},
                         [&] { return std::make_unique<Skin>(body, fineness_of[size_t(fineness)]); });
    }

    const Program& program_for(const Probe& probe, const Purpose& purpose, const Pose& now) const {
        const bool is_picture = !probe && purpose.name == std::string_view(),
                   reads_texture = probe.name == "uv" || probe.name == "tangent";
        const bool has_scales = is_picture && relief_ > 0;
        const bool needs_jacobian = purpose.way == gradient || folds_ || probe.name == "tangent" ||
                                    probe.name == "carried" || probe.name == "fold" || purpose.name[0] == 'E' ||
                                    purpose.name[0] == 'M';
        return skin_.with({probe, purpose.name, fmt::format("WAY {}", purpose.way),
                           purpose.body.is_serpent ? "SERPENT" : "",
                           now.is_rest() ? "RIGID"
                           : now.dual    ? "DUAL"
                                         : "",
                           now.uneven && !now.is_rest() ? "UNEVEN" : "",
                           needs_jacobian && !now.is_rest() && !now.dual ? "NEEDS_JACOBIAN" : "",
                           textured_ && (has_scales || reads_texture) ? "TEXTURED" : "", has_scales ? "BUMPS" : "",
                           purpose.unrolled ? "UNROLLED" : ""});
    }

    static void set_pose(const Program& program, const Body& body, const Pose& now) {
        const std::vector<Bone> bones = bones_of(body, now);
        const double over = std::clamp(now.over * body.radius, 0.001 * body.radius, 3 * body.spacing());
        program.set("u_body", glm::vec4(body.length, body.radius, body.joints, over));
        program.set("u_odd_sign", now.opposite ? -1.0f : 1.0f);
        for (size_t i = 0; i < bones.size(); ++i) {
            const auto set = [&](const char* name, const auto& value) {
                program.set(fmt::format("{}[{}]", name, i).c_str(), value);
            };
            set("u_bones", bones[i].matrix);
            set("u_bone_normals", glm::mat3(bones[i].normals));
            set("u_rotations", glm::vec4(bones[i].motion.real));
            set("u_duals", glm::vec4(bones[i].motion.dual));
        }
    }

    void set_look(const Program& program, const Body& body) const {
        struct Colors {
            glm::vec3 back, belly;
        };
        static constexpr std::array<Colors, material_count> colors = {{{{0.05f, 0.26f, 0.24f}, {0.62f, 0.55f, 0.34f}},
                                                                       {{0.28f, 0.10f, 0.05f}, {0.66f, 0.48f, 0.28f}},
                                                                       {{0.06f, 0.13f, 0.32f}, {0.50f, 0.55f, 0.58f}},
                                                                       {{0.30f, 0.24f, 0.05f}, {0.60f, 0.60f, 0.42f}},
                                                                       {{0.17f, 0.06f, 0.20f}, {0.58f, 0.42f, 0.45f}},
                                                                       {{0.10f, 0.20f, 0.07f}, {0.58f, 0.60f, 0.36f}},
                                                                       {{0.22f, 0.22f, 0.23f}, {0.62f, 0.60f, 0.56f}},
                                                                       {{0.33f, 0.05f, 0.06f}, {0.64f, 0.40f, 0.28f}}}};
        const auto transforms = materials(body);
        for (size_t i = 0; i < colors.size(); ++i) {
            const auto set = [&](const char* name, const auto& value) {
                program.set(fmt::format("{}[{}]", name, i).c_str(), value);
            };
            set("u_materials", glm::mat3(transforms[i]));
            set("u_backs", colors[i].back);
            set("u_bellies", colors[i].belly);
        }
        program.set("s_scales", 0, scales_);
        program.set("u_relief", relief_);
        program.set("u_to_light", light_.direction());
        program.set("u_folds", folds_);
        program.set("u_fog", 0.028f);
        program.set("u_error_scale", error_scale);
    }

    // ---- four ways, side by side

    void draw_four(const Frame& frame) {
        const auto tiles = tile_grid(frame.size, 2, 2);
        for (int way = 0; way < 4; ++way) {
            const Tile& tile = tiles[size_t(way)];
            const glm::ivec2 half(tile.size.x / 2, tile.size.y);
            draw_in(frame, {tile.corner, half}, {.body = tube, .name = "ZEBRA", .way = way}, false);
            draw_in(frame, {tile.corner + glm::ivec2(half.x, 0), {tile.size.x - half.x, half.y}},
                    {.body = tube, .name = "ERROR", .way = way}, false);
            labels_.caption(frame.size, tile, 0, ways[size_t(way)]);
            describe_error(frame.size, tile, tube, way);
        }
    }

    void draw_errors(const Frame& frame) {
        draw_in(frame, {{0, 0}, frame.size}, {.body = body(), .name = "ERROR", .way = way_, .unrolled = true}, false);
        labels_.caption(frame.size, {{0, 0}, frame.size}, 0, ways[size_t(way_)]);
        describe_error(frame.size, {{0, 0}, frame.size}, body(), way_);
    }

    void describe_error(glm::ivec2 size, const Tile& tile, const Body& body, int way) {
        const auto [mean, most] = measure(body, way);
        if (std::isfinite(mean))
            labels_.caption(size, tile, -1, fmt::format("{:.1f}~ off, {:.0f}~ at most", mean, most));
    }

    void draw_in(const Frame& frame, const Tile& tile, const Purpose& purpose, bool with_sky) {
        if (tile.size.x <= 0 || tile.size.y <= 0) return;
        Frame part = frame_in(frame, tile);
        Orbit orbit = part.camera.orbit();
        orbit.distance *= 0.31, orbit.target = {0, 0, 0};  // a tube is smaller than a serpent
        part.camera = Camera(orbit, double(tile.size.x) / tile.size.y);
        glViewport(tile.corner.x, tile.corner.y, tile.size.x, tile.size.y);
        if (with_sky) draw_sky(part);
        const Instance one = first(purpose.body);
        draw_bodies(part, purpose, fine_skin_, fine_, {&one, 1});
    }

    /// Returns the mean and the largest error of a way over the skin, in degrees, compared with the normal by the
    /// gradient. Infinity before the tasks are written.
    std::pair<double, double> measure(const Body& body, int way) {
        std::vector<std::string> knobs;
        for (const KnobText& knob : describe_knobs(*this)) knobs.push_back(knob.value);
        return measured_[size_t(way)].get({knobs, body.is_serpent, skin_.renewals()}, [&] {
            const glm::ivec2 size(64, 128);
            const Image drawn = draw_numbers(size, [&] {
                const Frame frame{0, size, 0, Camera({}, 1), {}};
                const Instance one = first(body);
                draw_bodies(frame, {.body = body, .name = "MEASURE", .way = way, .unrolled = true}, fine_skin_, fine_,
                            {&one, 1});
            });
            double sum = 0, most = 0;
            for (size_t i = 0; i < drawn.values.size(); i += 4) {
                sum += double(drawn.values[i]);
                most = std::max(most, double(drawn.values[i]));
            }
            return std::pair(sum / double(drawn.pixel_count()), most);
        });
    }

    Programs skin_{"18_moving_frames/serpent.vert", "18_moving_frames/serpent.frag"};
    Programs sky_{"18_moving_frames/sky.vert", "18_moving_frames/sky.frag"};
    Texture scales_{"scales", [] { return make_scales(256); }};
    KeptSkin fine_skin_, coarse_skin_;
    mutable Kept<Ball, bool, Pose> ball_;
    std::array<Kept<std::pair<double, double>, std::vector<std::string>, bool, int>, 4> measured_;
    GpuMesh nothing_ = upload([] { return Mesh{}; });
    Labels labels_;

    int view_ = the_flock, shape_ = serpent_shape, way_ = gradient, blend_ = 0, uneven_ = 0, opposite_ = 0,
        instances_ = 50, fine_ = 2, coarse_ = 0, material_ = 0;
    float bend_ = 90, twist_ = 0, stretch_ = 1, over_ = 4, scale_y_ = 1, instance_turn_ = 0, instance_scale_ = 1,
          material_turn_ = 0, material_scale_ = 1, relief_ = 1;
    bool folds_ = false, textured_ = true;
    DistantLight light_{.yaw = 35, .pitch = 24};
};

RELIEF_LAB(MovingFrames);

}  // namespace relief::moving_frames
