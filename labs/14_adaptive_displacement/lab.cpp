// Lab 14: adaptive displacement.
//
// Each edge chooses its own level, so that neighbours agree and no crack opens. Hidden patches are culled. Far away
// only the normal map is left. Your tasks: shaders/14_adaptive_displacement/task.glsl
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "annotations.h"
#include "framework/core/lab/lab.h"
#include "framework/library/kit/displaced_surface.h"
#include "framework/library/kit/drawn_numbers.h"
#include "framework/library/kit/labels.h"
#include "framework/library/kit/shadow_map.h"
#include "framework/library/kit/tiles.h"
#include "framework/library/kit/uniforms.h"
#include "framework/library/maps/slope_moments.h"
#include "scene.h"
#include "settings.h"
#include "truth.h"

namespace relief {

using namespace adaptive;

class AdaptiveDisplacement final : public Lab {
public:
    AdaptiveDisplacement() {
        surface_.shape = DisplacedSurface::ground;
        surface_.density = 36;
        surface_.material.map = ReliefMap::fbm;
    }

    void draw(const Frame& frame) override {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        most_level_ = DisplacedSurface::finest_level;
        const std::vector<View> views = views_of(frame);
        if (frame.probe) return draw_probe(frame.probe, views);
        int triangles = -1;  // of the eye's picture, unknown
        for (const View& view : views)
            if (view.is_above)
                draw_above(frame.size, view, triangles);
            else
                triangles = draw_eye(frame.size, view);
        describe_limits(labels_, frame.size, views[0].tile, {settings_, surface_}, most_level_);
        labels_.notes(notes_of_files(*this));
        labels_.draw(frame);
    }

    void knobs(Knobs& knobs) override {
        settings_.knobs(knobs);
        surface_.knobs(knobs);
    }

    std::optional<Image> truth(const Frame& frame) const override {
        // Every line of sight crosses as many front faces as back faces of a closed surface, so all sums are 0.
        if (frame.probe.name == "winding" && surface_.patches().is_closed) return Image(frame.size.x, frame.size.y, 4);
        if (settings_.view != Settings::eye_only) return {};
        return adaptive::truth(frame, settings_, surface_);
    }

private:
    /// A part of the picture, drawn by `seen`'s camera, with the levels and the culling for `eye`'s camera.
    struct View {
        Tile tile;
        Frame eye, seen;
        bool is_above = false;
    };

    std::vector<View> views_of(const Frame& frame) const {
        std::vector<View> all;
        for (const Tile& tile : tiles_of(frame.size, settings_.view == Settings::both ? 2 : 1)) {
            const Frame eye = frame_in(frame, tile);
            all.push_back(
                {.tile = tile, .eye = eye, .seen = eye, .is_above = settings_.view == Settings::above || !all.empty()});
            if (all.back().is_above)
                all.back().seen.camera = camera_above(eye, surface_.shape == DisplacedSurface::ground);
        }
        return all;
    }

    /// Returns the cost of a picture in draws of the surface: one for the triangles of each view, two for their edges,
    /// one for the search for holes, and one for the shadow map.
    int draws_of_picture() const {
        return (settings_.view == Settings::both ? 2 : 1) * (settings_.wire ? 3 : 1) +
               (settings_.view != Settings::above && settings_.may_crack() ? 1 : 0) + (casts_shadow() ? 1 : 0);
    }
    bool casts_shadow() const { return settings_.shadow != Settings::no_shadow && settings_.view != Settings::above; }

    void draw_probe(const Probe& probe, const std::vector<View>& views) {
        const bool is_count = probe.name == "winding";
        if (is_count) DisplacedSurface::begin_winding();
        for (const View& view : views) {
            set_viewport(view.tile);
            draw_surface(view, probe);
        }
        if (is_count) DisplacedSurface::end_winding();
    }

    /// Draws what the eye sees, with its holes. Returns the number of triangles.
    int draw_eye(glm::ivec2 size, const View& view) {
        if (casts_shadow()) draw_shadow(view);
        const int triangles = draw_picture(view, "");
        labels_.caption(size, view.tile, 0, fmt::format("{} triangles", triangles));
        if (settings_.may_crack()) mark_holes(size, view);
        return triangles;
    }

