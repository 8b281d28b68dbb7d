// Lab 01: specular highlights.
//
// Brick columns around a lamp. With vertex normals the highlight is that of a smooth column. A normal map gives every
// brick its own highlight.
#include <array>
#include <glm/gtc/matrix_transform.hpp>

#include "floor.h"
#include "framework/core/lab/lab.h"
#include "framework/library/kit/choices.h"
#include "framework/library/kit/culling.h"
#include "framework/library/kit/labels.h"
#include "framework/library/kit/light.h"
#include "framework/library/kit/tiles.h"
#include "framework/library/mesh/shapes.h"
#include "scene.h"
#include "truth.h"

namespace relief {

class SpecularHighlights final : public Lab {
public:
    void draw(const Frame& frame) override {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        const glm::ivec2 size = frame.size;
        const int split = int(std::lround(wipe_ * float(size.x)));
        switch (method_) {
            case vertex_normal:
            case normal_map:
                draw_scene(frame, {0, 0}, size, method_ == normal_map);
                break;
            case side_by_side: {
                const std::vector<Tile> tiles = tiles_side_by_side(size);
                for (const int with_map : {0, 1}) {
                    const Tile& tile = tiles[size_t(with_map)];
                    draw_scene(frame, tile.corner, tile.size, with_map == 1);
                    labels_.caption(size, tile, 0, with_map == 1 ? "normal map" : "vertex normals");
                }
                draw_line(frame, size.x / 2);
                break;
            }
            case wipe:  // one scene drawn twice, into two parts of the window
                glEnable(GL_SCISSOR_TEST);
                glScissor(0, 0, split, size.y);
                draw_scene(frame, {0, 0}, size, false, glm::ivec2(0, split));
                glScissor(split, 0, size.x - split, size.y);
                draw_scene(frame, {0, 0}, size, true, glm::ivec2(split, size.x));
                draw_line(frame, split);
                break;
        }
        labels_.draw(frame);
    }

    void knobs(Knobs& knobs) override {
        knobs.choice("method", method_, methods, "source of the normal, or both side by side");
        knobs.slider("wipe", wipe_, 0, 1, KnobHelp("position of the border in the picture").only("method", {"wipe"}));
        knobs.slider("light_yaw", light_yaw_, -180, 180,
                     KnobHelp("direction of the lamp around the colonnade").in("degrees"));
        knobs.slider("light_height", light_height_, 0.1f, 5, KnobHelp("height of the lamp").in("metres"));
        knobs.choice("brdf", brdf_, brdfs.names,
                     KnobHelp("shape of the highlight: Blinn-Phong's, or that of most engines, as wide and with a tail")
                         .only("terminator", {"none", "step", "chiang"})
                         .titled("BRDF"));
        knobs.slider("shininess", shininess_, 2, 256, "exponent of the highlight");
        knobs.slider("strength", strength_, 0, 2, "strength of the normal map; 0 is flat");
        knobs.choice("terminator", terminator_, terminators.names,
                     "what stands for the shadow that a normal map does not cast");
    }

    /// Returns the exact values for the bricks, independent of the method that draws them.
    std::optional<Image> truth(const Frame& frame) const override {
        const auto of = [&](const Frame& view) { return colonnade::truth(view, strength_); };
        if (method_ != side_by_side) return of(frame);
        return truth_in_tiles(frame, tiles_side_by_side(frame.size),
                              [&](const Frame& view, size_t) { return of(view); });
    }

private:
    enum Method { vertex_normal, normal_map, side_by_side, wipe };
    enum Brdf { by_blinn_phong, by_ggx };
    static constexpr auto brdfs = choices<Brdf>({{by_blinn_phong, "blinn-phong"}, {by_ggx, "ggx", "GGX"}});
    enum Terminator { no_shadow, by_step, chiang, schuessler };
    static constexpr auto terminators = choices<Terminator>({{no_shadow, "none"},
                                                             {by_step, "step", "TERMINATOR_STEP"},
                                                             {chiang, "chiang", "TERMINATOR_CHIANG"},
                                                             {schuessler, "schuessler", "TERMINATOR_SCHUESSLER"}});
    static constexpr std::array methods = {"vertex-normal", "normal-map", "side-by-side", "wipe"};

    static std::vector<Tile> tiles_side_by_side(glm::ivec2 size) {
        return Labels::with_feet(size, tile_grid(size, 2, 1), 1, 16);
    }

