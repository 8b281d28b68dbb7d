// Lab 14: adaptive displacement.
//
// Each edge chooses its own level, so that neighbours agree and no crack opens. Hidden patches are culled. Far away
// only the normal map is left. Your tasks: shaders/14_adaptive_displacement/task.glsl
#include <fmt/format.h>

#include <limits>

#include "framework/image/visualize.h"
#include "framework/kit/displaced_surface.h"
#include "framework/kit/labels.h"
#include "framework/kit/light.h"
#include "framework/kit/numbers.h"
#include "framework/kit/tiles.h"
#include "framework/lab/lab.h"
#include "scene.h"

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
        const bool is_count = frame.probe.name == "winding";
        if (is_count) DisplacedSurface::begin_winding();
        const auto tiles = tiles_of(frame.size, view_ == both ? 2 : 1);
        int by_eye = 0;
        most_level_ = DisplacedSurface::finest_level;
        for (size_t i = 0; i < tiles.size(); ++i) {
            const Frame eye = frame_in(frame, tiles[i]);
            const bool is_above = view_ == above || (view_ == both && i == 1);
            Frame seen = eye;
            if (is_above) seen.camera = camera_above(eye);
            set_viewport(tiles[i]);
            if (frame.probe) {
                draw_surface(eye, seen, frame.probe);
                continue;
            }
            glPolygonOffset(1, 1);
            if (wire_) glEnable(GL_POLYGON_OFFSET_FILL);  // so that lines lie in front
            const int triangles = draw_surface(eye, seen, is_above ? "PATCHES" : "");
            glDisable(GL_POLYGON_OFFSET_FILL);
            if (wire_) draw_wire(eye, seen);
            if (is_above)
                describe_patches(frame.size, tiles[i], eye, seen, view_ == both ? triangles - by_eye : -1);
            else
                describe_picture(frame.size, tiles[i], eye, by_eye = triangles);
        }
        if (is_count) DisplacedSurface::end_winding();
        std::string bounded;
        if (most_level_ < DisplacedSurface::finest_level) bounded = fmt::format("levels up to {:.0f}", most_level_);
        if (const int samples = densest_samples(surface_.patches().patches());
            method_ == by_error && samples < densest_samples(1))
            bounded += fmt::format("{}errors from {} places a side", bounded.empty() ? "" : ", ", samples);
        if (!bounded.empty() && !frame.probe) labels_.caption(frame.size, tiles[0], 1, bounded);
        labels_.draw(frame);
    }

    void knobs(Knobs& knobs) override {
        knobs.group("Picture");
        knobs.choice("view", view_, views, "the eye's picture, its patches from above, or both");
        knobs.toggle("wire", wire_, "draw the triangles' edges");
        knobs.group("Levels");
        knobs.choice("method", method_, methods, "rule for the levels");
        knobs.choice("levels_of", levels_of_, levels_ofs, "a level per edge, or per patch, which opens cracks");
        knobs.slider("level", level_, 1, 64, "for method = uniform: level of every edge");
        knobs.slider("nearest", nearest_, 0.1f, 32, "for method = distance: where edges have the finest level, metres");
        knobs.slider("farthest", farthest_, 0.1f, 64,
                     "for method = distance: where edges have the coarsest level, metres");
        knobs.slider("finest", finest_, 0, 6, "for method = distance: the finest level, an exponent of 2");
        knobs.slider("coarsest", coarsest_, 0, 6, "for method = distance: the coarsest level, an exponent of 2");
        knobs.slider("segment", segment_, 1, 64, "for method = size: pixels per segment");
        knobs.slider("budget", budget_, 0.125f, 8, "for method = error: tolerated error, pixels");
        knobs.choice("spacing", spacing_, DisplacedSurface::spacings,
                     "positions of the vertices at a fractional level");
        knobs.group("Culling and fading");
        knobs.choice("cull", cull_, culls,
                     "cull no patches, those outside of the picture, or also those that face away");
        knobs.toggle("fade", fade_, "let the displacement fade into the normal map");
        knobs.slider("fade_begin", fade_begin_, 0, 64, "where the fade begins, metres from the eye");
        knobs.slider("fade_end", fade_end_, 0, 64, "where the fade ends, metres from the eye");
        light_.knobs(knobs);
        surface_.knobs(knobs);
    }

    std::optional<Image> truth(const Frame& frame, const Probe& probe) const override {
        // Every line of sight crosses as many front faces as back faces of a closed surface, so all sums are 0.
        if (probe.name != "winding" || !surface_.patches().is_closed) return {};
        return Image(frame.size.x, frame.size.y, 4);
    }

