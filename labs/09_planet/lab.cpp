// Lab 09: a planet.
//
// A cube sphere has no poles. Its grid is bent and skewed, so heights become normals by its metric. Patches of several
// levels meet without gaps, as many as the picture needs.
//
// Your tasks: shaders/09_planet/task.glsl, labs/09_planet/task.cpp
#include <fmt/format.h>

#include "framework/gl/texel_target.h"
#include "framework/image/visualize.h"
#include "framework/kit/labels.h"
#include "framework/kit/light.h"
#include "framework/kit/tiles.h"
#include "framework/lab/lab.h"
#include "globe.h"
#include "task.h"
#include "truth.h"

namespace relief::planet {

class PlanetLab final : public Lab {
public:
    void draw(const Frame& frame) override {
        std::vector<View> views = views_of(frame);
        // Maps first: making them changes the framebuffer.
        for (size_t i = 0; i < views.size(); ++i) {
            cover_with_patches(views[i], views.size());
            prepare(views[i], globes_[i], frame.probe);
        }
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glViewport(0, 0, frame.size.x, frame.size.y);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        for (size_t i = 0; i < views.size(); ++i) {
            if (views[i].is_flat)
                draw_flat(frame, views[i], globes_[i]);
            else
                draw_globe(frame, views[i], globes_[i]);
            if (!frame.probe) describe(frame.size, views[i], globes_[i]);
        }
        labels_.draw(frame);
    }

    void knobs(Knobs& knobs) override {
        knobs.group("Picture");
        knobs.choice(
            "view", view_, view_names,
            "the planet, its pole and its patches; one of them; mountains by the map and by their vertices; the "
            "grid's frames where patches meet; or the faces spread out");
        knobs.group("Grid and normals");
        knobs.choice("mapping", mapping_, mappings,
                     "where the grid lies: equal angles, the cube, latitude and longitude");
        knobs.choice("normals", normals_, normal_rules, "normals by the metric, or by what is commonly written");
        knobs.choice("slopes_from", slopes_from_, slope_sources,
                     "for view = faces: slopes by a filter in the map, or from the heights' formula");
        knobs.choice("lit_by", lit_by_, lit_bys, "normals of the map, or those at the vertices, interpolated");
        knobs.toggle("gutter", gutter_, "maps go on beyond the border of their patch, or repeat its last texel");
        knobs.choice("strength", strength_, strengths, "by what a level multiplies its slopes");
        knobs.group("Patches");
        knobs.choice("levels", levels_, level_rules, "all patches alike, by distance, or by their error on the screen");
        knobs.steps("level", level_, 0, 5, "for levels = uniform, and of the faces: level of every patch");
        knobs.slider("budget", budget_, 0.25f, 16, "tolerated error, pixels");
        knobs.choice("quads", quads_, quad_counts, "quads along a patch's side");
        knobs.choice("texels", texels_, texel_counts, "texels along a patch's side");
        knobs.toggle("skirts", skirts_, "borders reach down, so that no gap opens between two levels");
        knobs.choice("cull", cull_, culls, "leave out no patches, those outside of the picture, or also hidden ones");
        knobs.group("Eye");
        knobs.choice("eye", eye_, eyes, "the camera, or above a place on the ground");
        knobs.slider("altitude", altitude_, -6, 1, "for eye = ground: height above it, as a power of 10 of the radius");
        knobs.slider("longitude", longitude_, -180, 180, "for eye = ground: longitude of the place, degrees");
        knobs.slider("latitude", latitude_, -90, 90, "for eye = ground: latitude of the place, degrees");
        knobs.slider("heading", heading_, -180, 180, "for eye = ground: direction from north to the right, degrees");
        knobs.slider("tilt", tilt_, -90, 90, "for eye = ground: elevation of the view, degrees");
        knobs.group("Planet");
        knobs.slider("radius", radius_, 0, 7, "radius of the planet, as a power of 10 in metres; 6.804 is the Earth");
        knobs.choice("precise", precise_, precisions, "subtract the eye before rounding to float, or after");
        knobs.choice("depth", depth_, depths, "depth by a logarithm, or as usual");
        knobs.slider("height", height_, 0, 2, "height of mountains and craters");
        knobs.steps("detail", detail_, 0, 5, "octaves of the mountains' ridges");
        knobs.steps("seed", seed_, 0, 99, "another planet");
        sun_.knobs(knobs);
    }

