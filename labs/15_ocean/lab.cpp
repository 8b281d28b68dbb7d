// Lab 15: ocean.
//
// Two maps of waves scroll over each other. Heights add, so slopes add, and normals do not. Far away a pixel covers
// many waves, of which only the spread of slopes is left. Your tasks: labs/15_ocean/task.cpp and
// shaders/15_ocean/task.glsl
#include <fmt/format.h>

#include "framework/core/gl/cube_texture.h"
#include "framework/core/kit/choices.h"
#include "framework/core/kit/evening_sky.h"
#include "framework/core/kit/kept.h"
#include "framework/core/kit/labels.h"
#include "framework/core/kit/light.h"
#include "framework/core/kit/numbers.h"
#include "framework/core/kit/tiles.h"
#include "framework/core/kit/view_axes.h"
#include "framework/core/kit/window_triangle.h"
#include "framework/core/lab/lab.h"
#include "rings.h"
#include "water.h"

namespace relief::ocean {

class Ocean final : public Lab {
public:
    void draw(const Frame& frame) override {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glViewport(0, 0, frame.size.x, frame.size.y);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        if (view_ == four_maps && !frame.probe) draw_maps(frame);
        for (const View& view : views_of(frame)) {
            draw_view(view);
            if (view_ == far_seas && !frame.probe)
                labels_.caption(frame.size, view.tile, 0, fars.names[size_t(view.far)]);
        }
        if (view_ == halves && !frame.probe) describe_halves(frame);
        labels_.draw(frame);
    }

    void knobs(Knobs& knobs) override {
        knobs.group("Picture");
        knobs.choice("view", view_, kinds,
                     "two rules for the normal and their errors; four far seas; one picture; or the four maps");
        knobs.group("Normals");
        knobs.choice("combine", combine_, combines.names, "for view = one: how the normals of two maps become one");
        knobs.choice("waves", water_.maps, Water::choices_of_maps, "both maps, or one of them");
        knobs.choice("normals", source_, sources.names,
                     "slopes out of normal maps, out of height maps, or by the formula");
        knobs.choice("far", far_, fars.names, "what the highlight knows of the waves within a pixel");
        knobs.choice("samples", samples_, sample_counts, "for far = samples: places within a pixel");
        knobs.choice("fresnel", fresnel_, fresnels.names,
                     "share of the mirrored light: Schlick's approximation, or exact");
        knobs.choice("material", material_, materials.names, "water, or blue paint with the same mirrored sky");
        knobs.choice("sky", sky_of_, skies.names, "the sky by a formula, or a cube map, whose sun stands still");
        knobs.group("Waves");
        knobs.slider("tiles_1", water_.tiles[0], 0.02f, 8, "how often the first map lies on 16 metres");
        knobs.slider("tiles_2", water_.tiles[1], 0.02f, 8, "how often the second map lies on 16 metres");
        knobs.slider("amplitude_1", water_.amplitudes[0], 0, 4, "significant wave height of the first map, metres");
        knobs.slider("amplitude_2", water_.amplitudes[1], 0, 4, "significant wave height of the second map, metres");
        knobs.slider("wind", water_.wind, 0, 20,
                     "metres a second: scales both amplitudes by Cox and Munk's law; 0 does not");
        knobs.slider("shininess", shininess_, 1, 4096, "exponent of the highlight of a single slope");
        knobs.toggle("lock", lock_, "normal maps lie as the height maps do; else they are tiled three times as often");
        knobs.choice("level", level_, levels, "mip level of the maps that a pixel reads");
        knobs.group("Waves of your own");
        water_.knobs(knobs);
        knobs.group("Raised waves");
        knobs.toggle("displace", rings_.displace, "raise the waves near the eye");
        knobs.slider("budget", rings_.budget, 0.25f, 16, "error of the raised waves, pixels");
        knobs.toggle("wire", wire_, "draw the triangles' edges");
        light_.knobs(knobs, -5, 90);
    }