private:
    enum View { both, eye_only, above };
    enum Method { uniform, by_distance, by_size, by_error };
    enum LevelsOf { edges, patches };
    enum Cull { cull_none, cull_outside, cull_all };
    static constexpr std::array views = {"both", "eye", "above"};
    static constexpr std::array methods = {"uniform", "distance", "size", "error"};
    static constexpr std::array levels_ofs = {"edge", "patch"};
    static constexpr std::array culls = {"none", "outside", "all"};
    // The colours of surface.frag.
    static constexpr glm::vec3 outside_color{0.16f, 0.20f, 0.28f}, away_color{0.34f, 0.27f, 0.25f},
        faded_color{0.62f, 0.70f, 0.72f};

    static void set_viewport(const Tile& tile) { glViewport(tile.corner.x, tile.corner.y, tile.size.x, tile.size.y); }

    /// Returns the camera that shows the patches. It looks at the ground from above and behind the eye, and at other
    /// shapes from the side, so that patches that face away from the eye are visible.
    Camera camera_above(const Frame& eye) const {
        Orbit orbit = eye.camera.orbit();
        orbit.field_of_view = 40, orbit.target = {0, -0.6, 0};
        if (surface_.shape == DisplacedSurface::ground)
            orbit.pitch = 50, orbit.distance = 19;
        else
            orbit.yaw += 105, orbit.pitch = 25, orbit.distance = 5, orbit.target = {0, 0, 0};
        return Camera(orbit, double(eye.size.x) / std::max(1, eye.size.y));
    }

    /// Returns the cost of a picture in draws of the surface: one for the triangles of each view, two for their edges,
    /// and one for the search for holes.
    int draws_of_picture() const {
        return (view_ == both ? 2 : 1) * (wire_ ? 3 : 1) + (view_ != above && levels_of_ == patches ? 1 : 0);
    }
    /// Maximum level of an edge, with a margin for fractions that round up.
    float highest_level() const {
        return method_ == uniform       ? level_
               : method_ == by_distance ? std::exp2(std::max(finest_, coarsest_))
                                        : DisplacedSurface::finest_level;
    }

    void draw_wire(const Frame& eye, const Frame& seen) {
        glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
        draw_surface(eye, seen, "WIRE");
        glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    }

    /// Draws the surface as `seen`'s camera sees it, with the levels and the culling for `eye`'s camera. Returns the
    /// number of triangles drawn, or 0 for a probe.
    int draw_surface(const Frame& eye, const Frame& seen, const Define& purpose) {
        const Program& program = program_.with(
            {purpose, surface_.corners_define(), DisplacedSurface::spacing_define(spacing_),
             fmt::format("METHOD {}", method_), levels_of_ == patches ? "LEVELS_OF_PATCH" : "", fade_ ? "FADE" : ""});
        const bool one_sided = surface_.is_one_sided() && purpose.text != "PROBE_winding";
        glUseProgram(program);
        surface_.set(program, seen);
        known_.set(program, surface_, method_ == by_error, 3);
        program.set("u_seen_from", seen.camera.eye() - surface_.origin);
        program.set("u_eye", eye.camera.eye() - surface_.origin);
        const auto planes = planes_of(eye.camera, surface_.origin);
        for (size_t i = 0; i < planes.size(); ++i) program.set(fmt::format("u_planes[{}]", i).c_str(), planes[i]);
        program.set("u_level", level_);
        program.set("u_by_distance", glm::vec4(nearest_, std::max(farthest_, nearest_ + 1e-3f), finest_, coarsest_));
        program.set("u_pixels_per_radian", method_ == by_error ? most_pixels_per_radian(eye) : pixels_per_radian(eye));
        program.set("u_pixels_per_segment", segment_);
        program.set("u_budget", budget_);
        program.set("u_cull", one_sided ? cull_ : std::min<int>(cull_, cull_outside));
        program.set("u_show_culled", eye.camera.eye() != seen.camera.eye());
        program.set("u_fade", glm::vec2(fade_begin_, std::max(fade_end_, fade_begin_ + 1e-3f)));
        program.set("u_to_light", light_.direction());
        program.set("u_wire", glm::vec3(0.93f, 0.86f, 0.62f));
        const float most =
            surface_.most_level(program, highest_level(), purpose.text.starts_with("PROBE_") ? 1 : draws_of_picture());
        most_level_ = std::min(most_level_, most);
        // Without a bound the task's own maximum must show, also if it is missing.
        program.set("u_most_level", most < DisplacedSurface::finest_level ? most : std::numeric_limits<float>::max());
        if (one_sided) glEnable(GL_CULL_FACE);
        // A probe has no caption for the count. Its caller may have a query of its own running.
        int triangles = 0;
        if (purpose.text.starts_with("PROBE_"))
            surface_.draw();
        else
            triangles = surface_.draw_and_count();
        glDisable(GL_CULL_FACE);
        return triangles;
    }

    void describe_picture(glm::ivec2 size, const Tile& tile, const Frame& eye, int triangles) {
        labels_.caption(size, tile, 0, fmt::format("{} triangles", triangles));
        if (levels_of_ == edges) return;
        const auto found = holes(eye);
        if (!found) return;
        const float top = float(size.y - tile.corner.y), side = std::max(3.0f, 0.009f * float(tile.size.y));
        for (const glm::ivec2 hole : *found)
            labels_.rectangle(glm::vec2(float(tile.corner.x + hole.x) + 0.5f, top - float(hole.y) - 0.5f) - side / 2,
                              glm::vec2(side), {1, 0.25f, 0.1f, 0.75f});
        labels_.caption(size, tile, -1, fmt::format("{} pixels are holes", found->size()), {1.0f, 0.55f, 0.4f});
    }

    /// `more` is the number of triangles of culled patches, which are drawn here but not in the eye's picture. It is -1
    /// if unknown.
    void describe_patches(glm::ivec2 size, const Tile& tile, const Frame& eye, const Frame& seen, int more) {
        draw_sight(eye, seen);
        const bool is_even = spacing_ == 2, is_quad = surface_.corners() == 4;  // fractional-even takes level 1 for 2
        const int each = is_quad ? (is_even ? 8 : 2) : (is_even ? 6 : 1);
        if (more >= 0 && cull_ != cull_none)
            labels_.caption(size, tile, 0,
                            fmt::format("{:.0f} % of {} patches culled",
                                        100.0 * more / each / double(std::max<size_t>(1, surface_.patches().patches())),
                                        surface_.patches().patches()));
        // A first line for the colours of the levels, as in surface.frag; a second for the other colours.
        const float line = std::min(Labels::line_height(size) * 0.75f, 0.06f * float(tile.size.y)), gap = line * 0.25f;
        const float bottom = float(size.y - tile.corner.y) - line - gap;
        glm::vec2 place(float(tile.corner.x) + gap * 2, bottom);
        const auto chip = [&](const std::string& text, glm::vec3 color) {
            labels_.rectangle(place, {line, line}, glm::vec4(color, 1));
            labels_.text(text, place + glm::vec2(line * 1.25f, 0), line);
            place.x += line * 1.75f + Labels::width(text, line);
        };
        for (int octave = 0; octave < level_octaves; ++octave)
            chip(std::to_string(1 << octave), heat_color(0.24 + 0.73 * octave / (level_octaves - 1)));
        place = {float(tile.corner.x) + gap * 2, bottom - line - gap};
        if (cull_ != cull_none) chip("outside", outside_color);
        if (cull_ == cull_all && surface_.is_one_sided()) chip("facing away", away_color);
        if (fade_) chip("faded", faded_color);
    }

    /// Draws the eye and its field of view as lines.
    void draw_sight(const Frame& eye, const Frame& seen) {
        const double reach = surface_.shape == DisplacedSurface::ground ? 15 : 3.5;
        const Program& program = sight_.with();
        glUseProgram(program);
        program.set("u_clip_from_world", seen.camera.clip_from_world());
        program.set("u_places[0]", eye.camera.eye());
        for (int i = 0; i < 4; ++i)
            program.set(
                fmt::format("u_places[{}]", i + 1).c_str(),
                eye.camera.eye() + reach * eye.camera.ray({i == 0 || i == 3 ? -1 : 1, i < 2 ? -1 : 1}).direction);
        program.set("u_color", glm::vec4(0.85f, 0.92f, 1.0f, 0.55f));
        if (!no_corners_) no_corners_.emplace();
        glBindVertexArray(*no_corners_);
        glEnable(GL_BLEND);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        glDrawArrays(GL_LINES, 0, 16);
        glDisable(GL_BLEND);
    }

    /// Returns the pixels that are holes, counted from the lower left corner. On a closed surface these show a
    /// different number of front and back faces. On an open one they are background with something drawn close by on
    /// all four sides. Returns nothing before the tasks are written.
    std::optional<std::vector<glm::ivec2>> holes(const Frame& frame) {
        const Image sums = draw_numbers(frame.size, [&] {
            DisplacedSurface::begin_winding();
            draw_surface(frame, frame, "PROBE_winding");
            DisplacedSurface::end_winding();
        });
        if (std::find(sums.values.begin(), sums.values.end(), not_written) != sums.values.end()) return {};
        const bool is_closed = surface_.patches().is_closed;
        const auto sum = [&](int x, int y) {
            return *sums.pixel(std::clamp(x, 0, sums.width - 1), std::clamp(y, 0, sums.height - 1));
        };
        const auto covered = [&](int x, int y, int dx, int dy) {
            for (int i = 1; i <= 3; ++i)
                if (sum(x + i * dx, y + i * dy) != 0) return true;
            return false;
        };
        std::vector<glm::ivec2> found;
        for (int y = 0; y < sums.height; ++y)
            for (int x = 0; x < sums.width; ++x) {
                const bool is_hole = is_closed ? sum(x, y) != 0
                                               : sum(x, y) == 0 && covered(x, y, -1, 0) && covered(x, y, 1, 0) &&
                                                     covered(x, y, 0, -1) && covered(x, y, 0, 1);
                if (is_hole) found.emplace_back(x, sums.height - 1 - y);
            }
        return found;
    }

    Programs program_{"common/patch.vert", "14_adaptive_displacement/patch.tesc",
                      "14_adaptive_displacement/surface.tese", "14_adaptive_displacement/surface.frag"};
    Programs sight_{"14_adaptive_displacement/sight.vert", "14_adaptive_displacement/sight.frag"};
    DisplacedSurface surface_;
    PatchTexture known_;
    std::optional<VertexArrayName> no_corners_;
    Labels labels_;

    int view_ = both, method_ = by_error, levels_of_ = edges, spacing_ = 1, cull_ = cull_all;
    float level_ = 8, nearest_ = 1, farthest_ = 16, finest_ = 5, coarsest_ = 0, segment_ = 8, budget_ = 4;
    float most_level_ = DisplacedSurface::finest_level;  ///< maximum level in this draw
    bool fade_ = false, wire_ = false;
    float fade_begin_ = 6, fade_end_ = 12;
    DistantLight light_{-60, 30};
};

RELIEF_LAB(AdaptiveDisplacement);

}  // namespace relief