    std::optional<Image> truth(const Frame& frame, const Probe& probe) const override {
        Frame asked = frame;
        asked.probe = probe;
        std::vector<View> views = views_of(asked);
        for (View& view : views) {
            view.plan.most_patches = most_patches(view, views.size());
            if (view.is_flat) cover_with_patches(view, views.size());  // limits the texels of its maps
        }
        std::vector<Tile> tiles;
        for (const View& view : views) tiles.push_back(view.tile);
        return truth_in_tiles(frame, tiles, [&](const Frame& part, size_t i) -> std::optional<Image> {
            const View& view = views[i];
            const Sight sight{view.plan, view.seen_from, view.recipe.texels};
            return view.is_flat ? flat_truth(part.size, probe, sight) : globe_truth(part.size, probe, sight);
        });
    }

private:
    enum ViewKind { compare, planet, pole, patches, faces, mountains, frames };
    static constexpr std::array view_names = {"compare", "planet", "pole", "patches", "faces", "mountains", "frames"};
    static constexpr std::array mappings = {"equal-angle", "gnomonic", "lat-long"};
    static constexpr std::array normal_rules = {"metric", "right-angled", "b-by-cross", "one-scale"};
    static constexpr std::array slope_sources = {"map", "formula"};
    static constexpr std::array lit_bys = {"map", "vertices"};
    static constexpr std::array strengths = {"2^level", "1+2^level", "none"};
    static constexpr std::array level_rules = {"uniform", "distance", "error"};
    static constexpr std::array quad_counts = {"8", "16", "32"};
    static constexpr std::array texel_counts = {"16", "32", "64", "128", "256"};
    static constexpr std::array culls = {"none", "outside", "horizon"};
    static constexpr std::array eyes = {"camera", "ground"};
    static constexpr std::array precisions = {"camera-relative", "float"};
    static constexpr double near = 1e-7;  // radii
    static constexpr std::array depths = {"logarithm", "usual"};

    struct View {
        Tile tile;
        bool is_flat = false, shows_patches = false, shows_frames = false, by_vertices = false;
        Plan plan;
        Eye seen_from;
        MapRecipe recipe;
        std::vector<Leaf> leaves;
        std::string title, bounded;  ///< `bounded`: the limits that reduced patches or texels, in words; or empty
    };

    Shape shape() const { return {{seed_, detail_, height_}, Mapping(mapping_), 8 << quads_}; }

    Eye eye_of(const Frame& frame) const {
        const double aspect = double(frame.size.x) / std::max(1, frame.size.y);
        if (eye_ == 0) return Eye::of(frame.camera, aspect);
        const double lon = glm::radians(double(longitude_)), lat = glm::radians(double(latitude_));
        const glm::dvec3 up(std::cos(lat) * std::sin(lon), std::sin(lat), std::cos(lat) * std::cos(lon));
        const glm::dvec3 east(std::cos(lon), 0, -std::sin(lon)), north = glm::cross(up, east);
        const double turn = glm::radians(double(heading_)), rise = glm::radians(double(tilt_));
        const glm::dvec3 ahead = std::cos(turn) * north + std::sin(turn) * east;
        const double from_centre = 1 + height(shape().ground, up) + std::pow(10.0, double(altitude_));
        const double field_of_view =
            std::min(2.4, 2 * std::atan(std::tan(glm::radians(30.0)) * std::max(1.0, 1 / aspect)));
        return Eye::looking(from_centre * up, std::cos(rise) * ahead + std::sin(rise) * up,
                            std::cos(rise) * up - std::sin(rise) * ahead, field_of_view, aspect);
    }

