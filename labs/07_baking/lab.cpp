// Lab 07: baking.
//
// Normals of a fine model in a map for a coarse one: the ray of a texel, its hit, the frame in which the normal is
// stored, and the padding around it. Your tasks: shaders/07_baking/task.glsl
#include <fmt/format.h>

#include "cut.h"
#include "framework/core/base/error.h"
#include "framework/core/lab/lab.h"
#include "framework/library/kit/labels.h"
#include "framework/library/kit/made_map.h"
#include "framework/library/kit/own_maps.h"
#include "framework/library/kit/studio.h"
#include "views.h"

namespace relief::baking {

class Baking final : public Lab, public MapMaker {
public:
    void draw(const Frame& frame) override {
        const std::vector<View> views = views_of(settings_, frame);
        // Bakes and reads back first: that changes the framebuffer.
        for (const View& view : views)
            if (view.needs_bake()) baker_.bake(view.sight.recipe);
        if (!frame.probe && (settings_.view == Settings::map || settings_.view == Settings::rays))
            describe(frame.size, views[0]);
        const std::vector<DrawnLine>* cut = nullptr;
        if (!frame.probe && settings_.view == Settings::rays) cut = &cut_of(baker_.bake(views[0].sight.recipe));
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glViewport(0, 0, frame.size.x, frame.size.y);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        for (const View& view : views) {
            switch (view.draws) {
                case Draws::model:
                    draw_model(frame_in(frame, view.tile), view);
                    draw_studio(frame_in(frame, view.tile), view);
                    break;
                case Draws::map:
                    draw_map(frame, view);
                    break;
                case Draws::cover:
                    baker_.draw_cover(view.sight.recipe);
                    break;
                case Draws::cut:
                    if (cut) cut_drawing_.draw(view.tile, *cut);
            }
            if (!view.title.empty()) labels_.caption(frame.size, view.tile, 0, view.title);
        }
        labels_.notes(notes_of_files(*this));
        labels_.draw(frame);
    }

    void knobs(Knobs& knobs) override { settings_.knobs(knobs); }

    std::optional<Image> truth(const Frame& frame) const override {
        if (settings_.is_own() && settings_.fine == Settings::itself) return {};  // nothing to compare with
        const std::vector<View> views = views_of(settings_, frame);
        if (frame.probe.name != "normal") return map_truth(frame, views[0].sight.recipe);
        std::vector<Tile> tiles;
        for (const View& view : views) tiles.push_back(view.tile);
        return truth_in_tiles(frame, tiles, [&](const Frame& part, size_t i) -> std::optional<Image> {
            if (views[i].draws == Draws::model) return normal_truth(part, views[i].sight);
            Image nothing(part.size.x, part.size.y, 4);
            std::fill(nothing.values.begin(), nothing.values.end(), no_surface);
            return nothing;
        });
    }

    /// Returns the baked map of the chosen shape.
    std::optional<Image> made_map() override {
        const Image stored = baker_.bake(settings_.recipe()).map.read();
        Image normals(stored.width, stored.height, 3);
        for (size_t i = 0; i < stored.pixel_count(); ++i) {
            // The map marks the texels of unfinished tasks.
            if (stored.values[4 * i + 3] < 0.9f) throw Error("the map is not written yet: see the tasks of this lab");
            std::copy_n(&stored.values[4 * i], 3, &normals.values[3 * i]);
        }
        return normals;
    }

private:
    void draw_model(const Frame& frame, const View& view) {
        const auto& [recipe, shown, other_diagonal] = view.sight;
        glViewport(view.tile.corner.x, view.tile.corner.y, view.tile.size.x, view.tile.size.y);
        const bool has_map = shown == Shown::mapped, is_cube = recipe.model.shape == Shape::cube;
        const Define space = recipe.object_space ? "OBJECT_SPACE" : frames.define(view.frame);
        const Program& surface =
            surface_.with({frame.probe, is_cube && !frame.probe ? "MIRROR" : "", has_map ? "MAP" : "",
                           has_map && settings_.level > 0 ? "ONE_LEVEL" : "", has_map ? space : ""});
        glUseProgram(surface);
        surface.set("u_clip_from_world", frame.camera.clip_from_world());
        surface.set("u_eye", frame.camera.eye());
        surface.set("u_to_light", settings_.light.direction());
        if (has_map) {
            surface.set("s_map", 0);
            surface.set("u_level", level());
            if (!view.wears_file) baker_.bake(recipe).map.bind(0);
        }
        const GpuMesh& mesh = shown == Shown::high ? baker_.high(recipe).uploaded : baker_.low(recipe, other_diagonal);
        glBindVertexArray(mesh.layout());
        if (has_map && view.wears_file)
            file_maps_.draw();
        else
            glDrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
    }