    std::optional<Image> truth(const Frame& frame, const Probe& probe) const override {
        if (water_.has_own()) return {};  // no formula
        const Frame drawn = frame_in(frame, {{0, 0}, frame.size});
        return ocean::truth(drawn, probe,
                            {.layers = water_.layers(),
                             .shininess = double(shininess_),
                             .to_light = light_.direction<double>(),
                             .displaced = rings_.displace,
                             .whole_spread = level_ == int(levels.size()) - 1,
                             .exact_fresnel = fresnel_ == exact});
    }

private:
    enum ViewKind { halves, far_seas, one, four_maps };
    static constexpr std::array kinds = {"halves", "far", "one", "maps"};
    enum Material { water, blue };
    static constexpr auto materials = choices<Material>({{water, "water"}, {blue, "blue", "BLUE_MATERIAL"}});
    enum Sky { by_formula, by_cube };
    static constexpr auto skies = choices<Sky>({{by_formula, "formula"}, {by_cube, "cube", "SKY_CUBE"}});
    enum Combine { mean, slopes };
    static constexpr auto combines =
        choices<Combine>({{mean, "mean", "COMBINE MEAN"}, {slopes, "slopes", "COMBINE SLOPES"}});
    enum Source { maps, heights, analytic };
    static constexpr auto sources = choices<Source>(
        {{maps, "maps"}, {heights, "heights", "NORMALS_BY_HEIGHTS"}, {analytic, "analytic", "NORMALS_ANALYTIC"}});
    enum Far { plain, toksvig, lean, samples };
    static constexpr auto fars = choices<Far>({{plain, "plain"},
                                               {toksvig, "toksvig", "FAR_TOKSVIG"},
                                               {lean, "lean", "FAR_LEAN"},
                                               {samples, "samples", "FAR_SAMPLES"}});
    enum Fresnel { schlick, exact };
    static constexpr auto fresnels = choices<Fresnel>({{schlick, "schlick"}, {exact, "exact", "EXACT_FRESNEL"}});
    static constexpr std::array sample_counts = {"64", "256", "1024"};
    static constexpr std::array levels = {"mip", "0", "1", "2", "3", "4", "5", "6", "7", "8"};
    static constexpr float error_scale = 12;  ///< error of the brightest colour (pale yellow), degrees

    /// A part of the picture.
    struct View {
        Tile tile;
        Frame frame;
        int rule, far;
        Define purpose = "";
        /// Returns whether it shows the error of a rule, for which the sea is flat and at level 0.
        bool is_error() const { return purpose.text == "ERROR" || purpose.text == "MEASURE"; }
    };

    // ---- views

    std::vector<View> views_of(const Frame& frame) const {
        if (view_ == four_maps && !frame.probe) return {};
        if (view_ == far_seas && !frame.probe) return views_from_afar(frame);
        if (view_ == halves && !frame.probe) return views_of_rules(frame);
        const Tile whole{{0, 0}, frame.size};
        return {
            {.tile = whole, .frame = frame_in(frame, whole), .rule = combine_, .far = far_, .purpose = frame.probe}};
    }

    /// Returns a view for each rule of the highlight, so far away that a pixel covers many waves.
    static std::vector<View> views_from_afar(const Frame& frame) {
        std::vector<View> all;
        for (const Tile& tile : tile_grid(frame.size, 2, 2)) {
            all.push_back({.tile = tile, .frame = frame_in(frame, tile), .rule = slopes, .far = int(all.size())});
            Orbit orbit = all.back().frame.camera.orbit();
            orbit.distance *= 6;
            set_orbit(all.back().frame, orbit);
        }
        return all;
    }