    /// Returns a second eye at the side, which sees ground that is hidden from `eye`.
    static Eye beside(const Eye& eye, double aspect) {
        const double away = glm::length(eye.place);
        const glm::dvec3 towards = away > 0 ? eye.place / away : glm::dvec3(0, 0, 1);
        const glm::dvec3 pole = std::abs(towards.y) > 0.95 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
        const glm::dvec3 side = glm::normalize(glm::cross(pole, towards)), up = glm::cross(towards, side);
        const glm::dvec3 from = glm::normalize(0.75 * towards + 0.75 * side + 0.35 * up);
        const double field_of_view = 2 * std::atan(0.42 * std::max(1.0, 1 / aspect));
        return Eye::looking(3.1 * from, -from, glm::normalize(up - glm::dot(up, from) * from), field_of_view, aspect);
    }

    /// Returns an eye above a place, `distance` radii from the centre, with `up` upwards in the picture.
    static Eye above(const glm::dvec3& place, double distance, const glm::dvec3& up, double aspect) {
        const glm::dvec3 from = glm::normalize(place);
        return Eye::looking(distance * from, -from, glm::normalize(up - glm::dot(up, from) * from),
                            2 * std::atan(0.42 * std::max(1.0, 1 / aspect)), aspect);
    }

    static Eye above_pole(double aspect) { return above({0, 1, 0.32}, 1.75, {0, 0, -1}, aspect); }

    /// Returns the views of the picture, each in its tile.
    std::vector<View> views_of(const Frame& frame) const {
        const std::string& probe = frame.probe.name;
        const bool of_grid = probe == "direction" || probe == "stretch" || probe == "corner" || probe == "gradient" ||
                             probe == "texel" || probe == "slope";
        const auto view = [&](const Tile& tile, std::string title) {
            View made;
            made.tile = tile, made.title = std::move(title);
            const Frame part = frame_in(frame, tile);
            made.plan = {shape(),         Levels(levels_),     level_,
                         double(budget_), Cull(cull_),         std::pow(10.0, double(radius_)),
                         skirts_,         double(tile.size.y), eye_of(part)};
            made.seen_from = made.plan.eye;
            made.recipe = {shape(), Normals(normals_), 16 << texels_, gutter_, strength_, probe == "slope"};
            made.by_vertices = lit_by_ == 1;
            return made;
        };
        const Tile whole{{0, 0}, frame.size};
        const auto as_patches = [&](View& made) {
            made.shows_patches = true;
            made.seen_from = beside(made.plan.eye, double(made.tile.size.x) / std::max(1, made.tile.size.y));
        };
        std::vector<View> views;
        if (of_grid || view_ == faces) {
            views.push_back(view(whole, ""));
            views[0].is_flat = true, views[0].plan.levels = Levels::uniform, views[0].plan.cull = Cull::none;
            return views;
        }
        if (view_ == pole) {
            for (size_t i = 0; const Tile& tile : tiles_of(frame.size, 2)) {
                views.push_back(view(tile, i == 0 ? "no poles" : "latitude and longitude"));
                View& made = views.back();
                made.plan.eye = made.seen_from = above_pole(double(tile.size.x) / std::max(1, tile.size.y));
                if (i++ == 1) as_usual(made);
            }
            return views;
        }
        if (view_ == frames) {
            for (size_t i = 0; const Tile& tile : tiles_of(frame.size, 2)) {
                views.push_back(view(tile, i == 0 ? "a corner of the cube" : "a pole of latitude and longitude"));
                View& made = views.back();
                const double aspect = double(tile.size.x) / std::max(1, tile.size.y);
                made.plan.eye = made.seen_from =
                    i == 0 ? above({-1, 0.85, 1}, 1.75, {0, 1, 0}, aspect) : above({0, 1, 0}, 1.7, {0, 0, -1}, aspect);
                made.plan.levels = Levels::uniform, made.plan.level = 2, made.shows_frames = true;
                if (i++ == 1) as_usual(made);
            }
            return views;
        }
        if (!frame.probe && view_ == mountains) {
            for (size_t i = 0; const Tile& tile : tiles_of(frame.size, 2)) {
                views.push_back(view(tile, i == 0 ? "normals of the map" : "normals of the vertices"));
                views.back().by_vertices = i++ == 1;
            }
            return views;
        }
        if (frame.probe || view_ == planet) {
            views.push_back(view(whole, ""));
            if (view_ == patches) as_patches(views[0]);
            return views;
        }
        if (view_ == patches) {
            for (const Tile& tile : tiles_of(frame.size, 2)) views.push_back(view(tile, ""));
            as_patches(views[1]);
            // Both tiles show the same patches: the patches that the eye's picture needs.
            views[1].plan = views[0].plan;
            return views;
        }
        // The planet is large, the other two views are beside or below it.
        const bool is_wide = frame.size.x >= frame.size.y;
        const int along = is_wide ? frame.size.x : frame.size.y, part = along * 2 / 3;
        const glm::ivec2 size = frame.size;
        const Tile large = is_wide ? Tile{{0, 0}, {part, size.y}} : Tile{{0, size.y - part}, {size.x, part}};
        const int half = (is_wide ? size.y : size.x) / 2;
        const Tile first =
            is_wide ? Tile{{part, half}, {size.x - part, size.y - half}} : Tile{{0, 0}, {half, size.y - part}};
        const Tile second =
            is_wide ? Tile{{part, 0}, {size.x - part, half}} : Tile{{half, 0}, {size.x - half, size.y - part}};
        views.push_back(view(large, ""));
        views.push_back(view(first, "latitude and longitude"));
        View& bald = views.back();
        bald.plan.eye = bald.seen_from = above_pole(double(first.size.x) / std::max(1, first.size.y));
        as_usual(bald);
        views.push_back(view(second, "patches"));
        as_patches(views[2]);
        views[2].plan = views[0].plan;
        return views;
    }

