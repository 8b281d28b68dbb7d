// Lab 15: ocean.
//
// Two maps of waves scroll over each other. Heights add, so slopes add, and normals do not. Far away a pixel covers
// many waves, of which only the spread of slopes is left. Your tasks: labs/15_ocean/task.cpp and
// shaders/15_ocean/task.glsl
#include <fmt/format.h>

#include "framework/core/gl/cube_texture.h"
#include "framework/library/kit/drawn_numbers.h"
#include "framework/library/kit/evening_sky.h"
#include "framework/library/kit/kept.h"
#include "framework/library/kit/labels.h"
#include "framework/library/kit/tiles.h"
#include "framework/library/kit/view_axes.h"
#include "framework/library/kit/window_triangle.h"
#include "rings.h"
#include "settings.h"

namespace relief::ocean {

class Ocean final : public Lab {
public:
    void draw(const Frame& frame) override {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glViewport(0, 0, frame.size.x, frame.size.y);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        if (frame.probe || settings_.view == Settings::one)
            draw_part(whole_picture(frame));
        else if (settings_.view == Settings::halves)
            draw_halves(frame);
        else if (settings_.view == Settings::far_seas)
            draw_far_seas(frame);
        else
            draw_maps(frame);
        labels_.notes(notes_of_files(*this));
        labels_.draw(frame);
    }

    void knobs(Knobs& knobs) override { settings_.knobs(knobs); }

    std::optional<Image> truth(const Frame& frame) const override {
        if (settings_.water.has_own()) return {};  // no formula
        return ocean::truth(whole_picture(frame).frame,
                            {.layers = settings_.water.layers(),
                             .shininess = double(settings_.shininess),
                             .to_light = settings_.light.direction<double>(),
                             .displaced = settings_.displace,
                             .whole_spread = settings_.level == int(Settings::levels.size()) - 1,
                             .exact_fresnel = settings_.fresnel == Settings::exact});
    }

private:
    /// A part of the picture.
    struct Part {
        Tile tile;
        Frame frame;
        int rule, far;
        Define purpose = "";  ///< a probe, WIPE, ERROR or MEASURE; empty for the picture
        /// Returns whether it shows the error of a rule, for which the sea is flat and at level 0.
        bool is_error() const { return purpose.text == "ERROR" || purpose.text == "MEASURE"; }
    };

    // ---- the views

    Part whole_picture(const Frame& frame) const {
        const Tile whole{{0, 0}, frame.size};
        return {.tile = whole,
                .frame = frame_in(frame, whole),
                .rule = settings_.combine,
                .far = settings_.far,
                .purpose = frame.probe};
    }

    /// Draws the mean of normals on the left and the sum of slopes on the right, and below them the errors of both.
    void draw_halves(const Frame& frame) {
        const int below = frame.size.y / 4, half = frame.size.x / 2, lowest = Labels::scale_height(frame.size);
        const Tile above{{0, below}, {frame.size.x, frame.size.y - below}};
        draw_part({.tile = above,
                   .frame = frame_in(frame, above),
                   .rule = Settings::mean,
                   .far = settings_.far,
                   .purpose = "WIPE"});
        constexpr std::array rules = {Settings::mean, Settings::slopes};
        constexpr std::array titles = {"mean of normals", "sum of slopes"};
        const std::vector<Tile> tiles = tile_grid({frame.size.x, below}, 2, 1, lowest);
        for (size_t i = 0; i < 2; ++i)
            draw_part({.tile = tiles[i],
                       .frame = seen_by(steep(frame.camera.orbit().yaw), frame_in(frame, tiles[i])),
                       .rule = rules[i],
                       .far = settings_.far,
                       .purpose = "ERROR"});
        for (int i = 0; i < 2; ++i)
            labels_.caption(frame.size, {{i * half, below}, {half, above.size.y}}, 0, titles[size_t(i)]);
        const float line = Labels::line_height(frame.size), top = float(above.size.y);
        labels_.rectangle({float(half) - 0.5f, 0.5f * top}, {1, 0.5f * top}, {1, 1, 1, 0.35f});
        labels_.scale(frame.size, "0~", "12~");  // u_error_scale
        for (size_t i = 0; i < 2; ++i)
            if (const double error = mean_error(rules[i]); std::isfinite(error))
                labels_.text(fmt::format("{:.1f}~ off", error), {float(half) * (float(i) + 0.5f), top + 0.3f * line},
                             line, Align::centre);
    }

