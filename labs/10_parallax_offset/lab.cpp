// Lab 10: parallax offset.
//
// A relief on a flat wall by three estimates of the hit, at view angles from head-on to nearly edge-on. The lit relief
// is above, the error in texels below. Or the eye in the space of the world, or of the model. Your tasks:
// shaders/10_parallax_offset/task.glsl
#include <fmt/format.h>

#include <algorithm>

#include "eye.h"
#include "framework/core/base/text.h"
#include "framework/core/image/compare.h"
#include "framework/library/kit/difference_map.h"
#include "framework/library/kit/drawn_numbers.h"
#include "framework/library/kit/kept.h"
#include "framework/library/kit/labels.h"
#include "framework/library/kit/light.h"
#include "framework/library/kit/relief_surface.h"
#include "framework/library/kit/studio.h"
#include "framework/library/kit/tiles.h"
#include "truth.h"

namespace relief {

class ParallaxOffset final : public Lab {
public:
    ParallaxOffset() { surface_.extent = 16, surface_.depth = 0.06f; }  // the wall fills the picture even at 85 degrees

    void draw(const Frame& frame) override {
        const auto sights = sights_of(frame);
        const bool words = !frame.probe && view_ != eye && (view_ == strip || show_ != light);
        const std::vector<ErrorSummary> found = words ? measure(frame, sights) : std::vector<ErrorSummary>();
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        for (const Sight& sight : sights) {
            draw_tile(sight);
            studio_.draw(sight.frame, sight.tile, surface_.studio_inputs(), [this] { return surface_.mesh(); });
        }
        if (words) describe(frame.size, sights, found);
        if (view_ == eye && !frame.probe) compare_eyes(frame, sights);
        labels_.notes(notes_of_files(*this));
        labels_.draw(frame);
    }

    void knobs(Knobs& knobs) override {
        knobs.group("Picture");
        knobs.choice("view", view_, views,
                     "every method at five angles on the wall, one from the camera, or ways to bring the eye to the "
                     "model");
        knobs.choice("method", method_, methods, KnobHelp("the method").only("view", {"one"}));
        knobs.steps("steps", steps_, 1, 256, "layers of the steep method");
        knobs.choice("show", show_, shows, "the lit relief, the error, or half of each");
        surface_.knobs(knobs);
        light_.knobs(knobs);
        knobs.group("Model");
        knobs.choice("eye", eye_, eyes,
                     KnobHelp("dot products in the world, or the inverse of the model's matrix")
                         .only("view", {"eye"})
                         .titled("Eye by"));
        knobs.slider("turn", turn_, -180, 180,
                     KnobHelp("turn of the model and the camera in the world")
                         .in("degrees")
                         .only("view", {"eye"})
                         .titled("World turn"));
        knobs.slider("away", away_, 0, 10000,
                     KnobHelp("distance of both from the world's origin")
                         .in("metres")
                         .only("view", {"eye"})
                         .titled("Away from origin"));
    }

    std::optional<Image> truth(const Frame& frame) const override {
        const auto exact = offsets::truth(frame.probe, surface_);
        if (!exact) return {};
        const std::vector<Sight> sights = sights_of(frame);
        std::vector<Tile> tiles;
        for (const Sight& sight : sights) tiles.push_back(sight.tile);
        return truth_in_tiles(frame, tiles, [&](const Frame&, size_t i) { return exact(sights[i].frame); });
    }

private:
    enum View { strip, one, eye };
    enum Show { half_and_half, light, error };
    static constexpr std::array views = {"strip", "one", "eye"};
    enum Method { offset, limited, steep };
    static constexpr std::array methods = {"offset", "limited", "steep"};
    static constexpr std::array shows = {"half-and-half", "light", "error"};
    static constexpr std::array eyes = {"every", "world", "inverse", "inverse-in-double"};
    static constexpr std::array angles = {0, 30, 60, 75, 85};  ///< between the view and the wall's normal, degrees

    struct Sight {
        Tile tile;
        Frame frame;
        int method, degrees;
        offsets::EyeBy eye = offsets::EyeBy::inverse_in_double;
    };