    /// Switches a view to the common way of making planets.
    static void as_usual(View& view) {
        view.plan.shape.mapping = view.recipe.shape.mapping = Mapping::lat_long;
        view.recipe.normals = Normals::one_scale;
    }

    /// Returns the maximum number of patches of a view, if the picture has `views` views.
    static size_t most_patches(const View& view, size_t views) {
        return size_t(most_vertices) / views / size_t(vertices_of_patch(view.plan.shape.quads));
    }

    /// Covers the planet with patches. Limits their number, and the texels of their maps, to one view's share of
    /// `views`.
    static void cover_with_patches(View& view, size_t views) {
        view.plan.most_patches = most_patches(view, views);
        Cover all = cover(view.plan);
        view.leaves = std::move(all.leaves);
        // Culled patches are only drawn in the view from the side.
        if (!view.shows_patches) std::erase_if(view.leaves, [](const Leaf& leaf) { return leaf.state != Leaf::drawn; });
        if (all.is_bounded) view.bounded = fmt::format("at most {} patches", view.plan.most_patches);
        const int wanted = view.recipe.texels;
        view.recipe.texels = texels_that_fit(wanted, view.leaves.size(), most_texels / int(views));
        if (view.recipe.texels < wanted)
            view.bounded +=
                fmt::format("{}maps of {} texels at most", view.bounded.empty() ? "" : ", ", view.recipe.texels);
    }

    void prepare(const View& view, Globe& globe, const Probe& probe) const {
        const bool maps = view.is_flat
                              ? !probe || probe.name == "slope" || (probe.name == "normal" && slopes_from_ == 0)
                              : !probe || probe.name == "normal";
        globe.prepare(view.recipe, view.leaves, maps);
    }

    Define probe_define(const Probe& probe) const {
        return probe.name == "normal" && slopes_from_ == 1 ? Define("PROBE_formula") : Define(probe);
    }