    /// Draws each rule of the highlight, so far away that a pixel covers many waves.
    void draw_far_seas(const Frame& frame) {
        const std::vector<Tile> tiles = tile_grid(frame.size, 2, 2);
        for (size_t i = 0; i < tiles.size(); ++i) {
            const Frame part = frame_in(frame, tiles[i]);
            Orbit orbit = part.camera.orbit();
            orbit.distance *= 6;
            draw_part({.tile = tiles[i], .frame = seen_by(orbit, part), .rule = Settings::slopes, .far = int(i)});
            labels_.caption(frame.size, tiles[i], 0, Settings::fars.names[i]);
        }
    }

    /// Draws the heights of both maps above their normals.
    void draw_maps(const Frame& frame) {
        const std::vector<Tile> tiles = tile_grid(frame.size, 2, 2);
        for (int i = 0; i < 4; ++i) {
            const glm::ivec2 corner = tiles[size_t(i)].corner, size = tiles[size_t(i)].size;
            const int side = std::min(size.x, size.y) * 9 / 10;
            const Tile square{corner + (size - side) / 2, glm::ivec2(side)};
            glViewport(square.corner.x, square.corner.y, side, side);
            const Program& program = map_.with({i < 2 ? "HEIGHTS" : "", settings_.level > 0 ? "ONE_LEVEL" : ""});
            glUseProgram(program);
            program.set("s_map", 0, i < 2 ? settings_.water.waves(i) : settings_.water.normals(i - 2));
            program.set("u_level", float(settings_.level - 1));
            window_.draw();
            labels_.caption(frame.size, square, 0, fmt::format("{} {}", i < 2 ? "heights" : "normals", i % 2 + 1));
        }
    }

    /// Returns the mean error of a rule in degrees, over the water ahead. Infinity before its task is written.
    double mean_error(Settings::Combine rule) {
        return means_[rule].get({settings_.water.key(), settings_.source, settings_.lock, sea_.renewals()}, [&] {
            constexpr glm::ivec2 size(48);
            const Frame frame{.target = 0, .size = size, .time = 0, .camera = {steep(180), 1}, .probe = {}};
            const Part part{
                .tile = {{0, 0}, size}, .frame = frame, .rule = rule, .far = settings_.far, .purpose = "MEASURE"};
            const Image drawn = draw_numbers(size, [&] { draw_sea(part, fill_grid(part)); });
            double sum = 0;
            for (size_t i = 0; i < drawn.values.size(); i += 4) sum += double(drawn.values[i]);
            return sum / double(drawn.pixel_count());
        });
    }

    /// Returns a camera's place from which waves do not hide each other: it looks down steeply.
    static Orbit steep(double yaw) { return {.yaw = yaw, .pitch = 38, .distance = 26, .field_of_view = 30}; }
    static Frame seen_by(const Orbit& orbit, Frame frame) {
        frame.camera = Camera(orbit, double(frame.size.x) / std::max(1, frame.size.y));
        return frame;
    }

    // ---- the passes

    /// Draws the sky, the sea and, if asked for, the edges of its triangles; of a probe or an error only the sea.
    void draw_part(const Part& part) {
        if (part.tile.size.x <= 0 || part.tile.size.y <= 0) return;
        glViewport(part.tile.corner.x, part.tile.corner.y, part.tile.size.x, part.tile.size.y);
        const bool is_picture = !part.frame.probe && !part.is_error();
        if (is_picture) draw_sky(part.frame);
        const bool is_raised = fill_grid(part);
        if (!is_picture || !settings_.wire) return draw_sea(part, is_raised);
        glPolygonOffset(1, 1);
        glEnable(GL_POLYGON_OFFSET_FILL);  // so that lines are in front
        draw_sea(part, is_raised);
        glDisable(GL_POLYGON_OFFSET_FILL);
        draw_edges(part, is_raised);
    }

    void draw_sky(const Frame& frame) {
        const Program& program = sky_.with(Settings::skies.define(settings_.sky));
        glUseProgram(program);
        if (settings_.sky == Settings::by_cube) program.set("s_sky", sky_unit, cube_);
        set_rays(program, frame);
        program.set("u_to_light", settings_.light.direction());
        window_.draw();
    }

