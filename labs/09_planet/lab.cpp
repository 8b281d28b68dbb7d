// Lab 09: a planet.
//
// A cube sphere has no poles. Its grid is bent and skewed, so heights become normals by its metric. Patches of several
// levels meet without gaps, as many as the picture needs.
//
// Your tasks: shaders/09_planet/task.glsl, labs/09_planet/task.cpp
#include <fmt/format.h>

#include <algorithm>

#include "framework/core/lab/lab.h"
#include "framework/library/kit/labels.h"
#include "framework/library/kit/made_map.h"
#include "framework/library/kit/tiles.h"
#include "task.h"
#include "truth.h"
#include "views.h"

namespace relief::planet {

class PlanetLab final : public Lab, public MapMaker {
public:
    void draw(const Frame& frame) override {
        std::vector<View> views = views_of(settings_, frame);
        // Maps first: making them changes the framebuffer.
        for (size_t i = 0; i < views.size(); ++i) {
            cover_with_patches(views[i]);
            globes_[i].prepare(views[i].recipe, views[i].leaves, needs_maps(views[i], frame.probe));
        }
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glViewport(0, 0, frame.size.x, frame.size.y);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        for (size_t i = 0; i < views.size(); ++i) {
            if (views[i].is_flat)
                draw_faces(frame, views[i], globes_[i]);
            else
                draw_view(frame, views[i], globes_[i]);
            if (!frame.probe) describe(frame.size, views[i], globes_[i]);
        }
        labels_.draw(frame);
    }

    void knobs(Knobs& knobs) override { settings_.knobs(knobs); }

    std::optional<Image> truth(const Frame& frame) const override {
        std::vector<View> views = views_of(settings_, frame);
        std::vector<Tile> tiles;
        for (View& view : views) {
            if (view.is_flat) cover_with_patches(view);  // limits the texels of its maps
            tiles.push_back(view.tile);
        }
        return truth_in_tiles(frame, tiles, [&](const Frame& part, size_t i) -> std::optional<Image> {
            const View& view = views[i];
            const Sight sight{view.plan, view.seen_from, view.recipe.texels};
            return view.is_flat ? flat_truth(part.size, frame.probe, sight)
                                : globe_truth(part.size, frame.probe, sight);
        });
    }

    /// Returns the normals of the patches of the first view.
    std::optional<Image> made_map() override { return globes_[0].map_picture(); }

private:
    static constexpr double near = 1e-7;  // radii

    bool by_formula() const { return settings_.slopes_from == Settings::by_formula; }
    bool needs_maps(const View& view, const Probe& probe) const {
        if (!probe) return true;
        return view.is_flat ? probe.name == "slope" || (probe.name == "normal" && !by_formula())
                            : probe.name == "normal";
    }

    // ---- an eye's view: the ground, the frames of its grid, the sky behind it

    void draw_view(const Frame& frame, const View& view, const Globe& globe) {
        glViewport(view.tile.corner.x, view.tile.corner.y, view.tile.size.x, view.tile.size.y);
        draw_ground(frame.probe, view, globe);
        if (frame.probe) return;
        if (view.shows_frames) draw_frames(view, globe);
        draw_sky(view);
    }

    void draw_ground(const Probe& probe, const View& view, const Globe& globe) {
        const Plan& plan = view.plan;
        const bool has_map = !probe || probe.name == "normal";
        const int lit = lit_by(view, probe);
        const Program& program =
            surface_.with({probe, !probe && view.shows_patches ? "PATCHES" : "", plan.skirts ? "SKIRTS" : "",
                           Settings::normal_sources.define(lit),
                           lit == Settings::lit_by_bumps ? mapping_define(plan.shape.mapping) : "", depth_define()});
        glUseProgram(program);
        set_eye(program, view.seen_from, plan.radius);
        program.set("u_radius", plan.radius);
        program.set("u_to_sun", settings_.sun.direction());
        program.set("u_quads", float(plan.shape.quads));
        program.set("s_bumps", 1, bumps_);
        program.set("u_texels", view.recipe.texels);
        if (has_map) {
            program.set("s_map", 0);
            globe.bind_maps(0);
        }
        PatchedSphere::ByLevel metres = patches_of(plan.shape).errors();
        for (double& error : metres) error *= plan.radius;
        const bool needs_skirts = plan.skirts || probe.name == "skirt";
        for (size_t i = 0; i < view.leaves.size(); ++i) {
            const auto& [id, state] = view.leaves[i];
            program.set("u_level", state == Leaf::drawn ? float(id.level) : state == Leaf::hidden ? -1.0f : -2.0f);
            program.set("u_skirt", needs_skirts ? skirt_depth(metres, id.level) : 0.0);
            set_grid(program, plan.shape.mapping, id);
            globe.draw(program, i, plan, view.seen_from, settings_.precise == Settings::camera_relative);
        }
    }

    /// Returns the normals that light a view. Probes and the picture of patches have no bumps.
    static int lit_by(const View& view, const Probe& probe) {
        const bool has_bumps = view.lit_by == Settings::lit_by_bumps && !probe && !view.shows_patches;
        const bool is_lit = !probe || probe.name == "normal";
        return has_bumps || (is_lit && view.lit_by == Settings::lit_by_vertices) ? view.lit_by
                                                                                 : int(Settings::lit_by_map);
    }

