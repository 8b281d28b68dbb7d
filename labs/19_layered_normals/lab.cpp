// Lab 19: layered normals.
//
// A grain on stones: the right blend of two normals depends on the second layer's meaning. A relief on three planes
// around a solid: gradients add, and the weights have a gradient, too. A wall far away: a pixel's highlight needs the
// spread of both layers' slopes. Your tasks: shaders/19_layered_normals/task.glsl
#include <fmt/format.h>

#include "framework/core/image/compare.h"
#include "framework/core/lab/lab.h"
#include "framework/library/kit/drawn_numbers.h"
#include "framework/library/kit/kept.h"
#include "framework/library/kit/labels.h"
#include "framework/library/kit/tiles.h"
#include "framework/library/kit/view_axes.h"
#include "framework/library/kit/window_triangle.h"
#include "framework/library/maps/own_picture.h"
#include "layers.h"
#include "scene.h"
#include "truth.h"

namespace relief::layered_normals {

class LayeredNormals final : public Lab {
public:
    void draw(const Frame& frame) override {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glViewport(0, 0, frame.size.x, frame.size.y);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        const Define purpose = frame.probe ? "PROBE" : "";
        if (settings_.view == Settings::six_blends && !frame.probe)
            draw_six(
                frame, wall_,
                {Settings::linear, Settings::overlay, Settings::whiteout, Settings::udn, Settings::pd, Settings::rnm},
                Settings::blends.names, [&](const Frame& part, int blend, const Define& shows) {
                    draw_wall(part, blend, Settings::plain, shows);
                });
        else if (settings_.view == Settings::six_mappings && !frame.probe)
            draw_six(frame, solid_, {0, 1, 2, 3, 4, 5}, Settings::mappings.names,
                     [&](const Frame& part, int mapping, const Define& shows) { draw_solid(part, mapping, shows); });
        else if (settings_.view == Settings::far_walls && !frame.probe)
            draw_far_walls(frame);
        else if (settings_.shows_solid(frame.probe))
            draw_solid(frame, settings_.mapping, purpose);
        else
            draw_wall(frame, settings_.blend, settings_.filter, purpose);
        labels_.draw(frame);
    }

    void knobs(Knobs& knobs) override { settings_.knobs(knobs); }

    std::optional<Image> truth(const Frame& frame) const override { return layered_normals::truth(frame, settings_); }

private:
    // ---- views

    /// Draws with six methods: lit on the left of a tile, its errors on the right.
    void draw_six(const Frame& frame, const Programs& programs, const std::array<int, 6>& methods,
                  std::span<const char* const> names,
                  const std::function<void(const Frame&, int method, const Define& purpose)>& draw) {
        const auto tiles =
            Labels::with_feet(frame.size, tile_grid(frame.size, 3, 2, Labels::scale_height(frame.size)), 2, 25);
        labels_.scale(frame.size, "0~", fmt::format("{:.0f}~", error_scale));
        for (size_t i = 0; i < tiles.size(); ++i) {
            draw_tile(frame, tiles[i], [&](const Frame& part) { draw(part, methods[i], "ERROR"); });
            labels_.caption(frame.size, tiles[i], 0, names[size_t(methods[i])]);
            const ErrorSummary& error =
                measured_[i].get({knob_values(*this), frame.camera.orbit(), programs.renewals()}, [&] {
                    const Camera camera(frame.camera.orbit(), 1);
                    const Frame small{.target = 0, .size = {256, 256}, .time = 0, .camera = camera, .probe = {}};
                    const Image errors = draw_numbers(small.size, [&] { draw(small, methods[i], "MEASURE"); });
                    return summarize(channels_of(errors, 0, 1));
                });
            if (error.missing == 0 && error.not_finite == 0)
                labels_.caption(frame.size, tiles[i], -1,
                                fmt::format("{:.2f}~ off, {:.1f}~ at most", error.mean, error.largest));
        }
    }

    /// Five filters of the highlight, so far away that a pixel covers many stones.
    void draw_far_walls(const Frame& frame) {
        const int count = int(Settings::filters.size());
        const bool is_wide = frame.size.x >= frame.size.y;  // else no name fits into a fifth of the width
        const auto tiles =
            Labels::with_feet(frame.size, tile_grid(frame.size, is_wide ? count : 1, is_wide ? 1 : count), 2, 12);
        const std::vector<double>& off = highlights_off_.get(
            {knob_values(*this), frame.camera.orbit(), wall_.renewals()}, [&] { return highlights_off(frame); });
        for (size_t i = 0; i < tiles.size(); ++i) {
            draw_tile(frame, tiles[i], [&](const Frame& part) { draw_wall(part, Settings::pd, int(i), ""); });
            labels_.caption(frame.size, tiles[i], 0, Settings::filters.names[i]);
            if (i != Settings::samples && std::isfinite(off[i]))
                labels_.caption(frame.size, tiles[i], -1, fmt::format("{:.0f} % off", 100 * off[i]));
        }
    }

    /// Returns for each filter the mean distance of its highlight from that of the samples, as a share of their mean.
    /// It is not finite before the tasks are written.
    std::vector<double> highlights_off(const Frame& whole) {
        Frame frame = frame_in(whole, {{0, 0}, {128, 128}});
        frame.probe = {"highlight", MissingTask::told};
        const auto highlight = [&](int filter) {
            return draw_numbers(frame.size, [&] { draw_wall(frame, Settings::pd, filter, "PROBE"); });
        };
        const Image exact = highlight(Settings::samples);
        const double mean = summarize(channels_of(exact, 0, 1)).mean;
        std::vector<double> off;
        for (size_t i = 0; i < Settings::filters.size(); ++i) {
            const ErrorSummary error = summarize(error_image(highlight(int(i)), exact, ErrorMetric::absolute));
            off.push_back(error.missing > 0 ? HUGE_VAL : error.mean / mean);
        }
        return off;
    }