    /// Returns a picture with the mean of normals on its left and the sum of slopes on its right, and below it the
    /// errors of both.
    std::vector<View> views_of_rules(const Frame& frame) const {
        const int below = frame.size.y / 4;
        const Tile above{{0, below}, {frame.size.x, frame.size.y - below}};
        std::vector<View> all = {
            {.tile = above, .frame = frame_in(frame, above), .rule = mean, .far = far_, .purpose = "WIPE"}};
        for (const Tile& tile : tile_grid({frame.size.x, below}, 2, 1)) {
            all.push_back({.tile = tile,
                           .frame = frame_in(frame, tile),
                           .rule = all.size() == 1 ? mean : slopes,
                           .far = far_,
                           .purpose = "ERROR"});
            // Looks down steeply, so that waves do not hide each other.
            set_orbit(all.back().frame, {.yaw = frame.camera.orbit().yaw,
                                         .pitch = 38,
                                         .distance = 26,
                                         .target = {0, 0, 0},
                                         .field_of_view = 30});
        }
        return all;
    }
    static void set_orbit(Frame& frame, const Orbit& orbit) {
        frame.camera = Camera(orbit, double(frame.size.x) / std::max(1, frame.size.y));
    }

    void describe_halves(const Frame& frame) {
        const std::vector<View> views = views_of_rules(frame);
        const Tile& picture = views[0].tile;
        const int half = frame.size.x / 2;
        labels_.caption(frame.size, {picture.corner, {half, picture.size.y}}, 0, "mean of normals");
        labels_.caption(frame.size, {picture.corner + glm::ivec2(half, 0), {half, picture.size.y}}, 0, "sum of slopes");
        const float line = Labels::line_height(frame.size), top = float(picture.size.y);
        labels_.rectangle({float(half) - 0.5f, 0.5f * top}, {1, 0.5f * top}, {1, 1, 1, 0.35f});
        for (int i = 0; i < 2; ++i)
            if (const double error = mean_error(i == 0 ? mean : slopes); std::isfinite(error))
                labels_.text(fmt::format("{:.1f}~ off", error), {float(half) * (float(i) + 0.5f), top + 0.3f * line},
                             line, Align::centre);
    }

    /// Returns the mean error of a rule in degrees, over the water ahead. Infinity before its task is written.
    double mean_error(Combine rule) {
        return means_[rule == mean ? 0 : 1].get({knob_values(*this), sea_.renewals() + water_.version()}, [&] {
            constexpr glm::ivec2 size(48);
            const Camera camera({.yaw = 180, .pitch = 38, .distance = 26, .field_of_view = 30}, 1);
            const View view{.tile = {{0, 0}, size},
                            .frame = {.target = 0, .size = size, .time = 0, .camera = camera, .probe = {}},
                            .rule = rule,
                            .far = far_,
                            .purpose = "MEASURE"};
            const Image drawn = draw_numbers(size, [&] { draw_sea(view, view.purpose); });
            double sum = 0;
            for (size_t i = 0; i < drawn.values.size(); i += 4) sum += double(drawn.values[i]);
            return sum / double(drawn.pixel_count());
        });
    }

    // ---- passes

    /// Draws the heights of both maps above their normals.
    void draw_maps(const Frame& frame) {
        const std::vector<Tile> tiles = tile_grid(frame.size, 2, 2);
        for (int i = 0; i < 4; ++i) {
            const auto& [corner, size] = tiles[size_t(i)];
            const int side = std::min(size.x, size.y) * 9 / 10;
            glViewport(corner.x + (size.x - side) / 2, corner.y + (size.y - side) / 2, side, side);
            const Program& program = map_.with({i < 2 ? "HEIGHTS" : "", level_ > 0 ? "ONE_LEVEL" : ""});
            glUseProgram(program);
            program.set("s_map", 0, i < 2 ? water_.waves(i) : water_.normals(i - 2));
            program.set("u_level", float(level_ - 1));
            window_.draw();
            labels_.caption(frame.size, tiles[size_t(i)], 0,
                            fmt::format("{} {}", i < 2 ? "heights" : "normals", i % 2 + 1));
        }
    }