    /// Draws the patches and the eye's lines of sight from above. `triangles`: their number in the eye's picture, or -1
    /// if it is unknown.
    void draw_above(glm::ivec2 size, const View& view, int triangles) {
        const int with_culled = draw_picture(view, "PATCHES");
        sight_.draw(view.seen.camera, view.eye.camera, surface_.shape == DisplacedSurface::ground ? 15 : 3.5);
        describe_patches(labels_, size, view.tile, {settings_, surface_}, triangles < 0 ? -1 : with_culled - triangles);
    }

    /// Draws the surface and, if asked for, the edges of its triangles. Returns the number of triangles.
    int draw_picture(const View& view, const Define& purpose) {
        set_viewport(view.tile);
        glPolygonOffset(1, 1);
        if (settings_.wire) glEnable(GL_POLYGON_OFFSET_FILL);  // so that lines lie in front
        const int triangles = draw_surface(view, purpose);
        glDisable(GL_POLYGON_OFFSET_FILL);
        if (!settings_.wire) return triangles;
        glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
        draw_surface(view, "WIRE");
        glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
        return triangles;
    }

    static void set_viewport(const Tile& tile) { glViewport(tile.corner.x, tile.corner.y, tile.size.x, tile.size.y); }

    static Define color_define(const char* name, glm::vec3 color) {
        return fmt::format("{} vec3({}, {}, {})", name, color.r, color.g, color.b);
    }

    /// Draws the depth map of the patches, with the levels that they have for the eye, then returns to the frame's
    /// target.
    void draw_shadow(const View& view) {
        const auto [low, high] = surface_.box_around();
        shadow_map_.draw(settings_.light.direction<double>(), low, high, [&](const glm::dmat4& clip_from_model) {
            const Program& program = use_program(view, "DEPTH");
            if (settings_.shadow == Settings::shadow_of_all) stop_culling(program);
            program.set("u_clip_from_model", clip_from_model);
            surface_.draw();
        });
        glBindFramebuffer(GL_FRAMEBUFFER, view.seen.target);
    }

    static bool reads_slopes(const Define& purpose) {
        return purpose.text.empty() || purpose.text == "PROBE_normal" || purpose.text == "PROBE_highlight";
    }

    bool has_backs(const Define& purpose) const { return !surface_.is_one_sided() || purpose.text == "PROBE_winding"; }

    /// Uses the surface's program, and sets all its uniforms.
    const Program& use_program(const View& view, const Define& purpose) {
        const bool is_probe = purpose.text.starts_with("PROBE_");
        const Program& program =
            program_.with({purpose, surface_.corners_define(), DisplacedSurface::spacing_define(settings_.spacing),
                           Settings::methods.define(settings_.method), Settings::levels_ofs.define(settings_.levels_of),
                           Settings::mips.define(settings_.mip), settings_.fade ? "FADE" : "",
                           Settings::shadows.define(purpose.text.empty() ? settings_.shadow : Settings::no_shadow),
                           reads_slopes(purpose) ? Settings::lost_slopes_choices.define(settings_.lost_slopes) : "",
                           color_define("OUTSIDE_COLOR", outside_color), color_define("AWAY_COLOR", away_color),
                           color_define("FADED_COLOR", faded_color)});
        glUseProgram(program);
        surface_.set(program, view.seen);
        set_colors(program, view.seen);
        set_slopes(program);
        if (settings_.shadow != Settings::no_shadow && purpose.text.empty()) shadow_map_.set(program, 4);
        set_levels(program, view.eye);
        set_culling(program, view, !has_backs(purpose));
        if (settings_.shadow == Settings::shadow_of_all && casts_shadow() && !is_probe)
            stop_culling(program);  // the shadow map is within the bound, too
        bound_levels(program, is_probe ? 1 : draws_of_picture());
        set_culling(program, view, !has_backs(purpose));
        return program;
    }

    /// Draws the surface. Returns the number of triangles drawn, or 0 for a probe.
    int draw_surface(const View& view, const Define& purpose) {
        const bool is_probe = purpose.text.starts_with("PROBE_");
        use_program(view, purpose);
        if (!has_backs(purpose)) glEnable(GL_CULL_FACE);
        // A probe has no caption for the count. Its caller may have a query of its own running.
        const int triangles = is_probe ? (surface_.draw(), 0) : surface_.draw_and_count();
        glDisable(GL_CULL_FACE);
        return triangles;
    }