    /// Draws the scene. `shown` is the range of pixel columns that the scissor leaves; columns and balls outside of it
    /// are culled.
    void draw_scene(const Frame& frame, glm::ivec2 corner, glm::ivec2 size, bool with_map,
                    std::optional<glm::ivec2> shown = {}) {
        if (size.x <= 0) return;
        const glm::dvec2 part = 2.0 * glm::dvec2(shown.value_or(glm::ivec2(0, size.x))) / double(size.x) - 1.0;
        glViewport(corner.x, corner.y, size.x, size.y);
        const Camera camera = size == frame.size ? frame.camera : frame_in(frame, {corner, size}).camera;
        const glm::vec3 light = lamp_at(light_yaw_, 2.8f, light_height_);
        const Program& surface = surface_.with({frame.probe, with_map ? "NORMAL_MAP" : "",
                                                with_map && !frame.probe ? terminators.define(terminator_) : "",
                                                frame.probe || terminator_ == schuessler ? "" : brdfs.define(brdf_)});
        glUseProgram(surface);
        const glm::dmat4 clip_from_world = camera.clip_from_world();
        surface.set("u_clip_from_world", clip_from_world);
        surface.set("u_eye", camera.eye());
        surface.set("u_light", light);
        surface.set("u_shininess", shininess_);
        surface.set("u_strength", strength_);

        // The floor is last, so that its hidden parts are not shaded.
        surface.set("s_albedo", 0, bricks_albedo_);
        surface.set("s_normal", 1, bricks_normal_);
        for (const glm::vec3 place : colonnade::places)
            if (may_be_seen(clip_from_world, place + colonnade::middle, colonnade::column_reach, part))
                draw_mesh(surface, column_, glm::translate(glm::mat4(1), place));
        if (!floor_) floor_.emplace();
        floor_->bind_albedo(surface);  // the balls have it, too
        surface.set("s_normal", 1, paving_normal_);
        glEnable(GL_CULL_FACE);  // a ball is closed, so its back faces are never visible
        for (const glm::vec3 place : colonnade::places)
            if (may_be_seen(clip_from_world, place + colonnade::top, colonnade::ball.radius, part))
                draw_mesh(surface, ball_, glm::translate(glm::mat4(1), place + colonnade::top));
        glDisable(GL_CULL_FACE);
        floor_->draw(surface);

        if (frame.probe || !may_be_seen(clip_from_world, light, lamp_scale * colonnade::ball.radius, part)) return;
        const Program& lamp = surface_.with("LAMP");
        glUseProgram(lamp);
        lamp.set("u_clip_from_world", clip_from_world);
        draw_mesh(lamp, ball_, glm::scale(glm::translate(glm::mat4(1), light), glm::vec3(lamp_scale)));
    }

    static void draw_line(const Frame& frame, int x) {
        if (frame.probe) return;  // the line and the lamp are no surfaces to probe
        glEnable(GL_SCISSOR_TEST);
        glScissor(x - 1, 0, 2, frame.size.y);
        glClearColor(0.9f, 0.88f, 0.84f, 1);
        glClear(GL_COLOR_BUFFER_BIT);
    }

    static void draw_mesh(const Program& surface, const GpuMesh& mesh, const glm::mat4& world_from_model) {
        surface.set("u_world_from_model", world_from_model);
        glBindVertexArray(mesh.layout());
        glDrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
    }

    Programs surface_{"01_specular_highlights/surface.vert", "01_specular_highlights/surface.frag"};
    Labels labels_;
    Texture bricks_albedo_ = load_texture("bricks_albedo.png", ColorSpace::srgb);
    Texture bricks_normal_ = load_texture("bricks_normal.png", ColorSpace::linear);
    Texture paving_normal_ = load_texture("paving_normal.png", ColorSpace::linear);
    std::optional<colonnade::Floor> floor_;
    GpuMesh column_ = upload([] { return make_column(colonnade::column); });
    GpuMesh ball_ = upload([] { return make_sphere(colonnade::ball); });

    static constexpr float lamp_scale = 0.15f;  // relative to a ball

    int method_ = wipe, brdf_ = by_blinn_phong, terminator_ = no_shadow;
    float wipe_ = 0.5f, light_yaw_ = 14, light_height_ = 1.7f, shininess_ = 48, strength_ = 1;
};

RELIEF_LAB(SpecularHighlights);

}  // namespace relief