    void draw_flat(const Frame& frame, const View& view, const Globe& globe) {
        const bool is_lat_long = view.plan.shape.mapping == Mapping::lat_long;
        const std::vector<Tile> tiles = tile_grid(frame.size, is_lat_long ? 2 : 3, is_lat_long ? 1 : 2);
        const Program& program = flat_.with({probe_define(frame.probe), mapping_define(view.plan.shape.mapping)});
        glUseProgram(program);
        glDisable(GL_DEPTH_TEST);
        set_ground(program, view.plan.shape.ground);
        program.set("u_to_sun", sun_.direction());
        program.set("u_texels", view.recipe.texels);
        program.set("s_map", 0);
        globe.bind_maps(0);
        if (!nothing_) nothing_.emplace();
        glBindVertexArray(*nothing_);
        for (size_t i = 0; i < view.leaves.size(); ++i) {
            const PatchId& id = view.leaves[i].id;
            const Tile& tile = tiles[size_t(id.face)];
            // Borders are rounded to pixels, so that each pixel belongs to exactly one patch.
            const glm::dvec2 size = glm::dvec2(tile.size) / double(1 << id.level);
            const glm::dvec2 low = glm::dvec2(tile.corner) + glm::dvec2(id.x, id.y) * size;
            const glm::ivec2 begin(glm::ceil(low - 0.5)), end(glm::ceil(low + size - 0.5));
            glViewport(begin.x, begin.y, end.x - begin.x, end.y - begin.y);
            program.set("u_window", glm::vec4(low, size));
            program.set("u_face", glm::mat3(face_axes(view.plan.shape.mapping, id.face)));
            program.set("u_patch_on_face", glm::vec4(id.on_face({0, 0}), id.on_face({1, 1})));
            program.set("u_patch", glm::ivec2(id.x, id.y));
            program.set("u_level", id.level);
            program.set("u_map_corner", globe.map_corner(i));
            glDrawArrays(GL_TRIANGLES, 0, 3);
        }
        glEnable(GL_DEPTH_TEST);
    }

    void draw_globe(const Frame& frame, const View& view, const Globe& globe) {
        glViewport(view.tile.corner.x, view.tile.corner.y, view.tile.size.x, view.tile.size.y);
        const Eye& eye = view.seen_from;
        const double tangent = std::tan(eye.field_of_view_rad / 2);
        const Plan& plan = view.plan;
        const bool has_map = !frame.probe || frame.probe.name == "normal";
        const Program& surface = surface_.with(
            {frame.probe, !frame.probe && view.shows_patches ? "PATCHES" : "", plan.skirts ? "SKIRTS" : "",
             has_map && view.by_vertices ? "VERTEX_NORMALS" : "", depth_ == 0 ? "LOG_DEPTH" : ""});
        glUseProgram(surface);
        Plan seen = plan;
        seen.eye = eye;
        surface.set("u_radius", plan.radius);
        surface.set("u_view_from_world", glm::mat3(eye.view_from_world));
        surface.set("u_zoom", glm::vec2(1 / (tangent * std::max(1e-9, eye.aspect)), 1 / tangent));
        surface.set("u_near", near * plan.radius);
        surface.set("u_far", (glm::length(eye.place) + 2) * plan.radius);
        surface.set("u_eye", eye.place);
        surface.set("u_to_sun", sun_.direction());
        surface.set("u_quads", float(plan.shape.quads));
        surface.set("u_texels", view.recipe.texels);
        if (has_map) {
            surface.set("s_map", 0);
            globe.bind_maps(0);
        }
        const Measured& known = measured(plan.shape);
        std::array<double, deepest_level + 1> metres{};
        for (size_t i = 0; i < metres.size(); ++i) metres[i] = known.errors[i] * plan.radius;
        const bool needs_skirts = plan.skirts || frame.probe.name == "skirt";
        for (size_t i = 0; i < view.leaves.size(); ++i) {
            const auto& [id, state] = view.leaves[i];
            surface.set("u_level", state == Leaf::drawn ? float(id.level) : state == Leaf::hidden ? -1.0f : -2.0f);
            surface.set("u_skirt", needs_skirts ? skirt_depth(metres, id.level) : 0.0);
            globe.draw(surface, seen, i, precise_ == 0);
        }
        if (!frame.probe && view.shows_frames) draw_frames(view, globe);
        if (!frame.probe) {
            const Program& sky = sky_.with();
            glUseProgram(sky);
            sky.set("u_to_sun", sun_.direction());
            sky.set("u_world_from_view", glm::mat3(glm::transpose(eye.view_from_world)));
            sky.set("u_tangents", glm::vec2(tangent * eye.aspect, tangent));
            sky.set("u_window", glm::vec4(view.tile.corner, view.tile.size));
            sky.set("u_eye", eye.place);
            if (!nothing_) nothing_.emplace();
            glDepthFunc(GL_LEQUAL);  // passes at the far plane, where nothing was drawn
            glBindVertexArray(*nothing_);
            glDrawArrays(GL_TRIANGLES, 0, 3);
            glDepthFunc(GL_LESS);
        }
    }