    void set_colors(const Program& program, const Frame& seen) const {
        program.set("u_seen_from", seen.camera.eye() - surface_.origin);
        program.set("u_to_light", settings_.light.direction());
        program.set("u_wire", glm::vec3(0.93f, 0.86f, 0.62f));
    }

    /// Binds the slopes of the normal map. Only LEADR reads them.
    void set_slopes(const Program& program) {
        program.set("u_shininess", settings_.shininess);
        const auto& [slopes, squares] = slopes_.get({surface_.material.version()}, [this] {
            const auto maps = std::make_shared<std::optional<SlopeMaps>>();  // both textures take their map from it
            const auto made = [maps, this]() -> const SlopeMaps& {
                if (!*maps) *maps = slope_maps(surface_.material.normals());
                return **maps;
            };
            return SlopeTextures{Texture("slopes", [made] { return made().slopes; }),
                                 Texture("squared slopes", [made] { return made().squares; })};
        });
        program.set("s_slopes", 5, slopes);
        program.set("s_squares", 6, squares);
    }

    void set_culling(const Program& program, const View& view, bool with_backs) const {
        set_each<glm::vec4>(program, "u_planes", planes_of(view.eye.camera, surface_.origin));
        program.set("u_culls_outside", settings_.cull != Settings::cull_none);
        program.set("u_culls_backs", settings_.cull == Settings::cull_all && with_backs);
        program.set("u_show_culled", view.eye.camera.eye() != view.seen.camera.eye());
    }

    static void stop_culling(const Program& program) {
        program.set("u_culls_outside", false);
        program.set("u_culls_backs", false);
    }

    void set_levels(const Program& program, const Frame& eye) {
        known_.set(program, surface_, settings_.method == Settings::by_error, 3);
        program.set("u_eye", eye.camera.eye() - surface_.origin);
        program.set("u_level", settings_.level);
        program.set("u_by_distance", glm::vec4(settings_.distances(), settings_.finest, settings_.coarsest));
        program.set("u_pixels_per_radian",
                    settings_.method == Settings::by_error ? most_pixels_per_radian(eye) : pixels_per_radian(eye));
        program.set("u_pixels_per_segment", settings_.segment);
        program.set("u_budget", settings_.budget);
        program.set("u_fade", settings_.fade_range());
    }

    /// Limits the number of triangles of a picture that draws the surface `draws` times. All other uniforms are set.
    void bound_levels(const Program& program, int draws) {
        const float most = surface_.most_level(program, settings_.highest_level(), draws);
        most_level_ = std::min(most_level_, most);
        // Without a bound the task's own maximum must show, also if it is missing.
        program.set("u_most_level", most < DisplacedSurface::finest_level ? most : std::numeric_limits<float>::max());
    }

    /// Marks the pixels where neighbours disagree, and counts them.
    void mark_holes(glm::ivec2 size, const View& view) {
        const Image sums = draw_numbers(view.eye.size, [&] {
            DisplacedSurface::begin_winding();
            draw_surface(view, Probe{"winding", MissingTask::told});
            DisplacedSurface::end_winding();
        });
        if (std::find(sums.values.begin(), sums.values.end(), not_written) != sums.values.end()) return;
        const std::vector<glm::ivec2> holes = holes_in(sums, surface_.patches().is_closed);
        mark(labels_, size, view.tile, holes);
        labels_.caption(size, view.tile, -1, fmt::format("{} pixels are holes", holes.size()), {1.0f, 0.55f, 0.4f});
    }

    Programs program_{"common/patch.vert", "14_adaptive_displacement/patch.tesc",
                      "14_adaptive_displacement/surface.tese", "14_adaptive_displacement/surface.frag"};
    SightLines sight_;
    Settings settings_;
    DisplacedSurface surface_;
    PatchTexture known_;
    struct SlopeTextures {
        Texture slopes, squares;
    };
    Kept<SlopeTextures, int> slopes_;  ///< by the version of the material
    ShadowMap shadow_map_;
    Labels labels_;

    float most_level_ = 0;  ///< maximum level in this draw
};

RELIEF_LAB(AdaptiveDisplacement);

}  // namespace relief