    /// Returns a sight for each angle, in tiles along the longer side of the picture.
    std::vector<Sight> sights_of(const Frame& frame) const {
        const int below = frame.probe || show_ == light ? 0 : Labels::scale_height(frame.size);
        if (view_ == one) {
            const Tile tile = tiles_of(frame.size, 1, below)[0];
            return {{tile, frame_in(frame, tile), method_, 0}};
        }
        if (view_ == eye) {
            std::vector<Sight> sights;
            std::vector<Tile> tiles = tiles_of(frame.size, eye_ == 0 ? int(eyes.size()) - 1 : 1, below);
            if (eye_ == 0) tiles = Labels::with_feet(frame.size, tiles, 3, 25);
            for (const Tile& tile : tiles)
                sights.push_back(
                    {tile, frame_in(frame, tile), steep, 0, offsets::EyeBy(eye_ == 0 ? int(sights.size()) : eye_ - 1)});
            return sights;
        }
        const bool wide = frame.size.x >= frame.size.y;
        const int columns = int(wide ? angles.size() : methods.size()),
                  rows = int(wide ? methods.size() : angles.size());
        std::vector<Tile> tiles = Labels::with_feet(frame.size, tile_grid(frame.size, columns, rows, below), 2, 16);
        const int gap = std::min(frame.size.x, frame.size.y) / 160;
        std::vector<Sight> sights;
        for (int i = 0; i < int(tiles.size()); ++i) {
            Tile& tile = tiles[size_t(i)];
            tile.size = glm::max(tile.size - gap, 0);
            const int method = wide ? i / columns : i % columns,
                      degrees = angles[size_t(wide ? i % columns : i / columns)];
            sights.push_back({tile, from_afar(frame_in(frame, tile), degrees), method, degrees});
        }
        return sights;
    }

    /// Returns a frame that shows as much of the wall, but through a long lens, so that the view angle hardly varies.
    static Frame from_afar(Frame frame, double degrees) {
        constexpr double lens = 2;
        Orbit orbit = frame.camera.orbit();
        orbit.distance *= std::tan(glm::radians(orbit.field_of_view) / 2) / std::tan(glm::radians(lens) / 2);
        orbit.yaw = degrees, orbit.pitch = 0, orbit.field_of_view = lens;
        frame.camera = Camera(orbit, double(frame.size.x) / std::max(1, frame.size.y));
        return frame;
    }

    void draw_tile(const Sight& sight) {
        const glm::ivec2 corner = sight.tile.corner, size = sight.tile.size;
        if (size.x <= 0 || size.y <= 0) return;
        glViewport(corner.x, corner.y, size.x, size.y);
        if (sight.frame.probe || show_ == light || view_ == eye) return draw_relief(sight, "");
        // Draws the scene twice, each time clipped to a part of the tile. Errors are on the right, below in small
        // tiles.
        glEnable(GL_SCISSOR_TEST);
        const auto through = [&](glm::ivec2 low, glm::ivec2 high, const char* purpose) {
            glScissor(corner.x + low.x, corner.y + low.y, high.x - low.x, high.y - low.y);
            draw_relief(sight, purpose);
        };
        if (view_ == one) {
            const int half = show_ == error ? 0 : size.x / 2;
            through({0, 0}, {half, size.y}, "");
            through({half, 0}, size, "ERROR");
        } else {
            const int half = show_ == error ? size.y : size.y / 2;
            through({0, half}, size, "");
            through({0, 0}, {size.x, half}, "ERROR");
        }
        glDisable(GL_SCISSOR_TEST);
    }

    const Program& program(const Sight& sight, const char* purpose) const {
        return program_.with({fmt::format("METHOD {}", sight.method), sight.frame.probe, purpose});
    }

    void draw_relief(const Sight& sight, const char* purpose) {
        const Program& relief = program(sight, purpose);
        glUseProgram(relief);
        const glm::dmat4 pose = view_ == eye ? offsets::pose_of(turn_, away_) : glm::dmat4(1);
        const offsets::PlacedEye placed = offsets::place(sight.eye, sight.frame.camera, pose, light_.direction());
        surface_.set(relief, sight.frame, placed.space_from_model);
        relief.set("u_clip_from_world", placed.clip_from_space);
        relief.set("u_eye", placed.eye);
        relief.set("u_to_light", placed.to_light);
        relief.set("u_up", placed.up);
        relief.set("u_steps", steps_);
        surface_.set_exact_hit(relief, 3);
        surface_.draw();
    }