    void draw_studio(const Frame& frame, const View& view) {
        const Recipe& recipe = view.sight.recipe;
        const Model& model = recipe.model;
        studio_.draw(frame, view.tile, {double(model.shape), model.gap, double(recipe.low), double(recipe.version)},
                     [&recipe] { return recipe.low_mesh(false); });
    }

    /// Draws the map: over the whole frame for a probe, and otherwise in the largest square of the tile.
    void draw_map(const Frame& frame, const View& view) {
        if (frame.probe.name == "normal") return;
        const Tile& tile = view.tile;
        glm::vec4 window(0, 0, frame.size);
        if (!frame.probe) {
            const float side = float(std::min(tile.size.x, tile.size.y));
            window = glm::vec4(glm::vec2(tile.corner) + (glm::vec2(tile.size) - side) / 2.0f, side, side);
        }
        const glm::ivec4 pixels(window);
        glViewport(pixels.x, pixels.y, pixels.z, pixels.w);
        const Program& program = map_.with(frame.probe);
        glUseProgram(program);
        program.set("s_map", 0);
        program.set("s_texels", 1);
        program.set("s_hits", 2);
        program.set("u_window", window);
        program.set("u_level", level());
        const Baked& baked = baker_.bake(view.sight.recipe);
        baked.texels.bind(2, 1);
        baked.texels.bind(1, 0);
        baked.map.bind(0);
        window_.draw();
    }

    /// Returns the mip level that is read, where it is only one.
    float level() const { return float(std::max(0, settings_.level - 1)); }

    const std::vector<DrawnLine>& cut_of(const Baked& baked) {
        return cut_lines_.get({baked.recipe, baked.programs, settings_.cut}, [&] {
            return cut_lines(baked.recipe, baker_.high(baked.recipe).mesh, baked.texels.read(1), settings_.cut);
        });
    }

    /// Writes the results of the rays, and which settings make them wrong. Reads the bake back at first.
    void describe(glm::ivec2 size, const View& view) {
        constexpr glm::vec3 warning(1.0f, 0.62f, 0.45f);
        const Recipe& recipe = view.sight.recipe;
        const Baked::Report report = baker_.report(baker_.bake(recipe));
        labels_.caption(size, view.tile, 0,
                        report.unwritten > 0
                            ? fmt::format("task 7.{} is not written yet: no ray has a hit", report.unwritten)
                            : fmt::format("{:.1f} % of the texels meet nothing, {:.1f} % another part",
                                          100 * report.missed, 100 * report.wrong));
        const double needed = reach_needed(recipe.model, low_finenesses[size_t(recipe.low)], recipe.sculpt);
        if (double(recipe.reach) < needed)
            labels_.caption(size, view.tile, -1,
                            fmt::format("a reach of {:.2f} may be too short: {:.2f}", recipe.reach, needed), warning);
        if (report.covered_twice > 0)
            labels_.caption(size, view.tile, -2, fmt::format("{} texels belong to two triangles", report.covered_twice),
                            warning);
    }

    Settings settings_;
    OwnMaps file_maps_{settings_.own.coarse};
    Programs surface_{"07_baking/surface.vert", "07_baking/surface.frag"};
    Programs map_{"common/window.vert", "07_baking/map.frag"};
    Baker baker_;
    WindowTriangle window_;
    LineDrawing cut_drawing_;
    Kept<std::vector<DrawnLine>, Recipe, std::array<GLuint, 3>, float> cut_lines_;
    Studio studio_;
    Labels labels_;
};

RELIEF_LAB(Baking);

}  // namespace relief::baking