    void draw_frames(const View& view, const Globe& globe) {
        constexpr int side = 5;
        const Eye& eye = view.seen_from;
        const double tangent = std::tan(eye.field_of_view_rad / 2);
        const Program& lines = frames_.with({mapping_define(view.plan.shape.mapping), depth_ == 0 ? "LOG_DEPTH" : ""});
        glUseProgram(lines);
        set_ground(lines, view.plan.shape.ground);
        lines.set("u_view_from_world", glm::mat3(eye.view_from_world));
        lines.set("u_zoom", glm::vec2(1 / (tangent * std::max(1e-9, eye.aspect)), 1 / tangent));
        lines.set("u_size", glm::vec2(view.tile.size));
        lines.set("u_near", near);
        lines.set("u_far", glm::length(eye.place) + 2);
        lines.set("u_eye", eye.place);
        lines.set("u_texels", view.recipe.texels);
        lines.set("u_side", side);
        lines.set("u_length", 0.045);
        lines.set("s_map", 0);
        globe.bind_maps(0);
        if (!nothing_) nothing_.emplace();
        glBindVertexArray(*nothing_);
        for (size_t i = 0; i < view.leaves.size(); ++i) {
            const PatchId& id = view.leaves[i].id;
            lines.set("u_face", glm::mat3(face_axes(view.plan.shape.mapping, id.face)));
            lines.set("u_patch_on_face", glm::vec4(id.on_face({0, 0}), id.on_face({1, 1})));
            lines.set("u_map_corner", globe.map_corner(i));
            glDrawArrays(GL_TRIANGLES, 0, 18 * side * side);
        }
    }

    void describe(glm::ivec2 size, const View& view, const Globe& globe) {
        if (!view.title.empty()) labels_.caption(size, view.tile, 0, view.title);
        if (!view.bounded.empty()) labels_.caption(size, view.tile, 1, view.bounded);
        if (view_ != patches) return;
        const size_t count = size_t(std::count_if(view.leaves.begin(), view.leaves.end(),
                                                  [](const Leaf& leaf) { return leaf.state == Leaf::drawn; }));
        labels_.caption(size, view.tile, 0,
                        view.shows_patches ? fmt::format("{} patches", count)
                                           : fmt::format("{} triangles", count * size_t(globe.triangles_of_patch())));
    }

    Programs surface_{"09_planet/surface.vert", "09_planet/surface.frag"};
    Programs flat_{"09_planet/window.vert", "09_planet/flat.frag"};
    Programs frames_{"09_planet/frames.vert", "09_planet/frames.frag"};
    Programs sky_{"09_planet/window.vert", "09_planet/sky.frag"};
    std::array<Globe, 3> globes_;
    std::optional<VertexArrayName> nothing_;
    Labels labels_;

    int view_ = compare, mapping_ = 0, normals_ = 0, slopes_from_ = 0, lit_by_ = 0, strength_ = 0, levels_ = 2;
    int level_ = 0, quads_ = 1, texels_ = 3, cull_ = 2, eye_ = 0, precise_ = 0, depth_ = 0, detail_ = 4, seed_ = 3;
    float budget_ = 1.5f, altitude_ = -2, longitude_ = 0, latitude_ = 20, heading_ = 0, tilt_ = -10, radius_ = 6.804f,
          height_ = 1;
    bool gutter_ = true, skirts_ = true;
    DistantLight sun_{.yaw = -52, .pitch = 16};
};

RELIEF_LAB(PlanetLab);

}  // namespace relief::planet
