// Lab 14: adaptive displacement.
//
// Each edge says how finely it is cut, so that neighbours agree and no crack opens; what is out of sight is not cut at
// all, and far away the relief is left to the normal map. Yours: shaders/14_adaptive_displacement/task.glsl
#include <fmt/format.h>

#include "framework/gl/target.h"
#include "framework/lab/displaced_surface.h"
#include "framework/lab/lab.h"
#include "framework/lab/labels.h"
#include "framework/lab/tiles.h"
#include "scene.h"

namespace relief {

using namespace adaptive;

class AdaptiveDisplacement final : public Lab {
public:
    AdaptiveDisplacement() {
        surface_.shape = DisplacedSurface::ground, surface_.density = 32;
        surface_.material.map = 1, surface_.material.size = 2;
    }

    void draw(const Frame& frame) override {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        const bool is_count = frame.probe.name == "winding";
        if (is_count) begin_count();
        const auto tiles = tiles_of(frame.size, view_ == both ? 2 : 1);
        for (size_t i = 0; i < tiles.size(); ++i) {
            const Frame eye = frame_in(frame, tiles[i]);
            const bool is_above = view_ == above || (view_ == both && i == 1);
            Frame seen = eye;
            if (is_above) seen.camera = camera_above(eye);
            glViewport(tiles[i].corner.x, tiles[i].corner.y, tiles[i].size.x, tiles[i].size.y);
            if (wire_ && !frame.probe) glPolygonOffset(1, 1), glEnable(GL_POLYGON_OFFSET_FILL);  // lines lie in front
            const int triangles = draw_surface(eye, seen,
                                               frame.probe ? Define(frame.probe)
                                               : is_above  ? "PATCHES"
                                                           : "");
            glDisable(GL_POLYGON_OFFSET_FILL);
            if (frame.probe) continue;
            if (wire_) draw_wire(eye, seen);
            describe(frame.size, tiles[i], eye, is_above, triangles);
        }
        if (is_count) glDisable(GL_BLEND), glEnable(GL_DEPTH_TEST);
        labels_.draw(frame);
    }

    void knobs(Knobs& knobs) override {
        knobs.choice("view", view_, views, "from the eye, its patches from above, or both");
        knobs.choice("method", method_, methods, "where the levels come from");
        knobs.choice("levels_of", levels_of_, levels_ofs, "each edge by itself, or the whole patch: then it cracks");
        knobs.slider("level", level_, 1, 64, "for uniform");
        knobs.slider("nearest", nearest_, 0.1f, 32, "for distance: metres, where edges have the finest level");
        knobs.slider("farthest", farthest_, 0.1f, 64, "for distance: metres, where they have the coarsest");
        knobs.slider("finest", finest_, 0, 6, "for distance: exponent of 2");
        knobs.slider("coarsest", coarsest_, 0, 6, "for distance: exponent of 2");
        knobs.slider("segment", segment_, 1, 64, "for size: pixels that a segment may have");
        knobs.slider("budget", budget_, 0.125f, 8, "for error: pixels that a vertex may be off");
        knobs.choice("spacing", spacing_, spacings, "where the vertices stand when a level is not whole");
        knobs.choice("cull", cull_, culls, "patches that are not drawn: outside of the picture, and facing away");
        knobs.toggle("fade", fade_, "let the displacement fade into the normal map");
        knobs.slider("fade_begin", fade_begin_, 0, 64, "metres from the eye");
        knobs.slider("fade_end", fade_end_, 0, 64, "metres from the eye");
        knobs.toggle("wire", wire_, "draw the triangles' edges");
        knobs.slider("light_yaw", light_yaw_, -180, 180, "where the light comes from, degrees");
        knobs.slider("light_pitch", light_pitch_, -90, 90, "from how high, degrees");
        surface_.knobs(knobs);
    }

    std::optional<Image> truth(const Frame& frame, const Probe& probe) const override {
        // Around a closed surface as many faces are seen from the front as from the back.
        if (probe.name != "winding" || !surface_.patches().is_closed) return {};
        return Image(frame.size.x, frame.size.y, 4);
    }

private:
    enum View { both, eye_only, above };
    static constexpr std::array views = {"both", "eye", "above"};
    static constexpr std::array methods = {"uniform", "distance", "size", "error"};
    static constexpr std::array levels_ofs = {"edge", "patch"};
    static constexpr std::array spacings = {"equal", "fractional-odd", "fractional-even"};
    static constexpr std::array spacing_defines = {"SPACING equal_spacing", "SPACING fractional_odd_spacing",
                                                   "SPACING fractional_even_spacing"};
    static constexpr std::array culls = {"none", "outside", "all"};

    /// Each front face adds 1, each back face takes 1 away: seen from outside, a closed surface sums up to 0.
    static void begin_count() {
        constexpr float zero[4] = {};
        glClearBufferfv(GL_COLOR, 0, zero);
        glDisable(GL_DEPTH_TEST);
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
    }