    void draw_view(const View& view) {
        if (view.tile.size.x <= 0 || view.tile.size.y <= 0) return;
        glViewport(view.tile.corner.x, view.tile.corner.y, view.tile.size.x, view.tile.size.y);
        if (view.frame.probe || view.is_error()) return draw_sea(view, view.purpose);
        draw_sky(view.frame);
        glPolygonOffset(1, 1);
        if (wire_) glEnable(GL_POLYGON_OFFSET_FILL);  // so that lines are in front
        draw_sea(view, view.purpose);
        glDisable(GL_POLYGON_OFFSET_FILL);
        if (!wire_) return;
        draw_sea(view, "WIRE");
    }

    void draw_sky(const Frame& frame) {
        const Program& program = sky_.with(skies.define(sky_of_));
        glUseProgram(program);
        if (sky_of_ == by_cube) program.set("s_sky", sky_unit, cube_);
        set_rays(program, frame);
        program.set("u_to_light", light_.direction());
        window_.draw();
    }

    void draw_sea(const View& view, const Define& purpose) {
        const bool is_raised = !view.is_error() && rings_.are_raised(view.frame, water_);
        const Program& program = program_of(view, purpose, is_raised);
        glUseProgram(program);
        water_.set(program, view.frame.camera.eye(), view.frame.time);
        program.set("u_level", view.is_error() ? 0.0f : float(level_ - 1));
        program.set("u_detail", lock_ ? 1.0f : 3.0f);
        program.set("u_shininess", shininess_);
        program.set("u_to_light", light_.direction());
        program.set("u_split", float(view.tile.corner.x) + float(view.tile.size.x) / 2);
        const ViewAxes axes = view_axes(view.frame.camera);
        const double pixel = 2 * axes.half_height / view.frame.size.y;
        program.set("u_forward", axes.forward);
        program.set("u_pixel_right", axes.right * pixel);
        program.set("u_pixel_up", axes.up * pixel);
        program.set("u_steepest", water_.steepest());
        program.set("u_error_scale", error_scale);
        program.set("u_wire", glm::vec3(0.93f, 0.86f, 0.62f));
        if (is_lit(view, purpose) && sky_of_ == by_cube) program.set("s_sky", sky_unit, cube_);
        rings_.draw(program, view.frame, water_, is_raised, purpose.text == "WIRE");
    }

    static bool is_lit(const View& view, const Define& purpose) { return purpose.text != "WIRE" && !view.is_error(); }

    const Program& program_of(const View& view, const Define& purpose, bool is_raised) const {
        const bool is_wire = purpose.text == "WIRE", is_light = is_lit(view, purpose);
        const int far = is_light ? view.far : plain;
        return sea_.with(
            {purpose, water_.is_used(0) ? "FIRST" : "", water_.is_used(1) ? "SECOND" : "", is_raised ? "" : "FLAT",
             combines.define(is_wire ? mean : view.rule), sources.define(is_wire ? maps : source_), fars.define(far),
             far == samples ? fmt::format("SIDE {}", 8 << samples_) : "", is_light ? fresnels.define(fresnel_) : "",
             is_light && !view.frame.probe ? materials.define(material_) : "",
             is_light && !view.frame.probe ? skies.define(sky_of_) : "",
             level_ > 0 || view.is_error() ? "ONE_LEVEL" : ""});
    }

    Programs sea_{"15_ocean/sea.vert", "15_ocean/sea.frag"};
    Programs sky_{"common/window.vert", "15_ocean/sky.frag"};
    Programs map_{"common/window.vert", "15_ocean/map.frag"};
    static constexpr int sky_unit = 6;  ///< after those of the maps
    CubeTexture cube_{"evening sky", 128, evening_sky};
    WindowTriangle window_;
    std::array<Kept<double, std::vector<std::string>, int>, 2> means_;
    Labels labels_;
    Water water_;
    Rings rings_;

    int view_ = halves, combine_ = slopes, source_ = maps, far_ = lean, samples_ = 2, fresnel_ = schlick, level_ = 0,
        material_ = water, sky_of_ = by_formula;
    float shininess_ = 512;
    bool lock_ = true, wire_ = false;
    DistantLight light_{.yaw = 0, .pitch = 7};
};

RELIEF_LAB(Ocean);

}  // namespace relief::ocean