    void draw_tile(const Frame& frame, const Tile& tile, const std::function<void(const Frame&)>& draw) {
        if (tile.size.x <= 0 || tile.size.y <= 0) return;
        glViewport(tile.corner.x, tile.corner.y, tile.size.x, tile.size.y);
        split_ = float(tile.corner.x) + float(tile.size.x) / 2;
        draw(frame_in(frame, tile));
    }

    // ---- passes

    void draw_wall(const Frame& frame, int blend, int filter, const Define& purpose) {
        const bool is_lit = purpose.text.empty(), is_compared = !is_lit && !frame.probe;
        const bool has_highlight = is_lit || frame.probe.name == "highlight" || frame.probe.name == "variance";
        const Program& program = wall_.with({purpose, frame.probe, Settings::blends.define(blend),
                                             is_compared ? Settings::questions.define(settings_.question) : "",
                                             has_highlight ? Settings::filters.define(filter) : "",
                                             has_highlight ? Settings::brdfs.define(settings_.brdf) : "",
                                             settings_.grain == 0 ? "NO_DETAIL" : "",
                                             has_highlight && filter == Settings::samples ? "SIDE 32" : ""});
        glUseProgram(program);
        const Frame seen = settings_.seen(frame);
        set_rays(program, seen);
        program.set("u_eye", seen.camera.eye());
        program.set("u_pixel", 2.0f / glm::vec2(frame.size));
        program.set("u_tile", glm::vec2(stone_tile, stone_tile / settings_.tiles));
        program.set("u_strength", settings_.strengths());
        program.set("u_fade", settings_.fade_end());
        program.set("u_shininess", settings_.shininess);
        program.set("s_base_normals", 0, base_normals_);
        program.set("s_base_slopes", 1, base_slopes_);
        program.set("s_base_bends", 2, base_bends_);
        program.set("s_detail_normals", 3, detail_normals_);
        program.set("s_detail_slopes", 4, detail_slopes_);
        program.set("s_detail_bends", 5, detail_bends_);
        set_light(program);
        window_.draw();
    }

    void draw_solid(const Frame& frame, int mapping, const Define& purpose) {
        const Frame seen = settings_.seen(frame);
        if (!frame.probe && purpose.text != "MEASURE") draw_sky(seen);
        const Program& program = solid_.with(
            {purpose, frame.probe, Settings::shapes.define(settings_.shape), Settings::mappings.define(mapping)});
        glUseProgram(program);
        program.set("u_clip_from_world", seen.camera.clip_from_world());
        program.set("u_eye", seen.camera.eye());
        for (size_t i = 0; i < lumps.size(); ++i)
            program.set(fmt::format("u_lumps[{}]", i).c_str(), glm::vec4(lumps[i]));
        program.set("u_lump", lump);
        program.set("u_tile", stone_tile / settings_.tiles);
        program.set("u_strength", settings_.grain);
        program.set("u_sharpness", settings_.sharpness);
        program.set("s_detail_normals", 0, detail_normals_);
        set_light(program);
        glEnable(GL_CULL_FACE);
        const GpuMesh& mesh = solids_[size_t(settings_.shape)];
        glBindVertexArray(mesh.layout());
        glDrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
        glDisable(GL_CULL_FACE);
    }

    void draw_sky(const Frame& frame) {
        const Program& program = sky_.with();
        glUseProgram(program);
        set_rays(program, frame);
        program.set("u_to_light", settings_.light.direction());
        window_.draw();
    }

    void set_light(const Program& program) const {
        program.set("u_to_light", settings_.light.direction());
        program.set("u_gloss", 0.003f * (settings_.shininess + 8));
        program.set("u_error_scale", error_scale);
        program.set("u_split", split_);
    }

    static constexpr float error_scale = 6;  ///< error of the brightest colour (pale yellow), degrees

    Settings settings_;
    float split_ = 0;
    Programs wall_{"common/window.vert", "19_layered_normals/wall.frag"};
    Programs solid_{"19_layered_normals/solid.vert", "19_layered_normals/solid.frag"};
    Programs sky_{"common/window.vert", "19_layered_normals/sky.frag"};
    Texture base_normals_{"stones", [] { return stone_maps().normals; }};
    Texture base_slopes_{"slopes of stones", [] { return stone_maps().slopes; }};
    Texture base_bends_{"bends of stones", [] { return stone_maps().bends; }};
    Texture detail_normals_{"grain", [] { return grain_maps().normals; }};
    Texture detail_slopes_{"slopes of grain", [] { return grain_maps().slopes; }};
    Texture detail_bends_{"bends of grain", [] { return grain_maps().bends; }};
    std::array<GpuMesh, 3> solids_{upload([] { return solid_mesh(0); }), upload([] { return solid_mesh(1); }),
                                   upload([] { return solid_mesh(2); })};
    /// One for each tile. The inputs are knobs, camera, and how often programs were renewed.
    std::array<Kept<ErrorSummary, std::vector<std::string>, Orbit, int>, 6> measured_;
    Kept<std::vector<double>, std::vector<std::string>, Orbit, int> highlights_off_;
    WindowTriangle window_;
    Labels labels_;
};

RELIEF_LAB(LayeredNormals);

}  // namespace relief::layered_normals