    /// Over the whole scene, from behind the eye.
    Camera camera_above(const Frame& eye) const {
        Orbit orbit = eye.camera.orbit();
        orbit.pitch = 52, orbit.distance = surface_.shape == DisplacedSurface::ground ? 21 : 5,
        orbit.target = {0, 0, 0};
        return Camera(orbit, double(eye.size.x) / std::max(1, eye.size.y));
    }

    void draw_wire(const Frame& eye, const Frame& seen) {
        glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
        draw_surface(eye, seen, "WIRE");
        glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    }

    /// Levels and culling go by `eye`, the picture by `seen`. How many triangles were drawn.
    int draw_surface(const Frame& eye, const Frame& seen, const Define& purpose) {
        const Program& program =
            program_.with({purpose, surface_.corners_define(), fmt::format("CORNERS {}", surface_.corners()),
                           spacing_defines[size_t(spacing_)], fmt::format("METHOD {}", method_),
                           levels_of_ == 1 ? "LEVELS_OF_PATCH" : ""});
        const float yaw = glm::radians(light_yaw_), pitch = glm::radians(light_pitch_);
        const bool one_sided = surface_.is_one_sided() && !is_count_of(purpose);
        glUseProgram(program);
        surface_.set(program, seen);
        known_.set(program, surface_, 3);
        program.set("u_seen_from", seen.camera.eye() - surface_.origin);
        program.set("u_eye", eye.camera.eye() - surface_.origin);
        const auto planes = planes_of(eye.camera, surface_.origin);
        for (size_t i = 0; i < planes.size(); ++i) program.set(fmt::format("u_planes[{}]", i).c_str(), planes[i]);
        program.set("u_level", level_);
        program.set("u_by_distance", glm::vec4(nearest_, std::max(farthest_, nearest_ + 1e-3f), finest_, coarsest_));
        program.set("u_pixels_per_radian", pixels_per_radian(eye));
        program.set("u_pixels_per_segment", segment_);
        program.set("u_budget", budget_);
        program.set("u_cull", one_sided ? cull_ : std::min(cull_, 1));
        program.set("u_show_culled", eye.camera.eye() != seen.camera.eye());
        program.set("u_fade",
                    fade_ ? glm::vec2(fade_begin_, std::max(fade_end_, fade_begin_ + 1e-3f)) : glm::vec2(1e30f, 2e30f));
        program.set("u_to_light",
                    glm::vec3(std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch)));
        program.set("u_wire", glm::vec3(0.93f, 0.86f, 0.62f));
        if (one_sided) glEnable(GL_CULL_FACE);
        // A probe has no caption; whoever draws it may count for himself.
        const int triangles = purpose.text.starts_with("PROBE_") ? (surface_.draw(), 0) : surface_.draw_and_count();
        glDisable(GL_CULL_FACE);
        return triangles;
    }
    static bool is_count_of(const Define& purpose) { return purpose.text == "PROBE_winding"; }

    void describe(glm::ivec2 size, const Tile& tile, const Frame& eye, bool is_above, int triangles) {
        if (is_above) return;
        labels_.caption(size, tile, 0, fmt::format("{} triangles", triangles));
        if (levels_of_ == 1 && surface_.patches().is_closed)
            labels_.caption(size, tile, -1, fmt::format("{} pixels are holes", holes(eye)), {0.95f, 0.5f, 0.4f});
    }

    /// Pixels where a closed surface is entered more often than left, or less.
    size_t holes(Frame frame) {
        if (!small_ || small_->size() != frame.size) small_.emplace(TargetKind::probe, frame.size);
        glBindFramebuffer(GL_FRAMEBUFFER, small_->framebuffer());
        GLint viewport[4];
        glGetIntegerv(GL_VIEWPORT, viewport);
        glViewport(0, 0, frame.size.x, frame.size.y);
        begin_count();
        draw_surface(frame, frame, "PROBE_winding");
        glDisable(GL_BLEND), glEnable(GL_DEPTH_TEST);
        const Image sums = small_->read();
        size_t count = 0;
        for (size_t i = 0; i < sums.values.size(); i += 4) count += sums.values[i] != 0;
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
        return count;
    }

    Programs program_{"common/patch.vert", "14_adaptive_displacement/patch.tesc",
                      "14_adaptive_displacement/surface.tese", "14_adaptive_displacement/surface.frag"};
    DisplacedSurface surface_;
    PatchTexture known_;
    std::optional<Target> small_;
    Labels labels_;

    int view_ = both, method_ = 3, levels_of_ = 0, spacing_ = 1, cull_ = 2;
    float level_ = 8, nearest_ = 1, farthest_ = 16, finest_ = 5, coarsest_ = 0, segment_ = 8, budget_ = 1;
    bool fade_ = false, wire_ = false;
    float fade_begin_ = 6, fade_end_ = 12;
    float light_yaw_ = -60, light_pitch_ = 30;
};

RELIEF_LAB(AdaptiveDisplacement);

}  // namespace relief