    /// Returns the error of each sight in texels, computed by the shader. It is measured in a picture of 64 x 64
    /// pixels, so it does not depend on the size of the tile. It has no pixels before the tasks are written.
    const std::vector<ErrorSummary>& measure(const Frame& frame, std::vector<Sight> sights) {
        constexpr int side = 64;
        const Frame square = frame_in(frame, {{0, 0}, {side, side}});
        std::vector<GLuint> programs;
        std::vector<glm::dmat4> cameras;
        int steps = 0;
        for (Sight& sight : sights) {
            sight.frame = view_ == one ? square : from_afar(square, sight.degrees);
            programs.push_back(program(sight, "MEASURE"));
            cameras.push_back(sight.frame.camera.clip_from_world());
            if (sight.method == steep) steps = steps_;
        }
        return errors_.get({programs, cameras, surface_.version(), surface_.mapping(), surface_.shape, steps}, [&] {
            const Image drawn = draw_numbers({side, side * int(sights.size())}, [&] {
                for (size_t i = 0; i < sights.size(); ++i) {
                    glViewport(0, side * int(i), side, side);
                    draw_relief(sights[i], "MEASURE");
                }
            });
            std::vector<ErrorSummary> found;
            for (int i = 0; i < int(sights.size()); ++i) {
                Image errors(side, side, 1);
                for (size_t pixel = 0; pixel < errors.values.size(); ++pixel)
                    errors.values[pixel] = drawn.pixel(0, side * (int(sights.size()) - 1 - i))[pixel * 4];
                found.push_back(summarize(errors));
            }
            return found;
        });
    }

    /// Compares the rays of each way with the rays by the inverse in doubles: as colours on half of its tile, and in
    /// captions, bit by bit and in texels.
    void compare_eyes(const Frame& frame, const std::vector<Sight>& sights) {
        const glm::ivec2 size = frame.size;
        constexpr std::array titles = {"dot products in the world", "eye by the inverse", "inverse in double"};
        constexpr glm::ivec2 sample{128, 128};
        const auto draw_ray = [&](Sight sight, offsets::EyeBy by) {
            sight.eye = by;
            sight.frame.probe = {"ray", MissingTask::told};
            draw_relief(sight, "");
        };
        const auto rays = [&](const Sight& sight, offsets::EyeBy by) {
            return draw_numbers(sample, [&] { draw_ray(sight, by); });
        };
        for (const Sight& sight : sights) {
            labels_.caption(size, sight.tile, 0, titles[size_t(sight.eye)]);
            if (sight.eye == offsets::EyeBy::inverse_in_double || sight.tile.size.x <= 0) continue;
            if (show_ != light)
                difference_.draw(
                    frame, sight.tile, show_ == error ? 0 : sight.tile.size.x / 2, [&] { draw_ray(sight, sight.eye); },
                    [&] { draw_ray(sight, offsets::EyeBy::inverse_in_double); });
            const Image own = rays(sight, sight.eye), exact = rays(sight, offsets::EyeBy::inverse_in_double);
            const Image apart = error_image(own, exact, ErrorMetric::distance);
            const ErrorSummary off = summarize(apart);
            if (off.count == 0) continue;
            const auto same = std::count(apart.values.begin(), apart.values.end(), 0.0f);
            labels_.caption(size, sight.tile, -2, fmt::format("same bits: {} %", 100 * same / int64_t(off.count)));
            labels_.caption(size, sight.tile, -1, amount_of(off.mean, "texel") + " off");
        }
        if (show_ != light) labels_.scale(size, "0.001", "10 texels", 4);
    }

    /// Writes captions. Those of a strip have the angles, too.
    void describe(glm::ivec2 size, const std::vector<Sight>& sights, const std::vector<ErrorSummary>& found) {
        for (size_t i = 0; i < sights.size(); ++i) {
            const auto& [tile, frame, method, degrees, by] = sights[i];
            std::string title = methods[size_t(method)];
            if (view_ == strip && surface_.shape == ReliefSurface::wall) title += fmt::format(" {}~", degrees);
            labels_.caption(size, tile, 0, title);
            if (found[i].count > 0) labels_.caption(size, tile, -1, amount_of(found[i].mean, "texel"));
        }
        if (show_ != light) labels_.scale(size, "0.01", "100 texels", 4);
    }

    Programs program_{"common/relief.vert", "10_parallax_offset/surface.frag"};
    ReliefSurface surface_;
    DifferenceMap difference_{ErrorMetric::distance, -3, 1};
    Studio studio_;
    Labels labels_;
    Kept<std::vector<ErrorSummary>, std::vector<GLuint>, std::vector<glm::dmat4>, int, ReliefMapping, int, int> errors_;
    DistantLight light_;

    int view_ = strip, method_ = steep, steps_ = 32, show_ = half_and_half, eye_ = 0;
    float turn_ = 40, away_ = 0;
};

RELIEF_LAB(ParallaxOffset);

}  // namespace relief