    /// Makes the grid of a part. Returns whether waves raise it.
    bool fill_grid(const Part& part) {
        const bool is_raised = settings_.displace && !part.is_error() &&
                               are_waves_visible(part.frame, settings_.water, double(settings_.budget));
        rings_.fill(grid_of(part.frame, settings_.water, double(settings_.budget), is_raised));
        return is_raised;
    }

    /// Precondition: fill_grid().
    void draw_sea(const Part& part, bool is_raised) {
        const bool is_light = !part.is_error(), is_picture = is_light && !part.frame.probe;
        const int far = is_light ? part.far : Settings::plain;
        const bool is_slope_exact = part.is_error() || settings_.source == Settings::analytic;
        const Program& program =
            sea_.with({part.purpose, used(0), used(1), is_slope_exact ? own(0) : "", is_slope_exact ? own(1) : "",
                       is_raised ? "" : "FLAT", Settings::combines.define(part.rule),
                       Settings::sources.define(settings_.source), Settings::fars.define(far),
                       far == Settings::samples ? Settings::sample_counts.define(settings_.sample_count) : "",
                       is_light ? Settings::fresnels.define(settings_.fresnel) : "",
                       is_picture ? Settings::materials.define(settings_.material) : "",
                       is_picture ? Settings::skies.define(settings_.sky) : "",
                       settings_.level > 0 || part.is_error() ? "ONE_LEVEL" : ""});
        glUseProgram(program);
        set_sea(program, part);
        if (is_light && settings_.sky == Settings::by_cube) program.set("s_sky", sky_unit, cube_);
        rings_.draw(program, part.frame.camera, false);
    }

    /// Precondition: fill_grid().
    void draw_edges(const Part& part, bool is_raised) {
        const Program& program =
            sea_.with({"WIRE", used(0), used(1), is_raised ? "" : "FLAT", Settings::combines.define(Settings::mean),
                       settings_.level > 0 ? "ONE_LEVEL" : ""});
        glUseProgram(program);
        set_sea(program, part);
        program.set("u_wire", glm::vec3(0.93f, 0.86f, 0.62f));
        rings_.draw(program, part.frame.camera, true);
    }

    Define used(int map) const { return !settings_.water.is_used(map) ? "" : map == 0 ? "FIRST" : "SECOND"; }

    /// Says that the slopes of a map have no formula.
    Define own(int map) const {
        const bool is_own = settings_.water.is_used(map) && settings_.water.has_own_heights(map);
        return !is_own ? "" : map == 0 ? "OWN_FIRST" : "OWN_SECOND";
    }

    void set_sea(const Program& program, const Part& part) const {
        const Frame& frame = part.frame;
        settings_.water.set(program, frame.camera.eye(), frame.time);
        program.set("u_level", part.is_error() ? 0.0f : float(settings_.level - 1));
        program.set("u_detail", settings_.lock ? 1.0f : 3.0f);
        program.set("u_shininess", settings_.shininess);
        program.set("u_to_light", settings_.light.direction());
        program.set("u_split", float(part.tile.corner.x) + float(part.tile.size.x) / 2);
        const ViewAxes axes = view_axes(frame.camera);
        const double pixel = 2 * axes.half_height / frame.size.y;
        program.set("u_forward", axes.forward);
        program.set("u_pixel_right", axes.right * pixel);
        program.set("u_pixel_up", axes.up * pixel);
        program.set("u_steepest", settings_.water.steepest());
        program.set("u_error_scale", 12.0f);  // error of the brightest colour (pale yellow), degrees
    }

    static constexpr int sky_unit = 6;  ///< after those of the maps
    Settings settings_;
    Programs sea_{"15_ocean/sea.vert", "15_ocean/sea.frag"};
    Programs sky_{"common/window.vert", "15_ocean/sky.frag"};
    Programs map_{"common/window.vert", "15_ocean/map.frag"};
    CubeTexture cube_{"evening sky", 128, evening_sky};
    WindowTriangle window_;
    Rings rings_;
    std::array<Kept<double, Water::Key, int, bool, int>, 2> means_;  ///< by rule
    Labels labels_;
};

RELIEF_LAB(Ocean);

}  // namespace relief::ocean