    void draw_frames(const View& view, const Globe& globe) {
        constexpr int side = 5;
        const SphereMapping mapping = view.plan.shape.mapping;
        const Program& program = frames_.with({mapping_define(mapping), depth_define()});
        glUseProgram(program);
        set_ground(program, view.plan.shape.ground);
        set_eye(program, view.seen_from, 1);
        program.set("u_size", glm::vec2(view.tile.size));
        program.set("u_texels", view.recipe.texels);
        program.set("u_side", side);
        program.set("u_length", 0.045);
        program.set("s_map", 0);
        globe.bind_maps(0);
        glBindVertexArray(nothing_.layout());
        for (size_t i = 0; i < view.leaves.size(); ++i) {
            const SpherePatch& patch = view.leaves[i].id;
            set_grid(program, mapping, patch);
            program.set("u_map_corner", globe.map_corner(i));
            glDrawArrays(GL_TRIANGLES, 0, 18 * side * side);
        }
    }

    void draw_sky(const View& view) {
        const Eye& eye = view.seen_from;
        const Program& program = sky_.with();
        glUseProgram(program);
        program.set("u_to_sun", settings_.sun.direction());
        program.set("u_world_from_view", glm::mat3(glm::transpose(eye.view_from_world)));
        program.set("u_tangents", glm::vec2(eye.tangent() * eye.aspect, eye.tangent()));
        program.set("u_window", glm::vec4(view.tile.corner, view.tile.size));
        program.set("u_eye", eye.place);
        glDepthFunc(GL_LEQUAL);  // passes at the far plane, where nothing was drawn
        glBindVertexArray(nothing_.layout());
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glDepthFunc(GL_LESS);
    }

    /// `radius` is the planet's, in the program's unit of length.
    static void set_eye(const Program& program, const Eye& eye, double radius) {
        program.set("u_view_from_world", glm::mat3(eye.view_from_world));
        program.set("u_zoom", glm::vec2(1 / (eye.tangent() * std::max(1e-9, eye.aspect)), 1 / eye.tangent()));
        program.set("u_near", near * radius);
        program.set("u_far", (glm::length(eye.place) + 2) * radius);
        program.set("u_eye", eye.place);
    }
    /// Sets where a patch is on its face, for shaders/09_planet/grid.glsl.
    static void set_grid(const Program& program, SphereMapping mapping, const SpherePatch& patch) {
        program.set("u_face", glm::mat3(face_axes(mapping, patch.face)));
        program.set("u_patch_on_face", glm::vec4(patch.on_face({0, 0}), patch.on_face({1, 1})));
    }
    Define depth_define() const { return Settings::depths.define(settings_.depth); }

    // ---- the faces, spread out flat

    void draw_faces(const Frame& frame, const View& view, const Globe& globe) {
        const SphereMapping mapping = view.plan.shape.mapping;
        const bool is_lat_long = mapping == SphereMapping::lat_long;
        const std::vector<Tile> tiles = tile_grid(frame.size, is_lat_long ? 2 : 3, is_lat_long ? 1 : 2);
        Probe shown = frame.probe;
        if (shown.name == "normal" && by_formula()) shown.name = "formula";
        const bool has_bumps = view.lit_by == Settings::lit_by_bumps && !frame.probe;
        const Program& program = flat_.with({shown, mapping_define(mapping), has_bumps ? "BUMPS" : ""});
        glUseProgram(program);
        glDisable(GL_DEPTH_TEST);
        set_ground(program, view.plan.shape.ground);
        program.set("u_to_sun", settings_.sun.direction());
        program.set("u_texels", view.recipe.texels);
        program.set("s_bumps", 1, bumps_);
        program.set("s_map", 0);
        globe.bind_maps(0);
        glBindVertexArray(nothing_.layout());
        for (size_t i = 0; i < view.leaves.size(); ++i) {
            const SpherePatch& patch = view.leaves[i].id;
            const Tile& tile = tiles[size_t(patch.face)];
            // Borders are rounded to pixels, so that each pixel belongs to exactly one patch.
            const glm::dvec2 size = glm::dvec2(tile.size) / double(1 << patch.level);
            const glm::dvec2 low = glm::dvec2(tile.corner) + glm::dvec2(patch.x, patch.y) * size;
            const glm::ivec2 begin(glm::ceil(low - 0.5)), end(glm::ceil(low + size - 0.5));
            glViewport(begin.x, begin.y, end.x - begin.x, end.y - begin.y);
            program.set("u_window", glm::vec4(low, size));
            set_grid(program, mapping, patch);
            program.set("u_patch", glm::ivec2(patch.x, patch.y));
            program.set("u_level", patch.level);
            program.set("u_map_corner", globe.map_corner(i));
            glDrawArrays(GL_TRIANGLES, 0, 3);
        }
        glEnable(GL_DEPTH_TEST);
    }

    void describe(glm::ivec2 size, const View& view, const Globe& globe) {
        if (!view.title.empty()) labels_.caption(size, view.tile, 0, view.title);
        if (!view.bounded.empty()) labels_.caption(size, view.tile, 1, view.bounded);
        if (settings_.view != Settings::patches) return;
        const auto count = std::count_if(view.leaves.begin(), view.leaves.end(),
                                         [](const Leaf& leaf) { return leaf.state == Leaf::drawn; });
        labels_.caption(size, view.tile, 0,
                        view.shows_patches
                            ? fmt::format("{} patches", count)
                            : fmt::format("{} triangles", count * globe.triangles_of_patch(settings_.skirts)));
    }

    Settings settings_;
    Programs surface_{"09_planet/surface.vert", "09_planet/surface.frag"};
    Programs flat_{"common/window.vert", "09_planet/flat.frag"};
    Programs frames_{"09_planet/frames.vert", "09_planet/frames.frag"};
    Programs sky_{"common/far_window.vert", "09_planet/sky.frag"};
    std::array<Globe, 3> globes_;
    Texture bumps_ = load_texture("bricks_normal.png", ColorSpace::linear);
    GpuMesh nothing_ = upload([] { return Mesh{}; });
    Labels labels_;
};

RELIEF_LAB(PlanetLab);

}  // namespace relief::planet
